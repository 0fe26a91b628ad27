#include "narrow/convex/expanding_polytope.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include "math/constants.hpp"
#include "math/vec3_measures.hpp"

// How far a rounded facet may be off. Let u = 2^-53 and V = extent(), the greatest magnitude of a coordinate of D. A
// corner's coordinates are off by at most uV each, an edge's by 4uV, so an edge vector e, of length E ≤ 2√3 V, by 7uV.
// The cross product n of two edges is off by 7uV(E1 + E2) for that (and a little more that is of second order), and by
// at most 6u E1 E2 ≤ 11uV(E1 + E2) for its own rounding: by 18uV(E1 + E2). The height n · e above the facet is then off
// by 18uV(E1 + E2) E ≤ 63uV²(E1 + E2), and by 21uV|n| ≤ 37uV²(E1 + E2) for e and for the product. For the offset the
// same holds with a corner in place of e, of length √3 V at most; in place of what that leaves, the error of |n| makes
// the distance offset / |n| wrong by 18uV(E1 + E2) √3 V / |n| ≤ 32uV²(E1 + E2) / |n|. All together stay below `error` =
// 128uV²(E1 + E2), along n. The second order needs edges that are longer than V / 2^40. An exact facet's normal is off
// by its last rounding only.
namespace toccata {
namespace {

/// numerator / √squared · 2^exponent, right to 2^-52 of itself where it is a normal double. The square of the quotient,
/// scaled to an integer of at least 130 bits, has a root of at least 65.
double quotient_by_root(const WideInteger& numerator, const WideInteger& squared, int exponent) {
  if (numerator == 0) return 0;
  const WideInteger square = numerator * numerator;
  const int missing = 132 + static_cast<int>(msb(squared)) - static_cast<int>(msb(square));
  const int half = std::max(0, (missing + 1) / 2);
  const WideInteger root = sqrt(WideInteger((square << static_cast<unsigned>(2 * half)) / squared));
  const double length = nearest_double(root, 1, exponent - half);
  return numerator < 0 ? -length : length;
}

}  // namespace

Vec3 unit_vector(const IntegerVector& n) {
  const Vec3 rounded = rounded_direction(n);
  return (1 / std::sqrt(dot(rounded, rounded))) * rounded;
}

ExpandingPolytope::ExpandingPolytope(const DifferenceBody& body)
    : body_(body),
      memory_(buffer_.data(), buffer_.size()),
      points_(&memory_),
      facets_(&memory_),
      queue_(&memory_),
      horizon_(&memory_),
      walk_(&memory_) {
  points_.reserve(48);
  facets_.reserve(192);
  queue_.reserve(192);
  horizon_.reserve(64);
  walk_.reserve(64);
}

// The queue is short: what lies beyond the upper bound never enters it. What is out of date leaves it here. A distance
// may underflow in its lower bound and still be more than the none of another facet: among equals the upper bound
// tells.
Index ExpandingPolytope::nearest() {
  std::size_t kept = 0;
  QueueEntry first{infinity, 0};
  const auto is_before = [this](const QueueEntry& p, const QueueEntry& q) {
    return std::tuple(p.lower, facets_[p.facet].upper, p.facet) < std::tuple(q.lower, facets_[q.facet].upper, q.facet);
  };
  for (const QueueEntry& entry : queue_) {
    const PolytopeFacet& facet = facets_[entry.facet];
    // A facet that was made exact has come in twice.
    if (!facet.alive || facet.lower != entry.lower || entry.lower > upper_) continue;
    queue_[kept++] = entry;
    if (is_before(entry, first)) first = entry;
  }
  queue_.resize(kept);
  return first.facet;
}

void ExpandingPolytope::enqueue(Index f) {
  if (facets_[f].lower <= upper_) queue_.push_back({facets_[f].lower, f});
}

void ExpandingPolytope::measure(PolytopeFacet& facet) const {
  const Vec3 &p = points_[facet.corner[0]].value, &q = points_[facet.corner[1]].value,
             &r = points_[facet.corner[2]].value;
  const Vec3 to_q = q - p, to_r = r - p;
  const double extent = body_.extent(), size_q = sum_of_magnitudes(to_q), size_r = sum_of_magnitudes(to_r);
  facet.normal = cross(to_q, to_r);
  facet.offset = dot(facet.normal, p);
  facet.error = 0x1p-46 * extent * extent * (size_q + size_r);
  const double squared = dot(facet.normal, facet.normal);
  if (squared < 0x1p-900 || std::min(size_q, size_r) < 0x1p-40 * extent) facet.error = infinity;
  facet.lower = (facet.offset - facet.error) / std::sqrt(squared);
}

Index ExpandingPolytope::add_facet(Index p, Index q, Index r) {
  const auto f = static_cast<Index>(facets_.size());
  PolytopeFacet& facet = facets_.emplace_back();
  facet.corner = {p, q, r};
  measure(facet);
  if (facet.error < infinity)
    enqueue(f);
  else
    make_exact(f);
  return f;
}

void ExpandingPolytope::settle(Index f, const Vec3& unit_normal, double distance, double lower, double upper) {
  PolytopeFacet& facet = facets_[f];
  facet.precise = true;
  facet.normal = unit_normal;
  facet.offset = distance;
  facet.error = 0x1p-47 * body_.extent();
  facet.lower = lower;
  facet.upper = upper;
  enqueue(f);
}

// With W = 2^-102 for each operation (double_word.hpp): corners are exact, and edges off by W of themselves, which
// makes the normal off by less than 8W E1 E2, and its product with a corner by less than 32W E1 E2 V.
void ExpandingPolytope::make_precise(Index f) {
  const auto precise = [&](std::size_t k) { return body_.precise_point(corner(f, k).on_a, corner(f, k).on_b); };
  const PrecisePoint p = precise(0), to_q = precise(1) - p, to_r = precise(2) - p;
  const PrecisePoint n = cross(to_q, to_r);
  const Vec3 rounded{n.x.high, n.y.high, n.z.high};
  const double length = std::sqrt(dot(rounded, rounded));
  const double edges = sum_of_magnitudes({to_q.x.high, to_q.y.high, to_q.z.high}) *
                       sum_of_magnitudes({to_r.x.high, to_r.y.high, to_r.z.high});
  if (!(length > 0x1p-40 * edges) || !(length > 0x1p-450)) return make_exact(f);
  const double distance = dot(n, p).high / length;
  const double error = 0x1p-97 * edges * body_.extent() / length + 0x1p-50 * std::fabs(distance);
  settle(f, (1 / length) * rounded, distance, distance - error, distance + error);
}

void ExpandingPolytope::make_exact(Index f) {
  const auto exact = [&](std::size_t k) { return body_.exact_point(corner(f, k).on_a, corner(f, k).on_b); };
  const IntegerVector p = exact(0);
  ExactPlane plane{cross(exact(1) - p, exact(2) - p), 0};
  plane.offset = dot(plane.normal, p);
  const WideInteger squared = dot(plane.normal, plane.normal);
  const double distance = body_.scaled_length(quotient_by_root(plane.offset, squared, body_.exact_exponent()));
  facets_[f].exact = static_cast<Index>(planes_.size());
  // Rounding takes the last denormal digits, but not the side on which the origin lies, however near it is: or a facet
  // that has the origin behind it could pass for one that is nearer than another that has it before it.
  const Sign side = sign_of(plane.offset);
  const double underflow = side == Sign::zero ? 0 : std::numeric_limits<double>::denorm_min();
  const double error = 0x1p-51 * std::fabs(distance) + underflow;
  const double lower = side == Sign::positive ? std::max(distance - error, 0.0) : distance - error;
  const double upper = side == Sign::negative ? std::min(distance + error, 0.0) : distance + error;
  settle(f, unit_vector(plane.normal), distance, lower, upper);
  planes_.push_back(std::move(plane));
}

// Where the facet is of a face of one and a vertex of the other, or of an edge of each, the corners' vertices make no
// other points of D than such as lie in the plane.
bool ExpandingPolytope::is_certainly_of_body(Index f) const {
  const Vec3& n = facets_[f].normal;
  const DifferencePoint &p = corner(f, 0), &q = corner(f, 1), &r = corner(f, 2);
  const bool one_on_a = p.on_a == q.on_a && q.on_a == r.on_a, one_on_b = p.on_b == q.on_b && q.on_b == r.on_b;
  const auto two = [](Index i, Index j, Index k) { return i == j || j == k || k == i; };
  if (!one_on_a && !one_on_b && !(two(p.on_a, q.on_a, r.on_a) && two(p.on_b, q.on_b, r.on_b))) return false;
  const double top = body_.a().height(p.on_a, n) - facets_[f].error,
               bottom = body_.b().height(p.on_b, n) + facets_[f].error;
  for (Index i = 0; i < body_.a().count(); ++i)
    if (body_.a().height(i, n) >= top && i != p.on_a && i != q.on_a && i != r.on_a) return false;
  for (Index i = 0; i < body_.b().count(); ++i)
    if (body_.b().height(i, n) <= bottom && i != p.on_b && i != q.on_b && i != r.on_b) return false;
  return true;
}

// With n = (q − p) × (r − p), the foot is (n · p / n · n) n, and the areas that it spans with two corners each, seen
// along n, are those of the origin.
std::array<double, 3> ExpandingPolytope::weights_of_foot(Index f) const {
  const auto exact = [&](std::size_t k) { return body_.exact_point(corner(f, k).on_a, corner(f, k).on_b); };
  const IntegerVector p = exact(0), q = exact(1), r = exact(2), n = cross(q - p, r - p);
  const WideInteger whole = dot(n, n);
  if (whole == 0) return {1, 0, 0};
  const auto share = [&](const IntegerVector& u, const IntegerVector& v) {
    return nearest_double(dot(n, cross(u, v)), whole, 0);
  };
  return {share(q, r), share(r, p), share(p, q)};
}

ExpandingPolytope::ExactSupport ExpandingPolytope::exact_support(Index f) const {
  const ExactPlane& plane = planes_[facets_[f].exact];
  const Vec3& n = facets_[f].normal;
  const double unsure = 0x1p-47 * body_.extent();
  const auto exact_height = [&](Index on_a, Index on_b) { return dot(plane.normal, body_.exact_point(on_a, on_b)); };
  DifferencePoint best = body_.support(n);
  WideInteger greatest = exact_height(best.on_a, best.on_b);
  const double top_a = body_.a().height(best.on_a, n), bottom_b = body_.b().height(best.on_b, n);
  const Index on_b = best.on_b;
  for (Index i = 0; i < body_.a().count(); ++i) {
    if (i == best.on_a || body_.a().height(i, n) < top_a - unsure) continue;
    const WideInteger here = exact_height(i, on_b);
    if (here > greatest) best.on_a = i, greatest = here;
  }
  for (Index i = 0; i < body_.b().count(); ++i) {
    if (i == best.on_b || body_.b().height(i, n) > bottom_b + unsure) continue;
    const WideInteger here = exact_height(best.on_a, i);
    if (here > greatest) best.on_b = i, greatest = here;
  }
  return {body_.point(best.on_a, best.on_b), sign_of(WideInteger(greatest - plane.offset))};
}

// The four differences of two edges, one of A and one of B, lie in one plane.
bool ExpandingPolytope::completes_parallelogram(Index f, const DifferencePoint& p) const {
  for (std::size_t k = 0; k < 3; ++k) {
    const DifferencePoint &opposite = corner(f, k), &q = corner(f, (k + 1) % 3), &r = corner(f, (k + 2) % 3);
    if (q.on_a == p.on_a && r.on_b == p.on_b && opposite.on_a == r.on_a && opposite.on_b == q.on_b) return true;
    if (r.on_a == p.on_a && q.on_b == p.on_b && opposite.on_a == q.on_a && opposite.on_b == r.on_b) return true;
  }
  return false;
}

Sign ExpandingPolytope::height_sign(Index f, const DifferencePoint& p) {
  const double rounded = height(f, p);
  if (rounded > facets_[f].error) return Sign::positive;
  if (rounded < -facets_[f].error) return Sign::negative;
  if (completes_parallelogram(f, p)) return Sign::zero;
  if (!is_exact(f)) make_exact(f);
  const ExactPlane& plane = planes_[facets_[f].exact];
  return sign_of(WideInteger(dot(plane.normal, body_.exact_point(p.on_a, p.on_b)) - plane.offset));
}

bool ExpandingPolytope::sees(const DifferencePoint& p, Index f) {
  return facets_[f].alive && height_sign(f, p) == Sign::positive;
}

std::size_t ExpandingPolytope::edge_towards(Index f, Index neighbour) const {
  const auto& around = facets_[f].neighbour;
  return around[0] == neighbour ? 0 : around[1] == neighbour ? 1 : 2;
}

// From the first facet over its edges, depth first and in their order: so the edges of the horizon come one after the
// other around it. Facets that are seen die at once.
void ExpandingPolytope::find_horizon(const DifferencePoint& point, Index above) {
  horizon_.clear();
  walk_.clear();
  facets_[above].alive = false;
  walk_.push_back({above, 0, 3});
  while (!walk_.empty()) {
    Walk& at = walk_.back();
    if (at.left == 0) {
      walk_.pop_back();
      continue;
    }
    const Index from = at.facet;
    const std::size_t edge = at.edge;
    at.edge = (edge + 1) % 3;
    --at.left;
    const Index next = facets_[from].neighbour[edge];
    if (!facets_[next].alive) continue;
    if (sees(point, next)) {
      facets_[next].alive = false;
      walk_.push_back({next, (edge_towards(next, from) + 1) % 3, 2});
    } else {
      horizon_.push_back({facets_[from].corner[edge], facets_[from].corner[(edge + 1) % 3], next});
    }
  }
}

bool ExpandingPolytope::horizon_is_a_loop() const {
  for (std::size_t k = 0; k < horizon_.size(); ++k)
    if (horizon_[k].to != horizon_[(k + 1) % horizon_.size()].from) return false;
  return horizon_.size() >= 3;
}

bool ExpandingPolytope::add(const DifferencePoint& point, Index above) {
  find_horizon(point, above);
  if (!horizon_is_a_loop()) return false;
  const auto apex = static_cast<Index>(points_.size());
  points_.push_back(point);
  const auto first = static_cast<Index>(facets_.size());
  const auto count = static_cast<Index>(horizon_.size());
  for (Index k = 0; k < count; ++k) {
    const HorizonEdge edge = horizon_[k];
    const Index f = add_facet(edge.from, edge.to, apex);
    facets_[f].neighbour = {edge.hidden, first + (k + 1) % count, first + (k + count - 1) % count};
    auto& hidden = facets_[edge.hidden];
    for (std::size_t i = 0; i < 3; ++i)
      if (hidden.corner[i] == edge.to && hidden.corner[(i + 1) % 3] == edge.from) hidden.neighbour[i] = f;
  }
  return true;
}

}  // namespace toccata
