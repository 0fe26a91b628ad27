#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <fmt/format.h>

#include "narrow/convex_cells.hpp"
#include "narrow/quadric_cases.hpp"
#include "toccata/narrow/quadrics.hpp"

// Points and other shapes in quadrics and around them, against support functions of 60 digits: a convex set holds
// another when it is nowhere lower, and holds a ball around a point when it is nowhere lower than that.
namespace toccata::test {
namespace {

using oracle::Fine;
using oracle::FinePoint;

Fine fine_height(const oracle::FineSet& set, const FinePoint& d) {
  const FinePoint p = farthest(set, d);
  return (p.x * d.x + p.y * d.y + p.z * d.z) / sqrt(d.x * d.x + d.y * d.y + d.z * d.z);
}

FinePoint fine_cross(const FinePoint& u, const FinePoint& v) {
  return {u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x};
}

/// Across the surfaces of a quadric, outwards, where its images of other sizes pass through a point: of the round
/// part, and of the flat ones.
std::vector<FinePoint> normals_at(const oracle::FineSet& set, const Vec3& point) {
  const auto& axis = set.axis;
  std::array<FinePoint, 3> dual{fine_cross(axis[1], axis[2]), fine_cross(axis[2], axis[0]),
                                fine_cross(axis[0], axis[1])};
  const Fine volume = axis[0].x * dual[0].x + axis[0].y * dual[0].y + axis[0].z * dual[0].z;
  for (FinePoint& d : dual) d = {d.x / volume, d.y / volume, d.z / volume};
  const FinePoint from{Fine(point.x) - set.centre.x, Fine(point.y) - set.centre.y, Fine(point.z) - set.centre.z};
  const auto coordinate = [&](std::size_t i) { return dual[i].x * from.x + dual[i].y * from.y + dual[i].z * from.z; };
  const auto across = [&](const Fine& u, const Fine& v, const Fine& w) {
    return FinePoint{u * dual[0].x + v * dual[1].x + w * dual[2].x, u * dual[0].y + v * dual[1].y + w * dual[2].y,
                     u * dual[0].z + v * dual[1].z + w * dual[2].z};
  };
  const Fine u = coordinate(0), v = coordinate(1), w = coordinate(2), radius = sqrt(u * u + v * v);
  std::vector<FinePoint> normals;
  if (set.kind == oracle::FineKind::ellipsoid && radius + abs(w) > 0) normals.push_back(across(u, v, w));
  if (set.kind == oracle::FineKind::ellipsoid) return normals;
  const bool is_cone = set.kind == oracle::FineKind::cone;
  if (radius > 0) normals.push_back(across(u / radius, v / radius, is_cone ? 0.5 : 0));
  normals.push_back(across(0, 0, -1));
  if (!is_cone) normals.push_back(across(0, 0, 1));
  return normals;
}

/// By how much A is higher than B in some direction, the most that a climb from many finds: never more than there is.
class Excess {
 public:
  Excess(const oracle::FineSet& a, const oracle::FineSet& b, Random& random) : a_(a), b_(b), random_(random) {}

  [[nodiscard]] Fine along(const FinePoint& d) const { return fine_height(a_, d) - fine_height(b_, d); }

  [[nodiscard]] Fine most(const std::vector<FinePoint>& hints, int tries, int steps) {
    std::vector<std::pair<Fine, FinePoint>> found;
    for (const FinePoint& at : hints) found.emplace_back(along(at), at);
    for (int i = 0; i < tries; ++i) {
      const Vec3 d = quadric_direction(random_);
      const FinePoint at{Fine(d.x), Fine(d.y), Fine(d.z)};
      found.emplace_back(along(at), at);
    }
    std::sort(found.begin(), found.end(), [](const auto& x, const auto& y) { return x.first > y.first; });
    Fine best = found[0].first;
    for (std::size_t i = 0; i < 2 && i < found.size(); ++i) best = std::max(best, climbed(found[i], steps));
    return best;
  }

  /// From many more, where that did not find any.
  [[nodiscard]] bool is_never() {
    for (int i = 0; i < 60; ++i) {
      const Vec3 d = quadric_direction(random_);
      const FinePoint at{Fine(d.x), Fine(d.y), Fine(d.z)};
      if (climbed({along(at), at}, 60) > 0) return false;
    }
    return true;
  }

 private:
  Fine climbed(std::pair<Fine, FinePoint> at, int steps) {
    const Fine size = sqrt(at.second.x * at.second.x + at.second.y * at.second.y + at.second.z * at.second.z);
    double reach = 0.3;
    for (int i = 0; i < steps; ++i) {
      const Vec3 way = reach * quadric_direction(random_);
      bool better = false;
      for (const double sign : {1.0, -1.0}) {
        const FinePoint to{at.second.x + size * Fine(sign * way.x), at.second.y + size * Fine(sign * way.y),
                           at.second.z + size * Fine(sign * way.z)};
        const Fine there = along(to);
        if (!(there > at.first)) continue;
        at = {there, to};
        better = true;
        break;
      }
      reach *= better ? 1.6 : 0.7;
    }
    return at.first;
  }

