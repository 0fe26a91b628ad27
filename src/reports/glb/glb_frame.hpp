#pragma once

#include <array>
#include <span>

#include "reports/view/display_frame.hpp"
#include "toccata/math/pose.hpp"

namespace toccata::io {

/// Where the floats of a GLB file are counted from: point = origin + 2^exponent · float. Around what lies near 0 and is
/// of ordinary size this changes nothing; what is far away, tiny or huge keeps its detail.
struct GlbFrame {
  Vec3 origin{};
  int exponent = 0;

  static GlbFrame around(const DisplayFrame& place);
  static GlbFrame around(std::span<const Vec3> points);

  [[nodiscard]] std::array<float, 3> counted(const Vec3& point) const;
};

/// What places, in `world`, a mesh that is counted in `own`: its node's pose.
[[nodiscard]] Pose pose_between(const GlbFrame& world, const Pose& pose, const GlbFrame& own);

/// A node may turn, mirror and stretch along the axes of what it holds, and no more.
[[nodiscard]] bool can_be_a_node(const Pose& pose);

/// Such a pose as glTF moves a node: scaled along the axes, then turned (x, y, z, w), then moved.
struct GlbTurn {
  std::array<float, 3> translation;
  std::array<float, 4> rotation;
  std::array<float, 3> scale;
};

/// The pose can be a node's.
[[nodiscard]] GlbTurn turn_of(const Pose& pose);

}  // namespace toccata::io
