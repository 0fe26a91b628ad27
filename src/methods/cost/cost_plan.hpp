#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "toccata/methods/cost.hpp"

namespace toccata {

/// The options with each thing that they name once, where it is first named. Throws Error for options that ask for
/// nothing, or for an arity that no tree has.
[[nodiscard]] CostOptions checked_options(CostOptions options);

/// Which combinations are measured within the work that may be done. CostVolume::wide is none of them.
class CostPlan {
 public:
  /// For two meshes of so many triangles together.
  CostPlan(const CostOptions& options, std::size_t triangles);

  [[nodiscard]] std::vector<CostVolume> volumes(CostWorkload workload, BvhMethod method, int arity) const;

  /// What is not measured, a line for each volume and workload.
  [[nodiscard]] std::vector<std::string> left_out() const;

 private:
  struct Combination {
    CostWorkload workload;
    CostVolume volume;
    BvhMethod method;
    int arity;
    double work = 0;
    double rank = 0;
    bool measured = false;
  };
  std::vector<Combination> all_;
};

}  // namespace toccata
