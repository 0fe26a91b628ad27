#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <tuple>
#include <vector>

#include "toccata/query/nearest.hpp"

namespace toccata {

/// The lower end that goes with the upper end of an interval of at most 0.99 · 10⁻¹² of it, or with the greater of two
/// neighbouring doubles: what is not nearer than such an interval allows is not below it.
inline double lower_from(double upper) {
  const double lower = upper * (1 - 0.995e-12);
  return lower < upper || upper == 0 ? lower : std::nextafter(upper, 0.0);
}

/// Not less than (1 + 2 · 10⁻¹²) x, where that is rounded.
inline double a_little_above(double x) { return x * (1 + 2e-12) + std::numeric_limits<double>::min(); }

/// The k nearest of the elements that it is told of, by (upper, element), of those within the greatest distance.
class NearestElements {
 public:
  /// It keeps them in `memory`.
  NearestElements(std::size_t k, double max_distance, std::vector<SurfacePoint>& memory)
      : k_(k), max_distance_(max_distance), limit_(a_little_above(max_distance)), kept_(memory) {
    kept_.clear();
    if (k == 0) limit_ = -1;
  }

  /// An element whose distance is certainly greater than this is of no interest.
  [[nodiscard]] double limit() const { return limit_; }
  [[nodiscard]] std::size_t k() const { return k_; }

  /// `upper` is the upper end of the element's own interval, of at most 0.99 · 10⁻¹² of it, or its neighbouring double.
  void see(const SurfacePoint& one) {
    if (one.upper > limit_ || one.lower > max_distance_ || k_ == 0) return;
    if (kept_.size() == k_) {
      if (!comes_before(one, kept_.front())) return;
      std::pop_heap(kept_.begin(), kept_.end(), comes_before);
      kept_.back() = one;
    } else {
      kept_.push_back(one);
    }
    std::push_heap(kept_.begin(), kept_.end(), comes_before);
    if (kept_.size() == k_) limit_ = std::min(limit_, kept_.front().upper);
  }

  /// In order.
  [[nodiscard]] std::span<const SurfacePoint> in_order() {
    std::sort(kept_.begin(), kept_.end(), comes_before);
    return kept_;
  }

  /// The first of them.
  [[nodiscard]] std::optional<SurfacePoint> first() {
    const std::span<const SurfacePoint> all = in_order();
    return all.empty() ? std::nullopt : std::optional(all.front());
  }

 private:
  static bool comes_before(const SurfacePoint& a, const SurfacePoint& b) {
    return std::tie(a.upper, a.element) < std::tie(b.upper, b.element);
  }

  std::size_t k_;
  double max_distance_;
  double limit_;
  std::vector<SurfacePoint>& kept_;  ///< a heap, the farthest first
};

/// Elements that may be among the k nearest, by bounds of their distances.
class NearestCandidates {
 public:
  struct Memory {
    struct Element {
      double lower;
      Index number;
    };
    std::vector<Element> elements;
    std::vector<double> uppers;  ///< a heap of the k least, the greatest first
  };

  NearestCandidates(const NearestElements& nearest, Memory& memory)
      : k_(nearest.k()), limit_(nearest.limit()), memory_(memory) {
    memory_.elements.clear();
    memory_.uppers.clear();
  }

  /// The same limit as that of NearestElements.
  [[nodiscard]] double limit() const { return limit_; }

  void see(Index number, double lower, double upper) {
    if (lower > limit_) return;
    memory_.elements.push_back({lower, number});
    std::vector<double>& uppers = memory_.uppers;
    if (uppers.size() == k_) {
      if (upper >= uppers.front()) return;
      std::pop_heap(uppers.begin(), uppers.end());
      uppers.back() = upper;
    } else {
      uppers.push_back(upper);
    }
    std::push_heap(uppers.begin(), uppers.end());
    if (uppers.size() == k_) limit_ = std::min(limit_, a_little_above(uppers.front()));
  }

  /// Calls `visit(number)` with those that may still be. Where a distance is at most an upper bound, the upper end of
  /// its own interval is at most a little above it.
  template <class Visit>
  void for_each(const Visit& visit) const {
    for (const Memory::Element& element : memory_.elements)
      if (!(element.lower > limit_)) visit(element.number);
  }

 private:
  std::size_t k_;
  double limit_;
  Memory& memory_;
};

}  // namespace toccata
