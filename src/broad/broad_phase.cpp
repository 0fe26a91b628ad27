#include "toccata/broad/broad_phase.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <iterator>
#include <limits>
#include <numeric>
#include <string_view>
#include <type_traits>
#include <utility>

#include <fmt/format.h>

#include "broad/own_bounds.hpp"
#include "broad/pair_finder.hpp"
#include "math/constants.hpp"
#include "toccata/core/error.hpp"

namespace toccata {
namespace {

template <class Bound>
constexpr std::string_view word_for = "box";
template <>
constexpr std::string_view word_for<Ball> = "ball";
template <>
constexpr std::string_view word_for<Obb> = "oriented box";

/// Empty, or lower ≤ upper along every axis, which what is no number is not.
bool is_sound(const Aabb& box) {
  return (box.lower.x <= box.upper.x && box.lower.y <= box.upper.y && box.lower.z <= box.upper.z) || box == Aabb{};
}
template <class Bound>
bool is_sound(const Bound& bound) {
  return complaint_about(bound).empty();
}

template <class Bound>
void require_sound(std::span<const Bound> bounds) {
  for (std::size_t i = 0; i < bounds.size(); ++i)
    if (!is_sound(bounds[i]))
      throw Error(
          fmt::format("{} {} of the {} to add: {}", word_for<Bound>, i, bounds.size(), complaint_about(bounds[i])));
}

const BroadPhaseOptions& checked(const BroadPhaseOptions& options) {
  if (!(options.hash_cell > 0 && options.hash_cell <= std::numeric_limits<double>::max()))
    throw Error(fmt::format("cells of {} usual boxes: the number must be positive and finite", options.hash_cell));
  return options;
}

/// The rest of `a` without `b`, both ascending.
PairList without(std::span<const IndexPair> a, std::span<const IndexPair> b) {
  PairList rest;
  std::set_difference(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(rest));
  return rest;
}

double moved_down(double value, double by) { return by == 0 ? value : std::nextafter(value - by, -infinity); }
double moved_up(double value, double by) { return -moved_down(-value, by); }

void require_margin(double margin) {
  if (!(margin >= 0)) throw Error(fmt::format("a margin of {}: it must not be negative", margin));
}

}  // namespace

Aabb offset_outward(const Aabb& box, double margin) {
  require_margin(margin);
  if (is_empty(box)) return box;
  const auto down = [&](double value) { return moved_down(value, margin); };
  const auto up = [&](double value) { return moved_up(value, margin); };
  return {{down(box.lower.x), down(box.lower.y), down(box.lower.z)},
          {up(box.upper.x), up(box.upper.y), up(box.upper.z)}};
}

Ball offset_outward(const Ball& ball, double margin) {
  require_margin(margin);
  return is_empty(ball) ? ball : Ball{ball.centre, moved_up(ball.radius, margin)};
}

Obb offset_outward(const Obb& box, double margin) {
  require_margin(margin);
  if (is_empty(box)) return box;
  // Axes are of unit length and at right angles but for 2^-46 each.
  const double by = margin * (1 + 0x1p-40);
  return {box.centre, box.axes, {moved_up(box.half.x, by), moved_up(box.half.y, by), moved_up(box.half.z, by)}};
}

class BroadPhase::State {
 public:
  explicit State(const BroadPhaseOptions& options) : options_(checked(options)), finder_(make_pair_finder(options)) {}
  /// What the method keeps is not copied: it is made anew.
  State(const State& other)
      : options_(other.options_),
        boxes_(other.boxes_),
        marks_(other.marks_),
        changed_(other.changed_),
        free_(other.free_),
        freed_(other.freed_),
        pairs_(other.pairs_),
        before_(other.before_),
        nothing_moved_(other.nothing_moved_),
        own_(other.own_ ? std::make_unique<OwnBounds>(*other.own_) : nullptr),
        finder_(make_pair_finder(options_)) {}

  template <class Bound>
  std::vector<Index> add(std::span<const Bound> bounds) {
    require_sound(bounds);
    const std::size_t reused = std::min(bounds.size(), free_.size());
    const std::size_t count = boxes_.size() + (bounds.size() - reused);
    if (count > std::numeric_limits<Index>::max()) throw Error("more boxes than 2^32 - 1");
    std::vector<Index> numbers;
    numbers.reserve(bounds.size());
    reserve(count, changed_.size() + bounds.size());
    make_room_aside<Bound>(count, bounds.size());
    for (const Bound& bound : bounds) numbers.push_back(next_number(bound));
    return numbers;
  }

  void remove(std::span<const Index> numbers) {
    for (const Index number : numbers) check_in_use(number);
    std::vector<Index> sorted(numbers.begin(), numbers.end());
    std::sort(sorted.begin(), sorted.end());
    if (const auto twice = std::adjacent_find(sorted.begin(), sorted.end()); twice != sorted.end())
      throw Error(fmt::format("box {} is to be removed twice", *twice));
    reserve(boxes_.size(), changed_.size() + numbers.size());
    make_room(freed_, freed_.size() + numbers.size());
    for (const Index number : numbers) {
      place(number, Aabb{});
      marks_[number] = static_cast<std::uint8_t>(marks_[number] & ~used);
      freed_.push_back(number);
    }
  }

