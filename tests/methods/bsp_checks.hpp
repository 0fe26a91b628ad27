#pragma once

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "oracle/oracle.hpp"
#include "oracle/test_meshes.hpp"
#include "support/convex_cases.hpp"
#include "support/mesh_soups.hpp"
#include "support/voxel_solids.hpp"
#include "toccata/core/random.hpp"
#include "toccata/generate/meshes.hpp"
#include "toccata/methods/bsp_tree.hpp"
#include "toccata/query/overlap.hpp"
#include "toccata/shapes/mesh_health.hpp"

// Closed meshes, what is asked of their BSP trees, and what is wrong with an answer: by the model's own.
namespace toccata::test {

struct NamedMesh {
  std::string name;
  TriangleMesh mesh;
};

inline TriangleMesh moved_mesh(const TriangleMesh& mesh, const Vec3& by) {
  std::vector<Vec3> vertices(mesh.vertices().begin(), mesh.vertices().end());
  for (Vec3& v : vertices) v += by;
  return mesh.with_vertices(std::move(vertices));
}

inline TriangleMesh generated(const std::string& specification) {
  const GeneratorSpecification s = parse_generator(specification);
  return generate_mesh(s.name, s.parameters);
}

/// Closed, and none meets itself.
inline std::vector<NamedMesh> closed_meshes() {
  std::vector<NamedMesh> meshes;
  for (const char* name :
       {"gen:box", "gen:tetrahedron", "gen:gear", "gen:gear?teeth=5", "gen:cavity-box", "gen:icosphere?subdivisions=0",
        "gen:icosphere", "gen:uv-sphere", "gen:uv-sphere?around=5&along=3", "gen:noise-sphere",
        "gen:noise-sphere?roughness=0.8&seed=3", "gen:prism", "gen:prism?sides=3", "gen:torus",
        "gen:torus?around=7&sides=5", "gen:torus-knot?around=120&sides=6", "gen:helix?turns=2&steps-per-turn=16"})
    meshes.push_back({name, generated(name)});
  const TriangleMesh box = box_between({0, 0, 0}, {4, 4, 4}), inner = box_between({1, 1, 1}, {3, 3, 3});
  meshes.push_back({"inside out", oracle::inverted_box_mesh({0, 0, 0}, {4, 4, 4})});
  meshes.push_back({"a cavity", oracle::joined(box, oracle::inverted_box_mesh({1, 1, 1}, {3, 3, 3}))});
  meshes.push_back({"twice inside", oracle::joined(box, inner)});
  meshes.push_back({"two boxes", oracle::joined(box, box_between({5, 0, 0}, {6, 4, 4}))});
  const TriangleMesh knot = generated("gen:torus-knot?around=60&sides=5");
  meshes.push_back({"tiny", scaled_mesh(knot, 1e-200)});
  meshes.push_back({"denormal", scaled_mesh(box, 0x1p-1070)});
  meshes.push_back({"huge", scaled_mesh(knot, 1e250)});
  meshes.push_back({"far", moved_mesh(generated("gen:icosphere?subdivisions=1"), {1e9, -1e9, 3})});
  Random voxel_random(1);
  meshes.push_back({"a grid of voxels", mesh_of({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {1, 1, 1}, {3, 0, 0}},
                                                      Skin::outer, voxel_random)});
  return meshes;
}

inline Vec3 vertex_of(const TriangleMesh& mesh, Index triangle, int corner) {
  return mesh.vertices()[mesh.triangles()[triangle][static_cast<std::size_t>(corner % 3)]];
}

/// In the box of the mesh and a little beyond, on its vertices, about on edges and faces, on their extensions, and
/// level with vertices.
inline std::vector<Vec3> telling_points(const Model& model, std::size_t count, std::uint64_t seed) {
  Random random(seed);
  const TriangleMesh& mesh = model.mesh();
  const Aabb& box = model.bounds();
  const Vec3 size = box.upper - box.lower;
  std::vector<Vec3> points;
  while (points.size() < count) {
    const auto t = static_cast<Index>(random.below(mesh.triangle_count()));
    const int corner = static_cast<int>(random.below(3));
    const Vec3 a = vertex_of(mesh, t, corner), b = vertex_of(mesh, t, corner + 1), c = vertex_of(mesh, t, corner + 2);
    Vec3 inside;
    for (int axis = 0; axis < 3; ++axis) inside[axis] = box.lower[axis] + random.between(-0.1, 1.1) * size[axis];
    Vec3 level = inside;
    level[corner] = a[corner];
    Vec3 on_line = inside;
    on_line[corner] = a[corner];
    on_line[(corner + 1) % 3] = a[(corner + 1) % 3];
    for (const Vec3& p : {inside, level, on_line, a, 0.5 * a + 0.5 * b, 0.5 * a + (0.25 * b + 0.25 * c), a + (a - b),
                          a + ((a - b) + (a - c))})
      points.push_back(p);
  }
  return points;
}

struct BspRay {
  Vec3 origin;
  Vec3 motion;
};

/// From telling points to telling points, some of which lie on the surface.
inline std::vector<BspRay> telling_rays(const Model& model, std::size_t count) {
  const std::vector<Vec3> from = telling_points(model, count, 3), to = telling_points(model, count, 4);
  std::vector<BspRay> rays;
  for (std::size_t i = 0; i < count; ++i) {
    const Vec3 way = to[(5 * i + i / 8) % count] - from[i];
    if (way == Vec3{} || !is_finite(way)) continue;
    rays.push_back({from[i], way});
    rays.push_back({from[i] - 4.0 * way, 8.0 * way});
  }
  return rays;
}

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

/// Of all closed meshes, made once.
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

/// Of any kind and size, turned, about somewhere.
inline PlacedPolytope random_placed(const Vec3& about, double size, Random& random) {
  PlacedPolytope placed{random_convex(convex_kinds()[random.below(convex_kinds().size())], random), {}};
  // A shape with a radius is made smaller in itself.
  const double scale = size * std::pow(2, -1 - static_cast<double>(random.below(6)));
  const auto scaled = [&](const auto& shape) -> ConvexShape {
    using S = std::decay_t<decltype(shape)>;
    const Shape smaller = scaled_in_itself(shape, scale);
    return std::get<S>(smaller);
  };
  if (keeps_its_form(std::visit([](const auto& shape) { return Shape(shape); }, placed.shape)))
    placed.shape = std::visit(scaled, placed.shape);
  else
    placed.pose.linear = scale * Mat3::identity();
  placed.pose.linear = random_rotation(random) * placed.pose.linear;
  placed.pose.offset = about;
  return placed;
}

/// Of points of the mesh, its planes and its lines; none of it is turned, so that much of it touches.
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
  return static_cast<const PointLocation&>(found) == locate(p, subject.model) ? "" : "located otherwise";
}

