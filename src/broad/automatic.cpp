#include "broad/automatic.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "broad/box_sample.hpp"
#include "broad/finders.hpp"
#include "math/constants.hpp"

namespace toccata {
namespace {

struct Candidate {
  BroadPhaseMethod method;
  double expected = 0;  ///< milliseconds, on a machine that is not this one
  struct Measurement {
    double milliseconds;
    std::size_t updates;  ///< that had been before
  };
  std::optional<Measurement> measured{};
};

/// What a method can be expected to take, in milliseconds, on a machine of about 2024. Only their order matters, and
/// measuring mends it.
class Expectation {
 public:
  Expectation(const BoxSample& sample, std::span<const Aabb> boxes, std::size_t changed)
      : count_(static_cast<double>(boxes.size())), changed_(static_cast<double>(changed)) {
    const BoxDensity density(sample, boxes);
    swept_ = density.swept * count_;
    near_ = density.near * count_;
    heaped_ = density.heaped;
  }

  [[nodiscard]] std::optional<double> of(BroadPhaseMethod method) const {
    constexpr double per_nanosecond = 1e-6;
    switch (method) {
      case BroadPhaseMethod::brute_force:
        return count_ > 4000 ? std::nullopt : std::optional(per_nanosecond * count_ * (30 + 0.06 * count_));
      case BroadPhaseMethod::sort_and_sweep:
        // Sorted boxes lie anywhere: the more, the slower they are fetched.
        return per_nanosecond * count_ * (std::max(60.0, 25 * std::log10(count_)) + 0.4 * swept_);
      case BroadPhaseMethod::uniform_grid:
        return per_nanosecond * count_ * (70 + 1.2 * near_);
      case BroadPhaseMethod::kd_tiles:
        return per_nanosecond * count_ * 150;
      case BroadPhaseMethod::layers:
        return changed_ > 0.12 * count_ ? std::nullopt : std::optional(per_nanosecond * (10 * count_ + 500 * changed_));
      default:
        return std::nullopt;
    }
  }
  [[nodiscard]] bool is_heaped() const { return heaped_; }

 private:
  double count_, changed_, swept_ = 0, near_ = 0;
  bool heaped_ = false;
};

/// Expects from a sample of the boxes what each method will take, uses the best, and measures it. Now and then the next
/// best, when it cannot be much worse, is tried for three updates; if it takes four fifths or less, it stays. A trial
/// ends with the second of them where that was no better than what there was.
class Automatic final : public PairFinder {
 public:
  explicit Automatic(AutomaticMeans means) : means_(std::move(means)) {}

  PairList find(const BoxesNow& now, PairList storage) override {
    if (is_due(now)) look_anew(now);
    begin_trial();
    given_up_ = false;
    const double start = means_.milliseconds();
    PairList pairs = finder_of_update().find(now, std::move(storage));
    const double milliseconds = means_.milliseconds() - start;
    ++updates_;
    note(milliseconds);
    return pairs;
  }

  [[nodiscard]] std::size_t bytes() const override {
    return (finder_ ? finder_->bytes() : 0) + (tried_finder_ ? tried_finder_->bytes() : 0);
  }
  [[nodiscard]] BroadPhaseCells cells(std::span<const Aabb> boxes) const override {
    const PairFinder* finder = tried_finder_ ? tried_finder_.get() : finder_.get();
    return given_up_ || finder == nullptr ? BroadPhaseCells{} : finder->cells(boxes);
  }
  [[nodiscard]] BroadPhaseMethod chosen() const override { return method_; }

  [[nodiscard]] std::string reason() const override {
    if (candidates_.empty()) return {};
    std::string text = fmt::format("{} boxes, {}, {:.3g} % move{}: {}", count_, sizes_, 100 * moving_,
                                   is_heaped_ ? ", in heaps" : "", name_of(method_));
    if (const auto& measured = candidate(method_).measured) text += fmt::format(", {:.3g} ms", measured->milliseconds);
    if (const Candidate* next = next_best())
      text += next->measured
                  ? fmt::format("; next best {}, took {:.3g} ms", name_of(next->method), next->measured->milliseconds)
                  : fmt::format("; next {}, expected to take {:.2g} times as long, not tried", name_of(next->method),
                                next->expected / candidate(method_).expected);
    return text;
  }