  template <class Bound>
  void move(std::span<const Index> numbers, std::span<const Bound> bounds) {
    if (numbers.size() != bounds.size())
      throw Error(fmt::format("{} numbers with {} boxes to move to", numbers.size(), bounds.size()));
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      check_in_use(numbers[i]);
      if (!is_sound(bounds[i]))
        throw Error(fmt::format("{} {}: {}", word_for<Bound>, numbers[i], complaint_about(bounds[i])));
    }
    reserve(boxes_.size(), std::min(changed_.size() + numbers.size(), boxes_.size()));
    make_room_aside<Bound>(boxes_.size(), count_of_other_kinds<Bound>(numbers));
    for (std::size_t i = 0; i < numbers.size(); ++i)
      if (!is_at(numbers[i], bounds[i])) place(numbers[i], bounds[i]);
  }

  std::span<const IndexPair> update() {
    nothing_moved_ = changed_.empty();
    if (!nothing_moved_) {
      has_found_ = true;
      PairList now =
          own_ ? find_cleaned() : finder_->find({boxes_, changed_, pairs_, options_.threads}, std::move(before_));
      before_ = std::exchange(pairs_, std::move(now));
      if (own_ && own_->is_without_any()) own_.reset();
      for (const Index number : changed_) marks_[number] = static_cast<std::uint8_t>(marks_[number] & ~changed);
      changed_.clear();
    }
    if (!freed_.empty()) {
      free_.insert(free_.end(), freed_.begin(), freed_.end());
      std::sort(free_.begin(), free_.end(), std::greater<>());
      freed_.clear();
    }
    return pairs_;
  }

  [[nodiscard]] std::span<const IndexPair> pairs() const { return pairs_; }
  [[nodiscard]] PairChanges changes() const {
    if (nothing_moved_) return {};
    return {without(pairs_, before_), without(before_, pairs_)};
  }

  [[nodiscard]] std::size_t size() const { return boxes_.size(); }
  [[nodiscard]] const Aabb& box(Index number) const {
    if (number >= boxes_.size()) throw Error(fmt::format("there is no box {}: there are {}", number, boxes_.size()));
    return boxes_[number];
  }
  [[nodiscard]] AnyBound bound(Index number) const {
    const Aabb& around = box(number);
    return own_ ? own_->bound(number, around) : around;
  }
  [[nodiscard]] bool in_use(Index number) const { return number < marks_.size() && (marks_[number] & used) != 0; }
  [[nodiscard]] BroadPhaseMethod method() const {
    return options_.method == BroadPhaseMethod::automatic ? finder_->chosen() : options_.method;
  }
  [[nodiscard]] std::string reason() const { return finder_->reason(); }
  [[nodiscard]] BroadPhaseCells cells() const {
    if (!changed_.empty())
      throw Error("boxes have come, gone or moved since the last update: ask for its cells before");
    return has_found_ ? finder_->cells(boxes_) : BroadPhaseCells{};
  }
  [[nodiscard]] std::size_t bytes() const {
    return boxes_.capacity() * sizeof(Aabb) + marks_.capacity() +
           (changed_.capacity() + free_.capacity() + freed_.capacity()) * sizeof(Index) + finder_->bytes() +
           (own_ ? own_->bytes() : 0);
  }

 private:
  static constexpr std::uint8_t used = 1, changed = 2;

  void check_in_use(Index number) const {
    if (!in_use(number)) throw Error(fmt::format("box {} is not in use: it was removed, or never added", number));
  }

  /// Makes room as vectors grow: growing to the exact size would copy all with every call.
  template <class List>
  static void make_room(List& list, std::size_t size) {
    if (size > list.capacity()) list.reserve(std::max(size, list.capacity() + list.capacity() / 2));
  }

  /// So that nothing after it can fail.
  void reserve(std::size_t boxes, std::size_t changes) {
    make_room(boxes_, boxes);
    make_room(marks_, boxes);
    make_room(changed_, changes);
  }

  /// The same of what is kept of bounds that are no boxes; nothing is as long as there are none.
  template <class Bound>
  void make_room_aside(std::size_t numbers, std::size_t more) {
    if (!own_ && !std::is_same_v<Bound, Aabb> && more > 0) own_ = std::make_unique<OwnBounds>(pairs_);
    if (own_) own_->make_room<Bound>(numbers, more);
  }
  template <class Bound>
  [[nodiscard]] std::size_t count_of_other_kinds(std::span<const Index> numbers) const {
    if (!own_) return numbers.size();
    return static_cast<std::size_t>(std::count_if(
        numbers.begin(), numbers.end(), [&](Index number) { return !own_->template has_kind<Bound>(number); }));
  }
  template <class Bound>
  [[nodiscard]] bool is_at(Index number, const Bound& bound) const {
    if constexpr (std::is_same_v<Bound, Aabb>)
      return boxes_[number] == bound && (!own_ || own_->has_kind<Aabb>(number));
    else
      return own_->has_kind<Bound>(number) && std::get<Bound>(own_->bound(number, boxes_[number])) == bound;
  }

