// Cores grown by radii, from their nearest features: depths, contact points, and distances however small.
// docs/design/primitive-depths.md. Included once for every SIMD level, like math/lanes.hpp.
#if defined(TOCCATA_NARROW_OFFSET_CORE_PAIR_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef TOCCATA_NARROW_OFFSET_CORE_PAIR_HPP
#undef TOCCATA_NARROW_OFFSET_CORE_PAIR_HPP
#else
#define TOCCATA_NARROW_OFFSET_CORE_PAIR_HPP
#endif

#include <bit>
#include <cmath>
#include <cstdint>

#include "math/neighbours.hpp"
#include "narrow/boxes/rigid_poses.hpp"
#include "narrow/convex/contact_choices.hpp"
#include "narrow/primitives/core_features.hpp"
#include "narrow/primitives/nearness.hpp"
#include "narrow/primitives/offset_cores.hpp"
#include "narrow/primitives/pair_depths.hpp"
#include "narrow/primitives/pair_distances.hpp"

HWY_BEFORE_NAMESPACE();
namespace toccata {
namespace HWY_NAMESPACE {
namespace {

/// Two cores grown by their radii, and which of their features may be the nearest.
template <std::size_t edges, std::size_t ways = 0>
struct OffsetCorePair {
  CoreFeatures<edges, ways> features;
  double radius_a, radius_b;
  OneVector on_a, on_b;  ///< the nearest points, rounded
  ConvexFeature feature_a{}, feature_b{};
};

/// What doubles tell of them.
template <std::size_t edges>
struct PlainContact {
  PlainGap<edges> gap;
  bool is_apart = false, is_meeting = false;  ///< certainly
};

/// The length is off by less than 2^-48 of the size, and by the square of what the difference is off by across; where
/// that is less than the one and the length not far less than the size, their sum is far below the error.
template <std::size_t edges, std::size_t ways>
HWY_INLINE PlainContact<edges> plain_contact(const OffsetCorePair<edges, ways>& cores) {
  PlainContact<edges> contact{plain_gap(cores.features)};
  const double reach = cores.radius_a + cores.radius_b, size = contact.gap.size, squared = contact.gap.squared;
  const double error = 0x1p-46 * (size + reach) + nearness_floor, outer = reach + error, inner = reach - error;
  const bool is_certain = contact.gap.is_certain & (squared > 0x1p-32 * (size * size));
  contact.is_apart = is_certain & (squared > more_square * (outer * outer));
  contact.is_meeting = is_certain & (inner > 0) & (squared < less_square * (inner * inner));
  return contact;
}

/// The greatest double that is not more than a positive number.
struct DoubleBelow {
  double value = 0;
  bool is_certain = false;  ///< and the number is none
};

/// `high` is the number, rounded.
HWY_INLINE DoubleBelow double_below(const TwoPart& number, double off) {
  const auto is_rounded_up = static_cast<std::uint64_t>(number.low < 0);
  return {std::bit_cast<double>(std::bit_cast<std::uint64_t>(number.high) - is_rounded_up),
          number.high > 4 * off && std::fabs(number.low) > off};
}

/// The sum of the radii less the length.
template <std::size_t edges, std::size_t ways>
HWY_INLINE TwoPart depth_between(const PreciseGap& gap, const OffsetCorePair<edges, ways>& cores) {
  const TwoPart reach = two_sum(cores.radius_a, cores.radius_b), rest = two_difference(reach.high, gap.length.high);
  return two_sum(rest.high, (rest.low + reach.low) - gap.length.low);
}

/// What that is off by: two roundings of what is below the last places.
template <std::size_t edges, std::size_t ways>
HWY_INLINE double depth_error(const PreciseGap& gap, const OffsetCorePair<edges, ways>& cores) {
  return gap.off + 0x1p-100 * (cores.radius_a + cores.radius_b);
}

HWY_INLINE bool is_along_an_axis(const OneVector& v) {
  return (first_of(x_of(v)) != 0) + (first_of(y_of(v)) != 0) + (first_of(z_of(v)) != 0) == 1;
}

/// The direction of a vector along an axis, of length 1 to the bit.
HWY_INLINE OneVector unit_along_axis(const OneVector& v) {
  const auto sign = [](double x) { return x > 0 ? 1.0 : x < 0 ? -1.0 : x; };
  return in_one(sign(first_of(x_of(v))), sign(first_of(y_of(v))), sign(first_of(z_of(v))));
}

/// Bounds as `rounded_depth` has them; those of shapes that are apart are 0.
template <std::size_t edges, std::size_t ways>
HWY_INLINE Penetration depth_of(const OffsetCorePair<edges, ways>& cores) {
  const PlainContact<edges> contact = plain_contact(cores);
  OneVector direction;
  double lower = 0, upper = 0;
  if (contact.is_apart) {
    direction = scaled(-1 / std::sqrt(contact.gap.squared), contact.gap.apart);
  } else {
    const PreciseGap gap = precise_gap(cores.features, contact.gap);
    const DoubleBelow depth = double_below(depth_between(gap, cores), depth_error(gap, cores));
    if (!(contact.is_meeting & gap.is_precise & depth.is_certain)) return unknown_depth();
    direction = scaled(-gap.length.inverse, gap.apart);
    lower = depth.value;
    upper = next_above(depth.value);
    // Along a rounded direction it is a little farther.
    if (is_along_an_axis(direction))
      direction = unit_along_axis(direction);
    else
      upper = next_above(upper + 0x1p-50 * upper);
  }
  Penetration result;
  result.lower = lower;
  result.upper = upper;
  store(direction, result.direction);
  store(plus(cores.on_a, scaled(cores.radius_a, direction)), result.on_a);
  store(minus(cores.on_b, scaled(cores.radius_b, direction)), result.on_b);
  return result;
}

/// The distance of shapes that are apart: neighbouring doubles around it.
template <std::size_t edges, std::size_t ways>
HWY_INLINE Distance distance_of(const OffsetCorePair<edges, ways>& cores) {
  const PlainContact<edges> contact = plain_contact(cores);
  const PreciseGap gap = precise_gap(cores.features, contact.gap);
  const TwoPart depth = depth_between(gap, cores);
  const DoubleBelow below = double_below({-depth.high, -depth.low}, depth_error(gap, cores));
  const bool is_known = contact.is_apart & contact.gap.is_placed & gap.is_precise & below.is_certain;
  if (!is_known) return unknown_distance();
  Distance result;
  result.lower = below.value;
  result.upper = next_above(below.value);
  store(minus(cores.on_a, scaled(cores.radius_a * gap.length.inverse, gap.apart)), result.on_a);
  store(plus(cores.on_b, scaled(cores.radius_b * gap.length.inverse, gap.apart)), result.on_b);
  return result;
}

/// A single point: nothing is promised of its last digits.
template <std::size_t edges, std::size_t ways>
HWY_INLINE Manifold manifold_of(const OffsetCorePair<edges, ways>& cores) {
  const PlainContact<edges> contact = plain_contact(cores);
  if (contact.is_apart) return {};
  if (!contact.is_meeting) return unknown_manifold();
  const double length = std::sqrt(contact.gap.squared);
  const OneVector normal = scaled(-1 / length, contact.gap.apart);
  const OneVector on_a = plus(cores.on_a, scaled(cores.radius_a, normal)),
                  on_b = minus(cores.on_b, scaled(cores.radius_b, normal));
  Manifold result;
  result.count = 1;
  store(normal, result.normal);
  ManifoldPoint& point = result.points[0];
  // The order of two balls does not show.
  store(plus(scaled(0.5, on_a), scaled(0.5, on_b)), point.position);
  point.depth = (cores.radius_a + cores.radius_b) - length;
  point.on_a = cores.feature_a;
  point.on_b = cores.feature_b;
  return result;
}

// The features of points and segments.

constexpr ConvexFeature only_vertex{ConvexFeature::Kind::vertex, 0}, only_edge{ConvexFeature::Kind::edge, 0};

/// The feature of a segment at the share of its length; without a branch.
HWY_INLINE ConvexFeature feature_at(double share) {
  const bool is_within = (share > 0) & (share < 1);
  return {is_within ? ConvexFeature::Kind::edge : ConvexFeature::Kind::vertex,
          static_cast<Index>((share >= 1) & !is_within)};
}

/// NaN becomes 0.
HWY_INLINE double clamped_to_share(double value) { return value > 0 ? (value < 1 ? value : 1) : 0; }

struct OneBall {
  OneVector centre;
  double radius;
};

struct OneRod {
  OneVector start, end;
  double radius;
};

HWY_INLINE OneBall in_world(const PosedSphere& s) { return {in_one(s.centre), s.radius}; }
HWY_INLINE OneRod in_world(const PosedCapsule& c) { return {in_one(c.start), in_one(c.end), c.radius}; }

/// The shape in the world, by a pose that is known to be rigid.
HWY_INLINE OneBall in_world(const Sphere& shape, const Pose& pose) {
  return {placed_in_one(pose, shape.centre()), shape.radius()};
}
HWY_INLINE OneRod in_world(const Capsule& shape, const Pose& pose) {
  const Placing placing(pose);
  return {placing(shape.start()), placing(shape.end()), shape.radius()};
}

HWY_INLINE OffsetCorePair<0> cores_of(const OneBall& a, const OneBall& b) {
  return {{a.centre, b.centre, {}}, a.radius, b.radius, a.centre, b.centre};
}

HWY_INLINE OffsetCorePair<1> cores_of(const OneBall& a, const OneRod& b) {
  const OneVector edge = minus(b.end, b.start);
  const double inverse = 1 / first_of(dot(edge, edge)),
               share = clamped_to_share(first_of(dot(minus(a.centre, b.start), edge)) * inverse);
  return {{a.centre, b.start, {{{b.start, b.end, share, inverse}}}},
          a.radius,
          b.radius,
          a.centre,
          plus(b.start, scaled(share, edge)),
          {},
          feature_at(share)};
}

/// As near_of_segments has them.
HWY_INLINE OffsetCorePair<2> cores_of(const OneRod& a, const OneRod& b) {
  const OneVector u = minus(a.end, a.start), v = minus(b.end, b.start), w = minus(a.start, b.start);
  const double uu = first_of(dot(u, u)), vv = first_of(dot(v, v)), uv = first_of(dot(u, v)),
               along_u = first_of(dot(u, w)), along_v = first_of(dot(v, w));
  const double inverse_u = 1 / uu, inverse_v = 1 / vv;
  const double first = clamped_to_share((uv * along_v - along_u * vv) / (uu * vv - uv * uv));
  const double t = clamped_to_share((uv * inverse_v) * first + along_v * inverse_v);
  const double s = clamped_to_share((uv * inverse_u) * t - along_u * inverse_u);
  return {{a.start, b.start, {{{a.end, a.start, s, inverse_u}, {b.start, b.end, t, inverse_v}}}},
          a.radius,
          b.radius,
          plus(a.start, scaled(s, u)),
          plus(b.start, scaled(t, v)),
          feature_at(s),
          feature_at(t)};
}

/// Two capsules go through the formula in the lexicographic order of their starts.
enum class Order { as_given, exchanged, unknown };

HWY_INLINE Order order_of(const OneRod& a, const OneRod& b) {
  if (hn::AllTrue(OneTag(), comes_after(b.start, a.start))) return Order::as_given;
  return hn::AllTrue(OneTag(), comes_after(a.start, b.start)) ? Order::exchanged : Order::unknown;
}

HWY_INLINE OneRod chosen(bool yes, const OneRod& a, const OneRod& b) {
  const OneMask mask = hn::Gt(all<OneNumber>(yes ? 1 : 0), hn::Zero(OneTag()));
  return {select(mask, a.start, b.start), select(mask, a.end, b.end), yes ? a.radius : b.radius};
}

/// Two that lie along each other touch in more than a point.
HWY_INLINE bool may_lie_along(const OneRod& a, const OneRod& b) {
  const OneVector u = minus(a.end, a.start), v = minus(b.end, b.start);
  const double uv = first_of(dot(u, v)), lengths = first_of(dot(u, u)) * first_of(dot(v, v));
  return !(uv * uv < 0.999 * cosine_of_face_contact * cosine_of_face_contact * lengths);
}

template <class A, class B>
HWY_INLINE Penetration depth_for(const A& a, const B& b) {
  return depth_of(cores_of(a, b));
}
template <class A, class B>
HWY_INLINE Manifold manifold_for(const A& a, const B& b) {
  return manifold_of(cores_of(a, b));
}
template <class A, class B>
HWY_INLINE Distance distance_for(const A& a, const B& b) {
  return distance_of(cores_of(a, b));
}

HWY_INLINE Penetration depth_for(const OneRod& a, const OneRod& b) {
  const Order order = order_of(a, b);
  if (order == Order::unknown) return unknown_depth();
  const bool given = order == Order::as_given;
  Penetration depth = depth_of(cores_of(chosen(given, a, b), chosen(given, b, a)));
  if (!given) depth = flipped(depth);
  return depth;
}

HWY_INLINE Manifold manifold_for(const OneRod& a, const OneRod& b) {
  const Order order = order_of(a, b);
  if (order == Order::unknown || may_lie_along(a, b)) return unknown_manifold();
  const bool given = order == Order::as_given;
  Manifold manifold = manifold_of(cores_of(chosen(given, a, b), chosen(given, b, a)));
  if (!given) manifold = flipped(manifold);
  return manifold;
}

HWY_INLINE Distance distance_for(const OneRod& a, const OneRod& b) {
  const Order order = order_of(a, b);
  if (order == Order::unknown) return unknown_distance();
  const bool given = order == Order::as_given;
  Distance distance = distance_of(cores_of(chosen(given, a, b), chosen(given, b, a)));
  if (!given) distance = flipped(distance);
  return distance;
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace toccata
HWY_AFTER_NAMESPACE();

#endif
