#include "reports/view/partition_layers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <string>

#include "io/formats/utf8.hpp"
#include "reports/view/counted.hpp"
#include "reports/view/quantised_boxes.hpp"
#include "toccata/core/error.hpp"
#include "toccata/partitions/measure.hpp"

namespace toccata::io {
namespace {

using Cells = std::vector<PartitionCell>;

/// Cells are drawn by how many triangles they hold: up to each of these.
constexpr std::array<std::size_t, 4> fullness{4, 16, 64, 256};

std::size_t class_of(const PartitionCell& cell) {
  return static_cast<std::size_t>(std::lower_bound(fullness.begin(), fullness.end(), cell.items.size()) -
                                  fullness.begin());
}

Json class_names() {
  Json names = Json::array();
  std::size_t from = 1;
  for (const std::size_t to : fullness) {
    names.push_back(fmt::format("{} to {} triangles", from, to));
    from = to + 1;
  }
  names.push_back("more");
  return names;
}

std::string note_of(const Cells& cells, std::size_t triangles) {
  std::size_t copies = 0, most = 0;
  for (const PartitionCell& cell : cells) {
    copies += cell.items.size();
    most = std::max(most, cell.items.size());
  }
  const auto share = [&](std::size_t of) {
    return static_cast<double>(copies) / static_cast<double>(std::max<std::size_t>(of, 1));
  };
  return fmt::format("{} with {:.1f} triangles on average, {} at most; a triangle is in {:.2f}",
                     counted(cells.size(), "cell", "cells"), share(cells.size()), most, share(triangles));
}

Aabb bounds_of_levels(const std::vector<PartitionLevel>& levels) {
  Aabb around;
  for (const PartitionLevel& level : levels)
    for (const PartitionCell& cell : level.cells) around = merge(around, cell.box);
  return is_empty(around) ? Aabb{{0, 0, 0}, {0, 0, 0}} : around;
}

Json layer_of(const TriangleMesh& mesh, PartitionKind kind, ViewData& data) {
  const std::vector<PartitionLevel> levels = partition_levels(kind, PartitionItems(mesh));
  QuantisedBoxes boxes(bounds_of_levels(levels));
  Json steps = Json::array();
  for (const PartitionLevel& level : levels) {
    const std::size_t first = boxes.size();
    for (const PartitionCell& cell : level.cells) boxes.add(cell.box, class_of(cell));
    steps.push_back({{"label", partition_label(level, levels.size())},
                     {"note", note_of(level.cells, mesh.triangle_count())},
                     {"first", first},
                     {"count", level.cells.size()}});
  }
  return {{"kind", "cells"},
          {"role", "partition"},
          {"data", boxes.written(data)},
          {"classes", class_names()},
          {"steps", steps}};
}

}  // namespace

std::string partition_label(const PartitionLevel& level, std::size_t levels) {
  return levels == 1 ? "all cells" : fmt::format("depth {}", level.depth);
}

void require_few_partitions(std::size_t meshes) {
  constexpr std::size_t most = 32;
  if (meshes > most)
    throw Error(fmt::format("partitions of more than {} meshes are too many to look at: show fewer", most));
}

std::vector<Json> partition_layers(std::span<const SceneInstance> models, PartitionKind kind, ViewData& data) {
  std::map<const TriangleMesh*, Json> layer_of_mesh;
  std::vector<Json> layers;
  for (std::size_t i = 0; i < models.size(); ++i) {
    if (!models[i].model.has_mesh()) continue;
    const auto [found, is_new] = layer_of_mesh.try_emplace(&models[i].model.mesh());
    require_few_partitions(layer_of_mesh.size());
    if (is_new) found->second = layer_of(models[i].model.mesh(), kind, data);
    Json& layer = layers.emplace_back(found->second);
    layer["object"] = i;
    layer["name"] = fmt::format("{}: cells of the {}", as_utf8(models[i].name), name_of(kind));
  }
  return layers;
}

}  // namespace toccata::io
