#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "library.hpp"
#include "toccata/query/scene_index.hpp"

namespace toccata::bench {

/// What all bodies are asked: where a ray from a point first meets one, where a ball or box that moves does, the
/// distance of the nearest from a ball, or how many a box overlaps.
enum class WorldTask { ray, cast, nearest, overlap };

/// Boxes, spheres and capsules, or one mesh taken as a surface, and questions to all of them.
struct WorldWork {
  WorldTask task = WorldTask::ray;
  std::vector<SceneInstance> bodies;
  std::vector<Ray> rays;              ///< of `ray`
  std::vector<MovingShape> moving;    ///< of `cast`
  std::vector<SceneInstance> shapes;  ///< of `nearest` and `overlap`
  [[nodiscard]] std::size_t size() const { return rays.size() + moving.size() + shapes.size(); }
};

/// A library that answers questions to all bodies at once: Toccata, or a peer.
class WorldQueryLibrary {
 public:
  virtual ~WorldQueryLibrary() = default;
  [[nodiscard]] virtual Description description() const = 0;
  /// Measured: takes over the bodies.
  virtual void build(const WorldWork& work) = 0;
  /// Not measured: takes over the questions.
  virtual void prepare(const WorldWork& work) = 0;
  /// Answers the questions from `first` on: with the time, 1 where nothing is met, the distance, or the number.
  virtual void answer(std::size_t first, std::span<double> answers) = 0;
};

using WorldQueryLibraries = std::vector<std::unique_ptr<WorldQueryLibrary>>;

WorldQueryLibraries toccata_world_query_libraries();
WorldQueryLibraries bullet_world_query_libraries(WorldTask task);
WorldQueryLibraries fcl_world_query_libraries(WorldTask task);

}  // namespace toccata::bench
