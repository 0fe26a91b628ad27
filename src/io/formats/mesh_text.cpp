#include "io/formats/mesh_text.hpp"

#include <fmt/format.h>

#include <cmath>
#include <iterator>

#include "math/vec3_measures.hpp"

namespace toccata::io {
namespace {

void append_vertices(std::string& text, const TriangleMesh& mesh, std::string_view prefix) {
  for (const Vec3& v : mesh.vertices()) fmt::format_to(std::back_inserter(text), "{}{} {} {}\n", prefix, v.x, v.y, v.z);
}

void append_triangles(std::string& text, const TriangleMesh& mesh, std::string_view prefix, std::size_t first_index) {
  for (const auto& [a, b, c] : mesh.triangles())
    fmt::format_to(std::back_inserter(text), "{}{} {} {}\n", prefix, a + first_index, b + first_index, c + first_index);
}

/// Close to the unit normal; zero where there is none, which readers take as "compute it yourself".
Vec3 displayed_normal(const Vec3& a, const Vec3& b, const Vec3& c) {
  // Halved first, and scaled before they are multiplied: neither step overflows.
  const Vec3 u = 0.5 * b - 0.5 * a, v = 0.5 * c - 0.5 * a;
  const double size_u = largest_magnitude(u), size_v = largest_magnitude(v);
  if (size_u == 0 || size_v == 0) return {};
  const auto over = [](const Vec3& w, double size) { return Vec3{w.x / size, w.y / size, w.z / size}; };
  const Vec3 normal = cross(over(u, size_u), over(v, size_v));
  const double length = std::sqrt(dot(normal, normal));
  return length > 0 ? over(normal, length) : Vec3{};
}

/// Line breaks and other control characters are no part of a name in a file of lines.
std::string line_safe(std::string name) {
  for (char& c : name)
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7F) c = '_';
  return name;
}

struct MeshCounts {
  std::size_t vertices = 0, triangles = 0;
};

MeshCounts counts_of(std::span<const WrittenMesh> meshes) {
  MeshCounts counts;
  for (const WrittenMesh& one : meshes) {
    counts.vertices += one.mesh->vertices().size();
    counts.triangles += one.mesh->triangles().size();
  }
  return counts;
}

/// All vertices and then all triangles, as one mesh.
void append_joined(std::string& text, std::span<const WrittenMesh> meshes) {
  for (const WrittenMesh& one : meshes) append_vertices(text, *one.mesh, "");
  std::size_t first = 0;
  for (const WrittenMesh& one : meshes) {
    append_triangles(text, *one.mesh, "3 ", first);
    first += one.mesh->vertices().size();
  }
}

void append_facets(std::string& text, const TriangleMesh& mesh) {
  for (const auto& triangle : mesh.triangles()) {
    const Vec3 &a = mesh.vertices()[triangle[0]], &b = mesh.vertices()[triangle[1]], &c = mesh.vertices()[triangle[2]];
    const Vec3 normal = displayed_normal(a, b, c);
    fmt::format_to(std::back_inserter(text), "facet normal {} {} {}\n outer loop\n", normal.x, normal.y, normal.z);
    for (const Vec3& v : {a, b, c}) fmt::format_to(std::back_inserter(text), "  vertex {} {} {}\n", v.x, v.y, v.z);
    text += " endloop\nendfacet\n";
  }
}

}  // namespace

std::string obj_text(std::span<const WrittenMesh> meshes) {
  std::string text;
  std::size_t first = 1;
  for (const WrittenMesh& one : meshes) {
    if (!one.name.empty()) text += "o " + line_safe(one.name) + "\n";
    append_vertices(text, *one.mesh, "v ");
    append_triangles(text, *one.mesh, "f ", first);
    first += one.mesh->vertices().size();
  }
  return text;
}

std::string obj_text(const TriangleMesh& mesh) {
  const WrittenMesh one{"", &mesh};
  return obj_text(std::span(&one, 1));
}

std::string off_text(std::span<const WrittenMesh> meshes) {
  const MeshCounts counts = counts_of(meshes);
  std::string text = fmt::format("OFF\n{} {} 0\n", counts.vertices, counts.triangles);
  append_joined(text, meshes);
  return text;
}

std::string ply_text(std::span<const WrittenMesh> meshes) {
  const MeshCounts counts = counts_of(meshes);
  std::string text = fmt::format(
      "ply\nformat ascii 1.0\n"
      "element vertex {}\nproperty double x\nproperty double y\nproperty double z\n"
      "element face {}\nproperty list uchar uint vertex_indices\nend_header\n",
      counts.vertices, counts.triangles);
  append_joined(text, meshes);
  return text;
}

std::string stl_text(std::span<const WrittenMesh> meshes) {
  std::string text;
  for (const WrittenMesh& one : meshes) {
    const std::string name = one.name.empty() ? "mesh" : line_safe(one.name);
    text += "solid " + name + "\n";
    append_facets(text, *one.mesh);
    text += "endsolid " + name + "\n";
  }
  return text;
}

}  // namespace toccata::io
