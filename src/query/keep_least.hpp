#pragma once

#include <algorithm>
#include <optional>

namespace toccata {

/// Keeps, of intervals that are told one after the other, the one with the least upper end, the first among equals, and
/// widens it so that the least of all exact numbers lies in it: another may begin lower and end higher. It is as wide
/// as one of them at most.
template <class Certified>
void keep_least(std::optional<Certified>& least, const Certified& found) {
  const double lower = least ? std::min(least->lower, found.lower) : found.lower;
  if (!least || found.upper < least->upper) least = found;
  least->lower = lower;
}

}  // namespace toccata
