#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "narrow/quadric_cases.hpp"
#include "oracle/winding.hpp"
#include "query/casts/mesh_casts.hpp"
#include "query/distance/mesh_distance.hpp"
#include "query/meshes/triangles_shape.hpp"
#include "support/mesh_soups.hpp"
#include "toccata/generate/meshes.hpp"
#include "toccata/narrow/quadrics.hpp"
#include "toccata/shapes/height_field.hpp"

// Meshes and height fields with a quadric beside, in or around them, and what the answers about them have to be:
// every triangle is asked by itself, what lies inside is told by winding numbers of 50 digits, and what is nearest is
// measured with 60.
namespace toccata::test {

struct QuadricMeshCase {
  Model mesh;
  Pose pose;
  bool solid;
  PlacedQuadric shape;
};

inline const std::vector<std::string>& quadric_mesh_kinds() {
  static const std::vector<std::string> kinds{"box", "channel", "shells", "bumpy", "soup", "height-field"};
  return kinds;
}

/// far, near, close (a gap or an overlap of 10⁻⁶ to 10⁻¹⁴), deep, inside (small), around (large), aligned (on a grid,
/// turned by right angles), affine, distant, tiny and huge.
inline const std::vector<std::string>& quadric_mesh_regimes() {
  static const std::vector<std::string> regimes{"far",     "near",   "close",   "deep", "inside", "around",
                                                "aligned", "affine", "distant", "tiny", "huge"};
  return regimes;
}

inline Model quadric_mesh_of(const std::string& kind, Random& random) {
  if (kind == "box") return Model(box_between({-1, -2, -1.5}, {1, 2, 1.5}));
  if (kind == "channel") {
    const std::vector<Vec2> outline = {{-2, -1}, {2, -1}, {2, 2}, {1, 2}, {1, 0}, {-1, 0}, {-1, 2}, {-2, 2}};
    return Model(extruded_mesh(outline, 2));
  }
  if (kind == "shells") {  // two that overlap, and inner faces with them
    const TriangleMesh one = box_between({-1, -1, -1}, {1, 1, 1}), other = box_between({0, -0.5, -1}, {2, 1.5, 1});
    std::vector<Vec3> vertices(one.vertices().begin(), one.vertices().end());
    std::vector<std::array<Index, 3>> triangles(one.triangles().begin(), one.triangles().end());
    const Index first = static_cast<Index>(vertices.size());
    vertices.insert(vertices.end(), other.vertices().begin(), other.vertices().end());
    for (const auto& t : other.triangles()) triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
    return Model(TriangleMesh(std::move(vertices), std::move(triangles)));
  }
  if (kind == "bumpy")
    return Model(noise_sphere_mesh({.radius = 1.5, .roughness = 0.3, .subdivisions = 1, .seed = random.below(1000)}));
  if (kind == "soup")
    return Model(random_soup(random, static_cast<Index>(3 + random.below(20)), 0.7, random.below(2) == 0 ? 0 : 4));
  std::vector<double> heights;
  for (int i = 0; i < 20; ++i) heights.push_back(0.25 * static_cast<double>(random.below(4)));
  return Model(HeightField(5, 4, 0.5, 0.75, heights));
}

inline std::vector<Triangle> world_triangles_of(const PosedTriangles& a) { return a.mesh.triangles(); }

inline PosedTriangles posed_triangles(const QuadricMeshCase& one) { return {PosedMesh(one.mesh, one.pose), one.solid}; }

/// Moves the shape until its gap to the surface is about this, or the overlap where it is negative.
inline void leave_gap_to_mesh(QuadricMeshCase& one, double gap) {
  SearchScratch scratch;
  const PosedTriangles surface{PosedMesh(one.mesh, one.pose), false};
  for (int i = 0; i < 3; ++i) {
    const Distance now = nearby(surface, posed(one.shape), {}, scratch)->distance;
    const Vec3 way = now.on_b - now.on_a;
    const double length = std::sqrt(dot(way, way));
    if (!(length > 0)) return;
    one.shape.pose.offset = one.shape.pose.offset - ((length - gap) / length) * way;
    if (gap <= 0) return;
  }
}

inline void resize(QuadricMeshCase& one, double factor) {
  for (Pose* pose : {&one.pose, &one.shape.pose}) *pose = {scaled(*pose, factor).linear, factor * pose->offset};
}

inline void place_in_regime(QuadricMeshCase& one, const std::string& regime, Random& random) {
  Vec3& offset = one.shape.pose.offset;
  const double sign = random.below(2) == 0 ? -1 : 1;
  if (regime == "aligned") {
    for (int i = 0; i < 3; ++i) offset[i] = 0.5 * (static_cast<double>(random.below(13)) - 6);
    return;
  }
  if (regime == "deep" || regime == "inside" || regime == "around") {
    offset = one.pose.offset + random.between(0, regime == "deep" ? 2 : 1) * quadric_direction(random);
    return;
  }
  offset = one.pose.offset + random.between(8, 12) * quadric_direction(random);
  if (regime == "close") leave_gap_to_mesh(one, sign * std::pow(10.0, random.between(-14, -6)));
  if (regime != "far" && regime != "close") leave_gap_to_mesh(one, sign * random.between(0.001, 0.3));
  if (regime == "distant") {
    const Vec3 place = std::pow(10.0, random.between(3, 8)) * quadric_direction(random);
    one.pose.offset = one.pose.offset + place;
    offset = offset + place;
  }
  if (regime == "tiny" || regime == "huge")
    resize(one, std::pow(10.0, regime == "tiny" ? -random.between(5, 90) : random.between(5, 90)));
}

inline QuadricMeshCase quadric_mesh_case(const std::string& kind, const std::string& mesh_kind,
                                         const std::string& regime, Random& random) {
  const std::string plain = regime == "aligned" || regime == "affine" ? regime : "far";
  Vec3 half = quadric_half_axes(plain, random);
  if (regime == "inside") half = 0.2 * half;
  if (regime == "around") half = {6 + half.x, 6 + half.y, 6 + half.z};
  if (regime == "aligned") half = 0.5 * half;
  const bool is_turned = regime != "aligned";
  QuadricMeshCase one{quadric_mesh_of(mesh_kind, random),
                      {is_turned ? quadric_linear("far", random) : Pose{}.linear, {}},
                      mesh_kind != "soup" && mesh_kind != "height-field" && random.below(4) > 0,
                      {quadric_shape(kind, half), {quadric_linear(plain, random), {}}}};
  place_in_regime(one, regime, random);
  return one;
}

// What every triangle by itself says.

struct TrianglesAlone {
  QuadricContact contact = QuadricContact::apart;
  Distance nearest;
  double lower = std::numeric_limits<double>::infinity();
  Index first_proved = 0;
};

inline TrianglesAlone each_by_itself(const std::vector<Triangle>& triangles, const PosedQuadric& shape) {
  TrianglesAlone all;
  all.nearest.upper = std::numeric_limits<double>::infinity();
  for (Index i = 0; i < triangles.size(); ++i) {
    const PosedPolytope triangle(triangles[i]);
    const QuadricContact met = quadric_contact(triangle, shape);
    Distance d = distance(triangle, shape);
    d.element_a = i;
    if (met == QuadricContact::contact && all.contact != met) all.first_proved = i;
    if (met == QuadricContact::contact || all.contact == QuadricContact::apart) all.contact = met;
    all.lower = std::min(all.lower, d.lower);
    if (d.upper < all.nearest.upper) all.nearest = d;
  }
  return all;
}

/// The winding number of a closed mesh, by angles in doubles where none of them is near the seam of its arc tangent;
/// else in 50 digits.
inline double winding_of_closed(const Vec3& p, const std::vector<Triangle>& triangles) {
  constexpr double pi = 3.14159265358979323846;
  double sum = 0;
  for (const Triangle& t : triangles) {
    const Vec3 a = t[0] - p, b = t[1] - p, c = t[2] - p;
    const double la = std::sqrt(dot(a, a)), lb = std::sqrt(dot(b, b)), lc = std::sqrt(dot(c, c)), size = la * lb * lc;
    const double across = dot(a, cross(b, c)), along = size + dot(a, b) * lc + dot(b, c) * la + dot(c, a) * lb;
    // Rounding turns no angle by more than 10⁻⁹ then. Asked so that NaN and lengths of 0 are left to the digits.
    if (!(along > 1e-5 * size || std::abs(across) > 1e-5 * size) || !(size > 1e-250 && size < 1e250))
      return oracle::winding_number(p, triangles);
    sum += std::atan2(across, along);
  }
  const double wound = sum / (2 * pi);
  return std::abs(wound - std::round(wound)) < 1e-6 ? std::round(wound) : oracle::winding_number(p, triangles);
}

inline bool is_middle_inside(const PosedTriangles& a, const std::vector<Triangle>& triangles, const PosedQuadric& b) {
  return a.solid && std::abs(winding_of_closed(b.pose().offset, triangles)) > 0.5;
}

inline std::string fault_of_contact(const PosedTriangles& a, const PosedQuadric& b, const TrianglesAlone& truth,
                                    bool inside) {
  const QuadricContact wanted = inside ? QuadricContact::contact : truth.contact;
  if (quadric_contact(a, b) != wanted) return "contact";
  if (overlap(a, b) != (wanted != QuadricContact::apart)) return "overlap";
  return "";
}

inline std::string fault_of_distance(const PosedTriangles& a, const PosedQuadric& b, const TrianglesAlone& truth,
                                     bool inside) {
  SearchScratch scratch;
  const Distance found = nearby(a, b, {}, scratch)->distance;
  if (inside && truth.nearest.upper > 0)
    return found.upper == 0 && found.status == Status::exact ? "" : "distance of what lies inside";
  if (found.upper != truth.nearest.upper) return fmt::format("distance {} of {}", found.upper, truth.nearest.upper);
  if (found.lower != (found.upper == 0 ? 0 : truth.lower))
    return fmt::format("lower {} of {}", found.lower, truth.lower);
  if (found.element_a != truth.nearest.element_a) return "nearest element";
  if (found.status == Status::exact && !(found.upper - found.lower <= 1e-12 * found.upper)) return "interval too wide";
  if (found.status == Status::undecided && found.lower > 0) return "undecided, but apart";
  const double more = found.upper * (1 + 1e-6) + 1e-300, less = found.lower * (1 - 1e-6);
  if (!nearby(a, b, WantedDistance::within(more), scratch)) return "within a tolerance";
  if (less > 0 && nearby(a, b, WantedDistance::within(less), scratch)) return "not within a tolerance";
  const auto near = nearby(a, b, {.limit = more}, scratch);
  if (!near || near->distance.upper != found.upper || near->distance.lower != found.lower) return "nearby";
  if (less > 0 && nearby(a, b, {.limit = less / 2}, scratch)) return "nearby, though farther";
  return "";
}

/// No coordinate of either is much larger.
template <class Corners>
double reach_of(const Corners& corners, const PlacedQuadric& placed) {
  double reach = 0;
  for (const Vec3& v : corners) reach = std::max({reach, std::abs(v.x), std::abs(v.y), std::abs(v.z)});
  const Vec3& middle = placed.pose.offset;
  return std::max({reach, std::abs(middle.x), std::abs(middle.y), std::abs(middle.z)});
}

/// The nearest triangle and some others with 60 digits. None is nearer than the least lower end, which is what is told.
inline std::string fault_in_digits(const TrianglesAlone& all, const std::vector<Triangle>& triangles,
                                   const PlacedQuadric& placed, Random& random) {
  const oracle::FineSet set = fine_set(placed);
  const Distance& found = all.nearest;
  for (int i = 0; i < 3; ++i) {
    const Index number = i == 0 ? found.element_a : static_cast<Index>(random.below(triangles.size()));
    const auto& corners = triangles[number].vertex;
    const auto truth = oracle::fine_nearness(set, oracle::hull_set_of({corners.begin(), corners.end()}, 0), 1e-14, 400);
    if (truth.upper < oracle::Fine(all.lower)) return fmt::format("triangle {} is nearer than lower", number);
    // The search of 60 digits leaves a gap of its own rounding for shapes that touch exactly.
    const oracle::Fine rounding = oracle::Fine("1e-50") * reach_of(corners, placed);
    if (i == 0 && truth.lower > oracle::Fine(found.upper) + rounding)
      return "the nearest triangle is farther than upper";
  }
  return "";
}

/// Regions that points of the shape and of the mesh show.
struct RegionsShown {
  bool in_both = false;
  bool only_in_a = false;
  bool only_in_b = false;
};

inline Vec3 point_well_within(const PosedQuadric& shape, Random& random) {
  const Vec3 d = std::cbrt(random.between(0, 1)) * quadric_direction(random);
  const double across = shape.kind() == PosedQuadric::kind_of<Cone>       ? 0.4
                        : shape.kind() == PosedQuadric::kind_of<Cylinder> ? 0.7
                                                                          : 0.99;
  const Vec3 u{across * d.x * shape.half().x, across * d.y * shape.half().y,
               (shape.kind() == PosedQuadric::kind_of<Cone> ? 0.15 : across) * d.z * shape.half().z};
  return transform(shape.pose(), u);
}

inline RegionsShown regions_shown(const std::vector<Triangle>& triangles, const PosedQuadric& shape, Random& random) {
  RegionsShown shown;
  for (int i = 0; i < 12; ++i) {
    const Vec3 p = i == 0 ? shape.pose().offset : point_well_within(shape, random);
    const double wound = winding_of_closed(p, triangles);
    if (std::abs(wound - std::round(wound)) > 1e-9) continue;  // on a face
    (std::abs(wound) > 0.5 ? shown.in_both : shown.only_in_b) = true;
  }
  for (const Triangle& t : triangles)
    for (const Vec3& v : t.vertex)
      shown.only_in_a |= quadric_contact(shape, PosedPolytope(Point(v))) == QuadricContact::apart;
  return shown;
}

inline std::string fault_of_solid_relation(const Relation& found, const TrianglesAlone& truth,
                                           const RegionsShown& shown, bool inside) {
  if (shown.in_both && found.kind != RelationKind::overlapping) return "not seen to overlap";
  if (found.containment == Containment::equal) return "equal";
  if (found.containment == Containment::a_in_b && shown.only_in_a) return "a in b";
  if (found.containment == Containment::b_in_a && shown.only_in_b) return "b in a";
  if (found.kind == RelationKind::touching && found.status == Status::exact && truth.contact != QuadricContact::contact)
    return "touching, exactly, and no triangle is";
  const bool clear = truth.contact == QuadricContact::apart;
  if (clear && inside && (found.containment != Containment::b_in_a || found.status != Status::exact)) return "held";
  if (found.kind == RelationKind::overlapping && found.status == Status::exact &&
      found.containment == Containment::none && !shown.only_in_a)
    return "the mesh within is not told";
  return "";
}

inline std::string fault_of_surface_relation(const Relation& found, const std::vector<Triangle>& triangles,
                                             const PosedQuadric& b) {
  RelationKind kind = RelationKind::apart;
  bool all = true, exact = true;
  for (const Triangle& t : triangles) {
    const Relation one = relation(PosedPolytope(t), b);
    exact &= one.status == Status::exact;
    if (one.kind == RelationKind::crossing || kind == RelationKind::apart) kind = one.kind;
    for (const Vec3& v : t.vertex) all &= quadric_contact(b, PosedPolytope(Point(v))) == QuadricContact::contact;
  }
  if (found.kind != kind) return "relation of a surface";
  if ((found.containment == Containment::a_in_b) != all) return "containment of a surface";
  if (kind == RelationKind::touching && found.status == Status::exact && !exact)
    return "a surface that touches, exactly";
  return "";
}

inline std::string fault_of_relation(const PosedTriangles& a, const PosedQuadric& b,
                                     const std::vector<Triangle>& triangles, const TrianglesAlone& truth, bool inside,
                                     Random& random) {
  const Relation found = relation(a, b);
  if (found.a_solid != a.solid || !found.b_solid || found.side_unresolved) return "what it was taken for";
  const bool meets = inside || truth.contact != QuadricContact::apart;
  if ((found.kind != RelationKind::apart) != meets) return "apart";
  if (!meets) return "";
  return a.solid ? fault_of_solid_relation(found, truth, regions_shown(triangles, b, random), inside)
                 : fault_of_surface_relation(found, triangles, b);
}

/// The first of the triangles, and the least time at which any may be met.
template <class CastOne>
std::pair<std::optional<ShapeHit>, double> first_by_itself(const std::vector<Triangle>& triangles, CastOne cast_one) {
  std::optional<ShapeHit> first;
  double lower = 2;
  for (Index i = 0; i < triangles.size(); ++i) {
    const std::optional<Cast> one = cast_one(PosedPolytope(triangles[i]));
    if (!one) continue;
    lower = std::min(lower, one->lower);
    if (!first || one->upper < first->upper) {
      first.emplace();
      static_cast<Cast&>(*first) = *one;
      first->element_a = first->element_b = i;
    }
  }
  return {first, lower};
}

inline std::string fault_of_cast(const std::optional<ShapeHit>& found, const std::optional<ShapeHit>& first,
                                 double lower, bool inside, Index element) {
  if (inside && !(first && first->upper == 0)) return found && found->upper == 0 ? "" : "a cast from within a solid";
  if (found.has_value() != first.has_value()) return "hit";
  if (!found) return "";
  // At the start any of those that meet is told.
  if (found->upper == 0 && first->upper == 0) return "";
  if (found->upper != first->upper || element != first->element_a) return "another triangle is met first";
  if (found->status != first->status || !(found->normal == first->normal)) return "what is met";
  if (found->lower < lower || found->lower > first->lower) return "the time's lower end";
  return "";
}

inline std::string fault_of_casts(const PosedTriangles& a, const PosedQuadric& b,
                                  const std::vector<Triangle>& triangles, bool inside, Random& random) {
  const Aabb box = world_box(b);
  const Vec3 way = random.between(0.8, 2) * (a.mesh.pose().offset - b.pose().offset) +
                   random.between(0, 1) * (box.upper - box.lower);
  SearchScratch scratch;
  const auto forth = first_by_itself(triangles, [&](const PosedPolytope& t) { return cast_shape(b, way, t); });
  const auto found = cast_until(b, way, a, 1, scratch);
  if (auto wrong = fault_of_cast(found, forth.first, forth.second, inside, found ? found->element_b : 0);
      !wrong.empty())
    return wrong + ", the shape moves";
  const auto back = first_by_itself(triangles, [&](const PosedPolytope& t) { return cast_shape(t, -way, b); });
  const auto other = cast_until(a, -way, b, 1, scratch);
  if (auto wrong = fault_of_cast(other, back.first, back.second, inside, other ? other->element_a : 0); !wrong.empty())
    return wrong + ", the mesh moves";
  return "";
}

/// What is wrong with the answers; empty when nothing is.
inline std::string fault_of(const QuadricMeshCase& one, Random& random) {
  const PosedTriangles a = posed_triangles(one);
  const PosedQuadric b = posed(one.shape);
  const std::vector<Triangle> triangles = a.mesh.triangles();
  const TrianglesAlone truth = each_by_itself(triangles, b);
  const bool inside = is_middle_inside(a, triangles, b);
  for (const std::string& wrong :
       {fault_of_contact(a, b, truth, inside), fault_of_distance(a, b, truth, inside),
        fault_in_digits(truth, triangles, one.shape, random), fault_of_relation(a, b, triangles, truth, inside, random),
        fault_of_casts(a, b, triangles, inside, random)})
    if (!wrong.empty()) return wrong;
  return "";
}

}  // namespace toccata::test
