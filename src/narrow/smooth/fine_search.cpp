#include "narrow/smooth/fine_search.hpp"

#include <cmath>

#include "math/vec3_measures.hpp"
#include "narrow/smooth/distance/smooth_proof.hpp"

namespace toccata {
namespace {

using FinePoint = VectorOf<DoubleWord>;

constexpr int most_steps = 256;

bool is_positive(const DoubleWord& x) { return x.high > 0; }

bool is_less(const DoubleWord& x, const DoubleWord& y) { return (x - y).high < 0; }

Vec3 rounded(const FinePoint& p) { return {p[0].high, p[1].high, p[2].high}; }

/// The face of a simplex that is nearest to the origin; four corners where the origin is inside.
struct Nearest {
  unsigned kept = 0;  ///< as bits
  FinePoint point{};
  DoubleWord squared{HUGE_VAL, 0};

  /// Of the relative interiors of all faces, the nearest point counts.
  void offer(unsigned bits, const FinePoint& at) {
    const DoubleWord now = inner(at, at);
    if (!(kept == 0 || is_less(now, squared))) return;
    kept = bits;
    point = at;
    squared = now;
  }
};

class FineSimplex {
 public:
  void append(const FinePoint& point, const SmoothSearch::Corner& corner) {
    point_[size_] = point;
    corner_[size_] = corner;
    ++size_;
  }

  void keep(unsigned bits) {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < size_; ++i) {
      if ((bits >> i & 1U) == 0) continue;
      point_[kept] = point_[i];
      corner_[kept] = corner_[i];
      ++kept;
    }
    size_ = kept;
  }

  /// Of a tetrahedron with the origin inside, with the weights that make it.
  [[nodiscard]] std::array<SmoothSearch::Corner, 4> corners() const {
    std::array<SmoothSearch::Corner, 4> corner = corner_;
    double total = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      corner[i].weight = std::fabs(volume_opposite(i));
      total += corner[i].weight;
    }
    for (SmoothSearch::Corner& c : corner) c.weight /= total;
    return corner;
  }

  [[nodiscard]] Nearest nearest() const {
    Nearest best;
    if (size_ == 4 && is_origin_inside()) {
      best.kept = 15;
      return best;
    }
    for (std::size_t i = 0; i < size_; ++i) {
      best.offer(1U << i, point_[i]);
      for (std::size_t j = 0; j < i; ++j) {
        offer_edge(best, i, j);
        for (std::size_t k = 0; k < j; ++k) offer_triangle(best, i, j, k);
      }
    }
    return best;
  }

 private:
  void offer_edge(Nearest& best, std::size_t i, std::size_t j) const {
    const FinePoint along = difference(point_[j], point_[i]);
    const DoubleWord squared = inner(along, along), part = -inner(point_[i], along);
    if (!is_positive(part) || !is_less(part, squared)) return;
    best.offer(1U << i | 1U << j, sum(point_[i], multiple(part / squared, along)));
  }

  void offer_triangle(Nearest& best, std::size_t i, std::size_t j, std::size_t k) const {
    const FinePoint &p = point_[i], &q = point_[j], &r = point_[k];
    const FinePoint normal = outer(difference(q, p), difference(r, p));
    const DoubleWord squared = inner(normal, normal);
    if (!is_positive(squared) || !is_positive(inner(normal, outer(q, r))) || !is_positive(inner(normal, outer(r, p))) ||
        !is_positive(inner(normal, outer(p, q))))
      return;
    best.offer(1U << i | 1U << j | 1U << k, multiple(inner(normal, p) / squared, normal));
  }

  /// Six times that of the tetrahedron of the origin and the face opposite to a corner; all have one sign where the
  /// origin is inside.
  [[nodiscard]] double volume_opposite(std::size_t i) const {
    const double volume = inner(outer(point_[(i + 1) % 4], point_[(i + 2) % 4]), point_[(i + 3) % 4]).high;
    return i % 2 == 0 ? volume : -volume;
  }

  [[nodiscard]] bool is_origin_inside() const {
    int positive = 0, negative = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      const double volume = volume_opposite(i);
      positive += volume > 0 ? 1 : 0;
      negative += volume < 0 ? 1 : 0;
    }
    return positive == 4 || negative == 4;
  }

  std::array<FinePoint, 4> point_{};
  std::array<SmoothSearch::Corner, 4> corner_{};
  std::size_t size_ = 0;
};

}  // namespace

std::optional<std::array<SmoothSearch::Corner, 4>> corners_around_origin(const SmoothBody& a, const SmoothBody& b,
                                                                         const Vec3& first_direction) {
  FineSimplex simplex;
  Nearest nearest;
  Vec3 direction = unit_or_zero(first_direction);
  for (int i = 0; i < most_steps && !(direction == Vec3{}); ++i) {
    const SmoothSearch::Corner corner{a.support(-direction), b.support(direction), 1};
    const FinePoint point = vector_as<DoubleWord>(point_of<BoundedNumber>(a, body_point(corner.a)) -
                                                  point_of<BoundedNumber>(b, body_point(corner.b)));
    if (i > 0 && !is_less(inner(nearest.point, point), nearest.squared)) return {};
    simplex.append(point, corner);
    const Nearest next = simplex.nearest();
    if (next.kept == 15) return simplex.corners();
    if (i > 0 && !is_less(next.squared, nearest.squared)) return {};
    nearest = next;
    simplex.keep(nearest.kept);
    direction = unit_or_zero(rounded(nearest.point));
  }
  return {};
}

}  // namespace toccata
