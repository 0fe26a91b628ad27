#include "toccata/io/model_file.hpp"

#include <string>
#include <utility>
#include <vector>

#include "io/formats/file_bytes.hpp"
#include "io/formats/file_error.hpp"
#include "io/formats/mesh_text.hpp"
#include "io/formats/parse.hpp"
#include "shapes/triangulated.hpp"
#include "toccata/core/error.hpp"

namespace toccata {
namespace io {
namespace {

constexpr const char* formats_advice = "use an OBJ, STL, PLY or OFF file with its usual extension";

TriangleMesh triangulated(PolygonMesh polygons, std::string_view name) {
  try {
    return toccata::triangulated(std::move(polygons));
  } catch (const Error& error) {
    throw Error(std::string(name) + ": " + error.what());
  }
}

}  // namespace

namespace {

/// Which reader takes the bytes: by the content, else by the extension. Text STL and binary have one.
enum class MeshFormat { obj, stl, ply, off };

MeshFormat format_of(std::span<const char> bytes, std::string_view name, std::string_view extension) {
  if (looks_like_ply(bytes)) return MeshFormat::ply;
  if (looks_like_off(bytes)) return MeshFormat::off;
  if (looks_like_stl(bytes)) return MeshFormat::stl;
  if (extension == ".obj") return MeshFormat::obj;
  if (extension == ".stl") return MeshFormat::stl;
  if (extension == ".ply") return MeshFormat::ply;
  if (extension == ".off") return MeshFormat::off;
  if (extension.empty()) fail_in_file(name, {"the format cannot be told without an extension", formats_advice});
  if (extension == ".gltf" || extension == ".glb" || extension == ".json")
    fail_in_file(name, {"this is a scene of posed objects, not one mesh", "read it with read_scene"});
  fail_in_file(name, {"the format " + in_quotes(extension) + " is not read as a mesh", formats_advice});
}

}  // namespace

TriangleMesh parse_mesh(std::span<const char> bytes, std::string_view name, std::string_view extension) {
  switch (format_of(bytes, name, extension)) {
    case MeshFormat::obj:
      return triangulated(parse_obj(bytes, name), name);
    case MeshFormat::ply:
      return triangulated(parse_ply(bytes, name), name);
    case MeshFormat::off:
      return triangulated(parse_off(bytes, name), name);
    case MeshFormat::stl:
      break;
  }
  return parse_stl(bytes, name);
}

std::vector<NamedMesh> parse_mesh_parts(std::span<const char> bytes, std::string_view name,
                                        std::string_view extension) {
  const MeshFormat format = format_of(bytes, name, extension);
  if (format == MeshFormat::stl) return parse_stl_solids(bytes, name);
  std::vector<NamedMesh> parts;
  if (format == MeshFormat::obj)
    for (NamedPolygons& part : parse_obj_parts(bytes, name))
      parts.push_back({std::move(part.name), triangulated(std::move(part.mesh), name)});
  else
    parts.push_back({"", parse_mesh(bytes, name, extension)});
  return parts;
}

void write_mesh_file(std::span<const WrittenMesh> meshes, const std::string& path) {
  const std::string extension = lower_case_extension(path);
  if (extension == ".obj") return write_file(path, obj_text(meshes));
  if (extension == ".off") return write_file(path, off_text(meshes));
  if (extension == ".ply") return write_file(path, ply_text(meshes));
  if (extension == ".stl") return write_file(path, stl_text(meshes));
  fail_in_file(path, {"the extension names no format that is written", "use .obj, .off, .ply or .stl"});
}

}  // namespace io

TriangleMesh read_mesh(const std::string& path) {
  const io::FileBytes bytes = io::read_file(path);
  return io::parse_mesh(bytes.span(), path, io::lower_case_extension(path));
}

void write_mesh(const TriangleMesh& mesh, const std::string& path) {
  const io::WrittenMesh one{"", &mesh};
  io::write_mesh_file(std::span(&one, 1), path);
}

}  // namespace toccata
