#pragma once

#include <span>
#include <string>
#include <vector>

#include "toccata/bounds/aabb.hpp"

namespace toccata {

/// How good a division of boxes into as many parts as there are ranks is.
struct PartitionQuality {
  std::string name;
  double seconds = 0;      ///< to divide, the longest of all ranks
  double imbalance = 1;    ///< boxes of the fullest part over the average
  double ghosts = 0;       ///< of all parts together, as a share of all boxes
  double most_ghosts = 0;  ///< of a part, as a share of the average number of boxes in one
};

/// Collective: of the planes of DistributedWorld and, where Zoltan was there when this was built, of its recursive
/// bisection and its Hilbert curve. All ranks have all boxes. Each counts as much.
[[nodiscard]] std::vector<PartitionQuality> partition_qualities(std::span<const Aabb> boxes);

}  // namespace toccata
