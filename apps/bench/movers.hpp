#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "library.hpp"
#include "toccata/query/scene_index.hpp"

// Characters that walk through levels, and who moves them.
namespace toccata::bench {

/// An upright capsule. It stands on its foot, the lowest point.
struct WalkerShape {
  static constexpr double radius = 0.4, height = 1.8;
};

/// Seconds of a step, and what pulls down, in units per second squared.
inline constexpr double walk_seconds = 1.0 / 60, walk_gravity = 9.81;

/// One who walks: where its foot is at first, free of everything, and how far it wishes to go in each step, level.
struct Walk {
  Vec3 start;
  std::vector<Vec3> wishes;
};

/// Where the true surface is a floor and two walls along x, which end nowhere near: nothing holds up the part of a wish
/// along x.
enum class TrueSurface { any, straight_corridor };

struct WalkWork {
  std::string level;
  std::vector<SceneInstance> models;  ///< a mesh of many triangles, and boxes
  TrueSurface surface = TrueSurface::any;
  std::vector<Walk> walks;
};

/// A library's character: one at a time. Every step falls too, where there is no ground.
class MoverLibrary {
 public:
  virtual ~MoverLibrary() = default;
  [[nodiscard]] virtual Description description() const = 0;
  /// Takes the level over; measured apart.
  virtual void build(const WalkWork& work) = 0;
  /// The character begins anew, at rest.
  virtual void place(const Vec3& foot) = 0;
  /// Measured.
  virtual void step(const Vec3& wish) = 0;
  [[nodiscard]] virtual Vec3 foot() const = 0;
};

using MoverLibraries = std::vector<std::unique_ptr<MoverLibrary>>;

MoverLibraries toccata_movers();
MoverLibraries bullet_movers();

/// The names of the levels, and one of them with walks in it.
std::vector<std::string> walk_levels();
WalkWork walk_work(const std::string& level, std::size_t triangles, std::size_t walks, std::size_t steps,
                   std::uint64_t seed);
/// A mesh of a file, taken as a surface, as the level.
WalkWork walk_work_at(const std::string& file, double scale, std::size_t walks, std::size_t steps, std::uint64_t seed);

/// The walker as Toccata sees it, with its foot at the origin of its frame.
Model walker_model();

}  // namespace toccata::bench
