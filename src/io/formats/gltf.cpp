#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <map>
#include <memory>
#include <numeric>
#include <optional>
#include <utility>

#include "io/formats/gltf_data.hpp"
#include "io/formats/gltf_nodes.hpp"
#include "io/formats/json_value.hpp"
#include "io/scenes/scene_parts.hpp"
#include "toccata/core/error.hpp"
#include "toccata/math/pose.hpp"

// glTF 2.0 (Khronos Group, "glTF 2.0 Specification", 2021). Read over the JSON itself: everything in such a file may be
// wrong, so each number is checked where it is used, and nothing but shapes and poses is looked at.
namespace toccata::io {
namespace {

constexpr std::size_t largest_index = std::numeric_limits<Index>::max();

enum class Mode : std::size_t { triangles = 4, strip = 5, fan = 6 };

/// Corner k of triangle t. Every second triangle of a strip runs the other way round.
std::size_t corner_position(Mode mode, std::size_t t, std::size_t k) {
  if (mode == Mode::triangles) return 3 * t + k;
  if (mode == Mode::fan) return k == 0 ? 0 : t + k;
  return k == 0 ? t : t % 2 == 0 ? t + k : t + 3 - k;
}

class MeshReader {
 public:
  MeshReader(GltfData& data, const JsonValue& mesh) : data_(data), mesh_(mesh) {}

  /// Nothing when the mesh has no triangles: points and lines are no surfaces.
  std::shared_ptr<const TriangleMesh> read() {
    check_morphing();
    for (const JsonValue& primitive : mesh_.elements("primitives")) add(primitive);
    if (triangles_.empty()) return nullptr;
    try {
      return std::make_shared<const TriangleMesh>(std::move(vertices_), std::move(triangles_));
    } catch (const Error& error) {
      mesh_.fail(error.what(), "export the file again");
    }
  }

 private:
  void check_morphing() const {
    for (const JsonValue& weight : mesh_.elements("weights"))
      if (weight.number() != 0)
        weight.fail("the mesh is morphed, which Toccata does not read", "export it with its shape applied");
  }

  [[nodiscard]] std::size_t accessor(const JsonValue& reference) const {
    return index_of(reference, data_.accessor_count(), "accessor");
  }

  void add(const JsonValue& primitive) {
    const std::size_t mode = primitive.whole_or("mode", 6, 4);
    if (mode < 4 || !primitive.has("attributes") || !primitive.at("attributes").has("POSITION")) return;
    const Vertices vertices = vertices_of(primitive.at("attributes").at("POSITION"));
    const std::vector<Index> corners = corners_of(primitive, vertices.count);
    for (const Index corner : corners)
      if (corner >= vertices.count)
        primitive.fail(fmt::format("index {} is out of range: there are {} positions", corner, vertices.count),
                       "the file is broken; export it again");
    add_triangles(primitive, static_cast<Mode>(mode), corners, vertices.first);
  }

  /// Primitives may share their accessors, and a mesh of many such must not outgrow its file: corners count as read.
  [[nodiscard]] std::vector<Index> corners_of(const JsonValue& primitive, Index vertex_count) {
    std::vector<Index> corners;
    if (primitive.has("indices")) {
      corners = data_.indices(accessor(primitive.at("indices")));
      data_.spend(primitive, corners.size());
    } else {
      data_.spend(primitive, vertex_count);
      corners.resize(vertex_count);
      std::iota(corners.begin(), corners.end(), Index{0});
    }
    return corners;
  }

  void add_triangles(const JsonValue& primitive, Mode mode, const std::vector<Index>& corners, Index first) {
    if (mode == Mode::triangles ? corners.size() % 3 != 0 : corners.size() < 3)
      primitive.fail(fmt::format("{} corners make no whole triangles", corners.size()), "export the file again");
    const std::size_t count = mode == Mode::triangles ? corners.size() / 3 : corners.size() - 2;
    for (std::size_t t = 0; t < count; ++t) {
      std::array<Index, 3> triangle{};
      for (std::size_t k = 0; k < 3; ++k) triangle[k] = first + corners[corner_position(mode, t, k)];
      triangles_.push_back(triangle);
    }
  }

  /// Positions of an accessor among the mesh's vertices; primitives often share them.
  struct Vertices {
    Index first;
    Index count;
  };

  Vertices vertices_of(const JsonValue& reference) {
    const std::size_t index = accessor(reference);
    if (const auto found = known_.find(index); found != known_.end()) return found->second;
    const std::vector<Vec3> positions = data_.vectors(index);
    if (positions.size() + vertices_.size() > largest_index) reference.fail("too many vertices", "split the mesh");
    const Vertices added{static_cast<Index>(vertices_.size()), static_cast<Index>(positions.size())};
    vertices_.insert(vertices_.end(), positions.begin(), positions.end());
    return known_.emplace(index, added).first->second;
  }

