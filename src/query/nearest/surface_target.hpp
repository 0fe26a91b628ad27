#pragma once

#include <span>

#include "narrow/triangles/point_triangles.hpp"
#include "query/nearest/nearest_elements.hpp"
#include "query/nearest/way_into_tree.hpp"
#include "query/search_scratch.hpp"
#include "trees/wide_point.hpp"

namespace toccata {

/// A posed mesh that points are near to, and what is the same for all of them. The mesh must outlive it.
class SurfaceTarget {
 public:
  /// Its elements and faces are counted from these on; about so many points will be asked about.
  SurfaceTarget(const PosedMesh& mesh, Index first_element, Index first_face, std::size_t points);

  /// A mesh at the identity, which need not be posed. The model must outlive it.
  SurfaceTarget(const Model& standing, std::size_t points);

  /// Shows all triangles that may be among the nearest, in any order.
  void see_near(const Vec3& point, NearestElements& nearest, SearchScratch& scratch) const;

  /// The nearest of each point, where it is within the greatest distance; several are looked for at a time.
  void find_nearest(std::span<const Vec3> points, double max_distance, std::span<std::optional<SurfacePoint>> found,
                    SearchScratch& scratch) const;

  /// It is worth asking that way.
  [[nodiscard]] bool has_leaves() const { return leaves_ != nullptr; }

 private:
  [[nodiscard]] WidePoint in_tree(const Vec3& point) const;
  [[nodiscard]] bool is_usable(const WidePoint& in_tree) const;
  [[nodiscard]] bool is_for_leaves(const WidePoint& in_tree) const;
  [[nodiscard]] float limit_in_tree(double limit) const;
  void find_some(std::span<const Vec3> points, double max_distance, std::span<std::optional<SurfacePoint>> found,
                 SearchScratch& scratch) const;
  void see_left(const Vec3& point, std::span<const Index> left, NearestElements& nearest, SearchScratch& scratch) const;
  /// Looks by the floats at the tree's leaves.
  void see_at_leaves(const Vec3& point, const WidePoint& in_tree, NearestElements& nearest,
                     SearchScratch& scratch) const;
  /// Looks by the vertices in doubles.
  void see_by_walk(const Vec3& point, const WidePoint& in_tree, NearestElements& nearest, SearchScratch& scratch) const;
  void bound_few(const Vec3& point, std::span<const Index> triangles, NearestCandidates& candidates) const;
  void see_candidates(const Vec3& point, const NearestCandidates& candidates, NearestElements& nearest) const;
  void see_all(const Vec3& point, NearestElements& nearest) const;
  void see(const Vec3& point, std::span<const Index> triangles, NearestElements& nearest) const;
  [[nodiscard]] Triangle world_triangle(Index number) const;

  Pose pose_;
  const TriangleMesh& mesh_;
  const WideBvh& tree_;
  WayIntoTree way_;
  Stretch stretch_;              ///< what becomes of lengths on that way
  const LeafTriangles* leaves_;  ///< null when they do not pay, or say nothing of what is nearest in the world
  Index first_element_;
  Index first_face_;
};

}  // namespace toccata
