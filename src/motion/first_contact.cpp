#include "toccata/motion/first_contact.hpp"

#include "motion/moving_polygon.hpp"
#include "motion/volume_filter.hpp"
#include "toccata/core/error.hpp"

namespace toccata {
namespace {

/// An infinite or NaN coordinate makes the sum so; a sum of finite ones that overflows is looked at again.
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
  const RoundedPolygon<Count> corners = rounded(polygon);
  for (int axis = 0; axis < 3; ++axis)
    if (is_apart_along(corners, axis)) return {};
  if (bernstein_volume(corners[0], corners[1], corners[2]).is_certainly_not_zero()) return {};
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
