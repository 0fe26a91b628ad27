#include "query/distance/nearby.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>
#include <variant>

#include "query/ask.hpp"
#include "query/distance/mesh_distance.hpp"
#include "query/keep_least.hpp"
#include "query/near_parts.hpp"
#include "query/numbered.hpp"
#include "query/part_questions.hpp"
#include "query/search_scratch.hpp"

namespace toccata {
namespace {

struct AskNearby {
  static constexpr ShapeQuestion question = ShapeQuestion::distance;

  std::optional<Nearby> operator()(const PosedPolytope& a, const PosedPolytope& b) const {
    return nearby(a, b, wanted, &scratch.convex);
  }
  template <class A, class B>
  requires requires(const A& a, const B& b) { nearby(a, b, WantedDistance{}); }
  std::optional<Nearby> operator()(const A& a, const B& b) const { return nearby(a, b, wanted); }
  template <class Other>
  std::optional<Nearby> operator()(const PosedTriangles& a, const Other& b) const {
    return nearby(a, b, wanted, scratch);
  }

  const WantedDistance& wanted;
  SearchScratch& scratch;
};

}  // namespace

std::optional<Nearby> nearby(const PosedPart& a, const PosedPart& b, const WantedDistance& wanted,
                             SearchScratch& scratch) {
  std::optional<Nearby> found = ask(AskNearby{wanted, scratch}, a, b);
  if (found) found->distance = numbered(found->distance, a, b);
  return found;
}

namespace {

/// The nearest of pairs of parts, which come by the gaps of their boxes: the answer is the one that all pairs,
/// ascending, would have.
class NearestParts {
 public:
  NearestParts(const WantedDistance& wanted, SearchScratch& scratch) : wanted_(wanted), scratch_(scratch) {}

  /// Pairs whose boxes are farther apart change nothing; negative when none can. Among parts that meet the first
  /// counts, and their boxes meet. Else the lower ends of intervals count too.
  [[nodiscard]] double limit() const { return is_enough() ? -1 : search_limit(wanted_); }

  void look_at(const PosedPart& a, const PosedPart& b) {
    if (is_farther(a, b)) return;
    const std::optional<Nearby> found = nearby(a, b, wanted_, scratch_);
    if (!found) return;
    is_within_ = is_within_ || found->is_within;
    keep(found->distance, {&a, &b});
    if (is_within_ && !is_enough()) wanted_.limit = least_->upper;
  }

  [[nodiscard]] std::optional<Nearby> answer() const {
    if (!least_) return {};
    return Nearby{*least_, is_within_};
  }

 private:
  using Parts = std::pair<const PosedPart*, const PosedPart*>;
  struct Kept : Distance {
    Parts parts;
  };

  [[nodiscard]] bool is_enough() const { return least_ && least_->upper <= std::max(wanted_.enough, 0.0); }

  /// Whether two parts are certainly farther apart than the least distance so far. It is not asked of shapes with few
  /// vertices, whose distance is as quick.
  [[nodiscard]] bool is_farther(const PosedPart& a, const PosedPart& b) const {
    constexpr Index few_vertices = 16;
    const auto* convex_a = std::get_if<PosedPolytope>(&a.shape);
    const auto* convex_b = std::get_if<PosedPolytope>(&b.shape);
    return least_ && convex_a && convex_b && convex_a->vertex_count() + convex_b->vertex_count() > few_vertices &&
           certainly_beyond(*convex_a, *convex_b, limit_from(least_->upper), &scratch_.convex);
  }

  void keep(const Distance& found, const Parts& parts) {
    keep_least(least_, {found, parts}, [](const Kept& kept) { return std::tie(kept.upper, kept.parts); });
  }

  WantedDistance wanted_;
  SearchScratch& scratch_;
  std::optional<Kept> least_;
  bool is_within_ = false;
};

}  // namespace

std::optional<Nearby> nearby(const Model& a, const Model& b, const WantedDistance& wanted, const PairQuery& query,
                             Workspace& workspace) {
  SearchScratch& scratch = workspace.scratch();
  scratch.counts = {};
  const PosedModelPair models(a, b, query, scratch);
  if (std::isinf(wanted.enough)) return Nearby{{.upper = infinity}};
  if (models.are_single()) return nearby(models.a.parts[0], models.b.parts[0], wanted, scratch);
  NearestParts nearest(wanted, scratch);
  NearParts pairs(models.a, models.b, gap_of_parts, nearest.limit(), scratch);
  while (const std::optional<ItemPair> next = pairs.next(nearest.limit()))
    nearest.look_at(models.a.parts[next->first], models.b.parts[next->second]);
  return nearest.answer();
}

}  // namespace toccata
