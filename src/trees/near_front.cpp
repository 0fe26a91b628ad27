#include "trees/near_front.hpp"

#include <algorithm>
#include <cmath>

namespace toccata {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

constexpr std::size_t items_at_once = 64;

double size_of(const OrientedBlock& block, std::size_t lane) {
  return (double{block.extent[0][lane]} + block.extent[1][lane]) + block.extent[2][lane];
}

}  // namespace

void NearFront::clear() {
  opened_.clear();
  opened_keys_.clear();
  items_.clear();
  item_keys_.clear();
  way_ = 0;
  question_ = 0;
  counts_ = {};
}

// Keys are rounded down and what they are compared with up, so that nothing is left out. What is not a number is never
// above anything, and is looked at every time.

double NearFront::reach(const FrontQuestion& question) const { return (question.limit() + way_) * (1 + 0x1p-50); }

double NearFront::key_of(double least) const { return (least + way_) * (1 - 0x1p-50); }

void NearFront::make(const NearWalk& walk, FrontQuestion& question) {
  clear();
  const std::uint32_t lanes = walk.tree(1).blocks[0].count;
  for (std::uint32_t lane = 0; lane < lanes; ++lane) {
    opened_.push_back({0, lane, 0});
    opened_keys_.push_back(-infinity);
  }
  ++question_;
  open_all(walk, std::numeric_limits<std::size_t>::max(), question);
  opened_when_made_ = opened_.size();
}

bool NearFront::move(const NearWalk& walk, double way, double likely, FrontQuestion& question) {
  way_ = way;
  counts_ = {};
  const double least_reach = (likely + way) * (1 + 0x1p-40);
  const auto expired =
      std::count_if(opened_keys_.begin(), opened_keys_.end(), [&](double key) { return !(key > least_reach); });
  if (2 * static_cast<std::size_t>(expired) > opened_.size()) return false;
  ++question_;
  show_items(0, least_reach, question);
  if (question.limit() < 0) return true;
  show_items(0, reach(question), question);
  const std::size_t most = 2 * opened_when_made_ + 32;
  open_all(walk, most, question);
  return opened_.size() <= most;
}

/// Ends early when there are more than `most`, or the question wants no more.
void NearFront::open_all(const NearWalk& walk, std::size_t most, FrontQuestion& question) {
  std::size_t shown = items_.size();
  double limit = reach(question);
  for (std::size_t place = 0; place < opened_.size() && opened_.size() <= most; ++place) {
    if (opened_keys_[place] > limit) continue;
    open(walk, place, limit);
    if (items_.size() - shown < items_at_once) continue;
    show_items(shown, limit, question);
    shown = items_.size();
    if (question.limit() < 0) return;
    limit = reach(question);
  }
  show_items(shown, limit, question);
}

/// Files the lanes that are within reach; the others are behind the entry's key.
void NearFront::open(const NearWalk& walk, std::size_t place, double reach) {
  const Opened opened = opened_[place];
  const std::size_t side = opened.first & 1U;
  const std::uint32_t number = opened.first >> 1, count = walk.tree(side).blocks[number].count;
  const NearBounds bounds = walk.bounds(side, number, opened.second);
  counts_.volume_tests += count;
  double least = infinity;
  std::uint32_t filed = opened.filed;
  for (std::uint32_t lane = 0; lane < count; ++lane) {
    if ((filed >> lane & 1U) != 0) continue;
    const double key = key_of(bounds.least[lane]);
    if (key > reach) {
      least = std::min(least, key);
    } else {
      filed |= 1U << lane;
      file(walk, opened, lane, bounds.other_size, key);
    }
  }
  opened_[place].filed = filed;
  opened_keys_[place] = least;
}

/// Two items, or two boxes of which the larger is opened.
void NearFront::file(const NearWalk& walk, const Opened& opened, std::uint32_t lane, double other_size, double key) {
  const std::size_t side = opened.first & 1U;
  const OrientedBlock& own = walk.tree(side).blocks[opened.first >> 1];
  const std::int32_t child = own.child[lane];
  const std::int32_t other_child = walk.tree(side ^ 1).blocks[opened.second >> 3].child[opened.second & 7U];
  if (child < 0 && other_child < 0) {
    const Index item = walk.tree(side).items[static_cast<std::uint32_t>(~child)];
    const Index other = walk.tree(side ^ 1).items[static_cast<std::uint32_t>(~other_child)];
    items_.push_back({side == 0 ? ItemPair{item, other} : ItemPair{other, item}, 0});
    item_keys_.push_back(key);
    return;
  }
  if (other_child < 0 || (child >= 0 && size_of(own, lane) >= other_size))
    opened_.push_back({static_cast<std::uint32_t>(child) << 1 | static_cast<std::uint32_t>(side), opened.second, 0});
  else
    opened_.push_back({static_cast<std::uint32_t>(other_child) << 1 | static_cast<std::uint32_t>(side ^ 1),
                       (opened.first >> 1) << 3 | lane, 0});
  opened_keys_.push_back(-infinity);
}

/// Those from `first` on that may be within reach and were not shown to this question.
void NearFront::show_items(std::size_t first, double reach, FrontQuestion& question) {
  for (std::size_t place = first; place < items_.size(); ++place) {
    if (item_keys_[place] > reach || items_[place].question == question_) continue;
    items_[place].question = question_;
    places_.push_back(static_cast<std::uint32_t>(place));
    pairs_.push_back(items_[place].pair);
    if (places_.size() == items_at_once) show(question);
  }
  show(question);
}

void NearFront::show(FrontQuestion& question) {
  if (question.limit() >= 0 && !pairs_.empty()) {
    least_.assign(pairs_.size(), 0);
    question.visit(pairs_, least_);
    counts_.items += pairs_.size();
    for (std::size_t i = 0; i < places_.size(); ++i) item_keys_[places_[i]] = key_of(least_[i]);
  }
  places_.clear();
  pairs_.clear();
}

}  // namespace toccata
