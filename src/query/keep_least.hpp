#pragma once

#include <algorithm>
#include <optional>

#include "narrow/near.hpp"

namespace toccata {

/// The ends of what is known about the number by which answers are compared.
template <class Certified>
auto& interval_of(Certified& answer) {
  if constexpr (requires { answer.distance; })
    return answer.distance;
  else
    return answer;
}

/// Keeps, of answers that are told one after the other, the one with the least upper end, and widens its interval so
/// that the least of all exact numbers lies in it: another may begin lower and end higher. It is as wide as one of them
/// at most. Of equal upper ends the first by `rank` is kept, which is a tuple that begins with them, or else the one
/// that was told first.
template <class Certified, class Rank>
void keep_least(std::optional<Certified>& least, const Certified& found, const Rank& rank) {
  double lower = interval_of(found).lower;
  if (least) lower = std::min(lower, interval_of(*least).lower);
  if (!least || rank(found) < rank(*least)) least = found;
  interval_of(*least).lower = lower;
}

template <class Certified>
void keep_least(std::optional<Certified>& least, const Certified& found) {
  keep_least(least, found, [](const Certified& answer) { return interval_of(answer).upper; });
}

/// What is certainly farther than this neither is the least distance nor widens its interval.
template <class Certified>
double last_distance(const std::optional<Certified>& least, double max_distance) {
  if (!least) return max_distance;
  const double upper = interval_of(*least).upper;
  return upper == 0 ? 0 : std::min(limit_from(upper), max_distance);
}

}  // namespace toccata
