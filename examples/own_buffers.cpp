// Meshes from buffers of your own, poses from quaternions, and what bad input gets told.
#include <toccata/toccata.hpp>

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <span>
#include <vector>

using namespace toccata;

namespace {

/// What a renderer has: floats with a stride, and 16-bit indices.
struct VertexOfRenderer {
  float position[3];
  float normal[3];
};

TriangleMesh mesh_from(std::span<const VertexOfRenderer> vertices, std::span<const std::uint16_t> indices) {
  return TriangleMesh::from_buffers({vertices[0].position, vertices.size(), sizeof(VertexOfRenderer)}, {indices});
}

template <class Try>
void tell(const char* what, const Try& attempt) {
  try {
    attempt();
    std::printf("%s: fine\n", what);
  } catch (const Error& error) {
    std::printf("%s: %s\n", what, error.what());
  }
}

}  // namespace

int main() {
  std::vector<VertexOfRenderer> vertices = {{{0, 0, 0}, {}}, {{1, 0, 0}, {}}, {{0, 1, 0}, {}}, {{0, 0, 1}, {}}};
  std::vector<std::uint16_t> indices = {0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3};
  const TriangleMesh mesh = mesh_from(vertices, indices);
  const MeshHealth health = inspect(mesh);
  std::printf("%zu triangles, %s\n", health.triangles, health.closed ? "closed" : "open");
  const Model tetrahedron(mesh);

  // A quaternion of floats is not quite of length 1: rotation_of divides by its length, in doubles.
  const Quaternion turn{0, 0, 0.70710677f, 0.70710677f};
  const Pose pose{rotation_of(turn), {5, 0, 0}};
  tell("a ball with that pose", [&] { (void)overlap(tetrahedron, Sphere(1), {.pose_b = pose}); });

  // The same in 16 numbers, column by column, as OpenGL and GLM have it.
  const float matrix[16] = {0, 1, 0, 0, -1, 0, 0, 0, 0, 0, 1, 0, 5, 0, 0, 1};
  const Pose same = Pose::from_numbers({matrix[0], matrix[4], matrix[8], matrix[1], matrix[5], matrix[9], matrix[2],
                                        matrix[6], matrix[10], matrix[12], matrix[13], matrix[14]});
  const Vec3 moved = transform(same, {1, 0, 0});
  std::printf("(1, 0, 0) comes to (%g, %g, %g)\n", moved.x, moved.y, moved.z);

  // Bad input is an Error that says what is wrong and what to do.
  indices[4] = 9;
  tell("an index too large", [&] { (void)mesh_from(vertices, indices); });
  indices[4] = 1;
  vertices[3].position[1] = std::nanf("");
  tell("a vertex that is no number", [&] { (void)mesh_from(vertices, indices); });
  tell("a ball without size", [] { (void)Sphere(0); });
  tell("a ball that is stretched", [] {
    (void)overlap(Sphere(1), Point{}, {.pose_a = {{{Vec3{2, 0, 0}, {0, 1, 0}, {0, 0, 1}}}, {}}});
  });
  const Model open(TriangleMesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}));
  tell("an open mesh as a solid", [&] { (void)overlap(open, tetrahedron, {.solid_a = Solid::all}); });
  tell("its depth", [&] { (void)penetration(open, tetrahedron); });
}
