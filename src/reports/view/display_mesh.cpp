#include "reports/view/display_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <type_traits>
#include <utility>
#include <variant>

#include "narrow/quadrics/kinds/quadric_kind.hpp"

namespace toccata::io {
namespace {

DisplayMesh mesh_of(const TriangleMesh& mesh) {
  DisplayMesh shown;
  shown.vertices.assign(mesh.vertices().begin(), mesh.vertices().end());
  shown.triangles.assign(mesh.triangles().begin(), mesh.triangles().end());
  shown.faces.resize(mesh.triangle_count());
  for (Index i = 0; i < mesh.triangle_count(); ++i) shown.faces[i] = mesh.face_of(i);
  return shown;
}

/// Every face of the hull as a fan; of a flat hull the front alone.
DisplayMesh mesh_of(const ConvexHull& hull) {
  DisplayMesh shown;
  for (Index i = 0; i < hull.vertex_count(); ++i) shown.vertices.push_back(hull.vertex(i));
  if (hull.dimension() < 2) return shown;
  const HullTopology topology = hull.topology();
  const Index faces = hull.dimension() == 2 ? 1 : topology.face_count();
  for (Index face = 0; face < faces; ++face) {
    const Index first = topology.face_start[face], end = topology.face_start[face + 1];
    for (Index i = first + 1; i + 1 < end; ++i)
      shown.triangles.push_back({topology.origin[first], topology.origin[i], topology.origin[i + 1]});
  }
  shown.faces.assign(shown.triangles.size(), 0);
  return shown;
}

DisplayMesh hull_of(std::span<const Vec3> points) { return mesh_of(ConvexHull(points)); }

/// The hull of spheres around these points.
DisplayMesh rounded_mesh(std::span<const Vec3> core, double radius, int circles) {
  const std::vector<Vec3> ball = sphere_points(circles);
  std::vector<Vec3> points;
  for (const Vec3& corner : core)
    for (const Vec3& direction : ball) points.push_back(corner + radius * direction);
  DisplayMesh shown = hull_of(points);
  shown.smooth = true;
  return shown;
}

std::vector<Vec3> corners_of(const Box& box) {
  std::vector<Vec3> corners;
  for (int i = 0; i < 8; ++i) corners.push_back(box.corner(i));
  return corners;
}

std::vector<Vec3> corners_of(const Point& point) { return {point.position()}; }
std::vector<Vec3> corners_of(const Segment& segment) { return {segment.start(), segment.end()}; }
std::vector<Vec3> corners_of(const Triangle& triangle) { return {triangle.vertex.begin(), triangle.vertex.end()}; }
std::vector<Vec3> corners_of(const ConvexHull& hull) {
  std::vector<Vec3> corners;
  for (Index i = 0; i < hull.vertex_count(); ++i) corners.push_back(hull.vertex(i));
  return corners;
}

DisplayMesh mesh_of(const Rounded& shape, int circles) {
  constexpr std::size_t few = 16;
  constexpr int coarse = 6;
  const std::vector<Vec3> core = std::visit([](const auto& part) { return corners_of(part); }, shape.core());
  return rounded_mesh(core, shape.radius(), core.size() <= few ? circles : std::min(circles, coarse));
}

/// Between rings of radius 1 and of `top`, 0 or 1, around the z axis; sides and discs share no vertices, so that light
/// breaks at the rims.
DisplayMesh unit_sides(double top, int circles) {
  const auto around = static_cast<Index>(4 * circles);
  DisplayMesh shown;
  shown.smooth = true;
  for (const auto& [radius, height] : {std::pair{1.0, -1.0}, {top, 1.0}, {1.0, -1.0}, {top, 1.0}})
    for (Index i = 0; i < around; ++i) {
      const double angle = 2 * std::numbers::pi * i / around;
      shown.vertices.push_back({radius * std::cos(angle), radius * std::sin(angle), height});
    }
  for (Index i = 0; i < around; ++i) {
    const Index next = (i + 1) % around, base = 2 * around, lid = 3 * around;
    shown.triangles.push_back({i, next, around + i});
    if (top > 0) shown.triangles.push_back({next, around + next, around + i});
    if (i == 0 || next == 0) continue;
    shown.triangles.push_back({base, base + next, base + i});
    if (top > 0) shown.triangles.push_back({lid, lid + i, lid + next});
  }
  shown.faces.assign(shown.triangles.size(), 0);
  return shown;
}

DisplayMesh stretched(DisplayMesh shown, const Vec3& by) {
  for (Vec3& p : shown.vertices) p = {by.x * p.x, by.y * p.y, by.z * p.z};
  return shown;
}

/// The parts one after the other, with faces counted as answers count them.
DisplayMesh mesh_of_parts(const Model& model, int circles) {
  DisplayMesh whole;
  Index first_face = 0;
  const auto compound_parts = std::get<Compound>(model.shape()).parts();
  for (std::size_t i = 0; i < compound_parts.size(); ++i) {
    const Model& part_model = model.parts()[i];
    const DisplayMesh part = display_mesh(part_model, circles);
    const auto first_vertex = static_cast<Index>(whole.vertices.size());
    for (const Vec3& vertex : part.vertices) whole.vertices.push_back(transform(compound_parts[i].pose, vertex));
    for (const auto& [a, b, c] : part.triangles)
      whole.triangles.push_back({first_vertex + a, first_vertex + b, first_vertex + c});
    for (const Index face : part.faces) whole.faces.push_back(first_face + face);
    first_face += part_model.face_count();
  }
  return whole;
}

struct MeshOfShape {
  const Model& model;
  int circles;

