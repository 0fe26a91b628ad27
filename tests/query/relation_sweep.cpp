#include "toccata/query/relation.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "oracle/oracle.hpp"
#include "support/relation_cases.hpp"
#include "support/sweep.hpp"
#include "toccata/query/signed_distance.hpp"

namespace toccata::test {
namespace {

oracle::MeshSet oracle_set(const TriangleMesh& mesh, const Pose& pose, Solid solid) {
  const bool is_solid = solid != Solid::none && oracle::is_closed(mesh);
  return is_solid ? oracle::solid_set(mesh, pose) : oracle::surface_set(mesh, pose);
}

std::string told(const TriangleMesh& mesh) {
  std::string text = "vertices";
  for (const Vec3& v : mesh.vertices()) text += fmt::format(" ({}, {}, {})", v.x, v.y, v.z);
  text += " triangles";
  for (const auto& corners : mesh.triangles()) text += fmt::format(" {}", corners);
  return text;
}

std::string told(const RelationCase& c) {
  return fmt::format("a {} posed {} solid {}, b {} posed {} solid {}", told(c.a), c.query.pose_a.numbers(),
                     static_cast<int>(c.query.solid_a), told(c.b), c.query.pose_b.numbers(),
                     static_cast<int>(c.query.solid_b));
}

std::string told(RelationKind kind, Containment containment, bool side_unresolved) {
  return fmt::format("{}/{}/{}", static_cast<int>(kind), static_cast<int>(containment), side_unresolved);
}

std::string told(const Relation& r) { return told(r.kind, r.containment, r.side_unresolved); }

std::string told(const oracle::Relation& r) {
  return told(static_cast<RelationKind>(r.kind), static_cast<Containment>(r.containment), r.side_unresolved);
}

/// Empty when the library agrees with the oracle, both ways round.
std::string disagreement(const RelationCase& c) {
  const Model a(c.a), b(c.b);
  const oracle::Relation truth = oracle::relation(oracle_set(c.a, c.query.pose_a, c.query.solid_a),
                                                  oracle_set(c.b, c.query.pose_b, c.query.solid_b));
  const PairQuery swapped{c.query.pose_b, c.query.pose_a, c.query.solid_b, c.query.solid_a};
  const std::string forward = told(relation(a, b, c.query)), backward = told(relation(b, a, swapped));
  if (forward != told(truth)) return fmt::format("{} is {}", forward, told(truth));
  if (backward != told(oracle::flipped(truth))) return fmt::format("swapped: {} is {}", backward, told(truth));
  return {};
}

SweepResult compare_relations(const std::string& family, std::uint64_t seed, std::uint64_t cases) {
  Random random(seed);
  SweepResult result;
  for (; result.cases < cases; ++result.cases) {
    const RelationCase made = random_relation_case(family, random);
    const std::string wrong = disagreement(made);
    if (wrong.empty()) continue;
    if (result.wrong++ == 0) result.first_failure = fmt::format("case {}: {}; {}", result.cases, wrong, told(made));
  }
  return result;
}

/// A grid point or a free point near the meshes.
Vec3 random_point(Random& random) {
  const auto coordinate = [&] { return 0.5 * static_cast<double>(random.below(13)) - 1; };
  const auto free = [&] { return random.between(-1, 5); };
  if (random.below(4) == 0) return Vec3{free(), free(), free()};
  return Vec3{coordinate(), coordinate(), coordinate()};
}

SweepResult compare_locations(const std::string& family, std::uint64_t seed, std::uint64_t cases) {
  Random random(seed);
  SweepResult result;
  while (result.cases < cases) {
    const RelationCase made = random_relation_case(family, random);
    const Model solid(made.a);
    const oracle::MeshSet truth = oracle::solid_set(made.a, made.query.pose_a);
    for (int i = 0; i < 20 && result.cases < cases; ++i, ++result.cases) {
      const Vec3 point = random_point(random);
      const PointLocation found = locate(point, solid, made.query.pose_a);
      const oracle::Location expected = oracle::locate(oracle::exact(point), truth);
      const bool agrees = (found.side == Side::boundary) == expected.on_face &&
                          found.winding_number == expected.winding_number &&
                          (found.side == Side::inside) == (expected.winding_number != 0);
      if (!agrees && result.wrong++ == 0)
        result.first_failure = fmt::format("point ({}, {}, {}); {}", point.x, point.y, point.z, told(made));
    }
  }
  return result;
}

std::vector<std::string> solid_families() {
  return {"grid boxes", "grid tetrahedra", "l shapes", "parts", "hollow boxes", "sheared", "rigid"};
}

/// Those whose meshes have many triangles, of which the oracle needs some tenths of a second a case.
std::vector<std::string> large_families() { return {"l shapes", "parts", "hollow boxes", "equal", "rigid"}; }

std::vector<std::string> small_families() {
  std::vector<std::string> families = relation_families();
  for (const std::string& large : large_families()) std::erase(families, large);
  return families;
}

const bool relation_known =
    register_sweep({"relations", small_families(), 100'000, 40, compare_relations, 1000}) &&
    register_sweep({"relations-of-parts", large_families(), 10'000, 4, compare_relations, 100}) &&
    register_sweep({"point-locations", solid_families(), 200'000, 200, compare_locations});

}  // namespace
}  // namespace toccata::test
