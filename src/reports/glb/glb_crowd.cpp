#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "reports/glb/glb_recordings.hpp"
#include "reports/view/drawn_cells.hpp"
#include "reports/view/recorded_boxes.hpp"
#include "toccata/reports/pages.hpp"
#include "toccata/shapes/primitives.hpp"

namespace toccata {
namespace {

using CrowdFrame = CrowdRecording::Frame;

const io::GlbPaint pairs_paint{"pairs", 0xcc79a7};
const io::GlbPaint cells_paint{"cells of the method", 0x009e73};

/// Where boxes of a scene of this extent are drawn: infinite sides end where it does, and flat boxes get a thickness,
/// as a node cannot flatten.
class DrawnBoxes {
 public:
  explicit DrawnBoxes(const Aabb& scene) : scene_(scene), least_(std::ldexp(extent(scene), -20)) {}

  /// What makes it of the box from −1 to 1; none of an empty one.
  [[nodiscard]] std::optional<Pose> pose(const Aabb& box) const {
    if (is_empty(box)) return std::nullopt;
    Pose pose;
    for (int axis = 0; axis < 3; ++axis) {
      const double lower = end(box.lower[axis], axis), upper = end(box.upper[axis], axis);
      pose.linear[axis][axis] = std::max(0.5 * upper - 0.5 * lower, least_);
      pose.offset[axis] = 0.5 * lower + 0.5 * upper;
    }
    return pose;
  }

 private:
  static double extent(const Aabb& scene) {
    const Vec3 size = scene.upper - scene.lower;
    const double greatest = std::max({size.x, size.y, size.z});
    return greatest > 0 ? greatest : 1;
  }
  [[nodiscard]] double end(double coordinate, int axis) const {
    return std::clamp(coordinate, scene_.lower[axis], scene_.upper[axis]);
  }

  Aabb scene_;
  double least_;
};

std::size_t most_boxes(const CrowdRecording& recording) {
  std::size_t most = 0;
  for (const CrowdFrame& frame : recording.frames()) most = std::max(most, frame.boxes.size());
  return most;
}

std::vector<std::vector<io::GlbKey>> keys_of(const CrowdRecording& recording, const DrawnBoxes& drawn) {
  std::vector<std::vector<io::GlbKey>> keys(most_boxes(recording));
  for (std::size_t i = 0; i < recording.frames().size(); ++i) {
    const std::vector<Aabb>& boxes = recording.frames()[i].boxes;
    for (std::size_t number = 0; number < keys.size(); ++number)
      io::add_key(keys[number], i, number < boxes.size() ? drawn.pose(boxes[number]) : std::nullopt);
  }
  return keys;
}

std::vector<bool> are_in_pairs(const CrowdRecording& recording) {
  std::vector<bool> are(most_boxes(recording));
  for (const CrowdFrame& frame : recording.frames())
    for (const IndexPair& pair : frame.pairs) are[pair.first] = are[pair.second] = true;
  return are;
}

void add_frames(io::GlbScene& glb, const CrowdRecording& recording, const Aabb& scene, const DrawnBoxes& drawn) {
  io::GlbFrames pairs(glb, "pairs", recording.frames().size()), cells(glb, "cells", recording.frames().size());
  for (const CrowdFrame& frame : recording.frames()) {
    const std::string name = fmt::format("frame {}", frame.number);
    std::vector<Vec3> ends;
    for (const IndexPair& pair : frame.pairs)
      for (const Index number : {pair.first, pair.second}) ends.push_back(drawn.pose(frame.boxes[number])->offset);
    pairs.add("pairs", ends, io::GlbMode::lines, pairs_paint);
    pairs.end_frame(name, {{"pairs", frame.pairs.size()}});
    cells.add("cells", io::drawn_cells(frame.space, scene), cells_paint);
    cells.end_frame(name, {{"cells", frame.space.cells.size()}, {"method", name_of(frame.method)}});
  }
  pairs.write();
  cells.write();
}

}  // namespace

std::string recording_glb(const CrowdRecording& recording, const ViewOptions& options) {
  io::require_recorded(recording.frames().size(), most_boxes(recording));
  const Aabb scene = io::bounds_of(recording);
  const DrawnBoxes drawn(scene);
  const auto keys = keys_of(recording, drawn);
  const Model box(Box({1, 1, 1}));
  std::vector<SceneInstance> models;
  for (std::size_t i = 0; i < keys.size(); ++i) models.push_back({box, {}, Solid::automatic, fmt::format("box {}", i)});
  const io::ViewMeshes meshes(models, io::places_of(keys));
  io::GlbScene glb(models, meshes);
  io::add_moving_objects(glb, keys, are_in_pairs(recording));
  add_frames(glb, recording, scene, drawn);
  return glb.file(options, "unit");
}

}  // namespace toccata
