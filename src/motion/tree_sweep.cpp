#include "motion/tree_sweep.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <vector>

#include "math/vec3_measures.hpp"
#include "motion/convex_pair_in_time.hpp"
#include "motion/item_contact.hpp"
#include "motion/stretch_view.hpp"
#include "narrow/triangles/heights_along.hpp"
#include "query/casts/mesh_casts.hpp"

namespace toccata {
namespace {

/// A pair of boxes, one of each thing.
using BoxNumbers = std::array<std::uint32_t, 2>;

/// Deeper the stretches are not halved: boxes without extent travel farther than they are large at any time.
constexpr int most_halvings = 24;

/// About half way between where a triangle is at the ends.
Vec3 normal_of(const std::array<Triangle, 2>& t) {
  return cross(t[0][1] - t[0][0], t[0][2] - t[0][0]) + cross(t[1][1] - t[1][0], t[1][2] - t[1][0]);
}
Vec3 middle_of(const std::array<Triangle, 2>& t) {
  return (t[0][0] + t[0][1] + t[0][2]) + (t[1][0] + t[1][1] + t[1][2]);
}

class TreeSweep {
 public:
  TreeSweep(const MovingPart& a, const MovingPart& b, const TimeStretch& stretch, double stop_before, double limit,
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
        keep_first(first,
                   {{contact->lower, contact->upper, {}, contact->normal, contact->status}, items.first, items.second});
    }
    // What was near in a part of the stretch, and is not when all of it is looked at, has cut off what comes later.
    if (!first && !found_.empty()) {
      const Found& near = *std::min_element(
          found_.begin(), found_.end(), [](const Found& one, const Found& other) { return one.lower < other.lower; });
      first = {{near.lower, near.lower, {}, {}, Status::undecided}, near.items.first, near.items.second};
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

  void search(const TimeStretch& stretch, const std::vector<BoxNumbers>& pairs, int halvings) {
    const StretchView view(things_[0], things_[1], stretch);
    const double length = stretch.end - stretch.begin, middle = stretch.begin + 0.5 * length;
    // What is open when a contact is found is looked at anew in the shorter stretch before it.
    const double worth_cutting = stretch.begin + 0.9 * length;
    std::vector<BoxNumbers> open, later;
    for (const BoxNumbers& pair : pairs)
      if (!is_parted(view, pair)) open.push_back(pair);
    while (!open.empty()) {
      const BoxNumbers pair = open.back();
      open.pop_back();
      if (halvings < most_halvings && (limit_ < worth_cutting || travels_far(pair, stretch)))
        later.push_back(pair);
      else if (is_item(pair))
        look_at(view, {things_[0].item(pair[0]), things_[1].item(pair[1])});
      else
        expand(view, pair, open);
    }
    if (later.empty()) return;
    search({stretch.begin, std::min(middle, limit_)}, later, halvings + 1);
    if (middle < limit_) search({middle, stretch.end}, later, halvings + 1);
  }

  [[nodiscard]] bool is_item(const BoxNumbers& pair) const {
    return things_[0].is_item(pair[0]) && things_[1].is_item(pair[1]);
  }

  /// Opens the larger of the two.
  void expand(const StretchView& view, const BoxNumbers& pair, std::vector<BoxNumbers>& open) {
    const bool opens_b =
        things_[0].is_item(pair[0]) ||
        (!things_[1].is_item(pair[1]) && things_[1].extent(pair[1]).radius > things_[0].extent(pair[0]).radius);
    const std::size_t side = opens_b ? 1 : 0;
    const std::uint32_t other = pair[1 - side], block = things_[side].block_below(pair[side]);
    const std::uint32_t count = things_[side].tree->blocks[block].count;
    counts_.volume_tests += count;
    for (std::uint32_t left = not_parted(view, side, block, count, other); left != 0; left &= left - 1) {
      const std::uint32_t at = block << 3 | static_cast<std::uint32_t>(std::countr_zero(left));
      open.push_back(side == 0 ? BoxNumbers{at, other} : BoxNumbers{other, at});
    }
  }

  /// Farther than half of what the two are large; of items it does not matter. (Measured: from a quarter to all of it
  /// the time is the same within a fifth.)
  [[nodiscard]] bool travels_far(const BoxNumbers& pair, const TimeStretch& stretch) const {
    if (is_item(pair)) return false;
    const auto a = things_[0].extent(pair[0]), b = things_[1].extent(pair[1]);
    return bounds_of(a.reach, b.reach).speed * (stretch.end - stretch.begin) > 0.5 * (a.radius + b.radius);
  }

  [[nodiscard]] GapBounds bounds_of(double reach_a, double reach_b) const {
    if (has_half_space_) return all_;
    const double rate_a = things_[0].motion.rate, rate_b = things_[1].motion.rate;
    return {alike_.speed + (rate_a * reach_a + rate_b * reach_b),
            alike_.bending + (rate_a * rate_a * reach_a + rate_b * rate_b * reach_b), alike_.pad};
  }

  /// What is left of a gap along a direction is certain.
  [[nodiscard]] double pad_along(const StretchView& view, std::size_t direction) const {
    return wanted_gap(view.pad(direction) + all_.pad, stop_before_);
  }

  /// Two heights apart, at the ends of the stretch, leave a gap throughout it.
  [[nodiscard]] static bool is_gap(double start, double end, const StretchView& view, const GapBounds& bounds) {
    const double step = (view.stretch().end - view.stretch().begin) * (1 + 0x1p-50);
    return least_between(start, end, step, bounds) > 0;
  }

  /// Those of the first boxes of a block, as bits, that no direction parts from a box of the other thing throughout.
  [[nodiscard]] std::uint32_t not_parted(const StretchView& view, std::size_t side, std::uint32_t block,
                                         std::uint32_t count, std::uint32_t other) const {
    std::uint32_t left = (1U << count) - 1;
    for (std::size_t i = 0; i < view.count() && left != 0; ++i) {
      const BlockHeights own = view.block_heights(i, side, block);
      const auto others = view.heights(i, 1 - side, other).at;
      const double pad = pad_along(view, i);
      for (std::uint32_t bits = left; bits != 0; bits &= bits - 1) {
        const auto lane = static_cast<std::size_t>(std::countr_zero(bits));
        const double above_start = own.low[0][lane] - others[0].high - pad,
                     above_end = own.low[1][lane] - others[1].high - pad;
        const double below_start = others[0].low - own.high[0][lane] - pad,
                     below_end = others[1].low - own.high[1][lane] - pad;
        const bool is_above = above_start > 0 && above_end > 0, is_below = below_start > 0 && below_end > 0;
        if (!is_above && !is_below) continue;
        const double start = is_above ? above_start : below_start, end = is_above ? above_end : below_end;
        if (is_gap(start, end, view, all_) ||
            is_gap(start, end, view, bounds_between(side, block << 3 | static_cast<std::uint32_t>(lane), other)))
          left &= ~(1U << lane);
      }
    }
    return left;
  }

  [[nodiscard]] bool is_parted(const StretchView& view, const BoxNumbers& pair) const {
    const GapBounds bounds = bounds_between(0, pair[0], pair[1]);
    for (std::size_t i = 0; i < view.count(); ++i) {
      const auto a = view.heights(i, 0, pair[0]).at, b = view.heights(i, 1, pair[1]).at;
      const double pad = pad_along(view, i);
      if (is_gap(a[0].low - b[0].high - pad, a[1].low - b[1].high - pad, view, bounds) ||
          is_gap(b[0].low - a[0].high - pad, b[1].low - a[1].high - pad, view, bounds))
        return true;
    }
    return false;
  }

  [[nodiscard]] GapBounds bounds_between(std::size_t side, std::uint32_t at, std::uint32_t other) const {
    const double own = things_[side].extent(at).reach, others = things_[1 - side].extent(other).reach;
    return side == 0 ? bounds_of(own, others) : bounds_of(others, own);
  }

  void look_at(const StretchView& view, const ItemPair& items) {
    ++counts_.items;
    const TimeStretch& stretch = view.stretch();
    if (!(stretch.begin <= limit_) || are_parted_triangles(view, items)) return;
    const auto contact = contact_of(items, {stretch.begin, std::min(stretch.end, limit_)});
    if (!contact) return;
    limit_ = std::min(limit_, contact->upper);
    found_.push_back({contact->lower, items});
  }

  /// Whether two items are triangles that certainly stay apart: for most their normals, or the line between their
  /// middles, show it.
  [[nodiscard]] bool are_parted_triangles(const StretchView& view, const ItemPair& items) const {
    if (things_[0].tree == nullptr || things_[1].tree == nullptr || view.count() == 0) return false;
    const std::array a{view.triangle(0, 0, items.first), view.triangle(0, 1, items.first)};
    const std::array b{view.triangle(1, 0, items.second), view.triangle(1, 1, items.second)};
    const GapBounds bounds = item_bounds(items);
    const double pad = pad_along(view, 0);
    for (const Vec3& along : {normal_of(a), normal_of(b), middle_of(b) - middle_of(a)}) {
      const Vec3 up = plain_unit_or_zero(along);
      const auto a0 = heights_along(up, a[0]), a1 = heights_along(up, a[1]), b0 = heights_along(up, b[0]),
                 b1 = heights_along(up, b[1]);
      if (is_gap(a0.low - b0.high - pad, a1.low - b1.high - pad, view, bounds) ||
          is_gap(b0.low - a0.high - pad, b1.low - a1.high - pad, view, bounds))
        return true;
    }
    return false;
  }

  [[nodiscard]] GapBounds item_bounds(const ItemPair& items) const {
    return bounds_of(reach_of(0, items.first), reach_of(1, items.second));
  }

  [[nodiscard]] std::optional<FirstContact> contact_of(const ItemPair& items, const TimeStretch& stretch) const {
    const MovingPart &a = *things_[0].part, &b = *things_[1].part;
    return item_contact(a, items.first, b, items.second, stretch, item_bounds(items), stop_before_);
  }

  /// How far an item reaches from the axis; for a triangle, that is the reach of its corners, which are farthest.
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
  TimeStretch stretch_;
  double stop_before_;
  double limit_;
  WalkCounts& counts_;
  std::vector<Found> found_;
};

}  // namespace

std::optional<ShapeHit> tree_sweep(const MovingPart& a, const MovingPart& b, const TimeStretch& stretch,
                                   double stop_before, double limit, WalkCounts& counts) {
  return TreeSweep(a, b, stretch, stop_before, limit, counts).answer();
}

}  // namespace toccata
