#pragma once

namespace toccata {

/// x i + y j + z k + w, in the order of glTF, of ROS and of GLM's memory. Write `{.x = …, .y = …, .z = …, .w = …}`
/// where yours has w first.
struct Quaternion {
  double x = 0, y = 0, z = 0, w = 1;
};

}  // namespace toccata
