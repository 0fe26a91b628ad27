#pragma once

#include <optional>
#include <utility>

#include "query/posed_shape.hpp"
#include "query/search_scratch.hpp"
#include "toccata/narrow/convex_convex.hpp"

namespace toccata {

/// The least distance of pairs of parts, which come as `PosedModelPair::visit_near` has them: the answer is the one
/// that all pairs, ascending, would have.
class LeastDistance {
 public:
  explicit LeastDistance(SearchScratch& scratch) : scratch_(scratch) {}

  [[nodiscard]] const std::optional<Distance>& found() const { return least_; }

  /// Pairs whose boxes are farther apart change nothing; negative when none can. What is given, before there is one.
  [[nodiscard]] double limit(double before) const;

  /// Proved to be farther apart than the limit, so that the distance need not be known.
  [[nodiscard]] bool is_farther(const PosedPart& a, const PosedPart& b) const;

  void keep(const Distance& found, const PosedPart& a, const PosedPart& b);

 private:
  SearchScratch& scratch_;
  std::optional<Distance> least_;
  std::pair<const PosedPart*, const PosedPart*> parts_{};
};

}  // namespace toccata
