#include "narrow/convex_cells.hpp"

#include <fmt/format.h>
#include "query/quadric_meshes_checks.hpp"

// Quadrics against solids, surfaces and height fields: every question against all triangles asked one by one.
namespace toccata::test {
namespace {

std::vector<std::string> cells_of_quadric_meshes() {
  std::vector<std::string> cells;
  for (const std::string& kind : quadric_kinds())
    for (const std::string& mesh : quadric_mesh_kinds()) cells.push_back(fmt::format("{}/{}", kind, mesh));
  return cells;
}

SweepResult run_quadric_meshes(const std::string& cell, std::uint64_t seed, std::uint64_t cases) {
  SweepResult result;
  Random random = random_of_cell(cell, seed);
  const std::size_t slash = cell.find('/');
  for (; result.cases < cases; ++result.cases) {
    const std::string& regime = quadric_mesh_regimes()[result.cases % quadric_mesh_regimes().size()];
    const QuadricMeshCase one = quadric_mesh_case(cell.substr(0, slash), cell.substr(slash + 1), regime, random);
    const std::string wrong = fault_of(one, random);
    if (!wrong.empty() && result.wrong++ == 0)
      result.first_failure = fmt::format("{}, case {} ({}) of seed {}", wrong, result.cases, regime, seed);
  }
  return result;
}

const bool known_quadric_meshes =
    register_sweep({"quadric-meshes", cells_of_quadric_meshes(), 10'000, 11, run_quadric_meshes, 220, 11});

}  // namespace
}  // namespace toccata::test
