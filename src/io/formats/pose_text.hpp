#pragma once

#include <functional>
#include <optional>
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

/// By how many degrees one turns to become the other as they are written; none where that is not about one axis.
[[nodiscard]] std::optional<double> degrees_between(const WrittenTurn& from, const WrittenTurn& to);

struct WrittenPose {
  Pose pose;
  std::optional<WrittenTurn> turn;  ///< none of 12 numbers, a quaternion or Euler's angles
};

/// A pose of its words (`pose_from_text`).
[[nodiscard]] WrittenPose pose_of_words(const std::vector<std::string_view>& words, const FailPose& fail);

}  // namespace toccata::io
