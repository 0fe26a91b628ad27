#pragma once

#include <span>
#include <string>
#include <vector>

#include "io/formats/json.hpp"
#include "reports/view/view_data.hpp"
#include "toccata/partitions/measure.hpp"
#include "toccata/query/check_all.hpp"

namespace toccata::io {

/// "depth 3"; of a partition that has no depths "all cells".
[[nodiscard]] std::string partition_label(const PartitionLevel& level, std::size_t levels);

/// Throws Error where so many meshes are too many to be looked at.
void require_few_partitions(std::size_t meshes);

/// A layer for every mesh or height field: the cells of a partition over its triangles, level by level. Throws Error
/// when there are too many meshes to be looked at, or a triangle is too large for a partition.
[[nodiscard]] std::vector<Json> partition_layers(std::span<const SceneInstance> models, PartitionKind kind,
                                                 ViewData& data);

}  // namespace toccata::io
