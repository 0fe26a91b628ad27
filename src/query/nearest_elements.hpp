#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <tuple>
#include <vector>

#include "toccata/query/nearest.hpp"

namespace toccata {

/// The lower end that goes with the upper end of an interval of at most 0.99 · 10⁻¹² of it, or with the greater of two
/// neighbouring doubles: what is not nearer than such an interval allows is not below it.
inline double lower_from(double upper) {
  return upper == 0 ? 0 : std::min(upper * (1 - 0.995e-12), std::nextafter(upper, 0.0));
}

/// The k nearest of the elements that it is told of, by (upper, element), of those within the greatest distance.
class NearestElements {
 public:
  /// It keeps them in `memory`.
  NearestElements(std::size_t k, double max_distance, std::vector<SurfacePoint>& memory)
      : k_(k),
        max_distance_(max_distance),
        limit_(std::nextafter(max_distance * (1 + 2e-12), HUGE_VAL)),
        kept_(memory) {
    kept_.clear();
    if (k == 0) limit_ = -1;
  }

  /// An element whose distance is certainly greater than this is of no interest.
  [[nodiscard]] double limit() const { return limit_; }

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

 private:
  static bool comes_before(const SurfacePoint& a, const SurfacePoint& b) {
    return std::tie(a.upper, a.element) < std::tie(b.upper, b.element);
  }

  std::size_t k_;
  double max_distance_;
  double limit_;
  std::vector<SurfacePoint>& kept_;  ///< a heap, the farthest first
};

}  // namespace toccata
