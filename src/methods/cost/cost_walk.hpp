#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <vector>

#include "math/constants.hpp"
#include "methods/cost/cost_leaves.hpp"
#include "toccata/bounds/volume.hpp"
#include "toccata/trees/builders.hpp"

namespace toccata {

/// Stands for a node's volume: the walker hands it on, and knows nothing of what it stands for.
struct NodeNumber {
  Index number = 0;
};

/// A hierarchy without volumes. Nodes have up to eight children, whatever the arity it was built with.
struct CostHierarchy {
  CostHierarchy(std::span<const Triangle> triangles_of_mesh, int arity_of_nodes, const BvhOptions& options);

  std::span<const Triangle> triangles;  ///< by item number
  std::vector<Triangle> ordered;        ///< in the order of the leaves
  Bvh<NodeNumber, 8> tree;
  std::vector<ItemRun> runs;
  BvhBalance balance;
  int arity;
  double build_ns;

  /// The same hierarchy after its triangles have moved.
  [[nodiscard]] CostHierarchy over(std::span<const Triangle> moved) const;

  [[nodiscard]] std::size_t nodes() const { return tree.nodes.size(); }
  [[nodiscard]] std::span<const Triangle> below(Index node) const {
    return std::span(ordered).subspan(runs[node].first, runs[node].count);
  }
};

/// What one query cost.
struct QueryCost {
  WalkCounts counts;
  double answer = 0;
  TimedOperations update;
  TimedOperations test;
  TimedOperations item;
  double measured_ns = 0;
};

/// Volumes for the nodes of a hierarchy: fitted where a walk looks, and brought into the world once a query.
template <BoundingVolume V>
class CostVolumes {
 public:
  explicit CostVolumes(const CostHierarchy& hierarchy) : hierarchy_(hierarchy), place_(hierarchy.nodes(), nowhere) {}

  struct Placed {
    V volume;
    double half_area = 0;
    std::uint32_t query = 0;  ///< in which it was looked at
    bool is_fitted = false;   ///< as it was fitted, not moved
  };

  void start_query(const Pose& pose) {
    pose_ = pose;
    moves_ = !(pose == Pose{});
    ++query_;
    updated_.clear();
  }

  const Placed& operator[](NodeNumber node) {
    if (place_[node.number] == nowhere) add(node.number);
    const Index place = place_[node.number];
    if (placed_[place].query != query_) put_in_query(place);
    return placed_[place];
  }

  /// The placed volume of a node that was looked at in this query.
  [[nodiscard]] const Placed& placed(NodeNumber node) const { return placed_[place_[node.number]]; }

  [[nodiscard]] std::size_t updates() const { return updated_.size(); }

  /// Puts all volumes around the hierarchy's triangles by the library's own `refit`. How long that took.
  double refit_all() {
    refitted_.items = hierarchy_.tree.items;
    refitted_.built_size = 0;
    refitted_.nodes.reserve(hierarchy_.nodes());
    for (const auto& node : hierarchy_.tree.nodes)
      refitted_.nodes.push_back({V{}, node.first, node.count, node.child_count});
    return nanoseconds_of([&] { refit(refitted_, hierarchy_.triangles); });
  }

  /// Repeats updates of the volumes of this query.
  TimedOperations time_updates() {
    const std::size_t count = std::min<std::size_t>(updated_.size(), 512);
    return timed(count, [&] {
      for (std::size_t i = 0; i < count; ++i) put(updated_[i]);
    });
  }

 private:
  void add(Index node) {
    place_[node] = static_cast<Index>(fitted_.size());
    fitted_.push_back(refitted_.nodes.empty() ? fit<V>(hierarchy_.below(node)) : refitted_.nodes[node].volume);
    placed_.emplace_back();
  }

  void put(Index place) {
    placed_[place].volume = moves_ ? posed(fitted_[place], pose_) : fitted_[place];
    placed_[place].half_area = half_area(placed_[place].volume);
  }

  void put_in_query(Index place) {
    if (moves_ || !placed_[place].is_fitted) put(place);
    placed_[place].is_fitted = !moves_;
    placed_[place].query = query_;
    if (moves_) updated_.push_back(place);
  }

  static constexpr Index nowhere = ~Index{0};

  const CostHierarchy& hierarchy_;
  std::vector<Index> place_;  ///< of a node's volumes below
  std::vector<V> fitted_;
  std::vector<Placed> placed_;
  std::vector<Index> updated_;
  Bvh<V, 8> refitted_;
  Pose pose_;
  bool moves_ = false;
  std::uint32_t query_ = 0;
};

/// The question that the walker asks of two hierarchies.
template <BoundingVolume V>
class MeasuringQuestion {
 public:
  MeasuringQuestion(CostVolumes<V>& a, CostVolumes<V>& b, CostLeaves& leaves)
      : a_(a), b_(b), leaves_(leaves), by_distance_(leaves.task() == CostTask::distance) {}

  double bound(NodeNumber a, NodeNumber b) {
    if (sample_.size() < 512) sample_.push_back({a.number, b.number});
    return bound_of(a_[a].volume, b_[b].volume);
  }
  [[nodiscard]] double limit() const { return leaves_.limit(); }
  void visit(std::span<const ItemPair> pairs) { leaves_.visit(pairs); }
  /// Whether the first of two nodes is split; they were compared, and so are placed.
  [[nodiscard]] bool split_first(NodeNumber a, NodeNumber b) const {
    return a_.placed(a).half_area >= b_.placed(b).half_area;
  }

