#pragma once

#include <vector>

#include "toccata/reports/report.hpp"

namespace toccata::io {

/// What pairs of faces have in common, in the world.
struct ContactGeometry {
  std::vector<Vec3> points;
  std::vector<Vec3> segments;   ///< two ends each
  std::vector<Vec3> triangles;  ///< three corners each, of the common areas
};

[[nodiscard]] ContactGeometry contact_geometry(const std::vector<ReportedFacePair>& pairs);

/// The faces of one side that meet a face of the other, ascending, each once.
[[nodiscard]] std::vector<Index> intersecting_faces(const std::vector<ReportedFacePair>& pairs,
                                                    Index ReportedFacePair::*side);

/// The faces of both sides, which are of one object.
[[nodiscard]] std::vector<Index> faces_intersecting(const std::vector<ReportedFacePair>& pairs);

}  // namespace toccata::io
