#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "reports/glb/glb_scene.hpp"

namespace toccata::io {

// What recordings of boxes and of bodies have in common.

/// Throws Error when there are no frames, or more objects than a program bears.
void require_recorded(std::size_t frames, std::size_t objects);

/// Nodes that are each seen in one frame alone, in a group of that name.
class GlbFrames {
 public:
  GlbFrames(GlbScene& glb, const char* group, std::size_t frames) : glb_(glb), group_(group), frames_(frames) {}

  /// Adds to the frame that is being made: points, or segments by both ends. What is not finite is left out.
  void add(const char* name, std::span<const Vec3> points, GlbMode mode, const GlbPaint& paint);
  /// The edges of boxes.
  void add(const char* name, std::span<const Aabb> boxes, const GlbPaint& paint);
  /// Ends it; where nothing was added, nothing is written of it.
  void end_frame(const std::string& name, Json extras);
  /// Ends all.
  void write() { glb_.add_group(group_, seen_); }

 private:
  void add_part(const char* name, const GlbPart& part, const GlbFrame& frame, GlbMode mode, const GlbPaint& paint);

  GlbScene& glb_;
  const char* group_;
  std::size_t frames_, frame_ = 0;
  std::vector<std::size_t> nodes_, seen_;
};

/// Puts a key where the pose is another than that of the last one.
void add_key(std::vector<GlbKey>& keys, std::size_t frame, const std::optional<Pose>& pose);

/// All places of all objects.
[[nodiscard]] std::vector<ViewMeshes::Place> places_of(const std::vector<std::vector<GlbKey>>& keys);

}  // namespace toccata::io
