#pragma once

#include <nlohmann/json.hpp>
#include <span>
#include <vector>

#include "io/view/view_data.hpp"
#include "toccata/partitions/measure.hpp"
#include "toccata/query/check_all.hpp"

namespace toccata::io {

/// A layer for every mesh or height field: the cells of a partition over its triangles, level by level. Throws Error
/// when there are too many meshes to be looked at, or a triangle is too large for a partition.
[[nodiscard]] std::vector<nlohmann::ordered_json> partition_layers(std::span<const Posed> models, PartitionKind kind,
                                                                   ViewData& data);

}  // namespace toccata::io
