#include <algorithm>
#include <cmath>

#include "narrow/penetration_checks.hpp"
#include "support/sweep.hpp"
#include "toccata/narrow/box_box.hpp"
#include "toccata/narrow/convex_convex.hpp"

// Everything that is asked of two boxes, in every regime, of the posed boxes and of the posed convex shapes.
namespace toccata::test {
namespace {

struct SeenBoxes {
  const ConvexCase& given;
  PosedPolytope a, b;
  oracle::ConvexSet set_a, set_b;
  double size;  ///< the largest coordinate
};

bool is_near(const Vec3& point, const oracle::ConvexSet& set, double distance) {
  return oracle::compare_distance(oracle::point_set(point), set, oracle::exact(distance)) <= 0;
}

std::string check_manifold(const Manifold& m, const SeenBoxes& seen, const oracle::Depth& depth, bool meet) {
  if ((m.count > 0) != meet) return "count of points";
  if (!meet) return "";
  if (!is_nearly_unit(m.normal)) return "normal";
  const double size = seen.size;
  double deepest = m.points[0].depth;
  for (std::size_t i = 0; i < static_cast<std::size_t>(m.count); ++i) {
    const ManifoldPoint& p = m.points[i];
    if (!is_finite(p.position) || !std::isfinite(p.depth)) return "not finite";
    deepest = std::max(deepest, p.depth);
    const double near = 0.5 * std::fabs(p.depth) + 0x1p-40 * size;
    if (!is_near(p.position, seen.set_a, near)) return "a point is far from A";
    if (!is_near(p.position, seen.set_b, near)) return "a point is far from B";
  }
  // A face may be 2 % deeper than the edge pair that parts them soonest.
  const oracle::Rational most = oracle::exact(deepest / 0.98 + 0x1p-40 * size);
  const oracle::Rational least = oracle::exact(0.98 * deepest - 0x1p-40 * size);
  if (depth.compare(most) > 0) return "a point is missing that is as deep";
  return depth.compare(least) < 0 ? "a point is too deep" : "";
}

std::string check_box_box(const SeenBoxes& seen) {
  const PosedBox a(std::get<Box>(seen.given.a.shape), seen.given.a.pose);
  const PosedBox b(std::get<Box>(seen.given.b.shape), seen.given.b.pose);
  const oracle::Relation truth = oracle::relation(seen.set_a, seen.set_b);
  const bool meet = truth.kind != oracle::RelationKind::apart;
  if (overlap(seen.a, seen.b) != meet) return "overlap";
  if (overlap(a, b) != meet || overlap(b, a) != meet) return "overlap of posed boxes";
  const Box &box_a = a.shape, &box_b = b.shape;
  if (overlap(box_a, a.pose, box_b, b.pose) != meet) return "overlap of boxes and poses";
  if (overlap_by_separating_axes(seen.a, seen.b) != meet) return "overlap by separating axes";
  if (static_cast<int>(relation(seen.a, seen.b).kind) != static_cast<int>(truth.kind)) return "relation";
  const oracle::Depth depth(seen.set_a, seen.set_b);
  const Penetration p = penetration(seen.a, seen.b);
  if (const std::string wrong = wrong_with(p, seen.set_a, seen.set_b, depth, seen.size); !wrong.empty())
    return "penetration: " + wrong;
  const bool is_same = same_shapes(seen.set_a, seen.set_b);
  const Penetration exchanged = penetration(seen.b, seen.a);
  if (!is_same && !(exchanged == Penetration{p.lower, p.upper, -p.direction, p.on_b, p.on_a, p.status}))
    return "penetration exchanged";
  const Manifold m = manifold(seen.a, seen.b);
  if (const std::string wrong = check_manifold(m, seen, depth, meet); !wrong.empty()) return "manifold: " + wrong;
  if (!is_same && !same_but_flipped(m, manifold(seen.b, seen.a))) return "manifold exchanged";
  if (!(manifold(a, b) == m)) return "manifold of posed boxes";
  if (!(penetration(a, b) == p)) return "penetration of posed boxes";
  if (!(manifold(box_a, a.pose, box_b, b.pose) == m)) return "manifold of boxes and poses";
  return penetration(box_a, a.pose, box_b, b.pose) == p ? "" : "penetration of boxes and poses";
}

SweepResult run_box_box(const std::string& regime, std::uint64_t seed, std::uint64_t cases) {
  SweepResult result;
  // Seeds in a row would give streams that are shifted by a draw each.
  Random random(Random(seed).bits());
  for (; result.cases < cases; ++result.cases) {
    const ConvexCase pair = convex_case("box", "box", regime, random);
    const oracle::ConvexSet set_a = set_of(pair.a), set_b = set_of(pair.b);
    const SeenBoxes seen{pair, posed(pair.a), posed(pair.b), set_a, set_b, std::max(size_of(set_a), size_of(set_b))};
    const std::string wrong = check_box_box(seen);
    if (wrong.empty()) continue;
    if (result.wrong++ == 0)
      result.first_failure = wrong + ", case " + std::to_string(result.cases) + ": " + to_text(pair);
  }
  return result;
}

const bool box_box_known = register_sweep({"box-box", convex_regimes(), 100'000, 100, run_box_box, 2'000});

}  // namespace
}  // namespace toccata::test
