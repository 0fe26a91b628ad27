#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "oracle/oracle.hpp"
#include "oracle/penetration.hpp"
#include "query/winding_checks.hpp"
#include "support/convex_cases.hpp"
#include "support/mesh_soups.hpp"
#include "support/voxel_solids.hpp"
#include "toccata/query/distance.hpp"
#include "toccata/query/faces_in_region.hpp"
#include "toccata/query/nearest.hpp"
#include "toccata/query/signed_distance.hpp"

// Questions about the surfaces of height fields and compounds at hard places, compared with rational arithmetic,
// element by element.
namespace toccata::test {

/// An element as it is in the world.
struct WorldElement {
  oracle::ConvexSet set;
  Index face = 0;
  bool solid = false;  ///< asked about by its boundary
};

struct SurfaceCase {
  Model model = Model(Point{});
  Pose pose;
  std::vector<WorldElement> elements;     ///< in their order
  std::vector<oracle::MeshSet> closed{};  ///< of the meshes that are
  bool has_open = false;                  ///< a mesh or height field that is not
};

inline const std::vector<std::string>& surface_families() {
  static const std::vector<std::string> all{"height field", "compound of surfaces", "compound of solids",
                                            "compound of compounds"};
  return all;
}

inline const std::vector<std::string>& surface_places() {
  static const std::vector<std::string> all{"rigid",   "scaled", "sheared", "mirrored", "singular",
                                            "snapped", "far",    "tiny",    "huge",     "small and far"};
  return all;
}

/// All of it, other than scaled.
inline Pose multiplied(const Pose& pose, double factor) { return {scaled(pose, factor).linear, factor * pose.offset}; }

inline Pose pose_at(const std::string& place, Random& random) {
  if (place == "tiny") return multiplied(random_poses("sheared", random).pose_a, 0x1p-400);
  if (place == "huge") return multiplied(random_poses("sheared", random).pose_a, 0x1p400);
  if (place != "small and far") return random_poses(place, random).pose_a;
  Pose pose = random_poses("scaled", random).pose_a;
  pose = scaled(pose, 1e-6);
  pose.offset = {1e6, -3e7, 12345.678};
  return pose;
}

inline HeightField random_field(Random& random) {
  const auto columns = static_cast<Index>(2 + random.below(4)), rows = static_cast<Index>(2 + random.below(4));
  const std::uint64_t kind = random.below(3);
  std::vector<double> heights;
  for (Index i = 0; i < columns * rows; ++i)
    heights.push_back(kind == 0   ? 0
                      : kind == 1 ? static_cast<double>(random.below(4)) / 4
                                  : random.between(-1, 1) * std::exp2(random.between(-20, 3)));
  return HeightField(columns, rows, 0.25 * static_cast<double>(1 + random.below(4)), 0.5, heights);
}

inline void add_elements(const TriangleMesh& mesh, const Pose& pose, SurfaceCase& c) {
  const Index faces = c.elements.empty() ? 0 : c.elements.back().face + 1;
  const std::vector<Triangle> world = world_triangles(mesh, pose);
  for (Index i = 0; i < world.size(); ++i)
    c.elements.push_back({oracle::triangle_set(world[i][0], world[i][1], world[i][2]), faces + mesh.face_of(i)});
}

/// A part, posed in the world; remembers its elements.
inline Shape surface_part(Random& random, const Pose& pose, SurfaceCase& c) {
  const Index faces = c.elements.empty() ? 0 : c.elements.back().face + 1;
  const std::uint64_t kind = random.below(4);
  if (kind == 0) {
    const HeightField field = random_field(random);
    add_elements(*field.mesh(), pose, c);
    c.has_open = true;
    return field;
  }
  const auto soup = std::make_shared<const TriangleMesh>(
      random_soup(random, static_cast<Index>(1 + random.below(10)), 0.4, random.below(2) == 0 ? 8 : 0));
  // Triangles without area may be closed: a solid, which no pose may flatten.
  if (kind == 1 && !(oracle::is_closed(*soup) && is_singular(pose.linear))) {
    add_elements(*soup, pose, c);
    if (oracle::is_closed(*soup))
      c.closed.push_back(oracle::solid_set(*soup, pose));
    else
      c.has_open = true;
    return soup;
  }
  const ConvexShape shape = random_convex(kind == 2 ? "segment" : "triangle", random);
  c.elements.push_back({set_of(PlacedPolytope{shape, pose}), faces});
  return std::visit([](const auto& one) -> Shape { return one; }, shape);
}

inline Shape solid_part(Random& random, const Pose& pose, bool may_be_round, SurfaceCase& c) {
  const Index faces = c.elements.empty() ? 0 : c.elements.back().face + 1;
  if (random.below(3) == 0) {
    const auto box = std::make_shared<const TriangleMesh>(mesh_of(random_voxels(random, 3, 2), Skin::outer, random));
    add_elements(*box, pose, c);
    c.closed.push_back(oracle::solid_set(*box, pose));
    return box;
  }
  static const std::vector<std::string> kinds{"box", "hull", "sphere", "capsule", "rounded-box", "rounded-triangle"};
  const PlacedPolytope placed{random_convex(kinds[random.below(may_be_round ? kinds.size() : 2)], random), pose};
  c.elements.push_back({set_of(placed), faces, is_solid(placed)});
  return std::visit([](const auto& one) -> Shape { return one; }, placed.shape);
}

inline Compound random_compound(const std::string& family, const Pose& pose, bool may_be_round, Random& random,
                                SurfaceCase& c) {
  std::vector<CompoundPart> parts;
  for (std::uint64_t i = 1 + random.below(4); i > 0; --i) {
    const Pose own{random_rotation(random), random_vector(random, 1.5)};
    const Pose world = pose * own;
    if (family == "compound of compounds" && random.below(2) == 0)
      parts.push_back({random_compound("compound of solids", world, false, random, c), own});
    else if (family == "compound of surfaces")
      parts.push_back({surface_part(random, world, c), own});
    else
      parts.push_back({solid_part(random, world, may_be_round, c), own});
  }
  return Compound(parts);
}

/// Solids are not flattened: where the pose is singular, surfaces take their place.
inline SurfaceCase surface_case(std::string family, const std::string& place, Random& random) {
  SurfaceCase c;
  c.pose = pose_at(place, random);
  if (is_singular(c.pose.linear) && family != "height field") family = "compound of surfaces";
  if (family == "height field") {
    const HeightField field = random_field(random);
    add_elements(*field.mesh(), c.pose, c);
    c.has_open = true;
    c.model = Model(field);
  } else {
    const bool is_rigid = place == "rigid" || place == "far";
    c.model = Model(random_compound(family, c.pose, is_rigid, random, c));
  }
  return c;
}

/// Near some element, or far off.
inline Vec3 point_of(const SurfaceCase& c, Random& random) {
  const std::vector<oracle::RationalPoint>& corners = c.elements[random.below(c.elements.size())].set.vertices;
  const auto any = [&] { return rounded(corners[random.below(corners.size())]); };
  const auto all = [&] { return rounded(c.elements[random.below(c.elements.size())].set.vertices[0]); };
  Vec3 p = any();
  const Vec3 way = any() - p;
  p = p + (random.below(2) == 0 ? 0.5 : random.unit()) * way;
  if (random.below(4) == 0) return p;
  const Vec3 across = all() - all();
  const double size = std::max({std::fabs(way.x), std::fabs(way.y), std::fabs(across.y), std::fabs(across.z)});
  return p + random_vector(random, size * std::exp2(random.between(-40, 4)));
}

/// How far the surface of an element is from a point.
class ElementDistance {
 public:
  ElementDistance(const WorldElement& element, const Vec3& point)
      : set_(element.set), at_(oracle::point_set(point)), inside_(element.solid && side_of(element, point) < 0) {
    if (inside_) depth_.emplace(at_, set_);
  }