  PairList find_cleaned() {
    PairList found = finder_->find({boxes_, changed_, own_->box_pairs(), options_.threads}, own_->take_storage());
    return own_->cleaned(std::move(found), pairs_, {boxes_, marks_, changed, options_.threads}, std::move(before_));
  }

  template <class Bound>
  void place(Index number, const Bound& bound) {
    boxes_[number] = box_around(bound);
    if (own_) own_->set(number, bound);
    if ((marks_[number] & changed) == 0) changed_.push_back(number);
    marks_[number] |= changed;
  }

  template <class Bound>
  Index next_number(const Bound& bound) {
    Index number = static_cast<Index>(boxes_.size());
    if (free_.empty()) {
      boxes_.emplace_back();
      marks_.push_back(0);
    } else {
      number = free_.back();
      free_.pop_back();
    }
    marks_[number] |= used;
    place(number, bound);
    return number;
  }

  BroadPhaseOptions options_;
  std::vector<Aabb> boxes_;
  std::vector<std::uint8_t> marks_;
  std::vector<Index> changed_;
  std::vector<Index> free_;   ///< to be given out, the least last
  std::vector<Index> freed_;  ///< since the last update
  PairList pairs_;
  PairList before_;
  bool nothing_moved_ = true;
  bool has_found_ = false;          ///< this finder, ever
  std::unique_ptr<OwnBounds> own_;  ///< null as long as all are boxes
  std::unique_ptr<PairFinder> finder_;
};

BroadPhase::BroadPhase(const BroadPhaseOptions& options) : state_(std::make_unique<State>(options)) {}
BroadPhase::BroadPhase(const BroadPhase& other) : state_(std::make_unique<State>(*other.state_)) {}
BroadPhase::BroadPhase(BroadPhase&&) noexcept = default;
BroadPhase& BroadPhase::operator=(BroadPhase other) noexcept {
  state_ = std::move(other.state_);
  return *this;
}
BroadPhase::~BroadPhase() = default;

std::vector<Index> BroadPhase::add(std::span<const Aabb> boxes) { return state_->add(boxes); }
std::vector<Index> BroadPhase::add(std::span<const Ball> balls) { return state_->add(balls); }
std::vector<Index> BroadPhase::add(std::span<const Obb> boxes) { return state_->add(boxes); }
void BroadPhase::remove(std::span<const Index> numbers) { state_->remove(numbers); }
void BroadPhase::move(std::span<const Index> numbers, std::span<const Aabb> boxes) { state_->move(numbers, boxes); }
void BroadPhase::move(std::span<const Index> numbers, std::span<const Ball> balls) { state_->move(numbers, balls); }
void BroadPhase::move(std::span<const Index> numbers, std::span<const Obb> boxes) { state_->move(numbers, boxes); }
std::span<const IndexPair> BroadPhase::update() { return state_->update(); }
std::span<const IndexPair> BroadPhase::pairs() const { return state_->pairs(); }
PairChanges BroadPhase::changes() const { return state_->changes(); }
std::size_t BroadPhase::size() const { return state_->size(); }
const Aabb& BroadPhase::box(Index number) const { return state_->box(number); }
AnyBound BroadPhase::bound(Index number) const { return state_->bound(number); }
bool BroadPhase::in_use(Index number) const { return state_->in_use(number); }
BroadPhaseMethod BroadPhase::method() const { return state_->method(); }
std::string BroadPhase::reason() const { return state_->reason(); }
BroadPhaseCells BroadPhase::cells() const { return state_->cells(); }
std::size_t BroadPhase::bytes() const { return state_->bytes(); }

namespace {

std::vector<IndexPair> pairs_of(std::span<const Aabb> boxes, const BroadPhaseOptions& options,
                                const PairFilter* wanted) {
  require_sound(boxes);
  if (boxes.size() > std::numeric_limits<Index>::max()) throw Error("more boxes than 2^32 - 1");
  std::vector<Index> all(boxes.size());
  std::iota(all.begin(), all.end(), Index{0});
  return make_pair_finder(checked(options))->find({boxes, all, {}, options.threads, wanted, true}, {});
}

}  // namespace

std::vector<IndexPair> overlapping_pairs(std::span<const Aabb> boxes, const BroadPhaseOptions& options) {
  return pairs_of(boxes, options, nullptr);
}

std::vector<IndexPair> overlapping_pairs(std::span<const Aabb> boxes, const BroadPhaseOptions& options,
                                         const PairFilter& wanted) {
  if (!wanted) return pairs_of(boxes, options, nullptr);
  std::vector<IndexPair> pairs = pairs_of(boxes, options, &wanted);
  std::erase_if(pairs, [&](const IndexPair& pair) { return !wanted(pair); });
  return pairs;
}

}  // namespace toccata
