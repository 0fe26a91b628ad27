#include "world/body_box.hpp"

#include "query/posed_shape.hpp"
#include "toccata/core/error.hpp"

namespace toccata {
namespace {

Aabb posed_box(const Body& body, const Pose& pose, std::string_view who) {
  if (std::holds_alternative<Compound>(body.model.shape()))
    return world_box(pose_model(body.model, pose, body.solid, who));
  return world_box(pose_shape(body.model, pose, body.solid, who));
}

}  // namespace

Aabb body_box(const Body& body, const Pose& pose, FunctionRef<std::string()> who) {
  try {
    return posed_box(body, pose, "the body");
  } catch (const Error&) {
    return posed_box(body, pose, who());  // names are made where they are needed
  }
}

}  // namespace toccata
