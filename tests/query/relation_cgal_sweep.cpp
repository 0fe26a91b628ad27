// Relations of solids against the regularised intersection of CGAL's Nef polyhedra, and points against its
// Side_of_triangle_mesh.
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Nef_polyhedron_3.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Polyhedron_incremental_builder_3.h>
#include <CGAL/Side_of_triangle_mesh.h>
#include <fmt/format.h>

#include "support/mesh_soups.hpp"
#include "support/relation_cases.hpp"
#include "support/sweep.hpp"
#include "toccata/query/relation.hpp"
#include "toccata/query/signed_distance.hpp"

namespace toccata::test {
namespace {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Polyhedron = CGAL::Polyhedron_3<Kernel>;
using Nef = CGAL::Nef_polyhedron_3<Kernel>;

class Builder : public CGAL::Modifier_base<Polyhedron::HalfedgeDS> {
 public:
  Builder(const TriangleMesh& mesh, const Pose& pose) : mesh_(mesh), pose_(pose) {}
  void operator()(Polyhedron::HalfedgeDS& target) override {
    CGAL::Polyhedron_incremental_builder_3<Polyhedron::HalfedgeDS> builder(target, true);
    builder.begin_surface(mesh_.vertices().size(), mesh_.triangles().size());
    for (const Vec3& v : mesh_.vertices()) {
      const Vec3 w = transform(pose_, v);
      builder.add_vertex(Kernel::Point_3(w.x, w.y, w.z));
    }
    for (const auto& corners : mesh_.triangles()) builder.add_facet(corners.begin(), corners.end());
    builder.end_surface();
  }

 private:
  const TriangleMesh& mesh_;
  const Pose& pose_;
};

Polyhedron polyhedron(const TriangleMesh& mesh, const Pose& pose) {
  Polyhedron result;
  Builder builder(mesh, pose);
  result.delegate(builder);
  return result;
}

/// The closure of the interior.
Nef solid(const TriangleMesh& mesh, const Pose& pose) {
  Polyhedron p = polyhedron(mesh, pose);
  return Nef(p).regularization();
}

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
  const Nef common = solid(made.a, made.query.pose_a) * solid(made.b, made.query.pose_b);
  return !common.interior().is_empty();
}

bool first_less_second_is_empty(const Nef& first, const Nef& second) { return (first - second).interior().is_empty(); }

Containment containment_by_cgal(const RelationCase& made) {
  const Nef a = solid(made.a, made.query.pose_a), b = solid(made.b, made.query.pose_b);
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
    const Polyhedron p = polyhedron(made.a, made.query.pose_a);
    const CGAL::Side_of_triangle_mesh<Polyhedron, Kernel> side_of(p);
    for (int i = 0; i < 20 && result.cases < cases; ++i, ++result.cases) {
      const auto coordinate = [&] { return 0.5 * static_cast<double>(random.below(13)) - 1; };
      const double x = coordinate(), y = coordinate(), z = coordinate();
      const CGAL::Bounded_side expected = side_of(Kernel::Point_3(x, y, z));
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
