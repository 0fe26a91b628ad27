#include "motion/tree_sweep.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "motion/item_contact.hpp"
#include "motion/stretch_view.hpp"
#include "query/casts/mesh_casts.hpp"

namespace toccata {
namespace {

/// A pair of boxes, one of each thing.
using BoxNumbers = std::array<std::uint32_t, 2>;

/// Deeper the stretches are not halved: boxes without extent travel farther than they are large at any time.
constexpr int most_halvings = 24;

class TreeSweep {
 public:
  TreeSweep(const MovingPart& a, const MovingPart& b, const Stretch& stretch, double stop_before, double limit,
            WalkCounts& counts)
      : things_{SweptThing(a, stretch), SweptThing(b, stretch)},
        all_(gap_bounds(a, b, stretch)),
        alike_(gap_bounds(things_[0].motion.alike, things_[1].motion.alike)),
        has_half_space_(a.is_half_space() || b.is_half_space()),
        stretch_(stretch),
        stop_before_(stop_before),
        limit_(limit),
        counts_(counts) {}

  std::optional<ShapeHit> answer() {
    if (things_[0].is_empty() || things_[1].is_empty()) return {};
    search(stretch_, {{SweptThing::whole, SweptThing::whole}}, 0);
    std::optional<ShapeHit> first;
    for (const ItemPair& items : candidates()) {
      // Found anew in the whole stretch, so that the numbers do not depend on how it was halved.
      if (const auto contact = contact_of(items, stretch_))
        keep_first(
            first,
            {{true, contact->lower, contact->upper, {}, contact->normal, contact->status}, items.first, items.second});
    }
    return first;
  }

 private:
  struct Found {
    double lower;
    ItemPair items;
  };

  [[nodiscard]] std::vector<ItemPair> candidates() const {
    std::vector<ItemPair> items;
    for (const Found& found : found_)
      if (found.lower <= limit_) items.push_back(found.items);
    std::sort(items.begin(), items.end());
    items.erase(std::unique(items.begin(), items.end()), items.end());
    return items;
  }

  void search(const Stretch& stretch, const std::vector<BoxNumbers>& pairs, int halvings) {
    const StretchView view(things_[0], things_[1], stretch);
    std::vector<BoxNumbers> open, later;
    for (const BoxNumbers& pair : pairs)
      if (!is_parted(view, 0, pair[0], pair[1], view.heights(1, pair[1]))) open.push_back(pair);
    while (!open.empty()) {
      const BoxNumbers pair = open.back();
      open.pop_back();
      if (things_[0].is_item(pair[0]) && things_[1].is_item(pair[1]))
        look_at({things_[0].item(pair[0]), things_[1].item(pair[1])}, stretch);
      else if (halvings < most_halvings && travels_far(pair, stretch))
        later.push_back(pair);
      else
        expand(view, pair, open);
    }
    if (later.empty()) return;
    const double middle = stretch.begin + 0.5 * (stretch.end - stretch.begin);
    search({stretch.begin, middle}, later, halvings + 1);
    if (middle < limit_) search({middle, stretch.end}, later, halvings + 1);
  }

  /// Opens the larger of the two.
  void expand(const StretchView& view, const BoxNumbers& pair, std::vector<BoxNumbers>& open) {
    const bool opens_b =
        things_[0].is_item(pair[0]) ||
        (!things_[1].is_item(pair[1]) && things_[1].extent(pair[1]).radius > things_[0].extent(pair[0]).radius);
    const std::size_t side = opens_b ? 1 : 0;
    const std::uint32_t other = pair[1 - side], block = things_[side].block_below(pair[side]);
    const StretchView::Heights other_heights = view.heights(1 - side, other);
    const std::uint32_t count = things_[side].tree->blocks[block].count;
    counts_.volume_tests += count;
    for (std::uint32_t lane = 0; lane < count; ++lane) {
      const std::uint32_t at = block << 3 | lane;
      if (is_parted(view, side, at, other, other_heights)) continue;
      open.push_back(side == 0 ? BoxNumbers{at, other} : BoxNumbers{other, at});
    }
  }

