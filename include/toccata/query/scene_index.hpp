#pragma once

#include <cstddef>
#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "toccata/query/nearest.hpp"
#include "toccata/query/object_queries.hpp"
#include "toccata/query/signed_distance.hpp"

// Questions about many posed models that stay where they are.
namespace toccata {

/// What was found, and of which object: its index.
template <class Answer>
struct ObjectAnswer : Answer {
  Index object = 0;
  friend constexpr bool operator==(const ObjectAnswer&, const ObjectAnswer&) = default;
};

/// Which objects are asked, by index; none: all. It gives the same answer each time, from many threads at once.
using ObjectFilter = std::function<bool(Index)>;

/// What a SceneIndex asks: models, by index.
struct SceneObjects {
  using Id = Index;
  using Filter = ObjectFilter;
  template <class Answer>
  using Found = ObjectAnswer<Answer>;

  std::vector<SceneInstance> models;

  // For the library itself.
  [[nodiscard]] Index id_of(Index object) const { return object; }
  [[nodiscard]] InstanceView at(Index object) const;
  [[nodiscard]] std::string name_of(Index object) const;
  [[nodiscard]] bool accepts(const Filter& filter, Index object) const { return !filter || filter(object); }
  void require_unchanged() const {}
};

/// Posed models in a tree over their boxes.
class SceneIndex : public ObjectQueries<SceneObjects> {
 public:
  SceneIndex() = default;
  /// The models are copied; copies share what is large. Throws Error naming the model that has a pose which is not
  /// finite or that its shape may not have, or is asked to be a solid that it is not.
  explicit SceneIndex(std::span<const SceneInstance> models);

  [[nodiscard]] std::span<const SceneInstance> models() const { return objects_.models; }
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

/// For each point what `nearest_points` answers, over the elements of all models: in the order of (upper, object,
/// element). The same for any number of threads. Throws like it.
[[nodiscard]] std::vector<std::vector<ScenePoint>> nearest_points_each(
    std::span<const Vec3> points, std::size_t k, std::span<const SceneInstance> models,
    double max_distance = std::numeric_limits<double>::infinity(), const BatchOptions& options = {});

/// How far a point is from the nearest surface of all, negative when it is inside some model.
struct SceneSignedDistance {
  SignedDistance distance;
  Index object = 0;  ///< whose surface is the nearest
  /// The model that the point is inside of: the first of those that are known exactly, else the first by its
  /// generalised winding number. Where the side is undecided, the first that may hold it.
  std::optional<Index> inside_of;
  friend bool operator==(const SceneSignedDistance&, const SceneSignedDistance&) = default;
};

/// For each point what `signed_distance` answers for the models as for one compound, whatever they are taken for
/// (`solid` is not looked at); but of a point on a surface `sign_by` is that of the object whose surface it is. Throws
/// like it, and Error where there is no model.
[[nodiscard]] std::vector<SceneSignedDistance> signed_distance_each(std::span<const Vec3> points,
                                                                    std::span<const SceneInstance> models,
                                                                    SignBy sign_by = SignBy::automatic,
                                                                    const BatchOptions& options = {});

}  // namespace toccata
