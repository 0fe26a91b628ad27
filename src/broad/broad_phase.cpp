#include "toccata/broad/broad_phase.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <iterator>
#include <limits>
#include <numeric>
#include <utility>

#include <fmt/format.h>

#include "broad/pair_finder.hpp"
#include "toccata/core/error.hpp"

namespace toccata {
namespace {

constexpr double Vec3::*coordinates[] = {&Vec3::x, &Vec3::y, &Vec3::z};

/// Empty, or lower ≤ upper along every axis, which what is no number is not.
bool is_sound(const Aabb& box) {
  return (box.lower.x <= box.upper.x && box.lower.y <= box.upper.y && box.lower.z <= box.upper.z) || box == Aabb{};
}

/// What is wrong with a box that is not sound.
std::string complaint_about(const Aabb& box) {
  for (int axis = 0; axis < 3; ++axis) {
    const double lower = box.lower.*coordinates[axis], upper = box.upper.*coordinates[axis];
    if (std::isnan(lower) || std::isnan(upper)) return fmt::format("its {} is not a number", "xyz"[axis]);
    if (!(lower <= upper))
      return fmt::format("its lower {0} {1} is above its upper {0} {2}", "xyz"[axis], lower, upper);
  }
  return {};
}

void require_boxes(std::span<const Aabb> boxes) {
  for (std::size_t i = 0; i < boxes.size(); ++i)
    if (!is_sound(boxes[i]))
      throw Error(fmt::format("box {} of the {} to add: {}", i, boxes.size(), complaint_about(boxes[i])));
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

double moved_down(double value, double by) {
  return by == 0 ? value : std::nextafter(value - by, -std::numeric_limits<double>::infinity());
}

}  // namespace

Aabb grown(const Aabb& box, double margin) {
  if (!(margin >= 0)) throw Error(fmt::format("a margin of {}: it must not be negative", margin));
  if (is_empty(box)) return box;
  const auto down = [&](double value) { return moved_down(value, margin); };
  const auto up = [&](double value) { return -moved_down(-value, margin); };
  return {{down(box.lower.x), down(box.lower.y), down(box.lower.z)},
          {up(box.upper.x), up(box.upper.y), up(box.upper.z)}};
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
        finder_(make_pair_finder(options_)) {}

  std::vector<Index> add(std::span<const Aabb> boxes) {
    require_boxes(boxes);
    const std::size_t reused = std::min(boxes.size(), free_.size());
    if (boxes_.size() + (boxes.size() - reused) > std::numeric_limits<Index>::max())
      throw Error("more boxes than 2^32 - 1");
    std::vector<Index> numbers;
    numbers.reserve(boxes.size());
    reserve(boxes_.size() + (boxes.size() - reused), changed_.size() + boxes.size());
    for (const Aabb& box : boxes) numbers.push_back(next_number(box));
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

  void move(std::span<const Index> numbers, std::span<const Aabb> boxes) {
    if (numbers.size() != boxes.size())
      throw Error(fmt::format("{} numbers with {} boxes to move to", numbers.size(), boxes.size()));
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      check_in_use(numbers[i]);
      if (!is_sound(boxes[i])) throw Error(fmt::format("box {}: {}", numbers[i], complaint_about(boxes[i])));
    }
    reserve(boxes_.size(), std::min(changed_.size() + numbers.size(), boxes_.size()));
    for (std::size_t i = 0; i < numbers.size(); ++i)
      if (boxes_[numbers[i]] != boxes[i]) place(numbers[i], boxes[i]);
  }

  std::span<const IndexPair> update() {
    nothing_moved_ = changed_.empty();
    if (!nothing_moved_) {
      has_found_ = true;
      PairList now = finder_->find({boxes_, changed_, pairs_, options_.threads}, std::move(before_));
      before_ = std::exchange(pairs_, std::move(now));
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
           (changed_.capacity() + free_.capacity() + freed_.capacity()) * sizeof(Index) + finder_->bytes();
  }

 private:
  static constexpr std::uint8_t used = 1, changed = 2;

  void check_in_use(Index number) const {
    if (!in_use(number)) throw Error(fmt::format("box {} is not in use: it was removed, or never added", number));
  }

  /// As vectors grow: to the exact size would copy all with every call.
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

  void place(Index number, const Aabb& box) {
    boxes_[number] = box;
    if ((marks_[number] & changed) == 0) changed_.push_back(number);
    marks_[number] |= changed;
  }

  Index next_number(const Aabb& box) {
    Index number = static_cast<Index>(boxes_.size());
    if (free_.empty()) {
      boxes_.emplace_back();
      marks_.push_back(0);
    } else {
      number = free_.back();
      free_.pop_back();
    }
    marks_[number] |= used;
    place(number, box);
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
  bool has_found_ = false;  ///< this finder, ever
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
void BroadPhase::remove(std::span<const Index> numbers) { state_->remove(numbers); }
void BroadPhase::move(std::span<const Index> numbers, std::span<const Aabb> boxes) { state_->move(numbers, boxes); }
std::span<const IndexPair> BroadPhase::update() { return state_->update(); }
std::span<const IndexPair> BroadPhase::pairs() const { return state_->pairs(); }
PairChanges BroadPhase::changes() const { return state_->changes(); }
std::size_t BroadPhase::size() const { return state_->size(); }
const Aabb& BroadPhase::box(Index number) const { return state_->box(number); }
bool BroadPhase::in_use(Index number) const { return state_->in_use(number); }
BroadPhaseMethod BroadPhase::method() const { return state_->method(); }
std::string BroadPhase::reason() const { return state_->reason(); }
BroadPhaseCells BroadPhase::cells() const { return state_->cells(); }
std::size_t BroadPhase::bytes() const { return state_->bytes(); }

namespace {

std::vector<IndexPair> pairs_of(std::span<const Aabb> boxes, const BroadPhaseOptions& options,
                                const PairFilter* wanted) {
  require_boxes(boxes);
  if (boxes.size() > std::numeric_limits<Index>::max()) throw Error("more boxes than 2^32 - 1");
  std::vector<Index> all(boxes.size());
  std::iota(all.begin(), all.end(), Index{0});
  return make_pair_finder(checked(options))->find({boxes, all, {}, options.threads, wanted}, {});
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
