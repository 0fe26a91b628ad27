#include "reports/view/recorded_bodies.hpp"

#include <fmt/format.h>

namespace toccata::io {

RecordedBodies::RecordedBodies(std::span<const Body> objects) {
  scene.unit = "unit";
  for (const Body& body : objects) {
    const std::string name = body.name.empty() ? fmt::format("body {}", models.size()) : body.name;
    scene.objects.push_back({name, body.model.shape(), body.pose, body.solid, "", {}, "a World"});
    models.push_back({body.model, body.pose, body.solid, name, ""});
  }
}

std::vector<ViewMeshes::Place> places_of(const WorldRecording& recording) {
  std::vector<ViewMeshes::Place> places;
  for (const WorldRecording::Frame& frame : recording.frames())
    for (const WorldRecording::Place& place : frame.placed) places.push_back({place.object, place.pose});
  return places;
}

}  // namespace toccata::io