 private:
  static constexpr std::array considered{BroadPhaseMethod::brute_force, BroadPhaseMethod::sort_and_sweep,
                                         BroadPhaseMethod::uniform_grid, BroadPhaseMethod::kd_tiles,
                                         BroadPhaseMethod::layers};
  static constexpr double clearly_better = 0.8;
  static constexpr double surely_better = 0.5;  ///< what is only expected, than what is measured
  static constexpr double most_worse = 1.5;     ///< than the present: what is expected to be worse is not tried
  /// How many times as long as expected a machine takes at most: where the present method takes longer, it is not the
  /// machine, but the boxes lie otherwise than the sample says, and the others are not expected to be slower, too.
  static constexpr double slowest_machine = 8;
  static constexpr std::size_t updates_of_memory = 1000;
  static constexpr std::size_t calm = 32;  ///< updates longer than patience demands: the motion stays what it is
  static constexpr std::size_t most_patience = 128;
  static constexpr std::size_t updates_of_trial = 3;  ///< the first of which has to make all its memory

  /// Whether the boxes are no longer what they were when a method was chosen.
  [[nodiscard]] bool is_due(const BoxesNow& now) const {
    if (tried_finder_) return false;
    if (!finder_ || have_come_ || updates_ - looked_at_ >= 256) return true;
    const auto count = static_cast<double>(now.boxes.size());
    const double moving = static_cast<double>(now.changed.size()) / count;
    const bool other_motion = (moving > 0.12) != (moving_ > 0.12);
    return count > 1.5 * static_cast<double>(count_) || (other_motion && updates_ - looked_at_ >= patience_);
  }

  void look_anew(const BoxesNow& now) {
    count_ = now.boxes.size();
    // That boxes come first is no motion.
    have_come_ = !finder_ && !now.is_only && now.changed.size() == count_;
    const std::size_t moved = have_come_ ? 0 : now.changed.size();
    moving_ = count_ == 0 ? 0 : static_cast<double>(moved) / static_cast<double>(count_);
    const BoxSample sample(now.boxes);
    const Expectation expectation(sample, now.boxes, moved);
    is_heaped_ = expectation.is_heaped();
    sizes_ = words_of_sizes(sample);
    // Where the motion goes back and forth, it is not followed each time.
    patience_ = !finder_ ? 1 : updates_ - looked_at_ < patience_ + calm ? std::min(2 * patience_, most_patience) : 2;
    looked_at_ = updates_;
    const std::vector<Candidate> known = std::exchange(candidates_, {});
    for (const BroadPhaseMethod method : considered)
      if (const auto expected = expectation.of(method))
        candidates_.push_back(with_measured({method, *expected}, known));
    tried_finder_.reset();
    next_trial_ = updates_ + 6;
    trial_pause_ = 16;
    const Candidate& best =
        *std::min_element(candidates_.begin(), candidates_.end(),
                          [&](const Candidate& a, const Candidate& b) { return cost(a) < cost(b); });
    if (!is_good_enough_beside(best)) use(best.method, means_.finder(best.method));
  }

  /// Whether the present method stays although this one is the best, as far as is known.
  [[nodiscard]] bool is_good_enough_beside(const Candidate& best) const {
    if (!finder_) return false;
    if (best.method == method_) return true;
    const auto present = std::find_if(candidates_.begin(), candidates_.end(),
                                      [&](const Candidate& one) { return one.method == method_; });
    if (present == candidates_.end()) return false;
    const double enough = present->measured && !best.measured ? surely_better : clearly_better;
    return cost(best) >= enough * cost(*present);
  }

  /// What was measured still holds where about the same is expected, for a while: the machine may have been busy.
  [[nodiscard]] Candidate with_measured(Candidate candidate, std::span<const Candidate> known) const {
    for (const Candidate& one : known)
      if (one.method == candidate.method && one.measured && updates_ - one.measured->updates < updates_of_memory &&
          std::max(one.expected, candidate.expected) < 1.5 * std::min(one.expected, candidate.expected))
        candidate.measured = one.measured;
    return candidate;
  }

  /// In milliseconds of this machine, as far as any are known.
  [[nodiscard]] double cost(const Candidate& one) const {
    if (one.measured) return one.measured->milliseconds;
    const Candidate* known = nullptr;
    for (const Candidate& other : candidates_)
      if (other.measured && (known == nullptr || other.method == method_)) known = &other;
    if (known == nullptr) return one.expected;
    return one.expected * std::min(known->measured->milliseconds / known->expected, slowest_machine);
  }
  /// None where there is no other.
  [[nodiscard]] const Candidate* next_best() const {
    const Candidate* next = nullptr;
    for (const Candidate& one : candidates_)
      if (one.method != method_ && (next == nullptr || cost(one) < cost(*next))) next = &one;
    return next;
  }