  const oracle::FineSet& a_;
  const oracle::FineSet& b_;
  Random& random_;
};

double quadric_extent(const PlacedQuadric& placed) {
  const PosedQuadric seen = posed(placed);
  double size = 0;
  for (int j = 0; j < 3; ++j) {
    const Vec3 axis = seen.half()[j] * placed.pose.linear.column(j);
    size = std::max({size, std::fabs(axis.x), std::fabs(axis.y), std::fabs(axis.z)});
  }
  return size;
}

bool is_slim(const std::string& regime) { return regime == "needle" || regime == "flat"; }

/// In the shape, mostly: in units of its half axes; on its axes and near its boundary too.
Vec3 point_in(const PlacedQuadric& placed, Random& random) {
  const PosedQuadric seen = posed(placed);
  Vec3 unit = random.unit() * quadric_direction(random);
  if (random.below(4) == 0) unit = {0, 0, random.between(-1, 1)};
  if (random.below(8) == 0) unit = {random.between(-1, 1), 0, 0};
  if (random.below(4) == 0) unit = (1 - std::pow(10.0, random.between(-12, -1))) * quadric_direction(random);
  if (seen.kind() == PosedQuadric::kind_of<Cone> && random.below(2) == 0) {
    const double below = 0.5 * (1 - unit.z);
    unit = {unit.x * below, unit.y * below, unit.z};
  }
  const Vec3 half = seen.half();
  return transform(placed.pose, {half.x * unit.x, half.y * unit.y, half.z * unit.z});
}

std::string inner_depth_fault(const BoundaryPoint& found, const Vec3& point, const oracle::FineSet& set,
                              const std::string& regime, double size, Random& random) {
  const oracle::FineSet at = oracle::hull_set_of({point}, 0);
  Excess above(at, set, random);
  // The direction of the least height is that across the surface at the nearest point; a climb alone ends before the
  // last digits.
  const Fine least = -above.most(normals_at(set, found.point), 40, is_slim(regime) ? 60 : 220);
  if (least < 0) return "told to be inside";
  if (Fine(found.lower) > least) return fmt::format("lower {} above {}", found.lower, least.str(20));
  const Fine slack = Fine(1e-12) * Fine(found.upper) + Fine(1e-15 * size);
  if (least > Fine(found.upper) + slack) return fmt::format("upper {} below {}", found.upper, least.str(20));
  return "";
}

std::string quadric_boundary_fault(const PlacedQuadric& placed, const std::string& regime, Random& random) {
  const PosedQuadric shape = posed(placed);
  const oracle::FineSet set = fine_set(placed);
  const Vec3 point = point_in(placed, random);
  const BoundaryPoint found = boundary_point(point, shape);
  const double size = quadric_extent(placed);
  if (found.side != side_of(point, shape)) return "two sides";
  if (!(found.lower <= found.upper)) return "turned round";
  if (found.side == Sign::zero) return found.upper == 0 ? "" : "not 0 on the boundary";
  if (!(found.upper > 0)) return "0 off the boundary";
  const bool narrow = found.upper - found.lower <= 1e-12 * found.upper;
  if (narrow != (found.status == Status::exact)) return "status";
  const double wide = is_slim(regime) ? 1e-9 * found.upper : 0;
  if (!narrow && found.upper > 1e-14 * size && found.upper - found.lower > wide)
    return fmt::format("wide: {} to {} of {}", found.lower, found.upper, size);
  if (found.side == Sign::negative) return inner_depth_fault(found, point, set, regime, size, random);
  const oracle::FineNearness truth = fine_nearness(set, oracle::hull_set_of({point}, 0), 1e-9, 200);
  if (truth.meet) return "told to be outside";
  if (truth.upper >= 0 && Fine(found.lower) > truth.upper) return "lower above the distance";
  return Fine(found.upper) < truth.lower ? "upper below the distance" : "";
}

template <class Check>
SweepResult run_checks(const std::string& cell, std::uint64_t seed, std::uint64_t cases, const Check& check) {
  SweepResult result;
  Random random = random_of_cell(cell, seed);
  for (; result.cases < cases; ++result.cases) {
    const std::string& regime = quadric_regimes()[result.cases % quadric_regimes().size()];
    const std::string wrong = check(regime, random);
    if (wrong.empty()) continue;
    if (result.wrong++ == 0) result.first_failure = fmt::format("{}, case {} ({})", wrong, result.cases, regime);
  }
  return result;
}

SweepResult run_boundaries(const std::string& kind, std::uint64_t seed, std::uint64_t cases) {
  return run_checks(kind, seed, cases, [&](const std::string& regime, Random& random) {
    return quadric_boundary_fault(quadric_case(kind, kind, regime, random).a, regime, random);
  });
}

PlacedQuadric resized(PlacedQuadric placed, double factor) {
  placed.pose.linear = scaled(placed.pose, factor).linear;
  return placed;
}

template <class B>
Containment containment_at(double factor, const PlacedQuadric& a, const B& b) {
  return relation(posed(resized(a, factor)), posed(b)).containment;
}

/// What is wrong with the containment that is told of A made larger by a factor; empty if nothing is. What is told of
/// containment is not refuted; and none is told where no direction shows it, only where it is told of an A that is a
/// hundredth larger or smaller: near the least that holds, few directions do.
template <class B>
std::string containment_fault(const PlacedQuadric& plain_a, double factor, const B& b, const std::string& regime,
                              Random& random) {
  const PlacedQuadric a = resized(plain_a, factor);
  const PosedQuadric shape = posed(a);
  const auto other = posed(b);
  const Relation found = relation(shape, other), back = relation(other, shape);
  const oracle::FineSet set_a = fine_set(a), set_b = fine_set(b);
  const bool a_in_b = found.containment == Containment::a_in_b, b_in_a = found.containment == Containment::b_in_a;
  if (back.status != found.status || a_in_b != (back.containment == Containment::b_in_a) ||
      b_in_a != (back.containment == Containment::a_in_b))
    return "exchanged";
  if (found.kind == RelationKind::apart || found.kind == RelationKind::touching) return "";
  if (found.containment == Containment::equal) return "equal";
  Excess of_a(set_a, set_b, random), of_b(set_b, set_a, random);
  const Fine a_beyond = of_a.most({}, 24, a_in_b ? 40 : 120), b_beyond = of_b.most({}, 24, b_in_a ? 40 : 120);
  if (a_in_b && a_beyond > 0) return "A leaves B by " + a_beyond.str(5);
  if (b_in_a && b_beyond > 0) return "B leaves A by " + b_beyond.str(5);
  // What is clear is decided.
  const Fine clear = Fine(1e-6) * Fine(quadric_extent(a));
  if (!is_slim(regime) && found.status == Status::undecided && a_beyond > clear && b_beyond > clear) return "undecided";
  if (is_slim(regime) || found.containment != Containment::none || found.status != Status::exact) return "";
  if (a_beyond < -clear && found.b_solid && of_a.is_never() &&
      containment_at(0.99 * factor, plain_a, b) != Containment::a_in_b)
    return "A is in B, by " + a_beyond.str(5);
  if (b_beyond < -clear && of_b.is_never() && containment_at(1.01 * factor, plain_a, b) != Containment::b_in_a)
    return "B is in A, by " + b_beyond.str(5);
  return "";
}

/// The greatest factor with which B holds A, or the least with which A holds B, between the two; they are the same
/// where there is none.
template <class B>
std::array<double, 2> critical_factors(const PlacedQuadric& a, const B& b, Containment wanted) {
  double low = 1e-2, high = 1e2;
  const bool holds_large = wanted == Containment::b_in_a;
  if ((containment_at(low, a, b) == wanted) == (containment_at(high, a, b) == wanted)) return {1, 1};
  while (high > low * (1 + 1e-13)) {
    const double middle = std::sqrt(low * high);
    ((containment_at(middle, a, b) == wanted) == holds_large ? high : low) = middle;
  }
  return {low, high};
}

template <class B>
std::string resized_fault(const PlacedQuadric& a, const B& b, const std::string& regime, Random& random) {
  std::vector<double> factors{std::pow(10.0, random.between(-2, 2))};
  if (random.below(4) == 0) {
    const auto [low, high] = critical_factors(a, b, random.below(2) == 0 ? Containment::b_in_a : Containment::a_in_b);
    for (const double factor : {low * (1 - 1e-9), low, high, high * (1 + 1e-9)}) factors.push_back(factor);
  }
  for (const double factor : factors)
    if (std::string wrong = containment_fault(a, factor, b, regime, random); !wrong.empty())
      return fmt::format("{}, factor {}", wrong, factor);
  return "";
}

SweepResult run_containment(const std::string& kind_b, std::uint64_t seed, std::uint64_t cases) {
  return run_checks(kind_b, seed, cases, [&](const std::string& regime, Random& random) {
    QuadricCase pair = quadric_case(quadric_kinds()[random.below(3)], kind_b, regime, random);
    // Around one place, but for those that lie on a grid.
    if (regime != "aligned" && regime != "tiny" && regime != "huge") {
      const double off = random.below(4) == 0 ? 0 : random.between(0, 0.5);
      pair.pose_of_b().offset = pair.a.pose.offset + off * quadric_direction(random);
    }
    return std::visit([&](const auto& b) { return resized_fault(pair.a, b, regime, random); }, pair.b);
  });
}

const bool boundaries_known =
    register_sweep({"quadric-boundaries", quadric_kinds(), 10'000, 44, run_boundaries, 2'000, 4});
const bool containment_known =
    register_sweep({"quadric-containment", quadric_other_kinds(), 10'000, 11, run_containment, 500, 1});

}  // namespace
}  // namespace toccata::test
