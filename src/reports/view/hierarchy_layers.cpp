#include "reports/view/hierarchy_layers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "io/formats/utf8.hpp"
#include "reports/view/drawn_hierarchy.hpp"

namespace toccata::io {
namespace {

/// Points as floats from 0 to 1 of the greatest extent of the mesh's box.
struct MeshFrame {
  Vec3 lower;
  double size = 1;

  explicit MeshFrame(const Aabb& box) : lower(box.lower) {
    const Vec3 extent = box.upper - box.lower;
    const double greatest = std::max({extent.x, extent.y, extent.z});
    if (greatest > 0) size = greatest;
  }

  void append(std::vector<float>& numbers, const Vec3& point) const {
    for (int axis = 0; axis < 3; ++axis) numbers.push_back(static_cast<float>((point[axis] - lower[axis]) / size));
  }
};

Json written(const std::vector<std::array<Vec3, 3>>& faces, const MeshFrame& frame, ViewData& data) {
  std::vector<float> numbers;
  numbers.reserve(faces.size() * 9);
  for (const auto& face : faces)
    for (const Vec3& corner : face) frame.append(numbers, corner);
  return data.add(numbers);
}

Json written(const std::vector<std::array<Index, 2>>& runs, ViewData& data) {
  std::vector<std::uint32_t> numbers;
  for (const auto& run : runs) numbers.insert(numbers.end(), run.begin(), run.end());
  return data.add(std::span<const std::uint32_t>(numbers));
}

Json written(const std::vector<RoundVolume>& rounds, const MeshFrame& frame, ViewData& data) {
  std::vector<float> numbers;
  numbers.reserve(rounds.size() * 18);
  for (const RoundVolume& round : rounds) {
    frame.append(numbers, round.centre);
    for (const Vec3& way : {round.core[0], round.core[1], round.axis[0], round.axis[1], round.axis[2]})
      for (int i = 0; i < 3; ++i) numbers.push_back(static_cast<float>(way[i] / frame.size));
  }
  return data.add(numbers);
}

Json written(const std::vector<std::uint8_t>& numbers, ViewData& data) {
  const std::vector<std::uint16_t> shorts(numbers.begin(), numbers.end());
  return data.add(std::span<const std::uint16_t>(shorts));
}

std::string note_of(const DrawnLevel& level) {
  const std::size_t pairs = level.nodes * (level.nodes - 1) / 2;
  return fmt::format("{} volume{}, {:.0f} % filled by the hulls of what they hold; {} of {} pair{} overlap",
                     level.nodes, level.nodes == 1 ? "" : "s", 100 * level.fill, level.overlapping_pairs, pairs,
                     pairs == 1 ? "" : "s");
}

Json steps_of(const DrawnHierarchy& hierarchy) {
  Json steps = Json::array();
  for (std::size_t i = 0; i < hierarchy.levels.size(); ++i) {
    const DrawnLevel& level = hierarchy.levels[i];
    steps.push_back({{"label", fmt::format("level {}", i)},
                     {"note", note_of(level)},
                     {"first", level.first_node},
                     {"count", level.nodes},
                     {"faces", {level.first_face, hierarchy.rounds.empty() ? level.faces : 0}},
                     {"fill", level.fill},
                     {"overlapping_pairs", level.overlapping_pairs}});
  }
  return steps;
}

Json layer_of(const Model& model, const DrawnHierarchy& hierarchy, ViewData& data) {
  const MeshFrame frame(model.bounds());
  const auto numbers = [&](const std::vector<Index>& all) { return data.add(std::span<const std::uint32_t>(all)); };
  Json layer = {{"kind", "hierarchy"},
                {"role", "hierarchy"},
                {"data", written(hierarchy.runs, data)},
                {"order", numbers(hierarchy.order)},
                {"lower", {frame.lower.x, frame.lower.y, frame.lower.z}},
                {"size", frame.size},
                {"steps", steps_of(hierarchy)}};
  if (!hierarchy.rounds.empty()) {
    layer["rounds"] = written(hierarchy.rounds, frame, data);
    return layer;
  }
  layer["faces"] = written(hierarchy.faces, frame, data);
  layer["node_of_face"] = numbers(hierarchy.node_of_face);
  layer["edges_of_face"] = written(hierarchy.edges_of_face, data);
  return layer;
}

}  // namespace

std::vector<Json> hierarchy_layers(std::span<const SceneInstance> models, CostVolume volume, ViewData& data) {
  const std::map<const TriangleMesh*, DrawnHierarchy> hierarchies = drawn_hierarchies(models, volume);
  std::map<const TriangleMesh*, Json> layer_of_mesh;
  std::vector<Json> layers;
  for (std::size_t i = 0; i < models.size(); ++i) {
    if (!models[i].model.has_mesh()) continue;
    const auto [found, is_new] = layer_of_mesh.try_emplace(&models[i].model.mesh());
    if (is_new) found->second = layer_of(models[i].model, hierarchies.at(found->first), data);
    Json& layer = layers.emplace_back(found->second);
    layer["object"] = i;
    layer["name"] = fmt::format("{}: {}", as_utf8(models[i].name),
                                volume == CostVolume::wide ? "the tree of the queries, eight children a node"
                                                           : fmt::format("hierarchy of {}", name_of(volume)));
  }
  return layers;
}

}  // namespace toccata::io
