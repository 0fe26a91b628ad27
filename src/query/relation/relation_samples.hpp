#pragma once

#include <span>

#include "query/inside/inside_point.hpp"
#include "query/meshes/posed_mesh.hpp"
#include "query/relation/relation_cells.hpp"

namespace toccata {

/// Two posed solids.
struct SolidPair {
  const PosedMesh& a;
  const PosedMesh& b;
};

/// Which kinds of open region were seen. Each is a fact once set: seen where it lies.
struct RegionsSeen {
  bool in_both = false;
  bool only_in_a = false;
  bool only_in_b = false;

  [[nodiscard]] bool all() const { return in_both && only_in_a && only_in_b; }
  friend bool operator==(const RegionsSeen&, const RegionsSeen&) = default;
};

RegionsSeen operator|(const RegionsSeen& x, const RegionsSeen& y);

/// The regions on both sides of a point of the triangle `t`.
struct SidesOfPoint {
  RegionsSeen seen;
  /// Kinds that can border on triangles that meet nothing of the other solid and hang together with the surface here.
  RegionsSeen possible_beyond;
  bool on_another_plane = false;  ///< a triangle that is not in the plane of t contains the point
};

/// The kinds of region that can border on a piece of the surface of A that lies off the surface of B, inside B or
/// outside as a whole; and the same of B.
[[nodiscard]] RegionsSeen possible_at_surface_of_a(bool in_b);
[[nodiscard]] RegionsSeen possible_at_surface_of_b(bool in_a);

/// Precondition: has_area(t).
[[nodiscard]] SidesOfPoint sides_of(const SolidPair& pair, const ExactPoint& p, const Triangle& t);

/// What is seen on both sides of some points of `t` and, where `cut` crosses it, beside that triangle. What is seen is
/// true; nothing is known about what is not.
[[nodiscard]] RegionsSeen sample(const SolidPair& pair, const Triangle& t);
[[nodiscard]] RegionsSeen sample(const SolidPair& pair, const Triangle& t, const Triangle& cut);

/// All regions that there are, found on both sides of every piece of both surfaces; those already `seen` are taken as
/// known. Returns early when all three are.
[[nodiscard]] RegionsSeen all_regions(const SolidPair& pair, const RegionsSeen& seen);

}  // namespace toccata
