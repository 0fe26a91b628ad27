#pragma once

#include <vector>

#include "toccata/io/report.hpp"

namespace toccata::io {

/// What the faces of a pair have in common, in the world.
struct ContactGeometry {
  std::vector<Vec3> points;
  std::vector<Vec3> segments;   ///< two ends each
  std::vector<Vec3> triangles;  ///< three corners each, of the common areas
};

[[nodiscard]] ContactGeometry contact_geometry(const ReportedPair& pair);

/// The faces of one side that meet a face of the other, ascending, each once.
[[nodiscard]] std::vector<Index> meeting_faces(const ReportedPair& pair, Index ReportedFacePair::*side);

}  // namespace toccata::io
