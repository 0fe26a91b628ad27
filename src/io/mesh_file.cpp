#include "toccata/io/mesh_file.hpp"

#include <string>

#include "io/file_bytes.hpp"
#include "io/file_error.hpp"
#include "io/parse.hpp"
#include "toccata/core/error.hpp"

namespace toccata {
namespace io {
namespace {

TriangleMesh triangulated(const PolygonMesh& polygons, std::string_view name) {
  try {
    return triangulate(polygons);
  } catch (const Error& error) {
    throw Error(std::string(name) + ": " + error.what());
  }
}

}  // namespace

TriangleMesh parse_mesh(std::span<const char> bytes, std::string_view name, std::string_view extension) {
  if (extension == ".obj") return triangulated(parse_obj(bytes, name), name);
  fail_in_file(name, {"the format is not known", "use an OBJ, STL, PLY or OFF file with its usual extension"});
}

}  // namespace io

TriangleMesh read_mesh(const std::filesystem::path& path) {
  const io::FileBytes bytes = io::read_file(path);
  return io::parse_mesh(bytes.span(), path.string(), io::lower_case_extension(path));
}

}  // namespace toccata
