#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "toccata/broad/box_bvh.hpp"
#include "toccata/query/scene_index.hpp"
#include "toccata/world/world.hpp"

namespace toccata {

// What was found, and of which body.

struct BodyRayHit : RayHit {
  BodyId body;
  friend constexpr bool operator==(const BodyRayHit&, const BodyRayHit&) = default;
};

struct BodyCast : ShapeHit {
  BodyId body;
  friend constexpr bool operator==(const BodyCast&, const BodyCast&) = default;
};

struct BodyRelation {
  BodyId body;
  Relation relation;
  friend constexpr bool operator==(const BodyRelation&, const BodyRelation&) = default;
};

/// A is what was asked about, and B the body.
struct BodyDistance : Distance {
  BodyId body;
  friend constexpr bool operator==(const BodyDistance&, const BodyDistance&) = default;
};

/// Which bodies are asked: all, if nothing is said.
struct BodyFilter {
  std::uint64_t mask = ~std::uint64_t{0};  ///< those that are in one of these groups
  /// Those whose own mask has one of these groups, as if the question were a body in them; 0: masks do not matter.
  std::uint64_t group = 0;
  /// Of them, those for which it says yes; none: all. The same answer each time, from many threads at once.
  std::function<bool(BodyId)> accepts{};
};

/// Questions to all bodies of a World, by a tree over their boxes that is kept from step to step. It looks at the World
/// where it is, which has to outlive it and not be moved; after the bodies have changed, `update` is called once before
/// anything is asked.
///
/// Each answer is what the question of that name gives for every body by itself, where it is now and without its
/// margin, in the order of (upper, body); the intervals are as in SceneIndex. Const functions may be called from many
/// threads at once, while nobody changes the World. They throw Error as the questions about two models do, naming the
/// body, and where the bodies have changed since the last update. Of shapes that are asked about, name and group are
/// not looked at.
class WorldQueries {
 public:
  explicit WorldQueries(const World& world);

  /// Looks where the bodies are now: takes time as a pass over their boxes does.
  void update();

  /// The first body that the ray meets; none where it meets nothing, which is proved.
  [[nodiscard]] std::optional<BodyRayHit> cast_ray(const Ray& ray, const BodyFilter& filter = {}) const;
  /// Where it meets each: in each the first point.
  [[nodiscard]] std::vector<BodyRayHit> cast_ray_through(const Ray& ray, const BodyFilter& filter = {}) const;
  /// The first body that the shape meets on its way.
  [[nodiscard]] std::optional<BodyCast> cast_shape(const MovingShape& moving, const BodyFilter& filter = {}) const;
  /// The bodies that have a point in common with the shape, ascending.
  [[nodiscard]] std::vector<BodyId> overlapping(const SceneInstance& shape, const BodyFilter& filter = {}) const;
  /// The same, and how: the shape is A.
  [[nodiscard]] std::vector<BodyRelation> relations(const SceneInstance& shape, const BodyFilter& filter = {}) const;
  /// The body nearest to the shape; none where none is within the greatest distance, decided exactly.
  [[nodiscard]] std::optional<BodyDistance> nearest(const SceneInstance& shape,
                                                    double max_distance = std::numeric_limits<double>::infinity(),
                                                    const BodyFilter& filter = {}) const;
  /// The bodies that are at most so far from the shape, ascending, decided exactly.
  [[nodiscard]] std::vector<BodyId> within(const SceneInstance& shape, double distance,
                                           const BodyFilter& filter = {}) const;

  // The same asked many times at once; an error begins with "ray i: " or "shape i: ", of the least such i.

  [[nodiscard]] std::vector<std::optional<BodyRayHit>> cast_ray_each(std::span<const Ray> rays,
                                                                     const BodyFilter& filter = {},
                                                                     const BatchOptions& options = {}) const;
  [[nodiscard]] std::vector<std::optional<BodyCast>> cast_shape_each(std::span<const MovingShape> moving,
                                                                     const BodyFilter& filter = {},
                                                                     const BatchOptions& options = {}) const;
  [[nodiscard]] std::vector<std::vector<BodyId>> overlapping_each(std::span<const SceneInstance> shapes,
                                                                  const BodyFilter& filter = {},
                                                                  const BatchOptions& options = {}) const;
  [[nodiscard]] std::vector<std::optional<BodyDistance>> nearest_each(
      std::span<const SceneInstance> shapes, double max_distance = std::numeric_limits<double>::infinity(),
      const BodyFilter& filter = {}, const BatchOptions& options = {}) const;
  [[nodiscard]] std::vector<std::vector<BodyId>> within_each(std::span<const SceneInstance> shapes, double distance,
                                                             const BodyFilter& filter = {},
                                                             const BatchOptions& options = {}) const;

 private:
  const World* world_;
  BoxBvh boxes_;
  std::uint64_t revision_ = 0;
};

}  // namespace toccata
