// Meshes that deform against the oracle, every pair of features, with what must not change the answer.
#include <fmt/format.h>

#include <algorithm>

#include "motion/approach.hpp"
#include "support/case_seeds.hpp"
#include "support/deforming_cases.hpp"
#include "support/deforming_judge.hpp"
#include "support/motion_cases.hpp"

namespace toccata::test {
namespace {

/// The features and times with those of the two meshes exchanged, in the order of answers.
std::vector<MeshImpact> exchanged(std::vector<MeshImpact> found) {
  for (MeshImpact& impact : found) std::swap(impact.a, impact.b);
  std::sort(found.begin(), found.end(), [](const MeshImpact& x, const MeshImpact& y) {
    return std::tie(x.time.lower, x.time.upper, x.a, x.b) < std::tie(y.time.lower, y.time.upper, y.a, y.b);
  });
  return found;
}

/// How many vertices and faces, and edges, meet at any time.
std::size_t hits(const std::vector<MeshImpact>& found) {
  return static_cast<std::size_t>(std::count_if(found.begin(), found.end(), [](const MeshImpact& i) {
    return (i.a.kind == FeatureKind::edge) == (i.b.kind == FeatureKind::edge);
  }));
}

DeformingCase backwards(const DeformingCase& made) {
  return {made.mesh.with_vertices(made.end), {made.mesh.vertices().begin(), made.mesh.vertices().end()}};
}

/// Vertices and triangles in the opposite order.
DeformingCase permuted(const DeformingCase& made) {
  const auto last = static_cast<Index>(made.end.size() - 1);
  std::vector<Vec3> start(made.mesh.vertices().rbegin(), made.mesh.vertices().rend()),
      end(made.end.rbegin(), made.end.rend());
  std::vector<std::array<Index, 3>> triangles;
  for (const auto& [a, b, c] : made.mesh.triangles()) triangles.push_back({last - b, last - a, last - c});
  std::reverse(triangles.begin(), triangles.end());
  return {{std::move(start), std::move(triangles)}, std::move(end)};
}

std::vector<TimeOfImpact> times_of(const std::vector<MeshImpact>& found) {
  std::vector<TimeOfImpact> times;
  for (const MeshImpact& impact : found) times.push_back(impact.time);
  return times;
}

std::string fault_of_one(const DeformingCase& made) {
  const DeformingMesh mesh = made.made();
  const std::vector<MeshImpact> found = impacts(mesh, {.threads = 2});
  if (const auto wrong = wrong_impacts(DeformingPair(mesh), found, FeatureJudge::oracle)) return *wrong;
  if (hits(impacts(backwards(made).made())) != hits(found)) return "the time reversed changes what meets";
  if (times_of(impacts(permuted(made).made())) != times_of(found)) return "another order of vertices changes the times";
  if (meets(mesh) == found.empty()) return "meets";
  const FreeStep step = free_step(mesh);
  if (step.limited_by.has_value() == found.empty()) return "free_step";
  if (step.limited_by && *step.limited_by != found.front()) return "free_step is limited by another";
  DeformingMesh moved(made.mesh);
  static_cast<void>(moved.move_to(made.end));
  return impacts(moved) == found ? "" : "the tree refitted changes the answer";
}

std::string fault_of_two(const DeformingCase& first, const DeformingCase& second) {
  const DeformingMesh a = first.made(), b = second.made();
  const std::vector<MeshImpact> found = impacts(a, b);
  if (const auto wrong = wrong_impacts({a, b}, found, FeatureJudge::oracle)) return "of two: " + *wrong;
  return impacts(b, a, {.threads = 2}) == exchanged(found) ? "" : "the meshes exchanged change the answer";
}

SweepResult run_deforming(const std::string& family, std::uint64_t seed, std::uint64_t cases) {
  return run_cases_at_simd_levels(family, seed, cases, [&](std::uint64_t case_seed) {
    Random random(case_seed);
    const DeformingCase first = random_deforming_case(family, random);
    const std::string fault = fault_of_one(first);
    return fault.empty() ? fault_of_two(first, random_deforming_case(family, random)) : fault;
  });
}

// A case is some thousand pairs of features, each judged by polynomials in rationals.
const bool deforming_known = register_sweep({.name = "deforming-meshes",
                                             .families = deforming_families(),
                                             .goal = 500,
                                             .slice = 4,
                                             .run = run_deforming,
                                             .shard = 50,
                                             .thin_slice = 1});

/// The verdict on one mesh and on two, and how many pairs of features were judged, at least one.
ImpactVerdict verdict_on_pairs(const std::string& family, std::uint64_t case_seed) {
  Random random(case_seed);
  const DeformingMesh a = random_deforming_case(family, random).made(),
                      b = random_deforming_case(family, random).made();
  ImpactVerdict verdict = verdict_on_impacts(DeformingPair(a), impacts(a), FeatureJudge::oracle);
  const ImpactVerdict of_two = verdict_on_impacts({a, b}, impacts(a, b), FeatureJudge::oracle);
  if (!verdict.wrong) verdict.wrong = of_two.wrong;
  verdict.judged = std::max<std::size_t>(1, verdict.judged + of_two.judged);
  return verdict;
}

SweepResult run_pairs(const std::string& family, std::uint64_t seed, std::uint64_t cases) {
  SweepResult result;
  Random seeds(seed);
  while (result.cases < cases) {
    const std::uint64_t case_seed = seeds.bits();
    const ImpactVerdict verdict = verdict_on_pairs(family, case_seed);
    result.cases += verdict.judged;
    if (verdict.wrong && result.wrong++ == 0)
      result.first_failure = fmt::format("{}, case seed {}: {}", family, case_seed, *verdict.wrong);
  }
  return result;
}

// Here a case is a pair of features that come near each other on their ways, judged by polynomials in rationals. Where
// a mesh is wrong, it counts once.
const bool pairs_known = register_sweep({.name = "deforming-pairs",
                                         .families = deforming_families(),
                                         .goal = 100'000,
                                         .slice = 200,
                                         .run = run_pairs,
                                         .shard = 2000,
                                         .thin_slice = 50});

template <class Pair>
std::string fault_of_separation(const Pair& pair, const Pair& reordered, double separation) {
  const std::optional<Approach> told = time_of_approach(differences(pair), separation);
  std::optional<MeshImpact> impact;
  if (told) impact = {{}, {}, told->time, told->status};
  if (const auto wrong = wrong_approach(pair, impact, separation)) return fmt::format("{} of {:a}", *wrong, separation);
  return time_of_approach(differences(reordered), separation) == told ? "" : "another order changes the answer";
}

/// About the size of the coordinates, and less.
double random_separation(const MovingPoints& points, Random& random) {
  double size = 0;
  for (const MovingPoint& p : points) size = std::max({size, std::abs(p.start.x), std::abs(p.end.y)});
  size = std::min(std::max(size, 0x1p-1000), 0x1p1000);
  return std::ldexp(random.between(0.5, 1) * size, -static_cast<int>(random.below(20)));
}

SweepResult run_separations(const std::string& family, std::uint64_t seed, std::uint64_t cases) {
  return run_cases(family, seed, cases, [&](std::uint64_t case_seed) -> std::string {
    Random random(case_seed);
    for (const MotionFamily& known : feature_families()) {
      if (known.name != family) continue;
      const MovingPoints p = known.draw(random);
      const double separation = random_separation(p, random);
      const VertexFace pair = vertex_face(p);
      const auto& [v, f] = pair;
      const EdgeEdge edges = edge_edge(p);
      const std::string fault = fault_of_separation(pair, VertexFace{v, {f[2], f[0], f[1]}}, separation);
      return fault.empty() ? fault_of_separation(edges, EdgeEdge{edges.b, {edges.a[1], edges.a[0]}}, separation)
                           : fault;
    }
    return "no such family";
  });
}

std::vector<std::string> names_of_features() {
  std::vector<std::string> names;
  for (const MotionFamily& family : feature_families()) names.push_back(family.name);
  return names;
}

const bool separations_known = register_sweep({.name = "time-of-approach",
                                               .families = names_of_features(),
                                               .goal = 100'000,
                                               .slice = 100,
                                               .run = run_separations,
                                               .shard = 1000,
                                               .thin_slice = 10});

}  // namespace
}  // namespace toccata::test
