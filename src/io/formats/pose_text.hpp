#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "toccata/math/pose.hpp"

namespace toccata::io {

/// Characters that separate the words of a pose, besides blanks.
inline constexpr std::string_view blanks_in_poses = ",=:";

/// Told what is wrong and what to do about it; throws.
using FailPose = std::function<void(const std::string& what, const std::string& advice)>;

/// A pose of its words (`pose_from_text`).
[[nodiscard]] Pose pose_of_words(const std::vector<std::string_view>& words, const FailPose& fail);

}  // namespace toccata::io
