#include "narrow/convex_cells.hpp"
#include "query/smooth_meshes_checks.hpp"

// Smooth shapes against solids, surfaces and height fields: every question against all triangles asked one by one.
namespace toccata::test {
namespace {

std::vector<std::string> cells_of_smooth_meshes() {
  std::vector<std::string> cells;
  for (const std::string& kind : smooth_kinds())
    for (const std::string& mesh : smooth_mesh_kinds()) cells.push_back(kind + "/" + mesh);
  return cells;
}

SweepResult run_smooth_meshes(const std::string& cell, std::uint64_t seed, std::uint64_t cases) {
  SweepResult result;
  Random random = random_of_cell(cell, seed);
  const std::size_t slash = cell.find('/');
  for (; result.cases < cases; ++result.cases) {
    const std::string& regime = smooth_mesh_regimes()[result.cases % smooth_mesh_regimes().size()];
    const SmoothMeshCase one = smooth_mesh_case(cell.substr(0, slash), cell.substr(slash + 1), regime, random);
    const std::string wrong = fault_of(one, random);
    if (!wrong.empty() && result.wrong++ == 0)
      result.first_failure = fmt::format("{}, case {} ({}) of seed {}", wrong, result.cases, regime, seed);
  }
  return result;
}

const bool known_smooth_meshes =
    register_sweep({"smooth-meshes", cells_of_smooth_meshes(), 10'000, 11, run_smooth_meshes, 220, 11});

}  // namespace
}  // namespace toccata::test
