#pragma once

#include <string>
#include <vector>

#include "toccata/methods/cost.hpp"
#include "toccata/partitions/measure.hpp"

namespace toccata::command {

/// What the words of the options --volumes, --arities, --builders, --workloads and --task are.
struct CostWords {
  std::vector<std::string> volumes;
  std::vector<std::string> builders;
  std::vector<std::string> workloads;
  std::vector<int> arities;
  std::string task = "overlap";
  Index leaf_size = CostOptions{}.leaf_size;
  bool quick = false;
  bool all = false;
};

/// Throws Error naming a word that is none, and those there are.
[[nodiscard]] CostOptions cost_options_of(const CostWords& words);

/// That the row `wide` is of another builder or arity than asked for; empty where it is not.
[[nodiscard]] std::string remark_on_wide(const CostOptions& options);

/// "the meshes move as they are".
[[nodiscard]] std::string meaning_of(CostWorkload workload);

/// The table of `inspect --volumes`, a line for each volume, arity and builder.
[[nodiscard]] std::string volume_table(const std::vector<VolumeCost>& costs);

/// The table of `inspect --partitions`, a line for each partition.
[[nodiscard]] std::string partition_table(const std::vector<PartitionCost>& costs);

}  // namespace toccata::command
