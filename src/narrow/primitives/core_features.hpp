// The nearest points of two simple cores from their features, first in doubles and then with twice the digits:
// docs/design/primitive-depths.md. Included once for every SIMD level, like math/lanes.hpp.
#if defined(TOCCATA_NARROW_CORE_FEATURES_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef TOCCATA_NARROW_CORE_FEATURES_HPP
#undef TOCCATA_NARROW_CORE_FEATURES_HPP
#else
#define TOCCATA_NARROW_CORE_FEATURES_HPP
#endif

#include <array>
#include <cstddef>
#include <type_traits>

#include "narrow/primitives/long_vector.hpp"

HWY_BEFORE_NAMESPACE();
namespace toccata {
namespace HWY_NAMESPACE {
namespace {

// Which feature it is cannot be foreseen, so that an edge is looked at in the same way, without a branch, whether the
// nearest point lies within it or at an end.

/// An edge of the difference of two cores, an edge of A or one of B turned round.
struct CoreEdge {
  OneVector head, tail;
  double share = 0;            ///< of the nearest point tail + share · (head − tail), from 0 to 1
  double inverse_squared = 0;  ///< 1 / |head − tail|²
};

/// Two cores, and which of their features may be the nearest: on_a − on_b + Σ share · (head − tail).
template <std::size_t edges, std::size_t ways = 0>
struct CoreFeatures {
  OneVector on_a, on_b;  ///< vertices
  std::array<CoreEdge, edges> edge;
  std::array<OneVector, ways> beyond{};  ///< from that vertex of the difference to others, which are no ends of edges
  double slack = 0;                      ///< by which a vertex may be beside where the edges and ways have it
};

// Bounds, with u = 2^-53, S the sum of the magnitudes of the coordinates of on_a − on_b and of all edges (`size`), and
// x the difference of the two points as it is found. Each coordinate of x is a difference of vertices and at most two
// steps along edges, and off by 4u of their magnitudes at most; its product with an edge, over the edge's length, by 4u
// of its length more. Both together are less than 2^-50 S.
//
// Let F be the free edges and x* the nearest point of their plane. x − x* lies in that plane, so that |x|² = |x*|² +
// |x − x*|²: what x is off by across, it is longer by in second order only. x* is the nearest point of the difference
// if its shares lie within the edges and the held edges lead away from the origin there.

/// Shares this near to an end are left to the general way.
constexpr double least_share = 0x1p-30;

/// The edges as doubles have them.
template <std::size_t edges>
struct PlainEdges {
  std::array<OneVector, edges> way;
  std::array<double, edges> inverse_squared;
  std::array<bool, edges> is_free;
  double mixed = 0;         ///< the product of two that are both free
  double sine_squared = 1;  ///< of the angle between these
  double inverse_sine_squared = 1;

  [[nodiscard]] HWY_INLINE std::array<double, edges> along(const OneVector& x) const {
    std::array<double, edges> products;
    for (std::size_t i = 0; i < edges; ++i) products[i] = is_free[i] ? first_of(dot(way[i], x)) : 0;
    return products;
  }

  /// A bound of |x − x*|² from the products of x with the free edges, each of them off by at most `off` over the edge's
  /// length: |x − x*|² ≤ Σ (x · E / |E|)² / (1 − |cos|), and 1 − |cos| is at least half of the squared sine.
  [[nodiscard]] HWY_INLINE double across_squared(const std::array<double, edges>& products, double off) const {
    double sum = 0;
    for (std::size_t i = 0; i < edges; ++i) sum += products[i] * products[i] * inverse_squared[i] + off * off;
    return (edges > 1 ? 4 : 2) * (sum * inverse_sine_squared);
  }
};

template <std::size_t edges, std::size_t ways>
HWY_INLINE PlainEdges<edges> plain_edges(const CoreFeatures<edges, ways>& f) {
  PlainEdges<edges> plain;
  for (std::size_t i = 0; i < edges; ++i) {
    const double share = f.edge[i].share;
    plain.way[i] = minus(f.edge[i].head, f.edge[i].tail);
    plain.inverse_squared[i] = f.edge[i].inverse_squared;
    plain.is_free[i] = (share > 0) & (share < 1);
  }
  if constexpr (edges == 2) {
    const bool first = plain.is_free[0], second = plain.is_free[1];
    plain.mixed = (first & second) ? first_of(dot(plain.way[0], plain.way[1])) : 0;
    plain.sine_squared = 1 - plain.mixed * plain.mixed * (plain.inverse_squared[0] * plain.inverse_squared[1]);
    plain.inverse_sine_squared = 1 / plain.sine_squared;
  }
  return plain;
}

/// In doubles.
template <std::size_t edges>
struct PlainGap {
  PlainEdges<edges> edges_found;
  OneVector apart{};  ///< on_a − on_b
  double squared = 0;
  double size = 0;
  bool is_certain = false;  ///< the features are the nearest, and there are no others
  bool is_placed = true;    ///< the points are as near to the nearest ones as is promised of witnesses
};

/// What the product of x with a way may be off by from that with x*, squared: a part for each unit of the way's length.
struct SlopeError {
  double of_length, of_any;

