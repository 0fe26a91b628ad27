#pragma once

#include <deque>
#include <optional>
#include <vector>

#include "query/penetration/convex_growth.hpp"
#include "query/posed_shape.hpp"
#include "toccata/narrow/convex_convex.hpp"

namespace toccata {

class WholeBodies;

/// A convex body that is proved to lie within a solid, and a box around it.
struct InnerPart {
  explicit InnerPart(const PosedPolytope& within) : shape(within), box(world_box(within)) {}
  explicit InnerPart(const ConvexHull& within) : hull(within), shape(*hull), box(world_box(shape)) {}
  InnerPart(const InnerPart&) = delete;  // the shape refers to the hull
  InnerPart& operator=(const InnerPart&) = delete;

  std::optional<ConvexHull> hull;
  PosedPolytope shape;
  Aabb box;
  std::optional<PosedQuadric> quadric;  ///< the part itself, where it is a quadric and the hull is one within
};

/// How deep the two overlap; of quadric parts, these and not the hulls within them.
[[nodiscard]] Penetration depth_between(const InnerPart& a, const InnerPart& b);

/// Greater than any coordinate that is added up on the way to a world vertex of the model.
[[nodiscard]] double extent_of(const PosedModel& posed);

/// The hull, drawn together towards the point just so far that it is proved to lie within the solid mesh; none where it
/// keeps less than that share of its size.
[[nodiscard]] std::optional<ConvexHull> drawn_within(const PosedMesh& mesh, const ConvexHull& hull, const Vec3& towards,
                                                     double least_share);

/// A convex body around the point, proved to lie within the solid mesh; none where the point is not inside, or none can
/// be proved.
[[nodiscard]] std::optional<ConvexHull> grow_within(const PosedMesh& mesh, const Vec3& point, double reach, CutBy cut);

/// The shape holds the point in its interior, or on its boundary where it is convex.
[[nodiscard]] bool holds(const PosedShape& shape, const Vec3& point);

/// A bounded solid as the union of posed parts, seen by convex bodies: one around it and as many within as were asked
/// for. It refers to the posed model, which has to outlive it.
class SolidBody {
 public:
  /// `wholes` knows the body of the whole where it was asked before.
  SolidBody(const PosedModel& posed, WholeBodies& wholes);
  SolidBody(const SolidBody&) = delete;
  SolidBody& operator=(const SolidBody&) = delete;

  [[nodiscard]] const std::vector<PosedPart>& parts() const { return posed_.parts; }
  [[nodiscard]] const Aabb& box() const { return box_; }

  /// Contains the solid.
  [[nodiscard]] const PosedPolytope& outer() const { return outer_->shape; }

  /// The solid as a whole, or all but a share of 2^-40 of it, where it is convex; else nothing.
  [[nodiscard]] const InnerPart* whole() const { return whole_; }
  /// It is convex, and `outer` is the solid.
  [[nodiscard]] bool exactly_convex() const { return exactly_convex_; }

  /// The solid, where it is convex or a quadric.
  [[nodiscard]] const InnerPart* as_one() const;

  /// A body within a part that is a convex shape or a quadric; for a convex shape, all of it.
  [[nodiscard]] const InnerPart* within(const PosedPart& part) const;

  /// Within some part of it.
  [[nodiscard]] bool contains(const Vec3& point) const;

  /// The bodies within those of its parts that are convex or a quadric, or all of it where it is convex.
  [[nodiscard]] std::vector<const InnerPart*> convex_parts();

  /// A convex body around a point that it contains, grown as told; none where none could be proved to lie within. It
  /// stays as long as the solid.
  [[nodiscard]] const InnerPart* grow(const Vec3& point, double reach, CutBy cut);

  /// Greater than any coordinate that was added up on the way to a world vertex.
  [[nodiscard]] double extent() const { return extent_; }

 private:
  const InnerPart* keep(const std::optional<ConvexHull>& hull);
  void find_whole(WholeBodies& wholes);
  void find_inner_parts();
  /// The surroundings of a point inside the mesh; else null. Those of the last point are kept: bodies grow around it by
  /// several cuts.
  const Surroundings* surroundings_in(const PosedMesh& mesh, const Vec3& point, double reach);

  const PosedModel& posed_;
  Aabb box_;
  double extent_ = 0;
  std::deque<InnerPart> kept_;  // a shape refers to its hull, so none may move
  std::optional<InnerPart> outer_;
  std::vector<const InnerPart*> inner_;  ///< of each part, or null
  const InnerPart* whole_ = nullptr;
  bool exactly_convex_ = false;
  Surroundings around_;
  const PosedMesh* around_mesh_ = nullptr;
  bool is_around_inside_ = false;
};

}  // namespace toccata
