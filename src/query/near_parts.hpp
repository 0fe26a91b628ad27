#pragma once

#include <optional>

#include "bounds/box_bounds.hpp"
#include "query/posed_shape.hpp"
#include "query/search_scratch.hpp"
#include "toccata/core/function_ref.hpp"

namespace toccata {

/// A bound of two parts by their boxes: their gap, or when one first meets the other. For boxes within these it is
/// never less.
using BoundOfBoxes = FunctionRef<double(const Aabb&, const Aabb&)>;

/// The pairs of parts of two models, the ones of the least bound first. Only those boxes of the two are compared that
/// may matter: a tree over the parts of each tells which (best first; G. Hjaltason, H. Samet, "Incremental distance
/// join algorithms for spatial databases", 1998).
class NearParts {
 public:
  /// Those whose bound is not above the limit. The bound has to outlive this.
  NearParts(const PosedModel& a, const PosedModel& b, BoundOfBoxes bound, double limit, SearchScratch& scratch);

  /// The next pair; of those with one bound, the first. Nothing when the bounds of all that are left are above the
  /// limit.
  [[nodiscard]] std::optional<ItemPair> next(double limit);

 private:
  void push(const PartPair& pair, double limit);
  void open(const ItemPair& nodes, double limit);

  SearchScratch& scratch_;
  BoundOfBoxes bound_;
};

/// How far apart two boxes are at least. A mesh without triangles has no box, and is infinitely far from all.
inline constexpr auto gap_of_parts = [](const Aabb& a, const Aabb& b) {
  return is_empty(a) ? box_gap(b, a) : box_gap(a, b);
};

}  // namespace toccata
