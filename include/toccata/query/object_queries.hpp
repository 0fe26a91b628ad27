#pragma once

#include <limits>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "toccata/broad/box_bvh.hpp"
#include "toccata/query/batch.hpp"
#include "toccata/query/casts.hpp"
#include "toccata/query/check_all.hpp"
#include "toccata/query/distance.hpp"
#include "toccata/query/relation.hpp"

// Questions about many posed models at once. Each answer is what the question of that name gives for every one of them
// by itself: those that it is not asked of are left out by their boxes, which loses nothing.
namespace toccata {

/// A ray from `origin` to `origin + motion`, in the world: times are fractions of the way. It is as long as is looked
/// far.
struct Ray {
  Vec3 origin;
  Vec3 motion;
};

/// A shape that moves by `motion` (world) without turning.
struct MovingShape {
  SceneInstance shape;
  Vec3 motion;
};

/// A model at its place: what the objects of ObjectQueries are to the library.
struct InstanceView {
  const Model& model;
  const Pose& pose;
  Solid solid;
};

/// The questions that SceneIndex and WorldQueries answer. `Objects` says what is asked, how an object is named (`Id`),
/// by what some are chosen (`Filter`), and in what an answer about one of them comes (`Found`). Questions may be asked
/// from many threads at once; the answers do not depend on them. The name and group of a shape that is asked about are
/// not looked at. Errors about an object begin with its name.
///
/// The first and the nearest of all are the least by (upper, id), and `lower` is such that the interval contains the
/// exact number of all of them together, as that of a compound does. Lists ascend by id unless more is said.
template <class Objects>
class ObjectQueries {
 public:
  using Id = typename Objects::Id;
  using Filter = typename Objects::Filter;
  template <class Answer>
  using Found = typename Objects::template Found<Answer>;

  /// The first that the ray meets; none where it meets nothing, which is proved. Throws like `cast_ray`.
  [[nodiscard]] std::optional<Found<RayHit>> cast_ray(const Ray& ray, const Filter& filter = {}) const;
  /// Where it meets each, ascending by (upper, id): in each the first point. Throws like `cast_ray`.
  [[nodiscard]] std::vector<Found<RayHit>> cast_ray_through(const Ray& ray, const Filter& filter = {}) const;

  /// The first that the shape, which is A, meets on its way. Throws like `cast_shape`: also where an object that it
  /// could meet is one for which pairs.hpp does not define it, as of two half-spaces.
  [[nodiscard]] std::optional<Found<ShapeHit>> cast_shape(const MovingShape& moving, const Filter& filter = {}) const;

  /// The objects that have a point in common with the shape. Throws like `overlap`.
  [[nodiscard]] std::vector<Id> overlapping(const SceneInstance& shape, const Filter& filter = {}) const;
  /// The same, and how: the shape is A. Throws like `relation`.
  [[nodiscard]] std::vector<Found<Relation>> relations(const SceneInstance& shape, const Filter& filter = {}) const;

  /// The nearest to the shape, which is A; none where none is within the greatest distance, decided exactly
  /// (`within_distance`). Throws like `distance`, and when the greatest distance is negative or no number.
  [[nodiscard]] std::optional<Found<Distance>> nearest(const SceneInstance& shape, double max_distance = unlimited,
                                                       const Filter& filter = {}) const;
  /// The objects that are at most so far from the shape, decided exactly. Throws like `within_distance`.
  [[nodiscard]] std::vector<Id> within(const SceneInstance& shape, double max_distance,
                                       const Filter& filter = {}) const;

  // The same asked many times at once; an error begins with "ray i: " or "shape i: ", of the least such i.

  [[nodiscard]] std::vector<std::optional<Found<RayHit>>> cast_ray_each(std::span<const Ray> rays,
                                                                        const Filter& filter = {},
                                                                        const BatchOptions& options = {}) const;
  [[nodiscard]] std::vector<std::optional<Found<ShapeHit>>> cast_shape_each(std::span<const MovingShape> moving,
                                                                            const Filter& filter = {},
                                                                            const BatchOptions& options = {}) const;
  [[nodiscard]] std::vector<std::vector<Id>> overlapping_each(std::span<const SceneInstance> shapes,
                                                              const Filter& filter = {},
                                                              const BatchOptions& options = {}) const;
  [[nodiscard]] std::vector<std::optional<Found<Distance>>> nearest_each(std::span<const SceneInstance> shapes,
                                                                         double max_distance = unlimited,
                                                                         const Filter& filter = {},
                                                                         const BatchOptions& options = {}) const;
  [[nodiscard]] std::vector<std::vector<Id>> within_each(std::span<const SceneInstance> shapes, double max_distance,
                                                         const Filter& filter = {},
                                                         const BatchOptions& options = {}) const;

  /// The tree over the boxes of the objects, by index.
  [[nodiscard]] const BoxBvh& boxes() const { return boxes_; }

  /// For the library itself.
  [[nodiscard]] const Objects& objects() const { return objects_; }

 protected:
  static constexpr double unlimited = std::numeric_limits<double>::infinity();

  ObjectQueries() = default;
  explicit ObjectQueries(Objects objects) : objects_(std::move(objects)) {}

  Objects objects_{};
  BoxBvh boxes_;
};

}  // namespace toccata
