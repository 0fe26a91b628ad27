#pragma once

#include <optional>

#include "query/posed_shape.hpp"
#include "query/search_scratch.hpp"

namespace toccata {

/// The pairs of parts of two models by the gaps of their boxes.
class NearParts {
 public:
  /// Those whose boxes are not farther apart than the limit.
  NearParts(const PosedModel& a, const PosedModel& b, double limit, SearchScratch& scratch);

  /// The next pair, the nearest first, the first of those that are as near; nothing when all that are left are farther
  /// apart than the limit.
  [[nodiscard]] std::optional<ItemPair> next(double limit);

 private:
  SearchScratch& scratch_;
};

}  // namespace toccata
