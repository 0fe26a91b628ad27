#include "methods/cost/cost_plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <utility>
#include <vector>

#include "methods/cost/cost_walk.hpp"
#include "toccata/core/error.hpp"

namespace toccata {
namespace {

/// In microseconds. A refit updates about as many volumes as there are triangles; the other workloads fit the few at
/// the top, over many triangles each. Walks matter where they look for a distance.
double work_of(const CostOptions& options, CostWorkload workload, CostVolume volume, std::size_t updates) {
  const double all = static_cast<double>(updates) * cost_functions_of(volume).work_of_update;
  const bool walks = options.task == CostTask::distance && workload == CostWorkload::rigid;
  return workload == CostWorkload::refit ? all : (walks ? 1 : 0.2) * all;
}

template <class T>
void drop_repeats(std::vector<T>& values) {
  std::vector<T> once;
  for (const T value : values)
    if (std::find(once.begin(), once.end(), value) == once.end()) once.push_back(value);
  values = std::move(once);
}

}  // namespace

CostOptions checked_options(CostOptions options) {
  if (options.workloads.empty() || options.volumes.empty() || options.arities.empty() || options.methods.empty())
    throw Error("nothing is asked for: name at least one workload, volume, arity and builder");
  for (const int arity : options.arities)
    if (arity < 2 || arity > 8)
      throw Error(fmt::format("a tree has 2 to 8 children a node, not {}; choose another", arity));
  drop_repeats(options.workloads);
  drop_repeats(options.volumes);
  drop_repeats(options.arities);
  drop_repeats(options.methods);
  return options;
}

CostPlan::CostPlan(const CostOptions& options, std::size_t triangles) {
  for (const CostWorkload workload : options.workloads)
    for (std::size_t place = 0; place < options.methods.size(); ++place)
      for (const int arity : options.arities)
        for (const CostVolume volume : options.volumes) {
          if (volume == CostVolume::wide) continue;
          const double work = work_of(options, workload, volume, triangles);
          all_.push_back({workload, volume, options.methods[place], arity, work,
                          work * static_cast<double>((place + 1) * (place + 1))});
        }
  std::vector<std::size_t> order(all_.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t x, std::size_t y) { return all_[x].rank < all_[y].rank; });
  double left = options.most_work;
  for (const std::size_t i : order) {
    left -= all_[i].work;
    if (left < 0) break;
    all_[i].measured = true;
  }
}

std::vector<CostVolume> CostPlan::volumes(CostWorkload workload, BvhMethod method, int arity) const {
  std::vector<CostVolume> volumes;
  for (const Combination& c : all_)
    if (c.measured && c.workload == workload && c.method == method && c.arity == arity) volumes.push_back(c.volume);
  return volumes;
}

std::vector<std::string> CostPlan::left_out() const {
  std::map<std::pair<CostWorkload, CostVolume>, std::vector<std::string>> hierarchies;
  std::map<std::pair<CostWorkload, CostVolume>, std::size_t> asked;
  for (const Combination& c : all_) {
    ++asked[{c.workload, c.volume}];
    if (!c.measured) hierarchies[{c.workload, c.volume}].push_back(fmt::format("{} {}", name_of(c.method), c.arity));
  }
  std::vector<std::string> lines;
  for (const auto& [what, names] : hierarchies)
    lines.push_back(fmt::format(
        "{} {} would take too long: {}", name_of(what.first), name_of(what.second),
        names.size() == asked[what] ? "every builder and arity" : fmt::format("{}", fmt::join(names, ", "))));
  return lines;
}

}  // namespace toccata
