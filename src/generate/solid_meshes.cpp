#include <algorithm>
#include <array>
#include <limits>
#include <utility>
#include <vector>

#include "generate/mesh_building.hpp"
#include "generate/subdivided_sphere.hpp"
#include "toccata/generate/meshes.hpp"
#include "toccata/math/trigonometry.hpp"

namespace toccata {
namespace {

constexpr double least_solid_length = std::numeric_limits<double>::denorm_min();
constexpr double greatest_solid_length = 1e300;

}  // namespace

TriangleMesh box_mesh(const Vec3& half, const Vec3& centre) {
  for (int axis = 0; axis < 3; ++axis)
    require_range("a half extent", half[axis], least_solid_length, greatest_solid_length);
  PolygonMesh mesh;
  for (int corner = 0; corner < 8; ++corner)
    mesh.vertices.push_back(
        centre + Vec3{corner & 1 ? half.x : -half.x, corner & 2 ? half.y : -half.y, corner & 4 ? half.z : -half.z});
  for (const auto& face : std::array<std::array<Index, 4>, 6>{
           {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}}})
    add_face(mesh, {face[0], face[1], face[2], face[3]});
  return triangulate(mesh);
}

TriangleMesh tetrahedron_mesh(double half_edge) {
  require_range("the half edge", half_edge, least_solid_length, greatest_solid_length);
  const double h = half_edge;
  return {{{h, h, h}, {h, -h, -h}, {-h, h, -h}, {-h, -h, h}}, {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}}};
}

TriangleMesh icosphere_mesh(double radius, int subdivisions) {
  require_range("the radius", radius, least_solid_length, greatest_solid_length);
  SubdividedSphere sphere = subdivided_sphere(subdivisions);
  for (Vec3& v : sphere.directions) v = radius * v;
  return {std::move(sphere.directions), std::move(sphere.triangles)};
}

TriangleMesh uv_sphere_mesh(double radius, int around, int along) {
  require_range("the radius", radius, least_solid_length, greatest_solid_length);
  require_range("the number of meridians", around, 3, 10000);
  require_range("the number of steps from pole to pole", along, 2, 10000);
  PolygonMesh mesh;
  for (int ring = 1; ring < along; ++ring) {
    const SineCosine latitude = sine_cosine_of_turns(0.5 * ring / along);
    for (int i = 0; i < around; ++i) {
      const SineCosine longitude = sine_cosine_of_turns(static_cast<double>(i) / around);
      mesh.vertices.push_back(radius *
                              Vec3{latitude.sine * longitude.cosine, latitude.sine * longitude.sine, latitude.cosine});
    }
  }
  const auto at = [&](int ring, int i) { return static_cast<Index>((ring - 1) * around + i % around); };
  const Index north = static_cast<Index>(mesh.vertices.size()), south = north + 1;
  mesh.vertices.insert(mesh.vertices.end(), {{0, 0, radius}, {0, 0, -radius}});
  for (int i = 0; i < around; ++i) {
    add_face(mesh, {north, at(1, i), at(1, i + 1)});
    for (int ring = 1; ring + 1 < along; ++ring)
      add_face(mesh, {at(ring, i), at(ring + 1, i), at(ring + 1, i + 1), at(ring, i + 1)});
    add_face(mesh, {at(along - 1, i), south, at(along - 1, i + 1)});
  }
  return triangulate(mesh);
}

TriangleMesh extruded_mesh(std::span<const Vec2> outline, double height) {
  require_range("the height", height, least_solid_length, greatest_solid_length);
  const Index n = static_cast<Index>(outline.size());
  PolygonMesh mesh;
  std::vector<Index> floor, roof;
  for (const double z : {0.0, height})
    for (const Vec2& p : outline) mesh.vertices.push_back({p.x, p.y, z});
  for (Index i = 0; i < n; ++i) {
    floor.push_back(n - 1 - i);
    roof.push_back(n + i);
    add_face(mesh, {i, (i + 1) % n, n + (i + 1) % n, n + i});
  }
  add_face(mesh, floor);
  add_face(mesh, roof);
  return triangulate(mesh);
}

TriangleMesh prism_mesh(double radius, double height, int sides) {
  require_range("the radius", radius, least_solid_length, greatest_solid_length);
  require_range("the number of sides", sides, 3, 100000);
  std::vector<Vec2> outline;
  for (int i = 0; i < sides; ++i) {
    const SineCosine angle = sine_cosine_of_turns(static_cast<double>(i) / sides);
    outline.push_back({radius * angle.cosine, radius * angle.sine});
  }
  return extruded_mesh(outline, height);
}

TriangleMesh gear_mesh(const GearShape& shape) {
  require_range("the number of teeth", shape.teeth, 3, 10000);
  require_range("the root radius", shape.root_radius, least_solid_length, greatest_solid_length);
  require_range("the tip radius", shape.tip_radius, shape.root_radius, greatest_solid_length);
  require_range("the share of a tooth at its root", shape.tooth_root, 0.01, 0.99);
  require_range("the share of a tooth at its tip", shape.tooth_tip, 0.01, 0.99);
  std::vector<Vec2> outline;
  const auto add = [&](double radius, double pitches) {
    const SineCosine angle = sine_cosine_of_turns(pitches / shape.teeth);
    outline.push_back({radius * angle.cosine, radius * angle.sine});
  };
  for (int tooth = 0; tooth < shape.teeth; ++tooth) {
    add(shape.root_radius, tooth - 0.5 * shape.tooth_root);
    add(shape.tip_radius, tooth - 0.5 * shape.tooth_tip);
    add(shape.tip_radius, tooth + 0.5 * shape.tooth_tip);
    add(shape.root_radius, tooth + 0.5 * shape.tooth_root);
  }
  return extruded_mesh(outline, shape.height);
}

}  // namespace toccata
