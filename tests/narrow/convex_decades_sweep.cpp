#include <cmath>

#include "narrow/casts_checks.hpp"
#include "narrow/penetration_checks.hpp"
#include "support/mesh_soups.hpp"
#include "support/sweep.hpp"
#include "toccata/core/error.hpp"
#include "toccata/narrow/convex_convex.hpp"

// Shapes whose own coordinates differ by many powers of ten: needles and slivers of every kind, and lengths of which
// the rounding is longer than the shapes' other parts. Family "20": from 1e-20 to 1e20.
namespace toccata::test {
namespace {

class DecadesCases {
 public:
  DecadesCases(double decades, Random& random) : decades_(decades), random_(random) {}

  ConvexCase next() {
    while (true) try {
        ConvexCase pair{{shape(), {}}, {shape(), {}}};
        if (random_.below(20) == 0) pair.b.shape = pair.a.shape;
        pair.a.pose = pose();
        pair.b.pose = random_.below(3) == 0 ? pair.a.pose : pose();
        static_cast<void>(posed(pair.a)), static_cast<void>(posed(pair.b));
        return pair;
      } catch (const Error&) {
        continue;  // a box that is lost in the rounding of its centre
      }
  }

  Vec3 point() {
    const double x = coordinate(), y = coordinate();
    return {x, y, coordinate()};
  }

 private:
  double size() { return std::pow(10, random_.between(-decades_, decades_)); }

  double coordinate() {
    const std::uint64_t way = random_.below(12);
    return way < 2 ? 0 : way < 7 ? size() : -size();
  }

  std::vector<Vec3> points() {
    std::vector<Vec3> result(4 + random_.below(8));
    const bool flat = random_.below(6) == 0;
    const double level = coordinate();
    for (Vec3& p : result) {
      p = point();
      if (flat) p.z = level;
    }
    return result;
  }

  Segment segment() {
    const Vec3 start = point();
    return {start, point()};
  }

  Triangle triangle() {
    const Vec3 first = point(), second = point();
    return {{first, second, point()}};
  }

  Box box() {
    const double x = size(), y = size(), z = size();
    return Box({x, y, z}, random_.below(3) == 0 ? point() : Vec3{});
  }

  Rounded::Core core() {
    switch (random_.below(5)) {
      case 0:
        return Point(point());
      case 1:
        return segment();
      case 2:
        return triangle();
      case 3:
        return box();
      default:
        return ConvexHull(points());
    }
  }

  ConvexShape shape() {
    const std::uint64_t rounded = random_.below(2);
    Rounded::Core alone = core();
    if (rounded != 0) return Rounded(std::move(alone), size());
    return std::visit([](auto& plain) -> ConvexShape { return std::move(plain); }, alone);
  }

  Pose pose() {
    Pose result;
    const std::uint64_t turn = random_.below(5);
    if (turn == 3) result.linear = {{Vec3{0, -1, 0}, Vec3{1, 0, 0}, Vec3{0, 0, 1}}};
    if (turn == 4) result.linear = random_rotation(random_);
    if (random_.below(3) == 0) result.offset = point();
    return result;
  }

  double decades_;
  Random& random_;
};

std::string check_penetration(const PosedPolytope& a, const PosedPolytope& b, const oracle::ConvexSet& set_a,
                              const oracle::ConvexSet& set_b) {
  if (!a.solid() || !b.solid() || !oracle::is_solid(set_a) || !oracle::is_solid(set_b)) return "";
  const oracle::Depth depth(set_a, set_b);
  const double size = size_of(set_a) + size_of(set_b);
  for (const Penetration& p : {penetration(a, b), penetration_by_separating_axes(a, b)})
    if (const std::string wrong = wrong_with(p, set_a, set_b, depth, size); !wrong.empty())
      return "penetration: " + wrong;
  return "";
}

std::string check_convex_decades(const ConvexCase& pair, const Vec3& motion) {
  const PosedPolytope a = posed(pair.a), b = posed(pair.b);
  const oracle::ConvexSet set_a = set_of(pair.a), set_b = set_of(pair.b);
  const oracle::Relation truth = oracle::relation(set_a, is_solid(pair.a), set_b, is_solid(pair.b));
  const bool meet = truth.kind != oracle::RelationKind::apart;
  if (overlap(a, b) != meet) return "overlap";
  if (overlap_by_separating_axes(a, b) != meet) return "overlap by separating axes";
  if ((manifold(a, b).count > 0) != meet) return "manifold";
  const Relation relation = toccata::relation(a, b);
  if (static_cast<int>(relation.kind) != static_cast<int>(truth.kind)) return "relation";
  if (static_cast<int>(relation.containment) != static_cast<int>(truth.containment)) return "containment";
  const Distance d = distance(a, b);
  if ((d.upper == 0) != meet) return "distance";
  const oracle::Separation separation(set_a, set_b);
  if (separation.compare(oracle::exact(d.lower)) < 0) return "lower is too large";
  if (separation.compare(oracle::exact(d.upper)) > 0) return "upper is too small";
  if (std::string wrong = check_penetration(a, b, set_a, set_b); !wrong.empty()) return wrong;
  const std::string wrong = cast_fault(cast_shape(a, motion, b), set_a, motion, set_b);
  return wrong.empty() ? "" : "cast: " + wrong;
}

SweepResult run_convex_decades(const std::string& family, std::uint64_t seed, std::uint64_t cases) {
  SweepResult result;
  Random random(Random(seed).bits() + 7);
  DecadesCases source(std::stod(family), random);
  for (; result.cases < cases; ++result.cases) {
    const ConvexCase pair = source.next();
    const std::string wrong = check_convex_decades(pair, source.point());
    if (wrong.empty()) continue;
    if (result.wrong++ == 0)
      result.first_failure = wrong + ", case " + std::to_string(result.cases) + ": " + to_text(pair);
  }
  return result;
}

const bool convex_decades_known =
    register_sweep({"convex-decades", {"1", "3", "9", "20", "100"}, 100'000, 1000, run_convex_decades, 1000, 100});

}  // namespace
}  // namespace toccata::test