  DisplayMesh operator()(const Point& shape) const { return {corners_of(shape), {}, {}, false}; }
  DisplayMesh operator()(const Segment& shape) const { return {corners_of(shape), {}, {}, false}; }
  DisplayMesh operator()(const Triangle& shape) const { return {corners_of(shape), {{0, 1, 2}}, {0}, false}; }
  DisplayMesh operator()(const HalfSpace& shape) const { return display_mesh(shape, shape.point(), 1); }
  DisplayMesh operator()(const Sphere& shape) const {
    const std::array<Vec3, 1> centre{shape.centre()};
    return rounded_mesh(centre, shape.radius(), circles);
  }
  DisplayMesh operator()(const Box& shape) const { return hull_of(corners_of(shape)); }
  DisplayMesh operator()(const Capsule& shape) const {
    const std::array<Vec3, 2> ends{shape.start(), shape.end()};
    return rounded_mesh(ends, shape.radius(), circles);
  }
  DisplayMesh operator()(const ConvexHull& shape) const { return mesh_of(shape); }
  DisplayMesh operator()(const Rounded& shape) const { return mesh_of(shape, circles); }
  template <QuadricShape S>
  DisplayMesh operator()(const S& shape) const {
    const PosedQuadric quadric(shape);
    return with_kind(quadric.kind(), [&]<class Kind>(Kind) {
      if constexpr (AxialKind<Kind>)
        return stretched(unit_sides(Kind::has_tip ? 0 : 1, circles), quadric.half());
      else
        return stretched(unit_sphere(circles), quadric.half());
    });
  }
  DisplayMesh operator()(const HeightField& shape) const { return mesh_of(*shape.mesh()); }
  DisplayMesh operator()(const std::shared_ptr<const TriangleMesh>& shape) const { return mesh_of(*shape); }
  DisplayMesh operator()(const Compound&) const { return mesh_of_parts(model, circles); }
};

Vec3 unit(const Vec3& v) {
  const double length = std::hypot(v.x, v.y, v.z);
  return {v.x / length, v.y / length, v.z / length};
}

}  // namespace

std::vector<Vec3> sphere_points(int circles) {
  std::vector<Vec3> points{{0, 0, 1}, {0, 0, -1}};
  for (int i = 1; i < circles; ++i) {
    const double latitude = std::numbers::pi * i / circles;
    const int around = 2 * circles;
    for (int j = 0; j < around; ++j) {
      const double longitude = std::numbers::pi * (2 * j + i % 2) / around;
      points.push_back(
          {std::sin(latitude) * std::cos(longitude), std::sin(latitude) * std::sin(longitude), std::cos(latitude)});
    }
  }
  return points;
}

DisplayMesh display_mesh(const Model& model, int circles) {
  return std::visit(MeshOfShape{model, circles}, model.shape());
}

DisplayMesh display_mesh(const HalfSpace& shape, const Vec3& centre, double half_side) {
  const Vec3 normal = unit(shape.normal());
  const Vec3 least = std::abs(normal.x) < 0.6 ? Vec3{1, 0, 0} : Vec3{0, 1, 0};
  const Vec3 along = unit(cross(normal, least)), across = cross(normal, along);
  const Vec3 middle = centre - dot(centre - shape.point(), normal) * normal;
  const Vec3 u = half_side * along, v = half_side * across;
  return {{middle - u - v, middle + u - v, middle + u + v, middle - u + v}, {{0, 1, 2}, {0, 2, 3}}, {0, 0}, false};
}

DisplayMesh unit_sphere(int circles) {
  const std::array<Vec3, 1> centre{};
  return rounded_mesh(centre, 1, circles);
}

DisplayMesh unit_box() { return hull_of(corners_of(Box({1, 1, 1}))); }

}  // namespace toccata::io