  /// Repeats tests of the first pairs of volumes that were compared.
  TimedOperations time_tests() {
    return timed(sample_.size(), [&] {
      for (const ItemPair& pair : sample_)
        sum_ += bound_of(a_[NodeNumber{pair.first}].volume, b_[NodeNumber{pair.second}].volume) > 0 ? 1 : 0;
    });
  }

 private:
  [[nodiscard]] double bound_of(const V& a, const V& b) const {
    if (by_distance_) return gap(a, b);
    return overlap(a, b) ? 0 : infinity;
  }

  CostVolumes<V>& a_;
  CostVolumes<V>& b_;
  CostLeaves& leaves_;
  bool by_distance_;
  std::vector<ItemPair> sample_;
  double sum_ = 0;
};

/// One query at two poses: counted, its operations repeated for their time, and run once more as it is.
template <BoundingVolume V>
QueryCost cost_of_query(CostVolumes<V>& a, CostVolumes<V>& b, const CostHierarchy& tree_a, const CostHierarchy& tree_b,
                        const PairQuery& query, CostTask task) {
  const CostSide side_a{tree_a.triangles, query.pose_a}, side_b{tree_b.triangles, query.pose_b};
  QueryCost cost;
  const auto start = [&] {
    a.start_query(query.pose_a);
    b.start_query(query.pose_b);
  };
  start();
  CostLeaves leaves(task, side_a, side_b);
  MeasuringQuestion<V> question(a, b, leaves);
  cost.counts = walk_pair(tree_a.tree, tree_b.tree, question);
  cost.counts.volumes_updated = a.updates() + b.updates();
  cost.answer = leaves.answer();
  cost.test = question.time_tests();
  cost.item = leaves.time_items();
  cost.update = a.time_updates() + b.time_updates();
  cost.measured_ns = timed(1, [&] {
                       start();
                       CostLeaves again(task, side_a, side_b);
                       MeasuringQuestion<V> asked(a, b, again);
                       walk_pair(tree_a.tree, tree_b.tree, asked);
                     }).nanoseconds;
  return cost;
}

/// How long fits take by the number of triangles, in classes of twice as many: a few of each are made.
struct FitTimes {
  std::array<double, 33> of_class{};

  static std::size_t class_of(Index count) {
    std::size_t c = 0;
    while (count > 1) {
      count /= 2;
      ++c;
    }
    return c;
  }
  [[nodiscard]] double all_of(const CostHierarchy& hierarchy) const {
    double sum = 0;
    for (const ItemRun& run : hierarchy.runs) sum += of_class[class_of(run.count)];
    return sum;
  }
};

template <BoundingVolume V>
[[nodiscard]] FitTimes time_fits(const CostHierarchy& hierarchy) {
  FitTimes times;
  std::array<TimedOperations, 33> of_class{};
  for (Index node = 0; node < hierarchy.nodes(); ++node) {
    const Index count = hierarchy.runs[node].count;
    TimedOperations& done = of_class[FitTimes::class_of(count)];
    if (done.count * count >= 2000) continue;
    V volume;
    const double time = nanoseconds_of([&] { volume = fit<V>(hierarchy.below(node)); });
    done = done + TimedOperations{is_empty(volume) ? 0U : 1U, time};
  }
  for (std::size_t i = 0; i < of_class.size(); ++i) times.of_class[i] = of_class[i].each();
  return times;
}

/// Under many poses; volumes are fitted once.
template <BoundingVolume V>
[[nodiscard]] std::vector<QueryCost> cost_of_poses(const CostHierarchy& a, const CostHierarchy& b,
                                                   std::span<const PairQuery> queries, CostTask task) {
  CostVolumes<V> volumes_a(a), volumes_b(b);
  std::vector<QueryCost> costs;
  for (const PairQuery& query : queries) costs.push_back(cost_of_query(volumes_a, volumes_b, a, b, query, task));
  return costs;
}

/// All volumes of both are refitted first.
template <BoundingVolume V>
[[nodiscard]] QueryCost cost_of_refit(const CostHierarchy& a, const CostHierarchy& b, CostTask task) {
  CostVolumes<V> volumes_a(a), volumes_b(b);
  const double time = volumes_a.refit_all() + volumes_b.refit_all();
  QueryCost cost = cost_of_query(volumes_a, volumes_b, a, b, PairQuery{}, task);
  cost.update = {a.nodes() + b.nodes(), time};
  cost.counts.volumes_updated = cost.update.count;
  cost.measured_ns += time;
  return cost;
}

/// The size of the volume around all triangles.
struct RootSize {
  double volume = 0;
  double surface = 0;
};

template <BoundingVolume V>
[[nodiscard]] RootSize size_of_root(const CostHierarchy& hierarchy) {
  const V root = fit<V>(hierarchy.below(0));
  return {measure(root), surface_area(root)};
}

/// The functions above for one volume.
struct CostFunctions {
  std::vector<QueryCost> (*of_poses)(const CostHierarchy&, const CostHierarchy&, std::span<const PairQuery>, CostTask);
  QueryCost (*of_refit)(const CostHierarchy&, const CostHierarchy&, CostTask);
  FitTimes (*fits)(const CostHierarchy&);
  RootSize (*root)(const CostHierarchy&);
  std::size_t bytes_of_node;
  double work_of_update;  ///< roughly, in microseconds
};

template <ListedVolume V>
constexpr CostFunctions cost_functions() {
  return {cost_of_poses<V>, cost_of_refit<V>, time_fits<V>, size_of_root<V>, sizeof(BvhNode<V>), V::microseconds};
}

/// The functions of a volume other than CostVolume::wide.
[[nodiscard]] CostFunctions cost_functions_of(CostVolume volume);

}  // namespace toccata
