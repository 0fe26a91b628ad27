#pragma once

#include <array>
#include <compare>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "toccata/core/index.hpp"
#include "toccata/core/parallel.hpp"
#include "toccata/core/status.hpp"
#include "toccata/math/vec3.hpp"
#include "toccata/motion/time_of_impact.hpp"
#include "toccata/narrow/triangle_triangle.hpp"
#include "toccata/shapes/triangle_mesh.hpp"
#include "toccata/trees/wide_bvh.hpp"

// Continuous collision of meshes that deform: of two, or of one with itself (docs/truth.md, "Meshes that deform").
namespace toccata {

struct MeshTopology;

/// A mesh over one step, in which every vertex moves in a straight line: at time t in [0, 1] it is at
/// (1 − t) · start + t · end. With a tree over all that its triangles pass, which is refitted from step to step.
/// Copies share what does not change: triangles and edges.
class DeformingMesh {
 public:
  /// Throws Error for another number of ends than of vertices, for an end that is not finite, and as a Model does.
  DeformingMesh(const TriangleMesh& start, std::vector<Vec3> end, int threads = own_thread);
  /// A mesh at rest.
  explicit DeformingMesh(const TriangleMesh& mesh, int threads = own_thread);

  /// Another end of the same step, as when a solver tries a shorter one. The tree keeps its shape and its boxes are
  /// put around the new ways; it is built anew once they have grown too much (Refit::should_rebuild; the answer is
  /// what was found before that). No answer depends on which was done. Throws Error as the constructor does; the mesh
  /// then stays as it was.
  Refit move_to(std::vector<Vec3> end, int threads = own_thread);
  /// The next step: what was the end is the start.
  Refit advance(std::vector<Vec3> end, int threads = own_thread);

  [[nodiscard]] std::span<const Vec3> start() const { return start_; }
  [[nodiscard]] std::span<const Vec3> end() const { return end_; }
  [[nodiscard]] std::span<const std::array<Index, 3>> triangles() const;
  /// Every edge of a triangle once, by its ends, ascending: an edge's number is its place here.
  [[nodiscard]] std::span<const IndexPair> edges() const;

  /// Over the triangles' ways; for the library itself.
  [[nodiscard]] const WideBvh& tree() const { return tree_; }
  [[nodiscard]] const MeshTopology& topology() const { return *topology_; }

 private:
  void build(int threads);
  Refit refit(int threads);

  std::shared_ptr<const MeshTopology> topology_;
  std::vector<Vec3> start_;
  std::vector<Vec3> end_;
  WideBvh tree_;
};

/// A vertex, an edge (its number in `DeformingMesh::edges`) or the face of a triangle, closed.
struct MeshFeature {
  FeatureKind kind = FeatureKind::vertex;
  Index number = 0;
  friend constexpr auto operator<=>(const MeshFeature&, const MeshFeature&) = default;
};

/// Two features that meet, and when first. For two meshes, `a` is of the first; for one, it is the lesser. They are
///  - a vertex and a face, or two edges, at any time;
///  - an edge and a face that meet at the start, as where it pierces it: their time is 0. (Had they met only later, so
///    would one of the pairs above have, before or then.)
/// Features of one mesh that have a vertex in common, by its number, are not asked about.
struct MeshImpact {
  MeshFeature a;
  MeshFeature b;
  TimeOfImpact time;
  /// Without a separation `exact`, always. With one, ImpactOptions says what the status means for the time.
  Status status = Status::exact;
  friend constexpr bool operator==(const MeshImpact&, const MeshImpact&) = default;
};

struct ImpactOptions {
  /// What counts as meeting: to be at most so far apart, in the unit of the coordinates. 0 is contact, decided exactly.
  /// Else the distance is more at all times before `lower`, which is proved, and
  ///  - `exact`: it is not more at `upper`, at most 2^-30 later;
  ///  - `undecided`: it comes so near to it between `lower` and `upper` that rounding leaves it open;
  ///  - `not_converged`: features that turn about each other at nearly this distance; nothing is known after `lower`.
  double separation = 0;
  /// The start is known to be free of contact, because the step before has been found so and ended where this one
  /// starts, to the bit: then no edge is looked at that might pierce a face at the start.
  bool starts_free = false;
  int threads = own_thread;
  Progress progress{};
};

// All are exact without a separation, and the same on any number of threads. They throw Error for a separation that is
// negative or not finite. Those that return times, asked without one, throw it, too, when a start that was promised to
// be free is not, as far as that was looked at, and name the two features.

/// Whether any two features meet.
[[nodiscard]] bool meets(const DeformingMesh& mesh, const ImpactOptions& options = {});
[[nodiscard]] bool meets(const DeformingMesh& a, const DeformingMesh& b, const ImpactOptions& options = {});

/// The first two to meet: the least by (time.lower, time.upper, a, b).
[[nodiscard]] std::optional<MeshImpact> first_impact(const DeformingMesh& mesh, const ImpactOptions& options = {});
[[nodiscard]] std::optional<MeshImpact> first_impact(const DeformingMesh& a, const DeformingMesh& b,
                                                     const ImpactOptions& options = {});

/// All that meet, each two once, ascending in the same order.
[[nodiscard]] std::vector<MeshImpact> impacts(const DeformingMesh& mesh, const ImpactOptions& options = {});
[[nodiscard]] std::vector<MeshImpact> impacts(const DeformingMesh& a, const DeformingMesh& b,
                                              const ImpactOptions& options = {});

/// A part of the step in which nothing meets.
struct FreeStep {
  /// At no time in [0, fraction] does anything meet. Where something meets later, it is at most 2^-40 less than
  /// the time of the first impact (than its `lower` with a separation).
  double fraction = 1;
  /// What ends it. It has time 0 where the start is not free; then the fraction is 0 and means nothing.
  std::optional<MeshImpact> limited_by;
};

[[nodiscard]] FreeStep free_step(const DeformingMesh& mesh, const ImpactOptions& options = {});
[[nodiscard]] FreeStep free_step(const DeformingMesh& a, const DeformingMesh& b, const ImpactOptions& options = {});

/// For each vertex a fraction of its own way: whichever part of it each vertex goes, up to that, and however fast each
/// goes, nothing meets. So vertices that nothing is near may go all their way while others stop. 0 for the vertices of
/// features that meet at the start. (Each may stop where it wants, so this cannot be read off the times at which
/// something meets: where one stops, what it would have moved away from may hit it.)
[[nodiscard]] std::vector<double> free_steps(const DeformingMesh& mesh, const ImpactOptions& options = {});

struct FreeSteps {
  std::vector<double> of_a;
  std::vector<double> of_b;
};
[[nodiscard]] FreeSteps free_steps(const DeformingMesh& a, const DeformingMesh& b, const ImpactOptions& options = {});

}  // namespace toccata
