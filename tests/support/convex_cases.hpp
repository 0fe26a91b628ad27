#pragma once

#include <string>
#include <variant>
#include <vector>

#include "oracle/convex.hpp"
#include "toccata/core/random.hpp"
#include "toccata/narrow/convex_convex.hpp"
#include "toccata/narrow/posed_polytope.hpp"

// Pairs of posed convex shapes, of every kind and in every regime that is hard in a way of its own.
namespace toccata::test {

using ConvexShape = std::variant<Point, Segment, Triangle, Sphere, Box, Capsule, ConvexHull, Rounded>;

struct PlacedPolytope {
  ConvexShape shape;
  Pose pose;
};

struct ConvexCase {
  PlacedPolytope a;
  PlacedPolytope b;
};

struct PlacedHalfSpace {
  HalfSpace shape;
  Pose pose;
};

struct HalfSpaceCase {
  PlacedPolytope a;
  PlacedHalfSpace b;
};

/// point, segment, triangle, sphere, box, capsule, hull (4 to 16 vertices, seldom up to 64), flat-hull, needle-hull,
/// and rounded-point, rounded-segment, rounded-triangle, rounded-box, rounded-hull.
const std::vector<std::string>& convex_kinds();

/// far; near: a gap of about 1 %; touching: exactly, in a vertex, an edge or a face, of small whole numbers; ulp: the
/// same, moved by a last place; hair: the same, moved by 1e-12 of the size; close: rotated, a gap or an overlap of 1e-9
/// to 1e-16; deep; concentric; identical: made of the same points; parallel: faces parallel, rotated; ratio: sizes that
/// differ by 1e12; small and large: of size 1e-6 and 1e6; distant: far from the origin; sheared: shapes without a
/// radius under poses that are no rotations.
const std::vector<std::string>& convex_regimes();

ConvexCase convex_case(const std::string& kind_a, const std::string& kind_b, const std::string& regime, Random& random);

/// A shape of the kind above, in or deep in a half-space, or touching it, in the same regimes.
HalfSpaceCase half_space_case(const std::string& kind, const std::string& regime, Random& random);

/// Case `number` of a sequence that goes round all kinds of B and round all regimes at once. There are 14 and 15, which
/// have no common factor, so that 210 numbers in a row are all pairs of them.
ConvexCase numbered_case(const std::string& kind_a, std::uint64_t number, Random& random);

/// A shape of the kind, of about size 1 around the origin of its own frame.
ConvexShape random_convex(const std::string& kind, Random& random);

/// Refers to the shape's hull.
PosedPolytope posed(const PlacedPolytope& placed);
inline PosedHalfSpace posed(const PlacedHalfSpace& placed) { return PosedHalfSpace(placed.shape, placed.pose); }

/// The same for the oracle: world vertices as the truth page says.
oracle::ConvexSet set_of(const PlacedPolytope& placed);
oracle::HalfSpace set_of(const PlacedHalfSpace& placed);

/// Taken as a solid (docs/truth.md): a flat hull stays a surface under a pose that bends it by rounding.
bool is_solid(const PlacedPolytope& placed);

/// World vertices and radius, in full precision.
std::string to_text(const ConvexCase& pair);
std::string to_text(const HalfSpaceCase& pair);

}  // namespace toccata::test
