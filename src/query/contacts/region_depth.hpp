#pragma once

#include <optional>
#include <span>

#include "query/nearest/nearest_search.hpp"
#include "query/posed_mesh_pair.hpp"
#include "toccata/query/contacts.hpp"

namespace toccata {

/// The point of a box that is nearest to p: its coordinates are those of p or of the box.
[[nodiscard]] Vec3 nearest_point_of(const Aabb& box, const Vec3& p);

/// The normal of a triangle of whatever size.
[[nodiscard]] Vec3 normal_of_any_size(const Triangle& t);

/// A point of the box and of two closed solids and the nearest points of both surfaces. `depth` is not more than the
/// sum of their distances; 0 where no such point is known.
struct DeepestPoint {
  double depth = 0;
  Vec3 point{};
  Vec3 on_a{};
  Vec3 on_b{};
};

/// How deep two solids are in each other within a box.
struct FoundDepth {
  ContactRegion::Depth bracket;
  DeepestPoint deepest;
};

/// A solid whose surface and inside are asked about at points and over cells.
class DepthSide {
 public:
  DepthSide(const Model& model, const Pose& pose, const PosedMesh& mesh, double turn);

  struct Place {
    SurfacePoint surface;  ///< its nearest point
    bool inside = false;
  };
  [[nodiscard]] Place at(const Vec3& point, SearchScratch& scratch) const;
  [[nodiscard]] SurfacePoint nearest(const Vec3& point, SearchScratch& scratch) const {
    return search_.nearest(point, scratch);
  }

  [[nodiscard]] const PosedMesh& mesh() const { return mesh_; }

  /// The normal of a triangle, out of the solid.
  [[nodiscard]] Vec3 outward_normal(Index triangle) const;

 private:
  NearestSearch search_;
  const PosedMesh& mesh_;
  double turn_;
};

/// Asks how deep two solids are in each other: the greatest sum of a point's distances from the two surfaces, over the
/// points of what they have in common (docs/methods/penetration.md#contact-regions). Branch and bound over boxes, the
/// box with the greatest bound first.
class CommonDepth {
 public:
  /// The solids' triangles turned by these signs have normals that point out. It refers to the pair.
  CommonDepth(const Model& a, const Model& b, const PairQuery& query, const PosedMeshPair& pair, double turn_a,
              double turn_b, SearchScratch& scratch);

  /// How deep the common points in the box are. `of_a` are vertices of A inside B, `of_b` such of B inside A.
  [[nodiscard]] FoundDepth within(const Aabb& box, std::span<const Vec3> of_a, std::span<const Vec3> of_b) const;

  /// The same, known no better than it takes to hold it against the limit: `upper` is at most that, or `lower` more;
  /// neither where that was not found in reasonable time, or where the two differ by rounding alone.
  [[nodiscard]] ContactRegion::Depth against(double limit, const Aabb& box) const;

  /// A point of the box in both, off their surfaces, if one was found in reasonable time.
  [[nodiscard]] std::optional<Vec3> inner_point(const Aabb& box) const;

 private:
  DepthSide a_;
  DepthSide b_;
  double size_;  ///< the greatest coordinate
  SearchScratch& scratch_;
};

}  // namespace toccata
