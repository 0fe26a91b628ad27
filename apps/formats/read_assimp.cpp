// Writes a scene file of what a file of one of Assimp's formats holds: its tree of nodes, each mesh once however often
// it is placed.
//
// usage: toccata-read-assimp FILE SCENE.json
//
// What is to be told about the reading goes to standard output, a line each; why it failed, to standard error.
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <assimp/Importer.hpp>
#include <cctype>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "scene_parts.hpp"

namespace {

using toccata::formats::base64_of;
using toccata::formats::PartNames;
using Json = nlohmann::json;

std::array<double, 12> numbers_of(const aiMatrix4x4& m) {
  return {m.a1, m.a2, m.a3, m.b1, m.b2, m.b3, m.c1, m.c2, m.c3, m.a4, m.b4, m.c4};
}

/// Corners that Assimp keeps apart for the sake of normals and colours, and that are one point, are one vertex.
Json json_of(const aiMesh& mesh) {
  std::vector<double> vertices;
  std::vector<std::uint32_t> triangles, vertex_of(mesh.mNumVertices);
  std::map<std::array<float, 3>, std::uint32_t> known;
  for (unsigned i = 0; i < mesh.mNumVertices; ++i) {
    const aiVector3D& at = mesh.mVertices[i];
    if (!std::isfinite(at.x) || !std::isfinite(at.y) || !std::isfinite(at.z))
      throw std::runtime_error(
          fmt::format("vertex {} of the mesh {} is no number; export it again", i, mesh.mName.C_Str()));
    const auto number = static_cast<std::uint32_t>(vertices.size() / 3);
    const auto [found, is_new] = known.try_emplace({at.x + 0.0F, at.y + 0.0F, at.z + 0.0F}, number);
    if (is_new) vertices.insert(vertices.end(), {at.x, at.y, at.z});
    vertex_of[i] = found->second;
  }
  for (const aiFace& face : std::span(mesh.mFaces, mesh.mNumFaces))
    for (unsigned i = 0; i < 3; ++i) triangles.push_back(vertex_of.at(face.mIndices[i]));
  return {{"vertices", base64_of(vertices)}, {"triangles", base64_of(triangles)}};
}

/// The name in UTF-8. Bytes that are none are shown as numbers, so that names that differ stay different.
std::string text_of(const aiString& name) {
  const std::string bytes(name.C_Str(), name.length);
  try {
    static_cast<void>(Json(bytes).dump());
    return bytes;
  } catch (const Json::type_error&) {
    std::string text;
    for (const char c : bytes)
      text += static_cast<unsigned char>(c) < 0x80 ? std::string(1, c)
                                                   : fmt::format("\\x{:02X}", static_cast<unsigned char>(c));
    return text;
  }
}

bool has_triangles(const aiMesh& mesh) {
  return mesh.mNumFaces > 0 && (mesh.mPrimitiveTypes & unsigned{aiPrimitiveType_TRIANGLE}) != 0;
}

/// Walks the nodes, and writes what it meets.
class SceneOfNodes {
 public:
  SceneOfNodes(const aiScene& scene, std::string source) : scene_(scene), source_(std::move(source)) {}

  void add_all() {
    if (scene_.mRootNode != nullptr) add(*scene_.mRootNode, "", "", 0);
    if (objects_.empty()) throw std::runtime_error("there is no mesh of triangles in it; export it with its geometry");
  }

  [[nodiscard]] Json json(const Json& unit) const {
    return {{"format", "toccata-scene"}, {"version", 1},        {"unit", unit},
            {"frames", frames_},         {"objects", objects_}, {"meshes", meshes_}};
  }

  [[nodiscard]] std::vector<std::string> notes() const {
    std::vector<std::string> notes{fmt::format(
        "{} of {} as Assimp reads them, with numbers of 32 bits: what overlaps or is apart by less than 1e-7 of its "
        "distance from the origin may be otherwise in the file",
        objects_.size() == 1 ? "1 part" : fmt::format("{} parts", objects_.size()),
        meshes_.size() == 1 ? "1 shape" : fmt::format("{} shapes", meshes_.size()))};
    if (scene_.mNumAnimations > 0) notes.emplace_back("it has animations, which are left out: parts are as they rest");
    const auto bends = [](const aiMesh* mesh) { return mesh->HasBones(); };
    if (const auto all = std::span(scene_.mMeshes, scene_.mNumMeshes); std::any_of(all.begin(), all.end(), bends))
      notes.emplace_back("meshes that bones bend are taken as they are drawn, unbent");
    return notes;
  }

