#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "broad/box_sample.hpp"
#include "broad/finders.hpp"

namespace toccata {
namespace {

using Clock = std::chrono::steady_clock;

struct Candidate {
  BroadPhaseMethod method;
  double milliseconds;  ///< expected, or measured
  bool measured;
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
        return per_nanosecond * count_ * (60 + 0.25 * swept_);
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
/// best, when it cannot be much worse, is tried for two updates; if it takes four fifths or less, it stays.
class Automatic final : public PairFinder {
 public:
  PairList find(const BoxesNow& now, PairList storage) override {
    if (is_due(now)) look_anew(now);
    begin_trial();
    const auto start = Clock::now();
    PairList pairs = finder_of_update().find(now, std::move(storage));
    const double milliseconds = std::chrono::duration<double, std::milli>(Clock::now() - start).count();
    ++updates_;
    note(milliseconds);
    return pairs;
  }

  [[nodiscard]] std::size_t bytes() const override {
    return (finder_ ? finder_->bytes() : 0) + (tried_finder_ ? tried_finder_->bytes() : 0);
  }
  [[nodiscard]] BroadPhaseMethod chosen() const override { return method_; }

  [[nodiscard]] std::string reason() const override {
    if (candidates_.empty()) return {};
    std::string text = fmt::format("{} boxes, {}, {:.3g} % move{}: {}", count_, sizes_, 100 * moving_,
                                   is_heaped_ ? ", in heaps" : "", name_of(method_));
    const Candidate* next = nullptr;
    for (const Candidate& candidate : candidates_) {
      if (candidate.method == method_ && candidate.measured) text += fmt::format(", {:.3g} ms", candidate.milliseconds);
      if (candidate.method != method_ && (next == nullptr || candidate.milliseconds < next->milliseconds))
        next = &candidate;
    }
    if (next != nullptr)
      text += next->measured
                  ? fmt::format("; next best {}, took {:.3g} ms", name_of(next->method), next->milliseconds)
                  : fmt::format("; next {}, expected {:.3g} ms, not tried", name_of(next->method), next->milliseconds);
    return text;
  }

 private:
  static constexpr std::array considered{BroadPhaseMethod::brute_force, BroadPhaseMethod::sort_and_sweep,
                                         BroadPhaseMethod::uniform_grid, BroadPhaseMethod::kd_tiles,
                                         BroadPhaseMethod::layers};
  static constexpr double clearly_better = 0.8;
  static constexpr double most_worse = 1.8;  ///< than the present: what is expected to be worse is not tried

  /// Whether the boxes are no longer what they were when a method was chosen.
  [[nodiscard]] bool is_due(const BoxesNow& now) const {
    if (!finder_ || updates_ - looked_at_ >= 256) return true;
    const auto count = static_cast<double>(now.boxes.size());
    const double moving = static_cast<double>(now.changed.size()) / count;
    const bool other_motion = (moving > 0.12) != (moving_ > 0.12);
    return count > 1.5 * static_cast<double>(count_) || (other_motion && updates_ - looked_at_ >= patience_);
  }

  void look_anew(const BoxesNow& now) {
    const BoxSample sample(now.boxes);
    const Expectation expectation(sample, now.boxes, now.changed.size());
    count_ = now.boxes.size();
    moving_ = count_ == 0 ? 0 : static_cast<double>(now.changed.size()) / static_cast<double>(count_);
    is_heaped_ = expectation.is_heaped();
    sizes_ = words_of_sizes(sample);
    // Where the motion goes back and forth, it is not followed each time.
    patience_ = finder_ && updates_ - looked_at_ < 32 ? std::min<std::size_t>(2 * patience_, 128) : 2;
    looked_at_ = updates_;
    candidates_.clear();
    for (const BroadPhaseMethod method : considered)
      if (const auto expected = expectation.of(method)) candidates_.push_back({method, *expected, false});
    tried_finder_.reset();
    next_trial_ = updates_ + 6;
    trial_pause_ = 16;
    const Candidate best = *std::min_element(candidates_.begin(), candidates_.end(), is_quicker);
    if (!finder_ || best.method != method_) use(best.method, make_pair_finder(best.method));
  }

  static bool is_quicker(const Candidate& a, const Candidate& b) { return a.milliseconds < b.milliseconds; }
  static std::string words_of_sizes(const BoxSample& sample) {
    double least = std::numeric_limits<double>::infinity(), most = 0;
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
  [[nodiscard]] Candidate& candidate(BroadPhaseMethod method) {
    return *std::find_if(candidates_.begin(), candidates_.end(),
                         [&](const Candidate& one) { return one.method == method; });
  }

  void begin_trial() {
    if (tried_finder_ || updates_ < next_trial_ || !candidate(method_).measured) return;
    const Candidate* next = nullptr;
    for (const Candidate& one : candidates_)
      if (one.method != method_ && (next == nullptr || is_quicker(one, *next))) next = &one;
    next_trial_ = updates_ + trial_pause_;
    trial_pause_ = std::min<std::size_t>(4 * trial_pause_, 1024);
    if (next == nullptr || next->milliseconds > most_worse * candidate(method_).milliseconds) return;
    tried_ = next->method;
    tried_finder_ = make_pair_finder(tried_);
    tried_updates_ = 0;
  }

  /// The one on trial has seen all updates since it was made; the other one begins anew after it.
  [[nodiscard]] PairFinder& finder_of_update() { return tried_finder_ ? *tried_finder_ : *finder_; }

  /// What other programs take from a single update does not show.
  static double smoothed(double before, double now) {
    return now < before ? 0.5 * (before + now) : std::min(now, 1.05 * before);
  }

  void note(double milliseconds) {
    if (!tried_finder_) {
      Candidate& used = candidate(method_);
      // The first time all memory is new.
      if (is_warm_) used = {method_, used.measured ? 0.8 * used.milliseconds + 0.2 * milliseconds : milliseconds, true};
      is_warm_ = true;
      return;
    }
    if (++tried_updates_ < 2) return;
    candidate(tried_) = {tried_, milliseconds, true};
    if (milliseconds < clearly_better * candidate(method_).milliseconds) {
      use(tried_, std::move(tried_finder_));
      is_warm_ = true;
    } else if (method_ == BroadPhaseMethod::layers) {
      finder_ = make_pair_finder(method_);  // it has not seen what moved meanwhile
    }
    tried_finder_.reset();
  }

  BroadPhaseMethod method_ = BroadPhaseMethod::kd_tiles, tried_ = BroadPhaseMethod::kd_tiles;
  std::unique_ptr<PairFinder> finder_, tried_finder_;
  std::vector<Candidate> candidates_;
  bool is_warm_ = false;
  std::size_t tried_updates_ = 0;
  std::size_t updates_ = 0, looked_at_ = 0, patience_ = 2, next_trial_ = 0, trial_pause_ = 16;
  std::size_t count_ = 0;
  double moving_ = 0;
  bool is_heaped_ = false;
  std::string sizes_;
};

}  // namespace

std::unique_ptr<PairFinder> make_automatic() { return std::make_unique<Automatic>(); }

}  // namespace toccata
