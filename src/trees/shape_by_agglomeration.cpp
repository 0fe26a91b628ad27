#include <algorithm>

#include "trees/binary_shape.hpp"

namespace toccata {
namespace {

/// How far along the curve a neighbour is looked for, to each side.
constexpr std::size_t search_reach = 8;

// The last rounds have few clusters, for which waking threads would take longer.
constexpr std::size_t fewest_for_threads = 4096;

struct Cluster {
  Aabb box;
  Index fork;
};

/// For each cluster the nearest one within reach: that with which it has the least surface. Among equal ones it is that
/// with which it makes a pair counted from the start, so that clusters that coincide are merged two by two, and not one
/// after another.
std::vector<std::size_t> nearest_of(std::span<const Cluster> clusters, int threads) {
  std::vector<std::size_t> nearest(clusters.size());
  const auto area_with = [&](std::size_t i, std::size_t j) {
    return half_area(merge(clusters[i].box, clusters[j].box));
  };
  parallel_for(clusters.size(), clusters.size() < fewest_for_threads ? 1 : threads, [&](std::size_t i) {
    const std::size_t first = i - std::min(i, search_reach), last = std::min(i + search_reach, clusters.size() - 1);
    nearest[i] = (i ^ 1) < clusters.size() ? (i ^ 1) : i - 1;
    double best = area_with(i, nearest[i]);
    for (std::size_t j = first; j <= last; ++j) {
      if (j == i || !(area_with(i, j) < best)) continue;
      best = area_with(i, j);
      nearest[i] = j;
    }
  });
  return nearest;
}

}  // namespace

BinaryShape shape_by_agglomeration(const ShapeItems& items, int threads) {
  BinaryShape shape;
  std::vector<Cluster> clusters;
  for (const CodedItem& coded : along_curve(items, threads))
    clusters.push_back({items.boxes[coded.item], shape.add_leaf(coded.item)});
  while (clusters.size() > 1) {
    const std::vector<std::size_t> nearest = nearest_of(clusters, threads);
    std::vector<Cluster> merged;
    for (std::size_t i = 0; i < clusters.size(); ++i) {
      const std::size_t j = nearest[i];
      if (nearest[j] != i) {
        merged.push_back(clusters[i]);
      } else if (i < j) {
        merged.push_back({merge(clusters[i].box, clusters[j].box), shape.add_fork(clusters[i].fork, clusters[j].fork)});
      }
    }
    // Areas that are equal can make a circle in which no two are each other's nearest: then the first two are merged.
    if (merged.size() == clusters.size()) {
      merged[1] = {merge(merged[0].box, merged[1].box), shape.add_fork(merged[0].fork, merged[1].fork)};
      merged.erase(merged.begin());
    }
    clusters = std::move(merged);
  }
  shape.root = clusters.front().fork;
  return shape;
}

}  // namespace toccata
