#include "toccata/motion/first_contact.hpp"

#include "motion/certain_contact.hpp"
#include "motion/moving_polygon.hpp"
#include "toccata/core/error.hpp"

namespace toccata {
namespace {

template <std::size_t Count>
void check_finite(const MovingPolygon<Count>& polygon) {
  for (const MovingCorner& c : polygon)
    for (const MovingPoint* point : {c.head, c.tail})
      if (!is_finite(point->start) || !is_finite(point->end))
        throw Error("first_contact: a coordinate is not finite; give the positions at both times as finite numbers");
}

template <std::size_t Count>
FirstContact first_contact_of(const MovingPolygon<Count>& polygon) {
  check_finite(polygon);
  if (const std::optional<FirstContact> answer = certain_first_contact(polygon)) return *answer;
  return first_contact_by_integers(polygon);
}

template <class Pair>
std::vector<FirstContact> answer_each(std::span<const Pair> pairs, int threads) {
  std::vector<FirstContact> answers(pairs.size());
  parallel_for(pairs.size(), threads, [&](std::size_t i) { answers[i] = first_contact(pairs[i]); });
  return answers;
}

}  // namespace

FirstContact first_contact(const VertexFace& pair) { return first_contact_of(differences(pair)); }
FirstContact first_contact(const EdgeEdge& pair) { return first_contact_of(differences(pair)); }

std::vector<FirstContact> first_contact_each(std::span<const VertexFace> pairs, int threads) {
  return answer_each(pairs, threads);
}
std::vector<FirstContact> first_contact_each(std::span<const EdgeEdge> pairs, int threads) {
  return answer_each(pairs, threads);
}

}  // namespace toccata
