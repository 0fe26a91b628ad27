#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "toccata/query/batch.hpp"
#include "toccata/query/check_all.hpp"
#include "toccata/query/nearest.hpp"
#include "toccata/query/signed_distance.hpp"

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