  static int side_of(const WorldElement& element, const Vec3& point) {
    return oracle::side_of(oracle::exact(point), element.set);
  }

  [[nodiscard]] bool inside() const { return inside_; }

  /// The sign of it less a length.
  [[nodiscard]] int compare(double length) const {
    const oracle::Rational exact = oracle::exact(length);
    return inside_ ? depth_->compare(exact) : oracle::compare_distance(at_, set_, exact);
  }

 private:
  const oracle::ConvexSet& set_;
  oracle::ConvexSet at_;
  bool inside_;
  std::optional<oracle::Depth> depth_;
};

/// What is wrong with the k nearest elements, or nothing.
inline std::string fault_of_nearest(const SurfaceCase& c, const Vec3& point, std::size_t k) {
  const std::vector<SurfacePoint> found = nearest_points(point, k, c.model, {.pose = c.pose});
  if (found.size() != std::min(k, c.elements.size())) return "the number";
  std::vector<bool> told(c.elements.size());
  for (std::size_t i = 0; i < found.size(); ++i) {
    const SurfacePoint& one = found[i];
    if (one.element >= c.elements.size() || told[one.element]) return "an element twice";
    told[one.element] = true;
    const ElementDistance distance(c.elements[one.element], point);
    if (distance.compare(one.lower) < 0 || distance.compare(one.upper) > 0) return fmt::format("the interval of {}", i);
    if (one.upper - one.lower > 1e-12 * one.upper && std::nextafter(one.lower, HUGE_VAL) < one.upper)
      return fmt::format("the width of {}", i);
    if (one.face != c.elements[one.element].face) return fmt::format("the face of {}", i);
    if (i > 0 &&
        (one.upper < found[i - 1].upper || (one.upper == found[i - 1].upper && one.element < found[i - 1].element)))
      return "the order";
  }
  // What was left out is not nearer than the farthest of these may be.
  for (std::size_t e = 0; e < told.size(); ++e)
    if (!told[e] && ElementDistance(c.elements[e], point).compare(found.back().lower) < 0)
      return fmt::format("element {} is nearer", e);
  return "";
}

/// What is wrong with the signed distance; of open meshes the side is not known here.
inline std::string fault_of_sign(const SurfaceCase& c, const Vec3& point) {
  const SignedDistance found = signed_distance(point, c.model, c.pose);
  const std::optional<SurfacePoint> nearest = nearest_point(point, c.model, {.pose = c.pose});
  if (found.element != nearest->element || !(found.nearest == nearest->point)) return "another point";
  const double least = std::min(std::fabs(found.lower), std::fabs(found.upper));
  if (found.status == Status::exact && least != nearest->lower) return "another distance";
  bool inside = false, on_some = false;
  for (const WorldElement& element : c.elements) {
    inside = inside || (element.solid && ElementDistance::side_of(element, point) < 0);
    on_some = on_some || ElementDistance(element, point).compare(0) == 0;
  }
  for (const oracle::MeshSet& mesh : c.closed)
    inside = inside || oracle::locate(oracle::exact(point), mesh).winding_number != 0;
  if (on_some) return found.side == Side::boundary && found.upper == 0 ? "" : "not on the surface";
  if (found.side == Side::boundary) return "on the surface";
  if (inside) return found.side == Side::inside && found.sign_by == SignBy::winding_number ? "" : "not inside";
  if (c.has_open) return found.sign_by == SignBy::generalized_winding_number ? "" : "not told how";
  return found.side == Side::outside ? "" : "not outside";
}

/// What is wrong with the elements within a ball and a box, or nothing.
inline std::string fault_of_regions(const SurfaceCase& c, const Vec3& point, double reach) {
  const Vec3 corner = point + Vec3{reach, 0.5 * reach, 2 * reach};
  std::vector<Vec3> corners;
  for (const double x : {point.x, corner.x})
    for (const double y : {point.y, corner.y})
      for (const double z : {point.z, corner.z}) corners.push_back({x, y, z});
  const auto fault = [&](const Region& region, const oracle::ConvexSet& set) -> std::string {
    std::vector<FoundElement> expected;
    for (Index i = 0; i < c.elements.size(); ++i)
      if (oracle::overlap(c.elements[i].set, set)) expected.push_back({i, c.elements[i].face});
    return faces_in_region(region, c.model, c.pose) == expected ? "" : "the elements within";
  };
  const std::string of_ball = fault(Ball{point, reach}, oracle::sphere_set(point, reach));
  return of_ball.empty() ? fault(Aabb{point, corner}, oracle::box_set(corners)) : of_ball;
}

/// What is wrong with whether a small box is closer than some lengths, or nothing. Meshes are taken as surfaces.
inline std::string fault_of_closeness(const SurfaceCase& c, const Vec3& point, double size, Random& random) {
  const PlacedPolytope other{random_convex(random.below(2) == 0 ? "hull" : "triangle", random),
                             scaled({random_rotation(random), {}}, size)};
  PlacedPolytope placed = other;
  placed.pose.offset = point;
  const auto shape = std::visit([](const auto& one) { return Model(one); }, placed.shape);
  const oracle::ConvexSet set = set_of(placed);
  const PairQuery query{.pose_a = c.pose, .pose_b = placed.pose, .solid_a = Solid::none};
  const Distance found = distance(c.model, shape, query);
  for (const double length : {0.0, found.lower, found.upper, std::nextafter(found.upper, HUGE_VAL), 0.5 * size, size}) {
    const oracle::Rational exact = oracle::exact(length);
    const bool expected = std::any_of(c.elements.begin(), c.elements.end(), [&](const WorldElement& element) {
      return oracle::compare_distance(element.set, set, exact) <= 0;
    });
    if (within_distance(c.model, shape, length, query) != expected) return fmt::format("closer than {}", length);
    if (distance_within(c.model, shape, length, query).has_value() != expected) return "the distance within";
  }
  return "";
}

/// Everything about one case and one point.
inline std::string surface_fault(const SurfaceCase& c, const Vec3& point, Random& random) {
  std::string fault = fault_of_nearest(c, point, 1 + random.below(c.elements.size() + 1));
  if (fault.empty()) fault = fault_of_sign(c, point);
  const double upper = nearest_point(point, c.model, {.pose = c.pose})->upper;
  const Vec3 from = rounded(c.elements[0].set.vertices[0]) - point;
  const double reach = random.below(3) == 0 ? upper : std::hypot(from.x, from.y, from.z) * random.unit();
  if (fault.empty()) fault = fault_of_regions(c, point, reach);
  if (fault.empty() && reach > 0) fault = fault_of_closeness(c, point, reach, random);
  return fault;
}

}  // namespace toccata::test
