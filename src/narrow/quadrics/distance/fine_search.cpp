#include "narrow/quadrics/distance/fine_search.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "math/vec3_measures.hpp"

namespace toccata {
namespace {

constexpr int most_fine_steps = 256;
/// Generators that are as high as doubles tell.
constexpr Index most_level_generators = 16;
/// Apart where a plane has this part of the distance of the nearest point found.
constexpr double enough = 0.99;

bool is_positive(const DoubleWord& x) { return x.high > 0; }

bool is_less(const DoubleWord& x, const DoubleWord& y) { return (x - y).high < 0; }

/// The face of a simplex that is nearest to the origin; four corners where the origin is inside.
struct NearestFineFace {
  unsigned kept = 0;  ///< as bits
  FineVector point{};
  DoubleWord squared{HUGE_VAL, 0};

  /// Takes the point if it is nearer: the nearest point of the relative interiors of all faces counts.
  void offer(unsigned bits, const FineVector& at) {
    const DoubleWord now = inner(at, at);
    if (!(kept == 0 || is_less(now, squared))) return;
    kept = bits;
    point = at;
    squared = now;
  }
};

class FineSimplex {
 public:
  void append(const FineVector& point, const QuadricSearch::Corner& corner) {
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

  /// The corners of a tetrahedron with the origin inside, with the weights that make it.
  [[nodiscard]] std::array<QuadricSearch::Corner, 4> corners() const {
    std::array<QuadricSearch::Corner, 4> corner = corner_;
    double total = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      corner[i].weight = std::fabs(volume_opposite(i));
      total += corner[i].weight;
    }
    for (QuadricSearch::Corner& c : corner) c.weight /= total;
    return corner;
  }

  [[nodiscard]] NearestFineFace nearest() const {
    NearestFineFace best;
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
  void offer_edge(NearestFineFace& best, std::size_t i, std::size_t j) const {
    if (is_nearer(j, i)) std::swap(i, j);
    const FineVector along = difference(point_[j], point_[i]);
    const DoubleWord squared = inner(along, along), part = -inner(point_[i], along);
    if (!is_positive(part) || !is_less(part, squared)) return;
    best.offer(1U << i | 1U << j, sum(point_[i], multiple(part / squared, along)));
  }

  /// Seen from the corner that is nearest to the origin: what is rounded far away counts little then.
  void offer_triangle(NearestFineFace& best, std::size_t i, std::size_t j, std::size_t k) const {
    if (is_nearer(j, i)) std::swap(i, j);
    if (is_nearer(k, i)) std::swap(i, k);
    const FineVector &p = point_[i], u = difference(point_[j], p), v = difference(point_[k], p), normal = outer(u, v);
    const DoubleWord squared = inner(normal, normal);
    if (!is_positive(squared)) return;
    const DoubleWord of_u = inner(normal, outer(v, p)), of_v = inner(normal, outer(p, u));
    if (!is_positive(of_u) || !is_positive(of_v) || !is_less(of_u + of_v, squared)) return;
    best.offer(1U << i | 1U << j | 1U << k, multiple(inner(normal, p) / squared, normal));
  }

  [[nodiscard]] bool is_nearer(std::size_t i, std::size_t j) const {
    return is_less(inner(point_[i], point_[i]), inner(point_[j], point_[j]));
  }

  /// Six times that of the tetrahedron of the origin and the face opposite to a corner; all have one sign where the
  /// origin is inside.
  [[nodiscard]] double volume_opposite(std::size_t i) const {
    const double volume = volume_from_origin(point_[(i + 1) % 4], point_[(i + 2) % 4], point_[(i + 3) % 4]).high;
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

  std::array<FineVector, 4> point_{};
  std::array<QuadricSearch::Corner, 4> corner_{};
  std::size_t size_ = 0;
};

/// The direction of a vector, of length 1 but for rounding.
FineDirection unit_of(const FineVector& p) {
  const double largest = largest_magnitude(high_parts(p));
  if (!(largest > 0) || !std::isfinite(largest)) return {};
  const double length = largest * plain_length((1 / largest) * high_parts(p));
  return multiple(DoubleWord{1, 0} / DoubleWord{length, 0}, p);
}

FineDirection opposite(const FineDirection& d) { return {-d[0], -d[1], -d[2]}; }

/// The highest of the generators that doubles do not tell apart, and the round part for the direction.
QuadricSupport fine_support(const QuadricBody& body, const FineDirection& direction) {
  QuadricSupport support = body.support(high_parts(direction));
  std::array<Index, most_level_generators> found;
  const Index count = std::min(body.highest_generators(high_parts(direction), found), most_level_generators);
  DoubleWord highest = generator_height<BoundedNumber>(body, support.generator, direction).value;
  for (const Index generator : std::span(found.data(), count)) {
    const DoubleWord height = generator_height<BoundedNumber>(body, generator, direction).value;
    if (!is_less(highest, height)) continue;
    support.generator = generator;
    highest = height;
  }
  support.round = {};
  support.point = body.plain_centre(support.generator);
  if (!body.grown(support.generator)) return support;
  Vec3 along;
  for (std::size_t j = 0; j < body.column_count(); ++j)
    along[static_cast<int>(j)] = inner(direction, vector_as<DoubleWord>(body.column(j))).high;
  support.round = unit_or_zero(along);
  support.point = support.point + body.map(support.round);
  return support;
}

}  // namespace

FineEnd search_finely(const QuadricBody& a, const QuadricBody& b, const Vec3& first_direction) {
  FineSimplex simplex;
  NearestFineFace nearest;
  FineEnd end;
  end.direction = fine(unit_or_zero(first_direction));
  for (int i = 0; i < most_fine_steps; ++i) {
    const QuadricSearch::Corner corner{fine_support(a, opposite(end.direction)), fine_support(b, end.direction), 1};
    const FineVector point = vector_as<DoubleWord>(point_of<BoundedNumber>(a, body_point(corner.a)) -
                                                   point_of<BoundedNumber>(b, body_point(corner.b)));
    if (i > 0 && !is_less(inner(nearest.point, point), nearest.squared * enough)) break;
    simplex.append(point, corner);
    const NearestFineFace next = simplex.nearest();
    if (next.kept == 15) {
      end.around = simplex.corners();
      break;
    }
    if (!(next.squared.high > 0) || (i > 0 && !is_less(next.squared, nearest.squared))) break;
    nearest = next;
    simplex.keep(nearest.kept);
    end.direction = unit_of(nearest.point);
  }
  return end;
}

}  // namespace toccata
