#include "shapes/ear_clipping.hpp"

#include <algorithm>
#include <numeric>

namespace toccata {
namespace {

/// Which corners may be cut. Each step allows what the one before it allows, and more; a polygon without repeated
/// corners never needs a step beyond the first.
enum class Allowed {
  clear_ears,     ///< convex, and no other corner anywhere in the closed triangle
  touched_ears,   ///< convex, and no other corner inside the triangle; some may lie on its boundary
  flat_corners,   ///< also corners that turn nowhere: their triangle has no area and takes nothing away
  nothing_helps,  ///< stuck
};

struct PlanarBox {
  Vec2 lower, upper;
  [[nodiscard]] bool contains(const Vec2& p) const {
    return p.x >= lower.x && p.x <= upper.x && p.y >= lower.y && p.y <= upper.y;
  }
};

class EarClipper {
 public:
  explicit EarClipper(std::span<const Vec2> polygon)
      : polygon_(polygon), previous_(polygon.size()), next_(polygon.size()), turn_(polygon.size()) {
    const auto n = static_cast<Index>(polygon.size());
    for (Index i = 0; i < n; ++i) {
      previous_[i] = i == 0 ? n - 1 : i - 1;
      next_[i] = i + 1 == n ? 0 : i + 1;
    }
    for (Index i = 0; i < n; ++i) turn_[i] = turn_at(i);
    for (Index i = 0; i < n; ++i)
      if (turn_[i] != Sign::positive) blockers_.push_back(i);
  }

  std::vector<CornerTriangle> clip() {
    std::vector<CornerTriangle> triangles;
    triangles.reserve(polygon_.size() - 2);
    while (triangles.size() + 3 < polygon_.size()) {
      const Index ear = find_ear();
      if (allowed_ == Allowed::nothing_helps) return {};
      triangles.push_back({previous_[ear], ear, next_[ear]});
      cut_area_ = cut_area_ || turn_[ear] == Sign::positive;
      remove(ear);
    }
    // The last three, from the least corner on, so that a convex quadrilateral is cut into (0, 1, 2) and (0, 2, 3).
    const Index last = std::min({candidate_, previous_[candidate_], next_[candidate_]});
    if (turn_[last] == Sign::negative || (turn_[last] == Sign::zero && !cut_area_)) return {};
    triangles.push_back({last, next_[last], previous_[last]});
    return triangles;
  }

 private:
  [[nodiscard]] Sign turn_at(Index i) const {
    return orient2d(polygon_[previous_[i]], polygon_[i], polygon_[next_[i]]);
  }

  // Cutting an ear makes ears of its two neighbours at most, so a corner is judged again only when a neighbour went or
  // more became allowed.
  Index find_ear() {
    while (allowed_ != Allowed::nothing_helps) {
      if (judged_.empty()) judged_.assign(polygon_.size(), 0);
      for (Index seen = 0; seen < remaining(); ++seen, candidate_ = next_[candidate_]) {
        if (judged_[candidate_] != 0) continue;
        if (is_ear(candidate_)) return candidate_;
        judged_[candidate_] = 1;
      }
      allowed_ = static_cast<Allowed>(static_cast<int>(allowed_) + 1);
      judged_.clear();
    }
    return candidate_;
  }

  [[nodiscard]] Index remaining() const { return static_cast<Index>(polygon_.size()) - removed_; }

  [[nodiscard]] bool is_ear(Index b) const {
    if (turn_[b] == Sign::zero) return allowed_ == Allowed::flat_corners;
    if (turn_[b] == Sign::negative) return false;
    return std::none_of(blockers_.begin(), blockers_.end(), [&](Index p) { return blocks(p, b); });
  }

  [[nodiscard]] bool blocks(Index p, Index ear) const {
    const Vec2 &a = polygon_[previous_[ear]], &b = polygon_[ear], &c = polygon_[next_[ear]], &point = polygon_[p];
    const PlanarBox box{{std::min({a.x, b.x, c.x}), std::min({a.y, b.y, c.y})},
                        {std::max({a.x, b.x, c.x}), std::max({a.y, b.y, c.y})}};
    // A corner at a corner of the triangle (a bridge to a hole) is not in the way; its neighbours may be.
    if (!box.contains(point) || point == a || point == b || point == c) return false;
    const auto outside = [&](const Vec2& tail, const Vec2& head) {
      const Sign side = orient2d(tail, head, point);
      return side == Sign::negative || (side == Sign::zero && allowed_ != Allowed::clear_ears);
    };
    return !outside(c, a) && !outside(a, b) && !outside(b, c);
  }

  void remove(Index ear) {
    const Index before = previous_[ear], after = next_[ear];
    next_[before] = after;
    previous_[after] = before;
    ++removed_;
    const bool was_blocker = turn_[ear] != Sign::positive;
    bool stale = was_blocker;
    for (const Index i : {before, after}) {
      judged_[i] = 0;
      const Sign turn = turn_at(i);
      stale = stale || (turn_[i] != Sign::positive) != (turn != Sign::positive);
      turn_[i] = turn;
    }
    if (stale) drop_convex_blockers(ear, before, after);
    // Skipping one corner spreads the cuts around the polygon instead of fanning it from one corner.
    candidate_ = next_[after];
  }

  // Cutting turns corners towards convex; only where the polygon crosses itself can one become a blocker.
  void drop_convex_blockers(Index ear, Index before, Index after) {
    std::erase_if(blockers_, [&](Index i) { return i == ear || i == before || i == after; });
    for (const Index i : {before, after})
      if (turn_[i] != Sign::positive) blockers_.push_back(i);
  }

  std::span<const Vec2> polygon_;
  std::vector<Index> previous_, next_;
  std::vector<Sign> turn_;
  std::vector<Index> blockers_;  ///< corners that are not convex: if any corner lies in a triangle, one of these does
  std::vector<char> judged_;     ///< found to be no ear by what is allowed now, and no neighbour cut since
  Allowed allowed_ = Allowed::clear_ears;
  Index candidate_ = 1;
  bool cut_area_ = false;
  Index removed_ = 0;
};

}  // namespace

std::vector<CornerTriangle> clip_ears(std::span<const Vec2> polygon) { return EarClipper(polygon).clip(); }

}  // namespace toccata
