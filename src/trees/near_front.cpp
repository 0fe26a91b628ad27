#include "trees/near_front.hpp"

#include <algorithm>
#include <cmath>

#include "math/constants.hpp"
#include "math/floats.hpp"
#include "math/vec3_measures.hpp"

namespace toccata {
namespace {

constexpr std::ptrdiff_t items_at_once = 64;
constexpr std::size_t items_at_first = 8;

// Sizes whose squares and errors are ordinary floats.
constexpr double largest_size = 1e12;
constexpr double smallest_ratio = 1e-12;

double size_of(const OrientedBlock& block, std::size_t lane) {
  return (double{block.extent[0][lane]} + block.extent[1][lane]) + block.extent[2][lane];
}

std::int32_t child_of(const NearBvh& tree, std::uint32_t box) { return tree.blocks[box >> 3].child[box & 7U]; }
double size_of(const NearBvh& tree, std::uint32_t box) { return size_of(tree.blocks[box >> 3], box & 7U); }
Index item_of(const NearBvh& tree, std::uint32_t box) {
  return tree.items[static_cast<std::uint32_t>(~child_of(tree, box))];
}

/// The plane between two items that are `found.gap` apart as they are now. What is rounded here is below 2⁻²¹ of the
/// sizes: the direction and how it is seen change by 2⁻²³ of their lengths.
GapPlane plane_of(const NearWalk& walk, const BoxPair& items, const FrontGap& found) {
  const NearView& view = walk.view(0);
  const OrientedBlock& block = walk.tree(1).blocks[items.second >> 3];
  const std::size_t lane = items.second & 7U;
  GapPlane plane;
  for (std::size_t i = 0; i < 3; ++i) plane.centre[i] = block.centre[i][lane];
  plane.radius = up_to_float(size_of(block, lane));
  plane.normal = as_floats(found.direction);
  const Vec3 normal = as_doubles(plane.normal);
  plane.turned = as_floats(view.ratio * Vec3{dot(view.rotation.column(0), normal), dot(view.rotation.column(1), normal),
                                             dot(view.rotation.column(2), normal)});
  const double middle = dot(normal, view.offset) + dot(as_doubles(plane.turned), as_doubles(plane.centre));
  const double pad = view.pad + 0x1p-21 * (4 + (4 * view.ratio + sum_of_magnitudes(view.offset)));
  const double reach = middle - (found.gap / view.scale - pad);
  plane.reach = up_to_float(std::min(reach, 1e30));
  return plane;
}

}  // namespace

bool NearFront::serves(const NearWalk& walk) {
  const NearView& view = walk.view(0);
  return view.rigid && !std::isnan(view.scale) && view.ratio > smallest_ratio &&
         view.ratio + sum_of_magnitudes(view.offset) < largest_size;
}

/// Lengths along a direction are too long by 2⁻²³ at most.
void NearFront::Step::read_limit() {
  const double now = question.limit();
  limit = now < 0 ? -1 : now / walk.view(0).scale * (1 + 0x1p-22);
}

void NearFront::clear() {
  boxes_.clear();
  box_planes_.clear();
  unused_.clear();
  items_.clear();
  item_planes_.clear();
  pending_.clear();
  pending_items_.clear();
  nearest_item_ = 0;
  nearest_gap_ = infinity;
  counts_ = {};
}

void NearFront::make(const NearWalk& walk, FrontQuestion& question) {
  clear();
  Step step{walk, question};
  step.read_limit();
  for (std::uint32_t lane = 0; lane < walk.tree(1).blocks[0].count; ++lane) {
    part_children(walk, 0, 0, lane, parted_);
    const std::uint32_t count = walk.tree(0).blocks[0].count;
    counts_.volume_tests += count;
    for (std::uint32_t own = 0; own < count; ++own) file(step, {own, lane}, own);
  }
  open_pending(step);
  size_when_made_ = size();
}

bool NearFront::move(const NearWalk& walk, FrontQuestion& question) {
  counts_ = {};
  Step step{walk, question};
  show_items_again(step);
  if (step.is_over()) return true;
  near_.clear();
  box_planes_.find_near(walk.view(0), step.limit, near_);
  if (3 * near_.size() > boxes_.size() - unused_.size() + 64) return false;
  part_boxes_again(step);
  open_pending(step);
  return true;
}

/// First that which was nearest before and then those that seem to be nearest now, so that few others are within reach.
void NearFront::show_items_again(Step& step) {
  first_shown_ = nearest_item_;
  nearest_gap_ = infinity;
  show(step, std::array{first_shown_});
  if (step.is_over()) return;
  near_.clear();
  item_planes_.find_near(step.walk.view(0), step.limit, near_);
  const auto first = near_.begin() + static_cast<std::ptrdiff_t>(std::min(items_at_first, near_.size()));
  std::nth_element(near_.begin(), first, near_.end(), [](const auto& x, const auto& y) { return x.least < y.least; });
  show_near(step, {near_.begin(), first});
  for (auto it = first; it != near_.end() && !step.is_over();) {
    const auto end = it + std::min<std::ptrdiff_t>(items_at_once, near_.end() - it);
    show_near(step, {it, end});
    it = end;
  }
}

/// Those within reach that were not shown yet.
void NearFront::show_near(Step& step, std::span<const GapPlanes::Near> items) {
  places_.clear();
  for (const GapPlanes::Near& item : items)
    if (!(item.least > step.limit) && item.place != first_shown_) places_.push_back(item.place);
  show(step, places_);
}

/// Other directions for those that are near along the ones they had, or they are to be opened.
void NearFront::part_boxes_again(Step& step) {
  std::array<BoxPair, GapPlaneLanes::width> pairs;
  for (std::size_t first = 0; first < near_.size(); first += pairs.size()) {
    const std::size_t count = std::min(pairs.size(), near_.size() - first);
    for (std::size_t i = 0; i < count; ++i) pairs[i] = boxes_[near_[first + i].place];
    part_boxes(step.walk, std::span(pairs).first(count), parted_);
    counts_.volume_tests += count;
    for (std::size_t i = 0; i < count; ++i) {
      const std::uint32_t place = near_[first + i].place;
      if (parted_.least[i] > step.limit) {
        box_planes_.set(place, parted_, i);
      } else {
        box_planes_.unset(place);
        unused_.push_back(place);
        leave_open(step, pairs[i]);
      }
    }
  }
}

void NearFront::open_pending(Step& step) {
  while (!step.is_over() && (!pending_.empty() || !pending_items_.empty())) {
    if (pending_.empty() || std::ssize(pending_items_) >= items_at_once) {
      show(step, pending_items_);
      pending_items_.clear();
    } else {
      const BoxPair pair = pending_.back();
      pending_.pop_back();
      open(step, pair);
    }
  }
}

/// The larger of two boxes.
void NearFront::open(const Step& step, const BoxPair& pair) {
  const NearBvh &first = step.walk.tree(0), &second = step.walk.tree(1);
  const std::int32_t child = child_of(first, pair.first), other_child = child_of(second, pair.second);
  const bool opens_first =
      other_child < 0 ||
      (child >= 0 && size_of(first, pair.first) >= step.walk.view(0).ratio * size_of(second, pair.second));
  const auto number = static_cast<std::uint32_t>(opens_first ? child : other_child);
  const std::uint32_t count = (opens_first ? first : second).blocks[number].count;
  part_children(step.walk, opens_first ? 0 : 1, number, opens_first ? pair.second : pair.first, parted_);
  counts_.volume_tests += count;
  for (std::uint32_t lane = 0; lane < count; ++lane) {
    const std::uint32_t box = number << 3 | lane;
    file(step, opens_first ? BoxPair{box, pair.second} : BoxPair{pair.first, box}, lane);
  }
}

/// Keeps two boxes that were parted if they are far enough apart.
void NearFront::file(const Step& step, const BoxPair& pair, std::size_t lane) {
  if (!(parted_.least[lane] > step.limit)) {
    leave_open(step, pair);
    return;
  }
  if (unused_.empty()) {
    boxes_.push_back(pair);
    unused_.push_back(box_planes_.add());
  }
  boxes_[unused_.back()] = pair;
  box_planes_.set(unused_.back(), parted_, lane);
  unused_.pop_back();
}

/// Two items, or two boxes to be opened.
void NearFront::leave_open(const Step& step, const BoxPair& pair) {
  if (child_of(step.walk.tree(0), pair.first) >= 0 || child_of(step.walk.tree(1), pair.second) >= 0) {
    pending_.push_back(pair);
    return;
  }
  pending_items_.push_back(item_planes_.add());
  items_.push_back(pair);
}

void NearFront::show(Step& step, std::span<const std::uint32_t> places) {
  pairs_.clear();
  for (const std::uint32_t place : places)
    pairs_.push_back(
        {item_of(step.walk.tree(0), items_[place].first), item_of(step.walk.tree(1), items_[place].second)});
  gaps_.assign(pairs_.size(), {});
  if (!pairs_.empty()) step.question.visit(pairs_, gaps_);
  counts_.items += pairs_.size();
  for (std::size_t i = 0; i < places.size(); ++i) {
    item_planes_.set(places[i], plane_of(step.walk, items_[places[i]], gaps_[i]));
    if (!(gaps_[i].gap < nearest_gap_)) continue;
    nearest_gap_ = gaps_[i].gap;
    nearest_item_ = places[i];
  }
  step.read_limit();
}

}  // namespace toccata