  /// Farther than half of what the two are large.
  [[nodiscard]] bool travels_far(const BoxNumbers& pair, const Stretch& stretch) const {
    const auto a = things_[0].extent(pair[0]), b = things_[1].extent(pair[1]);
    return bounds_of(a.reach, b.reach).speed * (stretch.end - stretch.begin) > a.radius + b.radius;
  }

  [[nodiscard]] GapBounds bounds_of(double reach_a, double reach_b) const {
    if (has_half_space_) return all_;
    const double rate_a = things_[0].motion.rate, rate_b = things_[1].motion.rate;
    return {alike_.speed + (rate_a * reach_a + rate_b * reach_b),
            alike_.bending + (rate_a * rate_a * reach_a + rate_b * rate_b * reach_b), alike_.pad};
  }

  /// Some direction parts a box of one side and one of the other, whose heights are given, throughout the stretch.
  [[nodiscard]] bool is_parted(const StretchView& view, std::size_t side, std::uint32_t at, std::uint32_t other,
                               const StretchView::Heights& other_heights) const {
    const double step = (view.stretch().end - view.stretch().begin) * (1 + 0x1p-50);
    std::optional<GapBounds> bounds;
    for (std::size_t i = 0; i < view.count(); ++i) {
      const auto own = view.heights(i, side, at).at;
      const auto& others = other_heights[i].at;
      const double pad = (view.pad(i) + all_.pad + stop_before_) * (1 + 0x1p-40);
      const auto is_gap = [&](double start, double end) {
        if (!(start > pad && end > pad)) return false;
        if (!bounds) bounds = bounds_between(side, at, other);
        return least_between(start - pad, end - pad, step, *bounds) > 0;
      };
      if (is_gap(own[0].low - others[0].high, own[1].low - others[1].high) ||
          is_gap(others[0].low - own[0].high, others[1].low - own[1].high))
        return true;
    }
    return false;
  }

  [[nodiscard]] GapBounds bounds_between(std::size_t side, std::uint32_t at, std::uint32_t other) const {
    const double own = things_[side].extent(at).reach, others = things_[1 - side].extent(other).reach;
    return side == 0 ? bounds_of(own, others) : bounds_of(others, own);
  }

  void look_at(const ItemPair& items, const Stretch& stretch) {
    ++counts_.items;
    if (!(stretch.begin <= limit_)) return;
    const auto contact = contact_of(items, {stretch.begin, std::min(stretch.end, limit_)});
    if (!contact) return;
    limit_ = std::min(limit_, contact->upper);
    found_.push_back({contact->lower, items});
  }

  [[nodiscard]] std::optional<FirstContact> contact_of(const ItemPair& items, const Stretch& stretch) const {
    const MovingPart &a = *things_[0].part, &b = *things_[1].part;
    const GapBounds bounds = bounds_of(reach_of(0, items.first), reach_of(1, items.second));
    return item_contact(a, items.first, b, items.second, stretch, bounds, stop_before_);
  }

  /// Of a triangle that of its corners, which are farthest.
  [[nodiscard]] double reach_of(std::size_t side, Index item) const {
    const SweptThing& thing = things_[side];
    if (thing.tree == nullptr) return thing.motion.reach;
    const TriangleMesh& mesh = thing.part->shape().mesh();
    double reach = 0;
    for (const Index corner : mesh.triangles()[item])
      reach = std::max(reach, thing.motion.reach_of(transform(thing.motion.pose, mesh.vertices()[corner])));
    return reach * (1 + 0x1p-40) + thing.motion.rounding;
  }

  std::array<SweptThing, 2> things_;
  GapBounds all_;    ///< of all points of both
  GapBounds alike_;  ///< of points on the axes
  bool has_half_space_;
  Stretch stretch_;
  double stop_before_;
  double limit_;
  WalkCounts& counts_;
  std::vector<Found> found_;
};

}  // namespace

std::optional<ShapeHit> tree_sweep(const MovingPart& a, const MovingPart& b, const Stretch& stretch, double stop_before,
                                   double limit, WalkCounts& counts) {
  return TreeSweep(a, b, stretch, stop_before, limit, counts).answer();
}

}  // namespace toccata
