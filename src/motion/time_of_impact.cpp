#include "toccata/motion/time_of_impact.hpp"

#include <string>

#include "motion/certain_impact.hpp"
#include "motion/moving_polygon.hpp"
#include "toccata/core/error.hpp"

namespace toccata {
namespace {

template <std::size_t Count>
bool has_finite_points(const MovingPolygon<Count>& polygon) {
  for (const MovingCorner& c : polygon)
    for (const MovingPoint* point : {c.head, c.tail})
      if (!is_finite(point->start) || !is_finite(point->end)) return false;
  return true;
}

/// `which` says which of several pairs it is; empty for one alone.
template <class Pair>
void check_finite(const Pair& pair, const std::string& which = "") {
  if (!has_finite_points(differences(pair)))
    throw Error("time_of_impact: a coordinate" + which +
                " is not finite; give the positions at both times as finite numbers");
}

template <std::size_t Count>
std::optional<TimeOfImpact> time_of_polygon(const MovingPolygon<Count>& polygon) {
  if (const auto decided = certain_time_of_impact(polygon); decided.is_certain) return decided.answer;
  return time_of_impact_by_integers(polygon);
}

template <class Pair>
std::vector<std::optional<TimeOfImpact>> answer_each(std::span<const Pair> pairs, int threads) {
  for (std::size_t i = 0; i < pairs.size(); ++i) check_finite(pairs[i], " of pair " + std::to_string(i));
  std::vector<std::optional<TimeOfImpact>> answers(pairs.size());
  parallel_for(pairs.size(), threads, [&](std::size_t i) { answers[i] = time_of_finite(differences(pairs[i])); });
  return answers;
}

template <class Pair>
std::optional<TimeOfImpact> answer_of(const Pair& pair) {
  check_finite(pair);
  return time_of_finite(differences(pair));
}

}  // namespace

std::optional<TimeOfImpact> time_of_finite(const MovingPolygon<3>& polygon) { return time_of_polygon(polygon); }
std::optional<TimeOfImpact> time_of_finite(const MovingPolygon<4>& polygon) { return time_of_polygon(polygon); }

std::optional<TimeOfImpact> time_of_impact(const VertexFace& pair) { return answer_of(pair); }
std::optional<TimeOfImpact> time_of_impact(const EdgeEdge& pair) { return answer_of(pair); }

std::vector<std::optional<TimeOfImpact>> time_of_impact_each(std::span<const VertexFace> pairs, int threads) {
  return answer_each(pairs, threads);
}
std::vector<std::optional<TimeOfImpact>> time_of_impact_each(std::span<const EdgeEdge> pairs, int threads) {
  return answer_each(pairs, threads);
}

}  // namespace toccata
