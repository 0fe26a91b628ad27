#pragma once

#include <cstddef>
#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "toccata/broad/box_bvh.hpp"
#include "toccata/query/batch.hpp"
#include "toccata/query/casts.hpp"
#include "toccata/query/check_all.hpp"
#include "toccata/query/distance.hpp"
#include "toccata/query/nearest.hpp"
#include "toccata/query/relation.hpp"
#include "toccata/query/signed_distance.hpp"

// Questions about many posed models at once. Each answer is what the question of that name gives for every one of them
// by itself: those that it is not asked of are left out by their boxes, which loses nothing.
namespace toccata {

/// From `origin` to `origin + motion`, in the world: times are fractions of the way. It is as long as is looked far.
struct Ray {
  Vec3 origin;
  Vec3 motion;
};

// What was found, and of which object: its index.

struct ObjectRayHit : RayHit {
  Index object = 0;
  friend constexpr bool operator==(const ObjectRayHit&, const ObjectRayHit&) = default;
};

/// A is the shape that moves, and B the object.
struct ObjectCast : ShapeHit {
  Index object = 0;
  friend constexpr bool operator==(const ObjectCast&, const ObjectCast&) = default;
};

struct ObjectRelation {
  Index object = 0;
  Relation relation;
  friend constexpr bool operator==(const ObjectRelation&, const ObjectRelation&) = default;
};

/// A is what was asked about, and B the object.
struct ObjectDistance : Distance {
  Index object = 0;
  friend constexpr bool operator==(const ObjectDistance&, const ObjectDistance&) = default;
};

/// A shape that moves by `motion` (world) without turning.
struct MovingShape {
  SceneInstance shape;
  Vec3 motion;
};

/// Which objects are asked, by index; none: all. It gives the same answer each time, from many threads at once.
using ObjectFilter = std::function<bool(Index)>;

/// Posed models in a tree over their boxes. Questions may be asked from many threads at once; the answers do not depend
/// on them. Of a shape that is asked about, name and group are not looked at. Errors about an object begin with its
/// name.
///
/// The first and the nearest of all are the least by (upper, object), and `lower` is such that the interval contains
/// the exact number of all of them together, as that of a compound does.
class SceneIndex {
 public:
  SceneIndex() = default;
  /// The models are copied; copies share what is large. Throws Error naming the model that has a pose which is not
  /// finite or that its shape may not have, or is asked to be a solid that it is not.
  explicit SceneIndex(std::span<const SceneInstance> models);

  [[nodiscard]] std::span<const SceneInstance> models() const { return models_; }
  [[nodiscard]] const BoxBvh& boxes() const { return boxes_; }

  /// The first that the ray meets; none where it meets nothing, which is proved. Throws like `cast_ray`.
  [[nodiscard]] std::optional<ObjectRayHit> cast_ray(const Ray& ray, const ObjectFilter& filter = {}) const;
  /// Where it meets each, ascending by (upper, object): in each the first point. Throws like `cast_ray`.
  [[nodiscard]] std::vector<ObjectRayHit> cast_ray_through(const Ray& ray, const ObjectFilter& filter = {}) const;

  /// The first that the shape meets on its way. Throws like `cast_shape`: also where an object that it could meet is
  /// one for which pairs.hpp does not define it, as of two half-spaces.
  [[nodiscard]] std::optional<ObjectCast> cast_shape(const MovingShape& moving, const ObjectFilter& filter = {}) const;

  /// Those that have a point in common with the shape, ascending. Throws like `overlap`.
  [[nodiscard]] std::vector<Index> overlapping(const SceneInstance& shape, const ObjectFilter& filter = {}) const;
  /// The same, and how: the shape is A. Throws like `relation`.
  [[nodiscard]] std::vector<ObjectRelation> relations(const SceneInstance& shape,
                                                      const ObjectFilter& filter = {}) const;

  /// The nearest to the shape; none where none is within the greatest distance, decided exactly (`within_distance`).
  /// Throws like `distance`, and when the greatest distance is negative or no number.
  [[nodiscard]] std::optional<ObjectDistance> nearest(const SceneInstance& shape,
                                                      double max_distance = std::numeric_limits<double>::infinity(),
                                                      const ObjectFilter& filter = {}) const;
  /// Those that are at most so far from the shape, ascending, decided exactly. Throws like `within_distance`.
  [[nodiscard]] std::vector<Index> within(const SceneInstance& shape, double distance,
                                          const ObjectFilter& filter = {}) const;

  // The same asked many times at once; an error begins with "ray i: " or "shape i: ", of the least such i.

  [[nodiscard]] std::vector<std::optional<ObjectRayHit>> cast_ray_each(std::span<const Ray> rays,
                                                                       const ObjectFilter& filter = {},
                                                                       const BatchOptions& options = {}) const;
  [[nodiscard]] std::vector<std::optional<ObjectCast>> cast_shape_each(std::span<const MovingShape> moving,
                                                                       const ObjectFilter& filter = {},
                                                                       const BatchOptions& options = {}) const;
  [[nodiscard]] std::vector<std::vector<Index>> overlapping_each(std::span<const SceneInstance> shapes,
                                                                 const ObjectFilter& filter = {},
                                                                 const BatchOptions& options = {}) const;
  [[nodiscard]] std::vector<std::optional<ObjectDistance>> nearest_each(
      std::span<const SceneInstance> shapes, double max_distance = std::numeric_limits<double>::infinity(),
      const ObjectFilter& filter = {}, const BatchOptions& options = {}) const;
  [[nodiscard]] std::vector<std::vector<Index>> within_each(std::span<const SceneInstance> shapes, double distance,
                                                            const ObjectFilter& filter = {},
                                                            const BatchOptions& options = {}) const;

 private:
  std::vector<SceneInstance> models_;
  BoxBvh boxes_;
};

}  // namespace toccata

// Points asked about among many posed models, as `scene_models` makes them of a scene. Each model is placed once; for
// a point only those are searched whose boxes are near enough. Errors about a model begin with its name.
namespace toccata {

/// A point of the surface of one of them.
struct ScenePoint {
  SurfacePoint nearest;
  Index object = 0;  ///< index in the span
  friend constexpr bool operator==(const ScenePoint&, const ScenePoint&) = default;
};

/// For each point what `nearest_points` tells, of the elements of all models: in the order of (upper, object, element).
/// The same for any number of threads. Throws like it.
[[nodiscard]] std::vector<std::vector<ScenePoint>> nearest_points_each(
    std::span<const Vec3> points, std::size_t k, std::span<const SceneInstance> models,
    double max_distance = std::numeric_limits<double>::infinity(), const BatchOptions& options = {});

/// How far a point is from the nearest surface of all, negative when it is inside some model.
struct SceneSignedDistance {
  SignedDistance distance;
  Index object = 0;  ///< whose surface is the nearest
  /// The model that the point is inside of: the first of those that are told exactly, else the first by its generalised
  /// winding number. Where the side is undecided, the first that may hold it.
  std::optional<Index> inside_of;
  friend bool operator==(const SceneSignedDistance&, const SceneSignedDistance&) = default;
};

/// For each point what `signed_distance` tells of the models as of one compound, whatever they are taken for (`solid`
/// is not looked at); but of a point on a surface `sign_by` is that of the object whose surface it is. Throws like it,
/// and Error where there is no model.
[[nodiscard]] std::vector<SceneSignedDistance> signed_distance_each(std::span<const Vec3> points,
                                                                    std::span<const SceneInstance> models,
                                                                    SignBy sign_by = SignBy::automatic,
                                                                    const BatchOptions& options = {});

}  // namespace toccata
