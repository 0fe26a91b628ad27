// Moving features against the oracle, with what must not change the answer.
#include <cmath>

#include "motion/moving_polygon.hpp"
#include "support/motion_cases.hpp"
#include "support/motion_judge.hpp"
#include "support/sweep.hpp"

namespace toccata::test {
namespace {

MovingPoint reversed(const MovingPoint& p) { return {p.end, p.start}; }

/// Twice as large, where nothing overflows.
std::optional<MovingPoints> doubled(MovingPoints points) {
  for (MovingPoint& p : points) {
    p = {2 * p.start, 2 * p.end};
    if (!is_finite(p.start) || !is_finite(p.end)) return std::nullopt;
  }
  return points;
}

/// The same question in another order, where the features are a vertex and a face.
std::optional<std::string> changed_answer(const VertexFace& pair, const std::optional<TimeOfImpact>& answer) {
  const auto& [v, f] = pair;
  if (time_of_impact(VertexFace{v, {f[1], f[2], f[0]}}) != answer) return "the corners turned";
  if (time_of_impact(VertexFace{v, {f[1], f[0], f[2]}}) != answer) return "two corners exchanged";
  const VertexFace backwards{reversed(v), {reversed(f[0]), reversed(f[1]), reversed(f[2])}};
  if (time_of_impact(backwards).has_value() != answer.has_value()) return "the time reversed";
  return std::nullopt;
}

std::optional<std::string> changed_answer(const EdgeEdge& pair, const std::optional<TimeOfImpact>& answer) {
  const auto& [a, b] = pair;
  if (time_of_impact(EdgeEdge{b, a}) != answer) return "the edges exchanged";
  if (time_of_impact(EdgeEdge{{a[1], a[0]}, b}) != answer) return "the ends of A exchanged";
  if (time_of_impact(EdgeEdge{a, {b[1], b[0]}}) != answer) return "the ends of B exchanged";
  const EdgeEdge backwards{{reversed(a[0]), reversed(a[1])}, {reversed(b[0]), reversed(b[1])}};
  if (time_of_impact(backwards).has_value() != answer.has_value()) return "the time reversed";
  return std::nullopt;
}

template <class Pair>
std::optional<std::string> wrong_with(const MovingPoints& points, Pair (*pair_of)(const MovingPoints&)) {
  const Pair pair = pair_of(points);
  const std::optional<TimeOfImpact> answer = time_of_impact(pair);
  if (auto wrong = wrong_answer(pair, answer)) return *wrong + ": " + told(pair);
  if (auto changed = changed_answer(pair, answer)) return *changed + " changes the answer: " + told(pair);
  // The last stage alone: what the others decide it decides too.
  if (time_of_impact_by_integers(differences(pair)) != answer) return "the integers differ: " + told(pair);
  const auto large = doubled(points);
  if (large && time_of_impact(pair_of(*large)) != answer) return "doubling changes the answer: " + told(pair);
  return std::nullopt;
}

SweepResult compare(const std::string& family, std::uint64_t seed, std::uint64_t cases) {
  SweepResult result;
  for (const MotionFamily& f : feature_families()) {
    if (f.name != family) continue;
    Random random(seed);
    for (; result.cases < cases; ++result.cases) {
      const MovingPoints points = f.draw(random);
      auto wrong = wrong_with(points, vertex_face);
      if (!wrong) wrong = wrong_with(points, edge_edge);
      if (wrong && result.wrong++ == 0) result.first_failure = *wrong;
    }
  }
  return result;
}

std::vector<std::string> family_names() {
  std::vector<std::string> names;
  for (const MotionFamily& family : feature_families()) names.push_back(family.name);
  return names;
}

const bool known = register_sweep({.name = "time-of-impact",
                                   .families = family_names(),
                                   .goal = 100'000,
                                   .slice = 200,
                                   .run = compare,
                                   .shard = 1000,
                                   .thin_slice = 20});

}  // namespace
}  // namespace toccata::test
