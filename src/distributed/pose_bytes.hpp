#pragma once

#include "distributed/messages.hpp"
#include "toccata/math/pose.hpp"

namespace toccata {

/// A pose as bytes and back, every bit of it: one that only moves is 25 of them, one that turns too 76 to 90, as a rule
/// 80, and any other 97.
void put_pose(MessageWriter& writer, const Pose& pose);
[[nodiscard]] Pose get_pose(MessageReader& reader);

}  // namespace toccata
