#pragma once

#include <string>
#include <utility>
#include <vector>

#include "oracle/test_meshes.hpp"
#include "support/mesh_soups.hpp"
#include "support/voxel_solids.hpp"
#include "toccata/core/random.hpp"
#include "toccata/generate/meshes.hpp"
#include "toccata/query/model.hpp"

namespace toccata::test {

struct NamedMesh {
  std::string name;
  TriangleMesh mesh;
};

inline TriangleMesh moved(const TriangleMesh& mesh, const Vec3& by) {
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
  meshes.push_back({"far", moved(generated("gen:icosphere?subdivisions=1"), {1e9, -1e9, 3})});
  Random voxel_random(1);
  meshes.push_back({"a grid of voxels",
                    mesh_of({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {1, 1, 1}, {3, 0, 0}}, Skin::outer, voxel_random)});
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

}  // namespace toccata::test