  GltfData& data_;
  const JsonValue& mesh_;
  std::vector<Vec3> vertices_;
  std::vector<std::array<Index, 3>> triangles_;
  std::map<std::size_t, Vertices> known_;
};

class SceneReader {
 public:
  SceneReader(const JsonValue& top, GltfData& data)
      : top_(top),
        data_(data),
        nodes_(top.elements("nodes")),
        meshes_(top.elements("meshes")),
        read_meshes_(meshes_.size()),
        visited_(nodes_.size(), 0) {}

  Scene read() {
    std::vector<Visit> open;
    const std::vector<std::size_t> roots = root_nodes();
    for (auto root = roots.rbegin(); root != roots.rend(); ++root) open.push_back({*root, std::nullopt});
    while (!open.empty()) {
      const Visit visit = open.back();
      open.pop_back();
      const Index node = add_node(visit);
      const std::vector<JsonValue> children = nodes_[visit.node].elements("children");
      for (auto child = children.rbegin(); child != children.rend(); ++child)
        open.push_back({node_index(*child), node});
    }
    if (scene_.objects.empty()) top_.fail("the file shows no triangles", "export it with its meshes");
    return std::move(scene_);
  }

 private:
  struct Visit {
    std::size_t node;
    std::optional<Index> parent;
  };

  [[nodiscard]] std::size_t node_index(const JsonValue& reference) const {
    return index_of(reference, nodes_.size(), "node");
  }

  /// The root nodes of the scene that the file shows first; those among all nodes, when it has no scenes.
  [[nodiscard]] std::vector<std::size_t> root_nodes() const {
    std::vector<std::size_t> roots;
    const std::vector<JsonValue> scenes = top_.elements("scenes");
    if (scenes.empty()) {
      std::vector<char> is_child(nodes_.size(), 0);
      for (const JsonValue& node : nodes_)
        for (const JsonValue& child : node.elements("children")) is_child[node_index(child)] = 1;
      for (std::size_t i = 0; i < nodes_.size(); ++i)
        if (is_child[i] == 0) roots.push_back(i);
      return roots;
    }
    const std::size_t shown = top_.whole_or("scene", largest_index, 0);
    if (shown >= scenes.size()) top_.at("scene").fail("there is no such scene", "export the file again");
    for (const JsonValue& root : scenes[shown].elements("nodes")) roots.push_back(node_index(root));
    return roots;
  }

  Index add_node(const Visit& visit) {
    const JsonValue& json = nodes_[visit.node];
    if (std::exchange(visited_[visit.node], char{1}) != 0)
      json.fail("the node has two parents, or is its own ancestor", "nodes must form a tree; export the file again");
    check_supported(json);
    SceneNode node{json.text_or("name", fmt::format("node {}", visit.node)), visit.parent, pose_of_node(json)};
    world_.push_back(node.parent ? world_[*node.parent] * node.pose : node.pose);
    const Index index = static_cast<Index>(scene_.nodes.size());
    scene_.nodes.push_back(std::move(node));
    if (json.has("mesh")) add_object(json, index);
    return index;
  }

  static void check_supported(const JsonValue& node) {
    if (node.has("skin") && node.has("mesh"))
      node.fail("the mesh is bent by a skeleton, which Toccata does not read", "export it with its pose applied");
    if (node.has("extensions") && node.at("extensions").has("EXT_mesh_gpu_instancing"))
      node.fail("the mesh is repeated by EXT_mesh_gpu_instancing, which Toccata does not read", "export plain nodes");
    for (const JsonValue& weight : node.elements("weights"))
      if (weight.number() != 0)
        weight.fail("the mesh is morphed, which Toccata does not read", "export it with its shape applied");
  }

  void add_object(const JsonValue& json, Index node) {
    const std::size_t index = index_of(json.at("mesh"), meshes_.size(), "mesh");
    if (!read_meshes_[index]) read_meshes_[index] = MeshReader(data_, meshes_[index]).read();
    if (*read_meshes_[index] == nullptr) return;
    SceneObject object;
    object.name = names_.make(json.text_or("name", meshes_[index].text_or("name", scene_.nodes[node].name)));
    object.shape = *read_meshes_[index];
    object.pose = world_[node];
    object.node = node;
    if (!is_finite(object.pose))
      json.fail("the pose is not finite once its parents are applied", "use smaller numbers");
    scene_.objects.push_back(std::move(object));
  }

  const JsonValue& top_;
  GltfData& data_;
  std::vector<JsonValue> nodes_, meshes_;
  std::vector<std::optional<std::shared_ptr<const TriangleMesh>>> read_meshes_;
  std::vector<char> visited_;
  Scene scene_;              ///< in metres, as its unit says by itself
  std::vector<Pose> world_;  ///< of scene_.nodes
  UniqueNames names_;
};

}  // namespace

Scene parse_gltf(const SceneBytes& source) {
  const GltfChunks chunks = split_glb(source);
  const nlohmann::json document = parse_json(chunks.text, source.file, RepeatedKeys::last_counts);
  const JsonValue top(document, source.file);
  check_gltf_header(top);
  GltfData data(top, source, chunks);
  Scene scene = SceneReader(top, data).read();
  for (SceneObject& object : scene.objects) object.source = source.file;
  return scene;
}

}  // namespace toccata::io
