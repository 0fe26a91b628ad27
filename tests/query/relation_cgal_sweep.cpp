// Relations of solids against the regularised intersection of CGAL's Nef polyhedra, and points against its
// Side_of_triangle_mesh.
#include <CGAL/Side_of_triangle_mesh.h>
#include <fmt/format.h>

#include "query/cgal_solids.hpp"
#include "support/mesh_soups.hpp"
#include "support/relation_cases.hpp"
#include "support/sweep.hpp"
#include "toccata/query/relation.hpp"
#include "toccata/query/signed_distance.hpp"

namespace toccata::test {
namespace {

/// With normals outward in the world, as CGAL wants them.
RelationCase valid_case(const std::string& family, Random& random) {
  for (;;) {
    RelationCase made = random_relation_case(family, random);
    const auto is_upright = [](const Pose& pose) {
      return dot(cross(pose.linear[0], pose.linear[1]), pose.linear[2]) > 0;
    };
    if (is_upright(made.query.pose_a) && is_upright(made.query.pose_b)) return made;
  }
}

bool volume_in_common(const RelationCase& made) {
  const CgalNef common = cgal_solid(made.a, made.query.pose_a) * cgal_solid(made.b, made.query.pose_b);
  return !common.interior().is_empty();
}

bool first_less_second_is_empty(const CgalNef& first, const CgalNef& second) {
  return (first - second).interior().is_empty();
}

Containment containment_by_cgal(const RelationCase& made) {
  const CgalNef a = cgal_solid(made.a, made.query.pose_a), b = cgal_solid(made.b, made.query.pose_b);
  const bool a_in_b = first_less_second_is_empty(a, b), b_in_a = first_less_second_is_empty(b, a);
  if (a_in_b && b_in_a) return Containment::equal;
  return a_in_b ? Containment::a_in_b : b_in_a ? Containment::b_in_a : Containment::none;
}

SweepResult compare_with_nef(const std::string& family, std::uint64_t seed, std::uint64_t cases) {
  Random random(seed);
  SweepResult result;
  for (; result.cases < cases; ++result.cases) {
    const RelationCase made = valid_case(family, random);
    const Relation found = relation(Model(made.a), Model(made.b), made.query);
    const bool overlaps = volume_in_common(made);
    const bool agrees = overlaps == (found.kind == RelationKind::overlapping) &&
                        (!overlaps || containment_by_cgal(made) == found.containment);
    if (!agrees && result.wrong++ == 0)
      result.first_failure = fmt::format("seed {} case {}: CGAL says {}", seed, result.cases, overlaps);
  }
  return result;
}

SweepResult compare_sides(const std::string& family, std::uint64_t seed, std::uint64_t cases) {
  Random random(seed);
  SweepResult result;
  while (result.cases < cases) {
    const RelationCase made = valid_case(family, random);
    const Model model(made.a);
    const CgalPolyhedron p = cgal_polyhedron(made.a, made.query.pose_a);
    const CGAL::Side_of_triangle_mesh<CgalPolyhedron, CgalKernel> side_of(p);
    for (int i = 0; i < 20 && result.cases < cases; ++i, ++result.cases) {
      const auto coordinate = [&] { return 0.5 * static_cast<double>(random.below(13)) - 1; };
      const double x = coordinate(), y = coordinate(), z = coordinate();
      const CGAL::Bounded_side expected = side_of(CgalKernel::Point_3(x, y, z));
      const Side found = locate({x, y, z}, model, made.query.pose_a).side;
      const bool agrees = (expected == CGAL::ON_BOUNDARY) == (found == Side::boundary) &&
                          (expected == CGAL::ON_BOUNDED_SIDE) == (found == Side::inside);
      if (!agrees && result.wrong++ == 0)
        result.first_failure = fmt::format("seed {} case {}: ({}, {}, {})", seed, result.cases, x, y, z);
    }
  }
  return result;
}

const bool known =
    register_sweep({"relations-cgal", {"grid boxes", "l shapes", "rigid"}, 20'000, 25, compare_with_nef, 1000}) &&
    register_sweep({"point-sides-cgal", {"grid boxes", "l shapes", "rigid"}, 200'000, 1000, compare_sides});

}  // namespace
}  // namespace toccata::test
