#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "toccata/bounds/all_volumes.hpp"
#include "toccata/core/parallel.hpp"
#include "toccata/query/pair_query.hpp"
#include "toccata/shapes/triangle_mesh.hpp"
#include "toccata/trees/builders.hpp"
#include "toccata/trees/walk.hpp"

// What a question about two meshes costs with each bounding volume and hierarchy, measured on these meshes:
// F = N_u·C_u + N_bv·C_bv + N_p·C_p (H. Weghorst, G. Hooper, D. P. Greenberg, "Improved computational methods for ray
// tracing", 1984; S. Gottschalk, M. C. Lin, D. Manocha, "OBBTree", 1996, section 2; with N_u, J. T. Klosowski et al.,
// "Efficient collision detection using bounding volume hierarchies of k-DOPs", 1998, section 3).
namespace toccata {

/// What surrounds the nodes. `wide` is the library's own tree, eight aligned boxes side by side (turned ones for
/// distances), and the library's own question; all others are walked by the same plain walker.
enum class CostVolume : std::uint8_t { wide = AllVolumes::size };

/// `cost_volume<Obb>`: the others are the places of AllVolumes.
template <ListedVolume V>
requires(AllVolumes::has<V>) inline constexpr CostVolume cost_volume =
    static_cast<CostVolume>(AllVolumes::place_of<V>());

/// All volumes in the order of AllVolumes, `wide` last.
inline constexpr auto all_cost_volumes = [] {
  std::array<CostVolume, AllVolumes::size + 1> all{};
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = static_cast<CostVolume>(i);
  return all;
}();

/// What happens between two queries, and so what N_u counts.
enum class CostWorkload {
  rigid,    ///< the meshes move as they are: of a mesh that is not at the identity, each volume that is looked at
  refit,    ///< every vertex has moved: all volumes, put around the new triangles by `refit`
  rebuild,  ///< the same, and both hierarchies are built anew: all volumes
};

inline constexpr std::array all_cost_workloads{CostWorkload::rigid, CostWorkload::refit, CostWorkload::rebuild};

/// What is asked of the surfaces of the two meshes.
enum class CostTask {
  overlap,   ///< whether they meet; ends with the first two triangles that do
  contacts,  ///< how many pairs of triangles meet
  distance,  ///< how far apart they are
};

/// The usual one first.
inline constexpr std::array all_bvh_methods{BvhMethod::heuristic,     BvhMethod::mean,   BvhMethod::median,
                                            BvhMethod::equal_regions, BvhMethod::morton, BvhMethod::agglomeration,
                                            BvhMethod::insertion};

// The names as the command writes them: "aabb", "26-dop", "rigid", "overlap", "heuristic".
[[nodiscard]] std::string_view name_of(CostVolume volume);
[[nodiscard]] std::string_view name_of(CostWorkload workload);
[[nodiscard]] std::string_view name_of(CostTask task);
[[nodiscard]] std::string_view name_of(BvhMethod method);

struct CostOptions {
  CostTask task = CostTask::overlap;
  std::vector<CostWorkload> workloads{all_cost_workloads.begin(), all_cost_workloads.end()};
  std::vector<CostVolume> volumes{all_cost_volumes.begin(), all_cost_volumes.end()};
  std::vector<int> arities{2, 4, 8};  ///< each 2 to 8
  std::vector<BvhMethod> methods{all_bvh_methods.begin(), all_bvh_methods.end()};
  Index leaf_size = 2;
  std::size_t most_rigid = 8;     ///< where there are more queries, so many are measured, evenly chosen
  std::size_t most_updating = 1;  ///< the same for the other workloads, each query of which touches every volume
  /// How long all may take, in microseconds, very roughly. What would take longer is left out, the dearest volumes over
  /// the last of the methods first, and `CostTable::left_out` says so. It is judged by counts and not by the clock: the
  /// same rows are left out everywhere.
  double most_work = 6e6;
  Progress progress{};
};

/// One combination, over all its queries.
struct CostRow {
  CostWorkload workload = CostWorkload::rigid;
  CostVolume volume{};
  int arity = 2;
  BvhMethod method = BvhMethod::heuristic;
  Index leaf_size = 1;
  std::size_t queries = 0;
  WalkCounts counts;  ///< N_u, N_bv and N_p, summed over the queries. They depend on the input alone.
  // The time of one operation, in nanoseconds, measured on some hundreds of those that the queries made.
  double update_ns = 0;    ///< C_u
  double test_ns = 0;      ///< C_bv; of `wide` with all the rest of the query, which is not taken apart
  double item_ns = 0;      ///< C_p; of `wide` 0
  double measured_ns = 0;  ///< the queries as they ran, with the walk itself and the memory it waits for
  double build_ns = 0;     ///< to build both hierarchies
  std::size_t nodes = 0;   ///< of both hierarchies
  std::size_t bytes = 0;
  int greatest_depth = 0;

