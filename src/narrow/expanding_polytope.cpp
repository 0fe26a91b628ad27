#include "narrow/expanding_polytope.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

// How far a rounded facet may be off. Let u = 2^-53 and V = extent(), the greatest magnitude of a coordinate of D. A
// corner's coordinates are off by at most uV each, an edge's by 4uV, so an edge vector e, of length E ≤ 2√3 V, by 7uV.
// The cross product n of two edges is off by 7uV(E1 + E2) for that, and by at most 6u E1 E2 ≤ 11uV(E1 + E2) for its own
// rounding. So the direction of n is off by an angle of at most θ = 18uV(E1 + E2) / |n| and a little more, as long as
// that is small. A height n · e / |n| is then off by at most θE + 7uV + 14uV (the last for the product and for making n
// a unit vector) ≤ 63uV · V(E1 + E2) / |n| + 21uV, and so is the distance of the plane from the origin.
// `error` is twice that; and infinite where θ is not small. An exact facet's normal is off by its last rounding only.
namespace toccata {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

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

Index ExpandingPolytope::nearest() {
  const auto later = [](const QueueEntry& p, const QueueEntry& q) {
    return p.lower != q.lower ? p.lower > q.lower : p.facet > q.facet;
  };
  // A facet that was made exact is in the queue twice.
  while (!facets_[queue_.front().facet].alive || facets_[queue_.front().facet].lower != queue_.front().lower) {
    std::pop_heap(queue_.begin(), queue_.end(), later);
    queue_.pop_back();
  }
  return queue_.front().facet;
}

void ExpandingPolytope::enqueue(Index f) {
  const auto later = [](const QueueEntry& p, const QueueEntry& q) {
    return p.lower != q.lower ? p.lower > q.lower : p.facet > q.facet;
  };
  queue_.push_back({facets_[f].lower, f});
  std::push_heap(queue_.begin(), queue_.end(), later);
}

void ExpandingPolytope::measure(PolytopeFacet& facet) const {
  const Vec3 &p = points_[facet.corner[0]].value, &q = points_[facet.corner[1]].value,
             &r = points_[facet.corner[2]].value;
  const Vec3 to_q = q - p, to_r = r - p;
  const Vec3 n = cross(to_q, to_r);
  const double squared = dot(n, n);
  const double length = std::sqrt(squared);
  const double extent = body_.extent();
  const double edges = std::sqrt(dot(to_q, to_q)) + std::sqrt(dot(to_r, to_r));
  const double angle = 0x1p-46 * extent * edges / length;
  // Not "angle ≥": NaN is not small.
  if (!(squared > 0x1p-900) || !(angle < 0x1p-10)) {
    facet.error = infinity;
    return;
  }
  facet.normal = (1 / length) * n;
  facet.distance = dot(facet.normal, p);
  facet.error = extent * (angle + 0x1p-46);
  facet.lower = facet.distance - facet.error;
}

Index ExpandingPolytope::add_facet(Index p, Index q, Index r) {
  const auto f = static_cast<Index>(facets_.size());
  PolytopeFacet facet;
  facet.corner = {p, q, r};
  measure(facet);
  facets_.push_back(facet);
  if (facet.error < infinity)
    enqueue(f);
  else
    make_exact(f);
  return f;
}

void ExpandingPolytope::make_exact(Index f) {
  PolytopeFacet& facet = facets_[f];
  const auto exact = [&](std::size_t k) {
    const DifferencePoint& p = points_[facet.corner[k]];
    return body_.exact_point(p.on_a, p.on_b);
  };
  const IntegerVector p = exact(0);
  ExactPlane plane{cross(exact(1) - p, exact(2) - p), 0};
  plane.offset = dot(plane.normal, p);
  facet.normal = unit_vector(plane.normal);
  const WideInteger squared = dot(plane.normal, plane.normal);
  facet.distance = body_.scaled_length(quotient_by_root(plane.offset, squared, body_.exact_exponent()));
  facet.error = 0x1p-47 * body_.extent();
  facet.lower = facet.distance - 0x1p-51 * std::fabs(facet.distance);
  facet.exact = static_cast<Index>(planes_.size());
  planes_.push_back(std::move(plane));
  enqueue(f);
}

Sign ExpandingPolytope::exact_distance_sign(Index f) const { return sign_of(planes_[facets_[f].exact].offset); }

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

Sign ExpandingPolytope::height_sign(Index f, const DifferencePoint& p) {
  const double rounded = height(f, p);
  if (rounded > facets_[f].error) return Sign::positive;
  if (rounded < -facets_[f].error) return Sign::negative;
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
