#include "reports/clash_groups.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "shapes/union_find.hpp"
#include "toccata/broad/broad_phase.hpp"

namespace toccata::io {
namespace {

/// Makes a group of all pairs of the object that has the most that are in no group yet, of several the first, until no
/// pair is left.
std::vector<ClashGroup> groups_of_parts(const std::vector<ReportedPair>& pairs) {
  std::map<Index, std::set<std::size_t>> of_part;
  for (std::size_t i = 0; i < pairs.size(); ++i)
    for (const Index part : {pairs[i].a, pairs[i].b}) of_part[part].insert(i);
  const auto rank = [](const std::set<std::size_t>& members, Index part) {
    return std::pair(-static_cast<std::ptrdiff_t>(members.size()), part);
  };
  std::set<std::pair<std::ptrdiff_t, Index>> waiting;
  for (const auto& [part, members] : of_part) waiting.insert(rank(members, part));
  std::vector<ClashGroup> groups;
  while (!waiting.empty() && waiting.begin()->first < 0) {
    const Index part = waiting.begin()->second;
    waiting.erase(waiting.begin());
    ClashGroup group{part, {}, {of_part[part].begin(), of_part[part].end()}};
    for (const std::size_t i : group.pairs) {
      const Index other = pairs[i].a == part ? pairs[i].b : pairs[i].a;
      std::set<std::size_t>& of_other = of_part[other];
      waiting.erase(rank(of_other, other));
      of_other.erase(i);
      waiting.insert(rank(of_other, other));
    }
    groups.push_back(std::move(group));
  }
  return groups;
}

Aabb grown_by_its_edge(const Aabb& box) {
  const Vec3 size = box.upper - box.lower;
  const double by = std::max({size.x, size.y, size.z});
  return {box.lower - Vec3{by, by, by}, box.upper + Vec3{by, by, by}};
}

std::vector<ClashGroup> groups_of_regions(const std::vector<ReportedPair>& pairs) {
  std::vector<Aabb> boxes;
  for (const ReportedPair& pair : pairs) boxes.push_back(grown_by_its_edge(pair.place));
  UnionFind together(pairs.size());
  for (const auto& [first, second] : overlapping_pairs(boxes)) together.unite(first, second);
  std::map<Index, ClashGroup> of_leader;
  for (std::size_t i = 0; i < pairs.size(); ++i) of_leader[together.leader(static_cast<Index>(i))].pairs.push_back(i);
  std::vector<ClashGroup> groups;
  for (auto& [leader, group] : of_leader) groups.push_back(std::move(group));
  return groups;
}

}  // namespace

std::vector<ClashGroup> clash_groups(const std::vector<ReportedPair>& pairs, ClashGrouping grouping) {
  if (grouping == ClashGrouping::none) return {};
  std::vector<ClashGroup> groups = grouping == ClashGrouping::part ? groups_of_parts(pairs) : groups_of_regions(pairs);
  for (ClashGroup& group : groups)
    for (const std::size_t i : group.pairs) group.place = merge(group.place, pairs[i].place);
  std::sort(groups.begin(), groups.end(), [](const ClashGroup& x, const ClashGroup& y) {
    return std::pair(y.pairs.size(), x.pairs.front()) < std::pair(x.pairs.size(), y.pairs.front());
  });
  return groups;
}

}  // namespace toccata::io
