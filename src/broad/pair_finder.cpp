#include "broad/pair_finder.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include <fmt/format.h>

#include "broad/finders.hpp"
#include "toccata/core/error.hpp"

namespace toccata {
namespace {

struct KnownMethod {
  BroadPhaseMethod method;
  std::string_view name;
};

constexpr std::array known_methods{
    KnownMethod{BroadPhaseMethod::automatic, "auto"},
    KnownMethod{BroadPhaseMethod::brute_force, "brute-force"},
    KnownMethod{BroadPhaseMethod::sort_and_sweep, "sort-and-sweep"},
    KnownMethod{BroadPhaseMethod::uniform_grid, "grid"},
    KnownMethod{BroadPhaseMethod::kd_tiles, "kd-tiles"},
    KnownMethod{BroadPhaseMethod::morton_tree, "morton-tree"},
    KnownMethod{BroadPhaseMethod::packed_r_tree, "packed-r-tree"},
    KnownMethod{BroadPhaseMethod::r_tree, "r-tree"},
    KnownMethod{BroadPhaseMethod::layers, "layers"},
    KnownMethod{BroadPhaseMethod::dynamic_tree, "dynamic-tree"},
    KnownMethod{BroadPhaseMethod::loose_octree, "loose-octree"},
    KnownMethod{BroadPhaseMethod::incremental_sweep, "incremental-sweep"},
    KnownMethod{BroadPhaseMethod::spatial_hash, "spatial-hash"},
    KnownMethod{BroadPhaseMethod::hierarchical_hash, "hierarchical-hash"},
    KnownMethod{BroadPhaseMethod::interval_sweeps, "interval-sweeps"},
    KnownMethod{BroadPhaseMethod::rectangle_sweeps, "rectangle-sweeps"},
};

}  // namespace

std::string_view name_of(BroadPhaseMethod method) {
  for (const KnownMethod& known : known_methods)
    if (known.method == method) return known.name;
  return {};
}

std::span<const BroadPhaseMethod> broad_phase_methods() {
  static const auto methods = [] {
    std::array<BroadPhaseMethod, known_methods.size()> all{};
    std::transform(known_methods.begin(), known_methods.end(), all.begin(),
                   [](const KnownMethod& k) { return k.method; });
    return all;
  }();
  return methods;
}

BroadPhaseMethod broad_phase_method(std::string_view name) {
  for (const KnownMethod& known : known_methods)
    if (known.name == name) return known.method;
  std::vector<std::string> names;
  for (const KnownMethod& known : known_methods) names.emplace_back(known.name);
  throw Error(fmt::format("there is no broad phase '{}'{}", name, suggestion(std::string(name), names)));
}

std::unique_ptr<PairFinder> make_pair_finder(const BroadPhaseOptions& options) {
  switch (options.method) {
    case BroadPhaseMethod::brute_force:
      return make_brute_force();
    case BroadPhaseMethod::sort_and_sweep:
      return make_sort_and_sweep();
    case BroadPhaseMethod::uniform_grid:
      return make_uniform_grid();
    case BroadPhaseMethod::kd_tiles:
      return make_kd_tiles();
    case BroadPhaseMethod::morton_tree:
      return make_morton_tree();
    case BroadPhaseMethod::packed_r_tree:
      return make_packed_r_tree();
    case BroadPhaseMethod::r_tree:
      return make_r_tree();
    case BroadPhaseMethod::layers:
      return make_layers();
    case BroadPhaseMethod::incremental_sweep:
      return make_incremental_sweep();
    case BroadPhaseMethod::spatial_hash:
      return make_spatial_hash(options.hash_cell);
    case BroadPhaseMethod::hierarchical_hash:
      return make_hierarchical_hash();
    case BroadPhaseMethod::interval_sweeps:
      return make_interval_sweeps();
    case BroadPhaseMethod::rectangle_sweeps:
      return make_rectangle_sweeps();
    case BroadPhaseMethod::dynamic_tree:
      return make_dynamic_tree();
    case BroadPhaseMethod::loose_octree:
      return make_loose_octree();
    case BroadPhaseMethod::automatic:
      break;
  }
  return make_automatic();
}

}  // namespace toccata
