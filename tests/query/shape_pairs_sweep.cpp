#include <fmt/format.h>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "narrow/convex_cells.hpp"
#include "query/shape_pairs_checks.hpp"
#include "support/mesh_soups.hpp"

// A mesh, a height field or a compound against every kind of convex shape, in every regime: overlap, relation and
// contacts, compared with the rational oracle.
namespace toccata::test {
namespace {

oracle::Relation relation_of(const PlacedPolytope& a, const PlacedPolytope& b) {
  return oracle::relation(set_of(a), is_solid(a), set_of(b), is_solid(b));
}

/// A is the mesh of its own hull, where that is the same set.
std::string check_mesh(const ConvexCase& pair) {
  const std::optional<Model> a = as_mesh(pair.a);
  if (!a) return "";
  // A triangle that is a segment is closed, and not meant as a solid here.
  const PairQuery query{.pose_b = pair.b.pose, .solid_a = is_solid(pair.a) ? Solid::all : Solid::none};
  return fault_of(*a, model_of(pair.b.shape), query, relation_of(pair.a, pair.b));
}

/// The relation of a union of surfaces, from those of its parts.
oracle::Relation relation_of_surfaces(const std::vector<oracle::ConvexSet>& parts, const PlacedPolytope& b) {
  oracle::Relation all;
  bool all_inside = true;
  for (const oracle::ConvexSet& part : parts) {
    const oracle::Relation r = oracle::relation(part, false, set_of(b), is_solid(b));
    all_inside = all_inside && r.containment == oracle::Containment::a_in_b;
    if (r.kind == oracle::RelationKind::apart || all.kind == oracle::RelationKind::crossing) continue;
    all = r;
  }
  all.containment = all_inside ? oracle::Containment::a_in_b : oracle::Containment::none;
  return all;
}

/// A field of 3 × 3 heights, the first vertex of which is exactly the point of the case.
std::string check_height_field(const ConvexCase& pair, Random& random) {
  const auto& point = std::get<Point>(pair.a.shape);
  const double size = std::ldexp(1, static_cast<int>(random.below(5)) - 2);
  std::vector<double> heights{0};
  for (int i = 1; i < 9; ++i) heights.push_back(size * random.between(-1, 1));
  const Model field(HeightField(3, 3, size, size, heights));
  const Mat3 turned = random_rotation(random);
  const Pose pose{turned, oracle::world_vertex(pair.a.pose, point.position())};
  std::vector<oracle::ConvexSet> triangles;
  for (Index i = 0; i < field.element_count(); ++i) {
    const Triangle t = world_triangle(field, pose, i);
    triangles.push_back(oracle::triangle_set(t[0], t[1], t[2]));
  }
  const PairQuery query{.pose_a = pose, .pose_b = pair.b.pose};
  return fault_of(field, model_of(pair.b.shape), query, relation_of_surfaces(triangles, pair.b));
}

Shape shape_of(const ConvexShape& shape) {
  return std::visit([](const auto& given) { return Shape(given); }, shape);
}

/// Two shapes of cases with B, as one model: it meets B where one of them does.
std::string check_compound(const ConvexCase& first, const PlacedPolytope& second) {
  const std::array<PlacedPolytope, 2> placed{first.a, second};
  const std::array<CompoundPart, 2> parts{CompoundPart{shape_of(placed[0].shape), placed[0].pose},
                                          CompoundPart{shape_of(placed[1].shape), placed[1].pose}};
  const Model a(Compound{parts}), b = model_of(first.b.shape);
  const PairQuery query{.pose_b = first.b.pose};
  std::vector<Index> meeting;
  for (Index i = 0; i < 2; ++i)
    if (oracle::overlap(set_of(placed[i]), set_of(first.b))) meeting.push_back(i);
  if (overlap(a, b, query) == meeting.empty()) return "overlap";
  if ((relation(a, b, query).kind == RelationKind::apart) != meeting.empty()) return "relation";
  std::vector<Index> found;
  for (const Contact& contact : contacts(a, b, query)) found.push_back(contact.element_a);
  if (found != meeting) return "contacts";
  if (!is_solid(placed[0]) || !is_solid(placed[1]) || !is_solid(first.b)) return "";
  // The interiors of solids meet where those of a part do.
  const oracle::Relation one = relation_of(placed[0], first.b), other = relation_of(placed[1], first.b);
  const oracle::RelationKind kind = std::max(one.kind, other.kind);
  return relation(a, b, query).kind == kind_of(kind) ? "" : "relation of solids";
}

const std::vector<std::string> sides{"mesh of triangle", "mesh of box", "mesh of hull", "height field", "compound"};

std::string check_shape_pairs(const std::string& side, const std::string& kind_b, const std::string& regime,
                              Random& random, std::string& text) {
  const bool of_mesh = side.starts_with("mesh of ");
  const std::string kind_a = of_mesh ? side.substr(8) : side == "compound" ? "hull" : "point";
  const ConvexCase pair = convex_case(kind_a, kind_b, regime, random);
  text = to_text(pair);
  if (of_mesh) return check_mesh(pair);
  if (side == "height field") return check_height_field(pair, random);
  const std::string& kind = convex_kinds()[random.below(convex_kinds().size())];
  return check_compound(pair, convex_case(kind, kind_b, regime, random).a);
}

SweepResult run_shape_pairs(const std::string& cell, std::uint64_t seed, std::uint64_t cases) {
  const std::size_t slash = cell.find('/');
  const std::vector<std::string>& regimes = convex_regimes();
  SweepResult result;
  Random random = random_of_cell(cell, seed);
  for (; result.cases < cases; ++result.cases) {
    const std::string& regime = regimes[result.cases % regimes.size()];
    std::string text;
    const std::string wrong = check_shape_pairs(cell.substr(0, slash), cell.substr(slash + 1), regime, random, text);
    if (wrong.empty()) continue;
    if (result.wrong++ == 0) result.first_failure = fmt::format("{}, case {}: {}", wrong, result.cases, text);
  }
  return result;
}

std::vector<std::string> cells() {
  std::vector<std::string> all;
  for (const std::string& side : sides)
    for (const std::string& kind : convex_kinds()) all.push_back(fmt::format("{}/{}", side, kind));
  return all;
}

const bool shape_pairs_known =
    register_sweep({"shape-pairs", cells(), cell_goal, 10 * cell_round, run_shape_pairs, cell_shard, cell_round});

}  // namespace
}  // namespace toccata::test
