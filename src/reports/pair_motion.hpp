#pragma once

#include <optional>

#include "toccata/query/check_all.hpp"
#include "toccata/reports/report.hpp"

// Whether two objects lie to each other as they did when an earlier report told of them.
namespace toccata::io {

/// The object as a report tells it: FormerObject says around what its box is.
[[nodiscard]] FormerObject placed(const SceneInstance& object);

/// Two objects, then or now.
struct PlacedPair {
  FormerObject a, b;
};

/// How far one of the two has moved as seen from the other, in world units: if each were carried along as the other has
/// moved, the greatest distance of a corner of its box from where that corner is. An object moves as the middle of its
/// box does, so that a mesh may be written anew with a move in its vertices. What has no box is the origin of its frame
/// alone; what is flattened by its pose is taken not to move. None up to `tolerance`, and up to what rounding to floats
/// makes of the two.
[[nodiscard]] std::optional<double> moved_by(const PlacedPair& then, const PlacedPair& now, double tolerance);

}  // namespace toccata::io
