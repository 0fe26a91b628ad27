#pragma once

#include <span>

#include "narrow/point_triangles.hpp"
#include "query/nearest_elements.hpp"
#include "query/search_scratch.hpp"
#include "query/way_into_tree.hpp"
#include "trees/wide_point.hpp"

namespace toccata {

/// A posed mesh that points are near to, and what is the same for all of them. The mesh must outlive it.
class SurfaceTarget {
 public:
  /// Its elements and faces are counted from these on.
  SurfaceTarget(const PosedMesh& mesh, Index first_element, Index first_face);

  /// Shows all triangles that may be among the nearest, in any order.
  void see_near(const Vec3& point, NearestElements& nearest, SearchScratch& scratch) const;

 private:
  void find(const Vec3& point, const WidePoint& in_tree, NearestCandidates& candidates, WalkCounts& counts) const;
  void see_all(const Vec3& point, NearestElements& nearest) const;
  void see(const Vec3& point, std::span<const Index> triangles, NearestElements& nearest) const;
  [[nodiscard]] Triangle world_triangle(Index number) const;

  const PosedMesh& posed_;
  const TriangleMesh& mesh_;
  const WideTree& tree_;
  WayIntoTree way_;
  double stretch_;  ///< two points of the world are no farther apart in the tree than so many times as far
  Index first_element_;
  Index first_face_;
};

}  // namespace toccata
