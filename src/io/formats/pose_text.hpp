#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "toccata/math/pose.hpp"

namespace toccata::io {

/// Characters that separate the words of a pose, besides blanks.
inline constexpr std::string_view blanks_in_poses = ",=:";

/// Told what is wrong and what to do about it; throws.
using FailPose = std::function<void(const std::string& what, const std::string& advice)>;

/// A turn as it is written, which tells more than the rotation: so many degrees about an axis, and also several times
/// round. No turn has no axis.
struct WrittenTurn {
  Vec3 axis{};
  double degrees = 0;
};

/// The degrees by which one turns to become the other as they are written; none where that is not about one axis.
[[nodiscard]] std::optional<double> degrees_between(const WrittenTurn& from, const WrittenTurn& to);

struct WrittenPose {
  Pose pose;
  std::optional<WrittenTurn> turn;  ///< none of 12 numbers, a quaternion or Euler's angles
};

/// What a pose may be of numbers alone; `is_count_of_pose` tells which counts there are.
inline constexpr std::string_view numbers_of_a_pose =
    "12 numbers, R row by row and then t; 16, a 4 × 4 matrix row by row that ends 0 0 0 1; or 7, a translation and a "
    "quaternion x y z w";

[[nodiscard]] bool is_count_of_pose(std::size_t numbers);

/// A pose of so many numbers.
[[nodiscard]] Pose pose_of_numbers(std::span<const double> numbers, const FailPose& fail);

/// A pose of its words (`pose_from_text`).
[[nodiscard]] WrittenPose pose_of_words(const std::vector<std::string_view>& words, const FailPose& fail);

}  // namespace toccata::io
