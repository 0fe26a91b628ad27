#pragma once

#include <optional>
#include <vector>

#include "toccata/reports/scene_question.hpp"

namespace toccata::io {

/// A line of the list of what `inspect` told: an object as a whole, or faults of one kind that hang together in it.
struct InspectFinding {
  Index object = 0;
  std::optional<MeshFault> fault{};
  std::size_t groups = 1;  ///< so many faults are one line, where an object has more of a kind than a list can show
};

/// The findings of each object: the object itself, and then its faults: the largest hundred of each kind, and one line
/// for all others of it.
[[nodiscard]] std::vector<InspectFinding> inspect_findings(const InspectReport& report);

/// Where a fault is in the world, as it is drawn.
struct FaultGeometry {
  std::vector<Vec3> segments;   ///< ends of its edges, or of those of its triangles
  std::vector<Vec3> triangles;  ///< corners of duplicate ones
  std::vector<Vec3> points;     ///< unused vertices, and corners of triangles without area, which may be one point
};

[[nodiscard]] FaultGeometry geometry_of(const MeshFault& fault, const TriangleMesh& mesh, const Pose& pose);

}  // namespace toccata::io
