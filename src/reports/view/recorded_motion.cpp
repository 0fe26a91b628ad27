#include "reports/view/recorded_motion.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <vector>

#include "toccata/core/error.hpp"
#include "toccata/math/pose.hpp"

namespace toccata::io {
namespace {

using Rows = std::array<std::array<double, 3>, 3>;

Rows rows_of(const Pose& pose) {
  const std::array<double, 12> n = pose.numbers();
  return {{{n[0], n[1], n[2]}, {n[3], n[4], n[5]}, {n[6], n[7], n[8]}}};
}

/// The columns of the cofactors: rows of the inverse, times the determinant.
Rows cofactors(const Rows& m) {
  Rows c{};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) {
      const std::size_t a = (i + 1) % 3, b = (i + 2) % 3, s = (j + 1) % 3, t = (j + 2) % 3;
      c[i][j] = m[a][s] * m[b][t] - m[a][t] * m[b][s];
    }
  return c;
}

/// `to` · `from`⁻¹; none where `from` is singular.
std::optional<Rows> turn_between(const Rows& from, const Rows& to) {
  const Rows c = cofactors(from);
  const double determinant = from[0][0] * c[0][0] + from[0][1] * c[0][1] + from[0][2] * c[0][2];
  if (!(std::abs(determinant) > 0)) return std::nullopt;
  Rows turn{};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      turn[i][j] = (to[i][0] * c[j][0] + to[i][1] * c[j][1] + to[i][2] * c[j][2]) / determinant;
  return turn;
}

/// The quaternion of a rotation, by the largest of the four (S. W. Shepperd, "Quaternion from rotation matrix", 1978).
Quaternion quaternion_of(const Rows& r) {
  const double trace = r[0][0] + r[1][1] + r[2][2];
  const std::array<double, 4> squares{1 + 2 * r[0][0] - trace, 1 + 2 * r[1][1] - trace, 1 + 2 * r[2][2] - trace,
                                      1 + trace};
  std::size_t largest = 0;
  for (std::size_t i = 1; i < 4; ++i)
    if (squares[i] > squares[largest]) largest = i;
  if (largest == 3) return {r[2][1] - r[1][2], r[0][2] - r[2][0], r[1][0] - r[0][1], squares[3]};
  const std::size_t i = largest, j = (i + 1) % 3, k = (i + 2) % 3;
  std::array<double, 3> q{};
  q[i] = squares[i];
  q[j] = r[i][j] + r[j][i];
  q[k] = r[i][k] + r[k][i];
  return {q[0], q[1], q[2], r[k][j] - r[j][k]};
}

bool are_near(const Rows& a, const Rows& b) {
  constexpr double as_good_as_the_file = 1e-4;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      if (!(std::abs(a[i][j] - b[i][j]) <= as_good_as_the_file)) return false;
  return true;
}

/// From the first pose to another one.
Quaternion turn_of_body(const Body& body, Index object, const Pose& pose) {
  if (body.pose.linear == pose.linear) return {};
  if (const auto turn = turn_between(rows_of(body.pose), rows_of(pose))) {
    const Quaternion q = quaternion_of(*turn);
    if (are_near(rows_of({rotation_of(q), {}}), *turn)) return q;
  }
  throw Error(
      fmt::format("body {} (\"{}\") is stretched or mirrored from one frame to another, where a page shows bodies "
                  "that turn and move",
                  object, body.name));
}

/// The places of all moments, one after the other.
struct Written {
  std::vector<std::uint32_t> objects;
  std::vector<float> places;
  std::vector<std::uint16_t> turns;

  void add(Index object, const std::array<float, 3>& place, const std::array<double, 4>& turn) {
    constexpr double most = 32767;
    objects.push_back(object);
    places.insert(places.end(), place.begin(), place.end());
    for (const double x : turn)
      turns.push_back(static_cast<std::uint16_t>(static_cast<std::int16_t>(std::lround(most * x))));
  }
};

std::array<double, 4> of_length_one(const Quaternion& q) {
  const double length = std::sqrt(q.x * q.x + q.y * q.y + q.z * q.z + q.w * q.w);
  return {q.x / length, q.y / length, q.z / length, q.w / length};
}

}  // namespace

Json motion_of(const WorldRecording& recording, const DisplayFrame& frame, ViewData& data) {
  Written written;
  Json moments = Json::array();
  for (const WorldRecording::Frame& one : recording.frames()) {
    const std::size_t first = written.objects.size();
    for (const WorldRecording::Place& place : one.placed)
      written.add(place.object, frame.shown(place.pose.offset),
                  of_length_one(turn_of_body(recording.objects()[place.object], place.object, place.pose)));
    for (const Index object : one.gone) written.add(object, {}, {});
    moments.push_back({first, written.objects.size() - first});
  }
  return {{"objects", data.add(std::span<const std::uint32_t>(written.objects))},
          {"places", data.add(written.places)},
          {"turns", data.add(std::span<const std::uint16_t>(written.turns))},
          {"moments", std::move(moments)}};
}

}  // namespace toccata::io
