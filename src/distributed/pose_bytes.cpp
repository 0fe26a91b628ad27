#include "distributed/pose_bytes.hpp"

#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <limits>

namespace toccata {
namespace {

/// How the nine numbers of a pose go.
enum class LinearForm : std::uint8_t { identity, rotation, any };

/// Neighbouring doubles are neighbouring numbers, and no two doubles the same.
std::uint64_t place_among_doubles(double value) {
  constexpr std::uint64_t sign = std::uint64_t{1} << 63;
  const auto bits = std::bit_cast<std::uint64_t>(value);
  return (bits & sign) != 0 ? ~bits : bits | sign;
}

double double_at(std::uint64_t place) {
  constexpr std::uint64_t sign = std::uint64_t{1} << 63;
  return std::bit_cast<double>((place & sign) != 0 ? place & ~sign : ~place);
}

/// How many doubles `value` lies above `guess`, small where they are near: 0, -1, 1, -2, … become 0, 1, 2, 3, …
std::uint64_t steps_from(double guess, double value) {
  const std::uint64_t above = place_among_doubles(value) - place_among_doubles(guess);
  return above << 1 ^ (above >> 63 != 0 ? std::numeric_limits<std::uint64_t>::max() : 0);
}

double double_by_steps(double guess, std::uint64_t steps) {
  const std::uint64_t above = steps >> 1 ^ ((steps & 1) != 0 ? std::numeric_limits<std::uint64_t>::max() : 0);
  return double_at(place_among_doubles(guess) + above);
}

/// The third row of a rotation is the cross product of the others, but for what is rounded.
std::array<std::uint64_t, 3> steps_from_rotation(const Mat3& linear) {
  const Vec3 guess = cross(linear[0], linear[1]);
  return {steps_from(guess.x, linear[2].x), steps_from(guess.y, linear[2].y), steps_from(guess.z, linear[2].z)};
}

bool is_same(const Mat3& a, const Mat3& b) { return std::memcmp(&a, &b, sizeof(Mat3)) == 0; }

LinearForm form_of(const Mat3& linear) {
  if (is_same(linear, Mat3{})) return LinearForm::identity;
  std::size_t bytes = 0;
  for (const std::uint64_t steps : steps_from_rotation(linear))
    bytes += (static_cast<std::size_t>(std::bit_width(steps | 1)) + 6) / 7;
  return bytes < sizeof(Vec3) ? LinearForm::rotation : LinearForm::any;
}

}  // namespace

void put_pose(MessageWriter& writer, const Pose& pose) {
  const LinearForm form = form_of(pose.linear);
  writer.put(form);
  writer.put(pose.offset);
  if (form == LinearForm::any) writer.put(pose.linear);
  if (form != LinearForm::rotation) return;
  writer.put(pose.linear[0]);
  writer.put(pose.linear[1]);
  for (const std::uint64_t steps : steps_from_rotation(pose.linear)) writer.put_number(steps);
}

Pose get_pose(MessageReader& reader) {
  const auto form = reader.get<LinearForm>();
  Pose pose;
  pose.offset = reader.get<Vec3>();
  if (form == LinearForm::any) pose.linear = reader.get<Mat3>();
  if (form != LinearForm::rotation) return pose;
  pose.linear[0] = reader.get<Vec3>();
  pose.linear[1] = reader.get<Vec3>();
  const Vec3 guess = cross(pose.linear[0], pose.linear[1]);
  for (int axis = 0; axis < 3; ++axis) pose.linear[2][axis] = double_by_steps(guess[axis], reader.get_number());
  return pose;
}

}  // namespace toccata
