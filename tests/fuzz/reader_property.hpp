#pragma once

#include <algorithm>
#include <set>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "io/formats/mesh_text.hpp"
#include "io/formats/parse.hpp"
#include "io/formats/parse_poses.hpp"
#include "io/scenes/scene_parts.hpp"
#include "toccata/core/error.hpp"

namespace toccata::fuzz {

inline void require(bool holds, const char* what) {
  if (!holds) throw std::logic_error(what);
}

inline void require_valid(const PolygonMesh& mesh) {
  require(std::ranges::all_of(mesh.vertices, [](const Vec3& vertex) { return is_finite(vertex); }),
          "a vertex is not finite");
  require(std::ranges::all_of(mesh.corners, [&](Index corner) { return corner < mesh.vertices.size(); }),
          "a corner is out of range");
  require(mesh.first.size() > 1, "there is no face");
  require(mesh.first.front() == 0 && mesh.first.back() == mesh.corners.size(), "the faces are not the corners");
  for (std::size_t face = 1; face < mesh.first.size(); ++face)
    require(mesh.first[face] >= mesh.first[face - 1] + 3, "a face has fewer than three corners");
}

/// Constructing it validated what require_valid does. Here: what is written is read as the same mesh.
inline void require_valid(const TriangleMesh& mesh) {
  const std::string text = io::obj_text(mesh);
  const PolygonMesh again = io::parse_obj(text, "again.obj");
  require(std::ranges::equal(again.vertices, mesh.vertices()), "vertices change when written and read");
  require(again.corners.size() == 3 * mesh.triangles().size(), "triangles change when written and read");
}

/// Every object has a name of its own and a finite pose, and its mesh is valid.
inline void require_valid(const Scene& scene) {
  std::set<std::string> names;
  require(!scene.objects.empty(), "there is no object");
  for (const SceneObject& object : scene.objects) {
    require(names.insert(object.name).second, "two objects have the same name");
    require(is_finite(object.pose), "an object is nowhere");
    if (const auto mesh = object.mesh()) require_valid(*mesh);
  }
}

/// There is a query, and every pose is finite.
inline void require_valid(const std::vector<PairQuery>& queries) {
  require(!queries.empty(), "there is no query");
  for (const PairQuery& query : queries)
    require(is_finite(query.pose_a) && is_finite(query.pose_b), "a pose is not finite");
}

/// A reader gives a valid mesh, scene or list of poses for any bytes, or an Error in one line that names the file.
template <typename Parse>
void check_reader(Parse parse, std::span<const char> bytes) {
  try {
    require_valid(parse(bytes, "input"));
  } catch (const Error& error) {
    const std::string_view message = error.what();
    require(message.starts_with("input:"), "a message does not begin with the name of the file");
    require(message.find("; ") != std::string_view::npos, "a message does not say what to do");
    require(message.find('\n') == std::string_view::npos, "a message is longer than a line");
  }
}

/// As read_mesh does, whatever the format.
inline TriangleMesh parse_any(std::span<const char> bytes, std::string_view name) {
  return io::parse_mesh(bytes, name, ".obj");
}

}  // namespace toccata::fuzz