inline std::string ray_fault(const BspSubject& subject, const BspRay& ray) {
  RayHit found = subject.tree.cast_ray(ray.origin, ray.motion);
  const RayHit truth = cast_ray(ray.origin, ray.motion, subject.model);
  found.lower = truth.lower;
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
inline std::string start_fault(const BspSubject& subject, const PlacedPolytope& placed, const ShapeHit& found,
                               const ShapeHit& truth) {
  if (!found.hit || found.upper != 0) return "they meet at the start";
  const auto meets = [&](Index t) {
    const Triangle triangle{{vertex_of(subject.model.mesh(), t, 0), vertex_of(subject.model.mesh(), t, 1),
                             vertex_of(subject.model.mesh(), t, 2)}};
    return overlap(posed(placed), PosedPolytope(triangle));
  };
  if (!meets(truth.element_b)) return found == truth ? "" : "another hit of a solid that holds it";
  return found.element_b <= truth.element_b && meets(found.element_b) ? "" : "does not meet at the start what it names";
}

inline std::string cast_fault(const BspSubject& subject, const PlacedPolytope& placed, const Vec3& motion,
                              const ShapeHit& truth) {
  ShapeHit found = subject.tree.cast_shape(posed(placed), motion);
  if (truth.hit && truth.upper == 0) return start_fault(subject, placed, found, truth);
  if (truth.lower > found.upper || found.lower > truth.upper) return "the time";
  found.lower = truth.lower;
  return found == truth ? "" : "another hit";
}

inline std::string trace_fault(const BspSubject& subject, const PlacedPolytope& placed, const Vec3& motion,
                               const ShapeHit& truth) {
  const BspTrace plain = subject.tree.trace(posed(placed), motion);
  const BspTrace bevelled = subject.tree.trace(posed(placed), motion, BspBevels::edges_and_corners);
  for (const BspTrace& trace : {plain, bevelled}) {
    if (!trace.hit && truth.hit) return "a trace is free, and the cast hits";
    if (truth.hit && trace.time > truth.upper) return "a trace is free too long";
    if (!trace.hit && trace != BspTrace{}) return "free, and yet not";
  }
  if (bevelled.hit && !plain.hit) return "bevels add a hit";
  return bevelled.time >= plain.time ? "" : "bevels make it earlier";
}

}  // namespace toccata::test