  // The costs of one query, in nanoseconds, on average.
  [[nodiscard]] double update_cost() const { return of_query(counts.volumes_updated, update_ns); }
  [[nodiscard]] double test_cost() const { return of_query(counts.volume_tests, test_ns); }
  [[nodiscard]] double item_cost() const { return of_query(counts.items, item_ns); }
  /// F.
  [[nodiscard]] double cost() const { return update_cost() + test_cost() + item_cost(); }

 private:
  [[nodiscard]] double of_query(std::size_t count, double each) const {
    return queries == 0 ? 0 : static_cast<double>(count) * each / static_cast<double>(queries);
  }
};

struct CostTable {
  CostTask task = CostTask::overlap;
  std::vector<CostRow> rows;  ///< by workload, then by F, cheapest first
  std::vector<double>
      answers;  ///< of the rigid queries that were measured, if any: 0 or 1, a number of pairs, a distance
  std::vector<std::string> left_out;  ///< what is not in the table and why, in words
};

/// Measures every combination on these meshes at these poses; of the queries only the poses matter, the meshes are
/// taken as surfaces. Every row has to give the same answers: throws Error when one does not, when there is no query,
/// when nothing is asked for, for an arity other than 2 to 8, and when a world vertex is not finite. Runs on the
/// caller's thread.
[[nodiscard]] CostTable measure_costs(const TriangleMesh& a, const TriangleMesh& b, std::span<const PairQuery> queries,
                                      const CostOptions& options = {});

/// Which row of a workload is the cheapest, and why, in words, a line each; empty where the workload has no row.
[[nodiscard]] std::vector<std::string> explain_winner(const CostTable& table, CostWorkload workload);

/// A volume around a whole mesh, and the hierarchy of such volumes, on its own.
struct VolumeCost {
  CostVolume volume{};
  int arity = 2;
  BvhMethod method = BvhMethod::heuristic;
  double root_volume = 0;   ///< of the volume around the whole mesh, in its units cubed
  double root_surface = 0;  ///< in units squared
  double fill = 0;          ///< the part of it that the mesh's convex hull takes up; 1 at best, 0 for flat meshes
  BvhBalance balance;
  std::size_t bytes = 0;
  double build_ns = 0;
};

/// What each volume and hierarchy is over this mesh; `task`, `workloads` and the numbers of queries play no part, and
/// `wide` is not among them. Throws like `measure_costs`.
[[nodiscard]] std::vector<VolumeCost> measure_volumes(const TriangleMesh& mesh, const CostOptions& options = {});

/// How well a volume fits, rounded, in the units of its points.
struct Tightness {
  double volume = 0;
  double surface = 0;
  /// The part of its volume that the convex hull of what it holds takes up; 1 at best, 0 for flat things.
  double fill = 0;
};

template <BoundingVolume V>
[[nodiscard]] Tightness tightness(const V& volume, const ConvexHull& held) {
  const double size = measure(volume);
  return {size, surface_area(volume), size > 0 ? measure(held) / size : 0};
}

}  // namespace toccata