  static std::string words_of_sizes(const BoxSample& sample) {
    double least = infinity, most = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (sample.sizes(axis).low > 0) least = std::min(least, sample.sizes(axis).low);
      most = std::max(most, sample.sizes(axis).most);
    }
    const double ratio = least <= most ? most / least : 1;
    return ratio < 8 ? "of similar sizes" : fmt::format("sizes over {:.2g} decades", std::log10(ratio));
  }

  void use(BroadPhaseMethod method, std::unique_ptr<PairFinder> finder) {
    method_ = method;
    finder_ = std::move(finder);
    is_warm_ = false;
  }
  [[nodiscard]] const Candidate& candidate(BroadPhaseMethod method) const {
    return *std::find_if(candidates_.begin(), candidates_.end(),
                         [&](const Candidate& one) { return one.method == method; });
  }
  void measure(BroadPhaseMethod method, double milliseconds) {
    for (Candidate& one : candidates_)
      if (one.method == method) one.measured = {milliseconds, updates_};
  }

  void begin_trial() {
    if (tried_finder_ || updates_ < next_trial_ || !candidate(method_).measured) return;
    const Candidate* next = next_best();
    next_trial_ = updates_ + trial_pause_;
    trial_pause_ = std::min<std::size_t>(4 * trial_pause_, 1024);
    if (next == nullptr || cost(*next) > most_worse * cost(candidate(method_))) return;
    tried_ = next->method;
    tried_finder_ = means_.finder(tried_);
    // Two at once would be twice the memory, and it will not have seen what moved meanwhile.
    finder_.reset();
    tried_updates_ = 0;
  }

  [[nodiscard]] PairFinder& finder_of_update() { return tried_finder_ ? *tried_finder_ : *finder_; }

  /// What other programs take from a single update does not show.
  static double smoothed(double before, double now) {
    return now < before ? 0.5 * (before + now) : std::min(now, 1.05 * before);
  }

  void note(double milliseconds) {
    if (!tried_finder_) {
      const auto& before = candidate(method_).measured;
      // The first time all memory is new.
      if (is_warm_) measure(method_, before ? smoothed(before->milliseconds, milliseconds) : milliseconds);
      is_warm_ = true;
      return;
    }
    if (++tried_updates_ == 1) return;
    trial_ = tried_updates_ == 2 ? milliseconds : std::min(trial_, milliseconds);
    const double present = cost(candidate(method_));
    if (tried_updates_ < updates_of_trial && trial_ < present) return;
    measure(tried_, trial_);
    if (trial_ < clearly_better * present) {
      use(tried_, std::move(tried_finder_));
      is_warm_ = true;
    } else {
      given_up_ = true;
      use(method_, means_.finder(method_));
    }
    tried_finder_.reset();
  }

  AutomaticMeans means_;
  BroadPhaseMethod method_ = BroadPhaseMethod::kd_tiles, tried_ = BroadPhaseMethod::kd_tiles;
  std::unique_ptr<PairFinder> finder_, tried_finder_;
  std::vector<Candidate> candidates_;
  bool is_warm_ = false;
  bool given_up_ = false;  ///< in the last update, the one that found its pairs
  std::size_t tried_updates_ = 0;
  double trial_ = 0;  ///< the best milliseconds of it
  std::size_t updates_ = 0, looked_at_ = 0, patience_ = 2, next_trial_ = 0, trial_pause_ = 16;
  std::size_t count_ = 0;
  double moving_ = 0;
  bool have_come_ = false;  ///< all boxes in the last update, the first: none has moved yet
  bool is_heaped_ = false;
  std::string sizes_;
};

}  // namespace

AutomaticMeans usual_means() {
  return {
      [] {
        return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now().time_since_epoch()).count();
      },
      [](BroadPhaseMethod method) { return make_pair_finder({method}); }};
}

std::unique_ptr<PairFinder> make_automatic(AutomaticMeans means) {
  return std::make_unique<Automatic>(std::move(means));
}

std::unique_ptr<PairFinder> make_automatic() { return make_automatic(usual_means()); }

}  // namespace toccata
