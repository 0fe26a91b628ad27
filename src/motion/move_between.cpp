#include "motion/move_between.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "math/plain_inverse.hpp"
#include "math/vec3_measures.hpp"
#include "narrow/pose_checks.hpp"
#include "toccata/core/error.hpp"
#include "toccata/math/trigonometry.hpp"

namespace toccata {
namespace {

constexpr double radians_in_half_a_turn = 3.14159265358979323846;

/// The quaternion of a rotation: its length is 1 but for rounding, and w is not negative (S. W. Shepperd, "Quaternion
/// from rotation matrix", 1978: from the greatest of the four, so nothing cancels).
Quaternion quaternion_of(const Mat3& m) {
  const double trace = (m[0].x + m[1].y) + m[2].z;
  int greatest = 0;
  for (int i = 1; i < 3; ++i)
    if (m[i][i] > m[greatest][greatest]) greatest = i;
  if (trace >= m[greatest][greatest]) {
    const double w = 0.5 * std::sqrt(1 + trace), factor = 0.25 / w;
    return {factor * (m[2].y - m[1].z), factor * (m[0].z - m[2].x), factor * (m[1].x - m[0].y), w};
  }
  const int i = greatest, j = (i + 1) % 3, k = (i + 2) % 3;
  Vec3 v;
  v[i] = 0.5 * std::sqrt(1 + ((m[i][i] - m[j][j]) - m[k][k]));
  const double factor = 0.25 / v[i];
  v[j] = factor * (m[j][i] + m[i][j]);
  v[k] = factor * (m[k][i] + m[i][k]);
  const double w = factor * (m[k][j] - m[j][k]);
  return w < 0 ? Quaternion{-v.x, -v.y, -v.z, -w} : Quaternion{v.x, v.y, v.z, w};
}

/// The angle of the point (c, s) of the circle, neither negative, in turns: with the same bits everywhere, which the C
/// library's does not have. sin(φ − θ) = s cos θ − c sin θ leaves the cube of an error of at most 1/80 turns, and of
/// that again.
double turns_of(double s, double c) {
  double turns = 0.25 * (s / (s + c));
  for (int step = 0; step < 4; ++step) {
    const SineCosine at = sine_cosine_of_turns(turns);
    turns += (s * at.cosine - c * at.sine) / (2 * radians_in_half_a_turn);
  }
  return turns;
}

double greatest_entry(const Mat3& m) {
  return std::max({largest_magnitude(m[0]), largest_magnitude(m[1]), largest_magnitude(m[2])});
}

void require_turned(const Mat3& turned, const Mat3& wanted) {
  double off = 0;
  for (int i = 0; i < 3; ++i) off = std::max(off, largest_magnitude(turned[i] - wanted[i]));
  const double size = greatest_entry(wanted);
  if (!(off <= 0x1p-10 * size))
    throw Error(
        fmt::format("a motion: no turn leads from the pose at the start to that at the end: their 3×3 parts differ by "
                    "{:.3g} of their size when turned; a motion does not scale, shear or mirror",
                    off / size));
}

/// Exact inverses cost more than a sweep, and of what is nearly a rotation they are no better.
Mat3 change_between(const Mat3& from, const Mat3& to) {
  return to * (is_surely_rigid(from) ? transpose(plain_inverse_transpose(from)) : inverse({from, {}}).linear);
}

Mat3 rotation_from(const Mat3& from, const Mat3& to) {
  try {
    return nearest_rotation(change_between(from, to));
  } catch (const Error& error) {
    throw Error(fmt::format("a motion: no turn leads from the pose at the start to that at the end: {}", error.what()));
  }
}

}  // namespace

Pose moved(const Pose& start, const RigidMove& move, double part) {
  if (part == 0) return start;
  const Vec3 shift = part * move.translation;
  if (move.turns == 0) return {start.linear, start.offset + shift};
  const Mat3 turned = rotation_about(normalized(move.axis), 360 * (part * move.turns));
  return {turned * start.linear, (move.centre + turned * (start.offset - move.centre)) + shift};
}

TurnBetween turn_between(const Mat3& from, const Mat3& to) {
  if (from == to) return {};
  const Mat3 rotation = rotation_from(from, to);
  require_turned(rotation * from, to);
  const Quaternion q = quaternion_of(rotation);
  const Vec3 v{q.x, q.y, q.z};
  const double sine = length(v);
  if (sine == 0) return {};
  return {normalized(v), 2 * turns_of(sine, q.w)};
}

}  // namespace toccata
