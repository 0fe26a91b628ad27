#pragma once

#include <memory>
#include <optional>
#include <utility>
#include <variant>

#include "query/posed_shape.hpp"
#include "toccata/bounds/aabb.hpp"
#include "toccata/query/model.hpp"
#include "world/character_mover/rounded_box.hpp"
#include "world/character_mover/thing_edges.hpp"
#include "world/character_mover/thing_planes.hpp"

namespace toccata {

/// A set, and its edges. A triangle is posed when that is first asked for: that is seldom, and takes longer than all
/// that is told by its planes and edges. By one thread at a time. Copies share what is posed.
class ElementSet {
 public:
  explicit ElementSet(LevelSet set);
  explicit ElementSet(const Triangle& triangle) : triangle_(triangle) {}

  [[nodiscard]] const LevelSet& posed() const {
    if (!set_) set_ = std::make_shared<const LevelSet>(std::in_place_type<PosedPolytope>, triangle_);
    return *set_;
  }

  [[nodiscard]] std::optional<EdgeGap> gap_at_edge(const FewCorners& core) const {
    return edges_ ? edge_gap(core, *edges_) : edge_gap(core, edges_of(triangle_));
  }

 private:
  Triangle triangle_{};
  mutable std::shared_ptr<const LevelSet> set_;
  std::shared_ptr<const ThingEdges> edges_;  ///< none: of the triangle
};

/// A convex thing of the level, and what it is called.
struct LevelElement {
  ElementSet set;
  Index object = 0;
  Index element = 0;  ///< as in Model
  Aabb box;           ///< around it, in the world
  ThingPlanes planes;
};

/// How far a body is from a convex thing.
struct MoverGap {
  double distance = 0;  ///< not more than the true one; where they overlap, the negative depth along the normal
  Vec3 normal{};        ///< unit, from the thing to the body; zero where none is told
  Vec3 point{};         ///< of the thing
  double witness = 0;   ///< how far apart the points are that tell the normal
};

/// The shape of a character, which is moved without being turned. A position is the offset of its pose.
class MoverBody {
 public:
  /// The model has to outlive it. Throws Error when it is not convex and bounded, or for its pose.
  MoverBody(const Model& shape, const Pose& pose);

  [[nodiscard]] const Model& model() const { return model_; }
  [[nodiscard]] Pose pose_at(const Vec3& position) const { return {pose_.linear, position}; }

  /// Around it, rounded outward.
  [[nodiscard]] Aabb box_at(const Vec3& position) const;
  /// The longest side of its box.
  [[nodiscard]] double size() const { return size_; }
  /// A point of it.
  [[nodiscard]] Vec3 point_at(const Vec3& position) const { return position + point_; }

  /// How far below its position its lowest point is.
  [[nodiscard]] double depth_below(const Vec3& up) const;

  /// It at a place, to be compared with several things.
  struct Placed {
    Vec3 position;
    FewCorners corners;  ///< of the core
  };
  [[nodiscard]] Placed placed_at(const Vec3& position) const;
  /// All that is no farther than that from it on a straight way, or a little farther.
  [[nodiscard]] RoundedBox reach_of(const Placed& placed, const Vec3& motion, double distance) const;
  /// The part of a box that bodies that lie in it may come near to: no corners beside a round one.
  [[nodiscard]] RoundedBox reached_in(const Aabb& box) const;
  /// By how much the core is grown.
  [[nodiscard]] double radius() const { return radius_; }

  [[nodiscard]] MoverGap gap_of(const Placed& placed, const LevelElement& thing) const;
  [[nodiscard]] MoverGap gap_at(const Vec3& position, const LevelElement& thing) const {
    return gap_of(placed_at(position), thing);
  }

  /// By the planes of the thing alone, which takes a fraction of the time: the distance is no more than the true one,
  /// and none is told (it is −∞) where no plane is known.
  struct Bound {
    double distance;
    PlaneGap planes;
  };
  [[nodiscard]] Bound bound_of(const Placed& placed, const LevelElement& thing) const;

 private:
  using Set = std::variant<PosedPolytope, PosedQuadric>;

  template <class Body>
  [[nodiscard]] std::optional<MoverGap> core_gap(const Body& core, const LevelSet& set) const;
  [[nodiscard]] MoverGap overlap_at(const Vec3& position, const LevelElement& thing) const;
  [[nodiscard]] MoverGap gap_from_apart(const Vec3& position, const LevelElement& thing) const;
  [[nodiscard]] Set at(const Set& set, const Vec3& position) const;

  const Model& model_;
  Pose pose_;
  double radius_ = 0;  ///< by which the core is grown
  Shape core_shape_;   ///< what `core_` refers to
  Set whole_, core_;   ///< where the pose has it
  Aabb box_;           ///< there
  Vec3 point_;         ///< from the position
  double size_ = 0;
};

}  // namespace toccata