  [[nodiscard]] HWY_INLINE bool leaves_positive(double slope, double way_squared) const {
    return (slope > 0) & (slope * slope > of_length * way_squared + of_any);
  }
};

template <std::size_t edges, std::size_t ways>
HWY_INLINE PlainGap<edges> plain_gap(const CoreFeatures<edges, ways>& f) {
  PlainGap<edges> gap{plain_edges(f)};
  const PlainEdges<edges>& plain = gap.edges_found;
  gap.apart = minus(f.on_a, f.on_b);
  OneVector sizes = magnitudes_of(gap.apart);
  for (std::size_t i = 0; i < edges; ++i) {
    gap.apart = plus(gap.apart, scaled(f.edge[i].share, plain.way[i]));
    sizes = plus(sizes, magnitudes_of(plain.way[i]));
  }
  gap.size = first_of(sum_of(sizes));
  gap.squared = first_of(dot(gap.apart, gap.apart));
  gap.is_certain = plain.sine_squared > 0x1p-12;
  if constexpr (edges > 0) {
    const double rounding = 0x1.08p-50 * gap.size;
    const double across = plain.across_squared(plain.along(gap.apart), rounding);
    // 2^-45 of the size is less than 10^-12 of the greatest coordinate.
    gap.is_placed = across < 0x1p-90 * (gap.size * gap.size) * plain.sine_squared;
    // By what x is off by and by what x* differs from it; and what vertices are off by, eight of them in a sum of
    // edges.
    const SlopeError error{8 * (rounding * rounding + across), 512 * (f.slack * f.slack) * gap.squared};
    for (std::size_t i = 0; i < edges; ++i) {
      const double share = f.edge[i].share, slope = first_of(dot(plain.way[i], gap.apart));
      // A share is off by at most |x − x*| / (|E| · sine).
      const bool is_within = (share > least_share) & (share < 1 - least_share) &
                             (across * plain.inverse_squared[i] < 0x1p-64 * plain.sine_squared);
      const double outwards = share > 0.5 ? -slope : slope;
      const bool is_held = error.leaves_positive(outwards, first_of(dot(plain.way[i], plain.way[i])));
      gap.is_certain = gap.is_certain & (plain.is_free[i] ? is_within : is_held);
    }
    for (const OneVector& way : f.beyond)
      gap.is_certain = gap.is_certain & error.leaves_positive(first_of(dot(way, gap.apart)), first_of(dot(way, way)));
  }
  return gap;
}

/// The vector without coordinates so small that what products are off by underflows, which levels do differently.
HWY_INLINE OneVector without_least(const OneVector& v) {
  return each(
      [](const auto& c) HWY_ATTR {
        using N = std::remove_cvref_t<decltype(c)>;
        return hn::IfThenElseZero(hn::Ge(hn::Abs(c), all<N>(0x1p-900)), c);
      },
      v);
}

/// The gap with twice the digits.
struct PreciseGap {
  OneVector apart;  ///< on_a − on_b, each coordinate nearly rounded once
  LongRoot length;  ///< of that
  double off = 0;   ///< what the length may be off by
  bool is_precise = false;
};

constexpr double greatest_correction = 0x1p-46;

/// Moves x along the free edges by what is left of its products with them.
template <std::size_t edges>
HWY_INLINE bool correct(const PlainEdges<edges>& plain, LongVector& x) {
  const std::array<double, edges> along = plain.along(plus(x.high, x.low));
  bool is_small = true;
  for (std::size_t i = 0; i < edges; ++i) {
    double rest = along[i];
    if constexpr (edges == 2) rest -= plain.mixed * along[1 - i] * plain.inverse_squared[1 - i];
    const double back = rest * (plain.inverse_squared[i] * plain.inverse_sine_squared);
    x.low = minus(x.low, scaled(back, plain.way[i]));
    is_small = is_small & (std::fabs(back) <= greatest_correction);
  }
  return is_small;
}

/// The gap of features that `plain_gap` has confirmed. The sums lose less than 2^-101 of the size, the corrections
/// 2^-98; the root 2^-99 of itself. Products with the edges, over their lengths, are off by less than 8u |x|.
template <std::size_t edges, std::size_t ways>
HWY_INLINE PreciseGap precise_gap(const CoreFeatures<edges, ways>& f, const PlainGap<edges>& plain) {
  LongVector x = exact_difference(f.on_a, f.on_b);
  double across = 0;
  bool is_corrected = true;
  if constexpr (edges > 0) {
    for (std::size_t i = 0; i < edges; ++i)
      x = moved(x, f.edge[i].share, exact_difference(f.edge[i].head, f.edge[i].tail));
    is_corrected = correct(plain.edges_found, x);
    x = renormalized(x);
    across = plain.edges_found.across_squared(plain.edges_found.along(x.high),
                                              0x1p-50 * first_of(sum_of(magnitudes_of(x.high))));
  }
  const TwoPart square = long_square(x);
  PreciseGap gap{without_least(x.high), long_root(square), 0, false};
  gap.off = 0x1p-96 * (gap.length.high + plain.size) + across * gap.length.inverse;
  gap.is_precise = is_corrected & (across <= 0x1p-80 * square.high) & (square.high > 0x1p-400) &
                   (square.high < 0x1p400) & (plain.size < 0x1p200);
  return gap;
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace toccata
HWY_AFTER_NAMESPACE();

#endif
