#include "reports/glb/glb_recordings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "toccata/core/error.hpp"

namespace toccata::io {

void require_recorded(std::size_t frames, std::size_t objects) {
  constexpr std::size_t most = 20'000;
  if (frames == 0) throw Error("there is no frame to be shown: record one first");
  if (objects > most)
    throw Error(
        fmt::format("a GLB file of {} things that move, each an object, is too much for the programs that read it: "
                    "show at most {}",
                    objects, most));
}

void GlbFrames::add(const char* name, std::span<const Vec3> points, GlbMode mode, const GlbPaint& paint) {
  const std::size_t width = mode == GlbMode::lines ? 2 : 1;
  std::vector<Vec3> finite;
  for (std::size_t i = 0; i + width <= points.size(); i += width) {
    const std::span<const Vec3> item = points.subspan(i, width);
    if (std::all_of(item.begin(), item.end(), [](const Vec3& point) { return is_finite(point); }))
      finite.insert(finite.end(), item.begin(), item.end());
  }
  if (finite.empty()) return;
  const GlbFrame frame = GlbFrame::around(finite);
  GlbPart part;
  for (const Vec3& point : finite) part.points.push_back(frame.counted(point));
  add_part(name, part, frame, mode, paint);
}

void GlbFrames::add(const char* name, std::span<const Aabb> boxes, const GlbPaint& paint) {
  Aabb around;
  for (const Aabb& box : boxes) around = merge(around, box);
  if (is_empty(around)) return;
  const GlbFrame frame = GlbFrame::around(DisplayFrame::around(around));
  add_part(name, edges_part(boxes, {}, frame), frame, GlbMode::lines, paint);
}

void GlbFrames::add_part(const char* name, const GlbPart& part, const GlbFrame& frame, GlbMode mode,
                         const GlbPaint& paint) {
  Json parts = Json::array();
  parts.push_back(glb_.part(part, mode, paint));
  nodes_.push_back(glb_.add_node(name, {}, frame, {{"mesh", glb_.add_mesh(name, std::move(parts))}}));
}

void GlbFrames::end_frame(const std::string& name, Json extras) {
  const std::vector<std::size_t> nodes = std::exchange(nodes_, {});
  const std::size_t frame = frame_++;
  if (!nodes.empty()) seen_.push_back(glb_.add_at_pose(name, nodes, frame, frames_, {{"extras", std::move(extras)}}));
}

void add_key(std::vector<GlbKey>& keys, std::size_t frame, const std::optional<Pose>& pose) {
  if (keys.empty() || keys.back().pose != pose) keys.push_back({frame, pose});
}

std::vector<ViewMeshes::Place> places_of(const std::vector<std::vector<GlbKey>>& keys) {
  std::vector<ViewMeshes::Place> places;
  for (std::size_t object = 0; object < keys.size(); ++object)
    for (const GlbKey& key : keys[object])
      if (key.pose) places.push_back({static_cast<Index>(object), *key.pose});
  return places;
}

}  // namespace toccata::io
