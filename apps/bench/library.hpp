#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "toccata/core/index.hpp"
#include "toccata/math/pose.hpp"
#include "toccata/shapes/primitives.hpp"
#include "toccata/shapes/triangle_mesh.hpp"

namespace toccata::bench {

/// Who answers, with which volume or method, and how it was built.
struct Description {
  std::string library;
  std::string variant;
  std::string version;
  std::string flags;
  friend bool operator==(const Description&, const Description&) = default;
};

enum class Task { overlap, contacts, distance, coherent_distance, build };

/// Distances are asked for, of poses that have nothing to do with each other or of meshes on their way.
[[nodiscard]] constexpr bool asks_distance(Task task) {
  return task == Task::distance || task == Task::coherent_distance;
}

struct PosePair {
  Pose a;
  Pose b;
};

using TrianglePairs = std::vector<std::pair<Index, Index>>;

/// The answer to `overlap` is the yes or no; to `contacts` also the triangles that meet, in any order; to `distance`
/// the one pair that is told to be nearest.
struct Answer {
  bool overlap = false;
  TrianglePairs pairs;
  double distance = 0;
};

/// A library that answers questions about two posed meshes, taken as surfaces: Toccata, or a peer.
class MeshLibrary {
 public:
  virtual ~MeshLibrary() = default;
  [[nodiscard]] virtual Description description() const = 0;
  /// Everything that is done once for two meshes.
  virtual void build(const TriangleMesh& a, const TriangleMesh& b) = 0;
  /// What `build` keeps of both, without the meshes' own vertices and indices.
  [[nodiscard]] virtual std::size_t bytes() const = 0;
  /// Why this is not measured, or not on so many threads; empty where it is.
  [[nodiscard]] virtual std::string obstacle(Task, int) const { return {}; }
  /// Told before queries. True: each query is itself spread over so many threads. Else that many are asked at a time.
  virtual bool spreads_queries(Task, int) { return false; }
  /// May be asked from several threads at once unless there is an obstacle. The task is not build.
  [[nodiscard]] virtual Answer answer(Task task, const PosePair& poses) const = 0;
};

struct TriangleQuestion {
  Triangle a;
  Triangle b;
};

/// A library that tells whether two triangles meet.
class TriangleLibrary {
 public:
  virtual ~TriangleLibrary() = default;
  [[nodiscard]] virtual Description description() const = 0;
  /// Takes the questions over in the library's own types; not measured.
  virtual void prepare(std::span<const TriangleQuestion> questions) = 0;
  /// Answers the questions from `first` on, one for each element of `answers` (1: they meet).
  virtual void answer(std::size_t first, std::span<char> answers) const = 0;
};

using MeshLibraries = std::vector<std::unique_ptr<MeshLibrary>>;
using TriangleLibraries = std::vector<std::unique_ptr<TriangleLibrary>>;

MeshLibraries toccata_mesh_libraries();
MeshLibraries fcl_mesh_libraries();
MeshLibraries cgal_mesh_libraries();
MeshLibraries embree_mesh_libraries();
MeshLibraries ode_mesh_libraries();
MeshLibraries bullet_mesh_libraries();
TriangleLibraries toccata_triangle_libraries();
TriangleLibraries fcl_triangle_libraries();
TriangleLibraries cgal_triangle_libraries();

/// Toccata first, then the named peers. Throws Error when one is not built in.
MeshLibraries mesh_libraries(const std::vector<std::string>& peers);
TriangleLibraries triangle_libraries(const std::vector<std::string>& peers);

/// The names that --peer takes for meshes, and for triangles.
std::vector<std::string> mesh_peers();
std::vector<std::string> triangle_peers();

/// Throws the Error that names the command which installs the peers.
[[noreturn]] void peer_is_missing(const std::string& name);

}  // namespace toccata::bench
