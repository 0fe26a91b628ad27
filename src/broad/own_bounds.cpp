#include "broad/own_bounds.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <variant>

#include <fmt/format.h>

#include "bounds/upper_sum.hpp"
#include "broad/exact_balls.hpp"
#include "broad/pair_buffer.hpp"
#include "toccata/core/parallel.hpp"

namespace toccata {
namespace {

/// A box that holds it, as the two are compared along the directions of both.
Obb oriented(const Aabb& box) {
  const Vec3 centre = middle(box);
  const auto half = [&](int axis) {
    return rounded_up(std::max(box.upper[axis] - centre[axis], centre[axis] - box.lower[axis]));
  };
  return {centre, Mat3{}, {half(0), half(1), half(2)}};
}

/// In an order of all their numbers.
bool is_before(const Obb& a, const Obb& b) {
  const auto numbers = [](const Obb& box) {
    std::array<double, 15> all{};
    auto out = all.begin();
    for (const Vec3& one : {box.centre, box.half, box.axes[0], box.axes[1], box.axes[2]})
      for (int axis = 0; axis < 3; ++axis) *out++ = one[axis];
    return all;
  };
  return numbers(a) < numbers(b);
}

bool do_overlap(const Aabb& a, const Aabb& b) { return overlap(a, b); }
bool do_overlap(const Ball& a, const Ball& b) { return balls_meet(a, b); }
/// They are compared from the middle of the first, so that there must be a first.
bool do_overlap(const Obb& a, const Obb& b) { return is_before(b, a) ? overlap(b, a) : overlap(a, b); }
bool do_overlap(const Aabb& box, const Ball& ball) { return ball_meets_box(ball, box); }
bool do_overlap(const Obb& box, const Ball& ball) { return gap(box, PointVolume{ball.centre}) <= ball.radius; }
bool do_overlap(const Aabb& a, const Obb& b) {
  return !is_finite(a.lower) || !is_finite(a.upper) || do_overlap(oriented(a), b);
}
bool do_overlap(const Ball& ball, const Aabb& box) { return do_overlap(box, ball); }
bool do_overlap(const Ball& ball, const Obb& box) { return do_overlap(box, ball); }
bool do_overlap(const Obb& a, const Aabb& b) { return do_overlap(b, a); }

}  // namespace

bool bounds_overlap(const AnyBound& a, const AnyBound& b) {
  return std::visit(
      [](const auto& one, const auto& other) {
        const Aabb around_one = box_around(one), around_other = box_around(other);
        return !is_empty(around_one) && !is_empty(around_other) && overlap(around_one, around_other) &&
               do_overlap(one, other);
      },
      a, b);
}

std::string complaint_about(const Aabb& box) {
  if (box == Aabb{}) return {};
  for (int axis = 0; axis < 3; ++axis) {
    const double lower = box.lower[axis], upper = box.upper[axis];
    if (std::isnan(lower) || std::isnan(upper)) return fmt::format("its {} is not a number", "xyz"[axis]);
    if (!(lower <= upper))
      return fmt::format("its lower {0} {1} is above its upper {0} {2}", "xyz"[axis], lower, upper);
  }
  return {};
}

std::string complaint_about(const Ball& ball) {
  if (!is_finite(ball.centre)) return "its centre is not finite";
  return std::isnan(ball.radius) ? "its radius is not a number" : std::string();
}

std::string complaint_about(const Obb& box) {
  if (!is_finite(box.centre)) return "its centre is not finite";
  if (std::isnan(box.half.x) || std::isnan(box.half.y) || std::isnan(box.half.z))
    return "a half extent is not a number";
  for (int i = 0; i < 3; ++i)
    for (int j = i; j < 3; ++j) {
      const double product = dot(box.axes[i], box.axes[j]);
      // Written so that what is no number is refused.
      if (!(std::fabs(product - (i == j ? 1 : 0)) <= 0x1.1p-46))
        return "its axes are not of unit length and at right angles: make them with orthonormal_axes";
    }
  return {};
}

template <class Bound>
void BoundPool<Bound>::make_room(std::size_t more) {
  const std::size_t needed = bounds_.size() + (more > free_.size() ? more - free_.size() : 0);
  if (needed > bounds_.capacity()) bounds_.reserve(std::max(needed, bounds_.capacity() + bounds_.capacity() / 2));
  if (needed > free_.capacity()) free_.reserve(bounds_.capacity());
}

template <class Bound>
Index BoundPool<Bound>::put(const Bound& bound) {
  if (free_.empty()) {
    bounds_.push_back(bound);
    return static_cast<Index>(bounds_.size() - 1);
  }
  const Index place = free_.back();
  free_.pop_back();
  bounds_[place] = bound;
  return place;
}

template class BoundPool<Ball>;
template class BoundPool<Obb>;

AnyBound OwnBounds::bound(Index number, const Aabb& box) const {
  switch (kind(number)) {
    case Kind::ball:
      return balls_[places_[number]];
    case Kind::oriented_box:
      return oriented_boxes_[places_[number]];
    case Kind::box:
      break;
  }
  return box;
}

std::size_t OwnBounds::bytes() const {
  return kinds_.capacity() * sizeof(Kind) + places_.capacity() * sizeof(Index) + balls_.bytes() +
         oriented_boxes_.bytes() + (box_pairs_.capacity() + storage_.capacity()) * sizeof(IndexPair) +
         stays_.capacity();
}

bool OwnBounds::overlap_themselves(const IndexPair& pair, std::span<const Aabb> boxes) const {
  const auto [first, second] = pair;
  const Kind one = kind(first), other = kind(second);
  if (one == Kind::box && other == Kind::box) return true;
  if (one == Kind::ball && other == Kind::ball) return do_overlap(balls_[places_[first]], balls_[places_[second]]);
  if (one == Kind::oriented_box && other == Kind::oriented_box)
    return do_overlap(oriented_boxes_[places_[first]], oriented_boxes_[places_[second]]);
  return bounds_overlap(bound(first, boxes[first]), bound(second, boxes[second]));
}

void OwnBounds::judge(std::size_t begin, std::size_t end, std::span<const IndexPair> before, const Seen& seen) {
  auto next = begin < end ? std::lower_bound(before.begin(), before.end(), box_pairs_[begin]) : before.end();
  for (std::size_t i = begin; i < end; ++i) {
    const IndexPair& pair = box_pairs_[i];
    if (((seen.marks[pair.first] | seen.marks[pair.second]) & seen.changed) != 0) {
      stays_[i] = overlap_themselves(pair, seen.boxes) ? 1 : 0;
      continue;
    }
    while (next != before.end() && *next < pair) ++next;
    stays_[i] = next != before.end() && *next == pair ? 1 : 0;
  }
}

PairList OwnBounds::cleaned(PairList box_pairs, std::span<const IndexPair> before, const Seen& seen, PairList storage) {
  storage_ = std::exchange(box_pairs_, std::move(box_pairs));
  stays_.resize(box_pairs_.size());
  const EvenParts chunks(box_pairs_.size(), 16);
  parallel_for(chunks.parts(), seen.threads,
               [&](std::size_t part) { judge(chunks.begin(part), chunks.end(part), before, seen); });
  storage.clear();
  for (std::size_t i = 0; i < box_pairs_.size(); ++i)
    if (stays_[i] != 0) storage.push_back(box_pairs_[i]);
  return storage;
}

}  // namespace toccata
