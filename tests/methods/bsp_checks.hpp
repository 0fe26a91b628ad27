#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "methods/closed_meshes.hpp"
#include "support/convex_cases.hpp"
#include "support/mesh_soups.hpp"
#include "toccata/core/random.hpp"
#include "toccata/methods/bsp_tree.hpp"
#include "toccata/query/overlap.hpp"

// Closed meshes, what is asked of their BSP trees, and what is wrong with an answer: by the model's own.
namespace toccata::test {

inline bool is_slow(const std::string& mesh) { return mesh == "tiny" || mesh == "huge" || mesh == "denormal"; }

/// A mesh with its tree.
struct BspSubject {
  explicit BspSubject(NamedMesh named) : name(std::move(named.name)), model(std::move(named.mesh)), tree(model) {}

  std::string name;
  Model model;
  BspTree tree;

  [[nodiscard]] double size() const {
    const Vec3 sides = model.bounds().upper - model.bounds().lower;
    return std::max({sides.x, sides.y, sides.z});
  }
};

/// The subjects of all closed meshes, made once.
inline const std::vector<BspSubject>& bsp_subjects() {
  static const std::vector<BspSubject> all = [] {
    std::vector<BspSubject> subjects;
    for (NamedMesh& named : closed_meshes()) subjects.emplace_back(std::move(named));
    return subjects;
  }();
  return all;
}

inline Model model_of_placed(const PlacedPolytope& placed) {
  return std::visit([](const auto& shape) { return Model(shape); }, placed.shape);
}

/// A shape of any kind, turned, about somewhere, and some 1/2 to 1/64 of the size.
inline PlacedPolytope random_placed(const Vec3& about, double size, Random& random) {
  const ConvexShape shape = random_convex(convex_kinds()[random.below(convex_kinds().size())], random);
  const double scale = std::ldexp(size, -1 - static_cast<int>(random.below(6)));
  const Mat3 rotation = random_rotation(random);
  return std::visit(
      [&]<class S>(const S& unit) -> PlacedPolytope {
        if (!keeps_its_form(unit)) return {unit, pose_of(about, rotation, {scale, scale, scale})};
        return {std::get<S>(scaled_in_itself(unit, scale)), {rotation, about}};
      },
      shape);
}

/// A shape made of points of the mesh, its planes and its lines; none of it is turned, so that much of it touches.
inline PlacedPolytope telling_placed(const std::vector<Vec3>& points, double size, Random& random) {
  const auto point = [&] { return points[random.below(points.size())]; };
  const Vec3 a = point(), b = point(), c = point();
  const double length = std::max(size * std::pow(2, -static_cast<double>(random.below(6))), 0x1p-1074);
  switch (random.below(7)) {
    case 0:
      return {Point{a}, {}};
    case 1:
      return {Segment{a, b}, {}};
    case 2:
      return {Triangle{{a, b, c}}, {}};
    case 3:
      return {Sphere(length), Pose::translation(a + Vec3{length, 0, 0})};
    case 4:
      return {Capsule(a, b, length), {}};
    case 5:
      return {Box({length, length, length}), Pose::translation(a + Vec3{length, length, -length})};
    default:
      return {Box({length, 0.5 * length, 0.25 * length + 0x1p-1074}), Pose::translation(a + Vec3{0, 0, 0.25 * length})};
  }
}

inline std::string located_fault(const BspSubject& subject, const Vec3& p) {
  const BspLocation found = subject.tree.locate(p);
  const PointLocation truth = locate(p, subject.model);
  return found.side == truth.side && found.winding_number == truth.winding_number ? "" : "located otherwise";
}

inline std::string ray_fault(const BspSubject& subject, const Vec3& origin, const Vec3& motion) {
  std::optional<RayHit> found = subject.tree.cast_ray(origin, motion);
  const std::optional<RayHit> truth = cast_ray(origin, motion, subject.model);
  if (found && truth) found->lower = truth->lower;
  return found == truth ? "" : "another ray's hit";
}

inline std::string segment_fault(const BspSubject& subject, const Vec3& from, const Vec3& to) {
  return subject.tree.overlap(from, to) == overlap(Segment(from, to), subject.model) ? "" : "overlap of a segment";
}

inline std::string shape_fault(const BspSubject& subject, const PlacedPolytope& placed) {
  const bool truth = overlap(model_of_placed(placed), subject.model, {.pose_a = placed.pose});
  return subject.tree.overlap(posed(placed)) == truth ? "" : "overlap of a shape";
}

/// The truth of those that meet at the start names any triangle, or none of a solid that holds the shape.
inline std::string start_fault(const BspSubject& subject, const PlacedPolytope& placed,
                               const std::optional<ShapeHit>& found, const std::optional<ShapeHit>& truth) {
  if (!found || found->upper != 0) return "they meet at the start";
  const auto meets = [&](Index t) {
    const Triangle triangle{{vertex_of(subject.model.mesh(), t, 0), vertex_of(subject.model.mesh(), t, 1),
                             vertex_of(subject.model.mesh(), t, 2)}};
    return overlap(posed(placed), PosedPolytope(triangle));
  };
  if (!meets(truth->element_b)) return found == truth ? "" : "another hit of a solid that holds it";
  return found->element_b <= truth->element_b && meets(found->element_b) ? ""
                                                                         : "does not meet at the start what it names";
}

inline std::string cast_fault(const BspSubject& subject, const PlacedPolytope& placed, const Vec3& motion,
                              const std::optional<ShapeHit>& truth) {
  std::optional<ShapeHit> found = subject.tree.cast_shape(posed(placed), motion);
  if (truth && truth->upper == 0) return start_fault(subject, placed, found, truth);
  if (found.has_value() != truth.has_value()) return "met by one";
  if (!truth) return "";
  if (truth->lower > found->upper || found->lower > truth->upper) return "the time";
  found->lower = truth->lower;
  return found == truth ? "" : "another hit";
}

inline std::string trace_fault(const BspSubject& subject, const PlacedPolytope& placed, const Vec3& motion,
                               const std::optional<ShapeHit>& truth) {
  const std::optional<BspTrace> plain = subject.tree.trace(posed(placed), motion);
  const std::optional<BspTrace> bevelled = subject.tree.trace(posed(placed), motion, BspBevels::edges_and_corners);
  for (const std::optional<BspTrace>& trace : {plain, bevelled}) {
    if (!trace && truth) return "a trace is free, and the cast hits";
    if (!trace) continue;
    if (truth && trace->time > truth->upper) return "a trace is free too long";
    if (trace->time > 0 && !(std::fabs(length(trace->normal) - 1) < 1e-12)) return "the normal is no unit";
    if (!(dot(trace->normal, normalized(motion)) < 1e-9)) return "the normal is along the motion";
  }
  if (bevelled && !plain) return "bevels add a hit";
  return !bevelled || bevelled->time >= plain->time ? "" : "bevels make it earlier";
}

}  // namespace toccata::test