 private:
  /// `path` is what its parts are called: the names from the root down, whose own tells nothing.
  void add(const aiNode& node, const std::string& path, const std::string& parent, int depth) {
    constexpr int deepest = 500;
    if (depth > deepest) throw std::runtime_error(fmt::format("its nodes are nested more than {} deep", deepest));
    const std::string frame = names_.take(path + "/");
    frames_.push_back({{"name", frame}, {"pose", numbers_of(node.mTransformation)}});
    if (!parent.empty()) frames_.back()["parent"] = parent;
    for (const unsigned number : std::span(node.mMeshes, node.mNumMeshes))
      add_part(*scene_.mMeshes[number], number, frame, node.mNumMeshes > 1 || path.empty() ? path + "/" : path);
    for (const aiNode* child : std::span(node.mChildren, node.mNumChildren)) {
      const std::string name = child->mName.length == 0 ? "part" : text_of(child->mName);
      add(*child, path.empty() ? name : path + "/" + name, frame, depth + 1);
    }
  }

  /// A path that ends with a slash has the mesh's own name behind.
  void add_part(const aiMesh& mesh, unsigned number, const std::string& frame, const std::string& path) {
    if (!has_triangles(mesh)) return;
    const std::string own = mesh.mName.length == 0 ? "part" : text_of(mesh.mName);
    const std::string name = path == "/" ? own : path.ends_with('/') ? path + own : path;
    const std::string shape = fmt::format("{} ({})", own, number);
    if (!meshes_.contains(shape)) meshes_[shape] = json_of(mesh);
    objects_.push_back({{"name", names_.take(name)}, {"parent", frame}, {"mesh", shape}, {"source", source_}});
  }

  const aiScene& scene_;
  std::string source_;
  Json frames_ = Json::array(), objects_ = Json::array(), meshes_ = Json::object();
  PartNames names_;
};

/// The unit as a scene file has it. Assimp makes metres of Collada, and gives the centimetres of an FBX file's unit,
/// rounded to a float. Nothing is known about the other formats.
Json unit_of(const aiScene& scene, const std::string& file) {
  std::string extension = std::filesystem::path(file).extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  if (extension == ".dae") return "m";
  if (extension != ".fbx") return "unit";
  double centimetres = 1;
  float single = 1;
  if (scene.mMetaData != nullptr) {
    if (!scene.mMetaData->Get("UnitScaleFactor", centimetres) && scene.mMetaData->Get("UnitScaleFactor", single))
      centimetres = std::stod(fmt::format("{}", single));  // 2.54, and not the float nearest to it
  }
  if (!(centimetres > 0) || !std::isfinite(centimetres))
    throw std::runtime_error("the length of its unit is no number above 0; export it again");
  if (centimetres == 1) return "cm";
  return centimetres == 100 ? Json("m") : Json(centimetres / 100);
}

void convert(const std::string& file, const std::string& scene_file) {
  Assimp::Importer importer;
  importer.SetPropertyBool(AI_CONFIG_IMPORT_COLLADA_IGNORE_UP_DIRECTION, true);  // as all other formats are taken
  importer.SetPropertyBool(AI_CONFIG_IMPORT_FBX_PRESERVE_PIVOTS, false);         // which would be nodes with names
  importer.SetPropertyInteger(AI_CONFIG_PP_SBP_REMOVE, int{aiPrimitiveType_POINT} | int{aiPrimitiveType_LINE});
  const aiScene* scene = importer.ReadFile(file, unsigned{aiProcess_Triangulate} | unsigned{aiProcess_SortByPType});
  if (scene == nullptr) throw std::runtime_error(fmt::format("{}; export it again", importer.GetErrorString()));
  if ((scene->mFlags & unsigned{AI_SCENE_FLAGS_INCOMPLETE}) != 0)
    throw std::runtime_error("it holds no whole scene; export it again with its geometry");
  SceneOfNodes nodes(*scene, file);
  nodes.add_all();
  std::ofstream out(scene_file, std::ios::binary);
  out << nodes.json(unit_of(*scene, file)).dump(-1, ' ', false, Json::error_handler_t::replace) << "\n";
  if (!out.flush()) throw std::runtime_error(scene_file + " cannot be written; is the disk full?");
  for (const std::string& note : nodes.notes()) fmt::print("{}\n", note);
}

}  // namespace

int main(int argc, char** argv) {
  try {
    if (argc != 3) throw std::runtime_error("usage: toccata-read-assimp FILE SCENE.json");
    convert(argv[1], argv[2]);
    return 0;
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}\n", error.what());
  }
  return 2;
}
