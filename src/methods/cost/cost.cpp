#include "toccata/methods/cost.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <tuple>

#include "methods/cost/cost_plan.hpp"
#include "methods/cost/cost_wide.hpp"
#include "toccata/core/error.hpp"

namespace toccata {
namespace {

std::vector<Triangle> triangles_of(const TriangleMesh& mesh, std::span<const Vec3> vertices) {
  std::vector<Triangle> triangles;
  triangles.reserve(mesh.triangle_count());
  for (const auto& corner : mesh.triangles())
    triangles.push_back({{vertices[corner[0]], vertices[corner[1]], vertices[corner[2]]}});
  return triangles;
}

/// So many at most, evenly chosen, the first among them.
std::vector<PairQuery> chosen(std::span<const PairQuery> queries, std::size_t most) {
  const std::size_t count = std::min(queries.size(), std::max<std::size_t>(most, 1));
  std::vector<PairQuery> some;
  for (std::size_t i = 0; i < count; ++i) some.push_back(queries[i * queries.size() / count]);
  return some;
}

void require(bool met, const std::string& message) {
  if (!met) throw Error(message);
}

template <class T>
bool is_among(const std::vector<T>& all, const T& one) {
  return std::find(all.begin(), all.end(), one) != all.end();
}

bool asks_for(const CostOptions& options, CostWorkload workload) { return is_among(options.workloads, workload); }

/// Both meshes where a query puts them.
struct WorldMeshes {
  WorldMeshes(const TriangleMesh& mesh_a, const TriangleMesh& mesh_b, const PairQuery& query)
      : vertices_a(transform(query.pose_a, mesh_a.vertices())),
        vertices_b(transform(query.pose_b, mesh_b.vertices())),
        a(triangles_of(mesh_a, vertices_a)),
        b(triangles_of(mesh_b, vertices_b)) {
    const auto finite = [](const Vec3& v) { return is_finite(v); };
    require(std::all_of(vertices_a.begin(), vertices_a.end(), finite) &&
                std::all_of(vertices_b.begin(), vertices_b.end(), finite),
            "a pose puts a vertex where it is not finite; look at the poses and units");
  }

  [[nodiscard]] double largest_coordinate() const {
    double largest = 0;
    for (const std::vector<Vec3>* vertices : {&vertices_a, &vertices_b})
      for (const Vec3& v : *vertices) largest = std::max({largest, std::abs(v.x), std::abs(v.y), std::abs(v.z)});
    return largest;
  }

  std::vector<Vec3> vertices_a;
  std::vector<Vec3> vertices_b;
  std::vector<Triangle> a;
  std::vector<Triangle> b;
};

/// Adds up the queries of a row.
class RowSum {
 public:
  RowSum(CostWorkload workload, CostVolume volume) {
    row_.workload = workload;
    row_.volume = volume;
  }

  void add(const QueryCost& cost) {
    ++row_.queries;
    row_.counts.volumes_updated += cost.counts.volumes_updated;
    row_.counts.volume_tests += cost.counts.volume_tests;
    row_.counts.items += cost.counts.items;
    update_ = update_ + cost.update;
    test_ = test_ + cost.test;
    item_ = item_ + cost.item;
    row_.measured_ns += cost.measured_ns;
  }

  [[nodiscard]] CostRow row() const {
    CostRow row = row_;
    row.update_ns = update_.each();
    row.test_ns = test_.each();
    row.item_ns = item_.each();
    row.measured_ns /= static_cast<double>(row.queries);
    return row;
  }

 private:
  CostRow row_;
  TimedOperations update_;
  TimedOperations test_;
  TimedOperations item_;
};

class Measurement {
 public:
  Measurement(const TriangleMesh& a, const TriangleMesh& b, std::span<const PairQuery> queries,
              const CostOptions& options)
      : mesh_a_(a),
        mesh_b_(b),
        options_(options),
        rigid_(chosen(queries, options.most_rigid)),
        updating_(chosen(queries, options.most_updating)),
        a_(triangles_of(a, a.vertices())),
        b_(triangles_of(b, b.vertices())),
        plan_(options, a.triangle_count() + std::size_t{b.triangle_count()}) {
    table_.task = options.task;
    for (const PairQuery& query : rigid_) size_ = std::max(size_, WorldMeshes(a, b, query).largest_coordinate());
    for (const PairQuery& query : updating_) worlds_.emplace_back(a, b, query);
  }

  CostTable measure() {
    const std::size_t steps = options_.methods.size() * options_.arities.size();
    std::size_t done = 0;
    if (is_among(options_.volumes, CostVolume::wide)) measure_library();
    for (const BvhMethod method : options_.methods)
      for (const int arity : options_.arities) {
        measure_hierarchies(method, arity);
        if (options_.progress) options_.progress(++done, steps);
      }
    for (std::string& words : plan_.left_out()) table_.left_out.push_back(std::move(words));
    std::stable_sort(table_.rows.begin(), table_.rows.end(), [](const CostRow& x, const CostRow& y) {
      return std::tuple(x.workload, x.cost()) < std::tuple(y.workload, y.cost());
    });
    return std::move(table_);
  }

 private:
  void measure_hierarchies(BvhMethod method, int arity) {
    const BvhOptions tree{method, options_.leaf_size, BvhDriver::iterative};
    const CostHierarchy a(a_, arity, tree), b(b_, arity, tree);
    if (asks_for(options_, CostWorkload::rigid))
      for (const CostVolume volume : plan_.volumes(CostWorkload::rigid, method, arity))
        measure_rigid(volume, method, a, b);
    if (asks_for(options_, CostWorkload::refit)) measure_refit(method, a, b);
    if (asks_for(options_, CostWorkload::rebuild)) measure_rebuild(method, arity, tree);
  }

  void measure_rigid(CostVolume volume, BvhMethod method, const CostHierarchy& a, const CostHierarchy& b) {
    RowSum sum(CostWorkload::rigid, volume);
    const std::vector<QueryCost> costs = cost_functions_of(volume).of_poses(a, b, rigid_, options_.task);
    for (const QueryCost& cost : costs) sum.add(cost);
    finish(sum.row(), method, a, b, costs);
  }

  void measure_refit(BvhMethod method, const CostHierarchy& a, const CostHierarchy& b) {
    std::vector<CostHierarchy> moved_a, moved_b;
    for (const WorldMeshes& world : worlds_) {
      moved_a.push_back(a.over(world.a));
      moved_b.push_back(b.over(world.b));
    }
    for (const CostVolume volume : plan_.volumes(CostWorkload::refit, method, a.arity)) {
      RowSum sum(CostWorkload::refit, volume);
      std::vector<QueryCost> costs;
      for (std::size_t i = 0; i < moved_a.size(); ++i) {
        costs.push_back(cost_functions_of(volume).of_refit(moved_a[i], moved_b[i], options_.task));
        sum.add(costs.back());
      }
      finish(sum.row(), method, a, b, costs);
    }
  }

  void measure_rebuild(BvhMethod method, int arity, const BvhOptions& tree) {
    std::vector<CostHierarchy> a, b;
    for (const WorldMeshes& world : worlds_) {
      a.emplace_back(world.a, arity, tree);
      b.emplace_back(world.b, arity, tree);
    }
    for (const CostVolume volume : plan_.volumes(CostWorkload::rebuild, method, arity)) {
      RowSum sum(CostWorkload::rebuild, volume);
      std::vector<QueryCost> costs;
      for (std::size_t i = 0; i < a.size(); ++i) {
        costs.push_back(cost_functions_of(volume).of_poses(a[i], b[i], std::array{PairQuery{}}, options_.task).front());
        QueryCost& cost = costs.back();
        cost.update = {a[i].nodes() + b[i].nodes(), build_time(volume, a[i], b[i])};
        cost.counts.volumes_updated = cost.update.count;
        cost.measured_ns += cost.update.nanoseconds;
        sum.add(cost);
      }
      finish(sum.row(), method, a.front(), b.front(), costs);
    }
  }

  /// Fits of a volume are timed once, since they depend on how many triangles there are and not on who sorted them.
  double build_time(CostVolume volume, const CostHierarchy& a, const CostHierarchy& b) {
    auto& times = fit_times_[static_cast<std::size_t>(volume)];
    if (times.empty()) {
      times.push_back(cost_functions_of(volume).fits(a));
      times.push_back(cost_functions_of(volume).fits(b));
    }
    return a.build_ns + b.build_ns + times[0].all_of(a) + times[1].all_of(b);
  }

  void finish(CostRow row, BvhMethod method, const CostHierarchy& a, const CostHierarchy& b,
              std::span<const QueryCost> costs) {
    row.arity = a.arity;
    row.method = method;
    row.leaf_size = options_.leaf_size;
    row.nodes = a.nodes() + b.nodes();
    row.bytes = row.nodes * cost_functions_of(row.volume).bytes_of_node + (a_.size() + b_.size()) * sizeof(Index);
    row.greatest_depth = std::max(a.balance.greatest_depth, b.balance.greatest_depth);
    row.build_ns = build_time(row.volume, a, b);
    compare_answers(row, costs);
    table_.rows.push_back(row);
  }

  void measure_library() {
    const Model a(mesh_a_), b(mesh_b_);
    if (asks_for(options_, CostWorkload::rigid)) {
      std::vector<QueryCost> costs;
      for (const PairQuery& query : rigid_) costs.push_back(cost_of_library(a, b, query, options_.task));
      finish_library(CostWorkload::rigid, costs);
    }
    std::vector<QueryCost> refits, rebuilds;
    for (const WorldMeshes& world : worlds_) {
      const MovedVertices moved{world.vertices_a, world.vertices_b};
      if (asks_for(options_, CostWorkload::refit))
        refits.push_back(cost_of_library_deformed(a, b, moved, options_.task));
      if (asks_for(options_, CostWorkload::rebuild))
        rebuilds.push_back(cost_of_library_anew(mesh_a_, mesh_b_, moved, options_.task));
    }
    if (!refits.empty()) finish_library(CostWorkload::refit, refits);
    if (!rebuilds.empty()) finish_library(CostWorkload::rebuild, rebuilds);
  }

  void finish_library(CostWorkload workload, std::span<const QueryCost> costs) {
    RowSum sum(workload, CostVolume::wide);
    for (const QueryCost& cost : costs) sum.add(cost);
    CostRow row = sum.row();
    const LibraryBvh a = library_bvh(mesh_a_, options_.task), b = library_bvh(mesh_b_, options_.task);
    row.arity = 8;
    row.method = BvhMethod::heuristic;
    row.leaf_size = 1;
    row.nodes = a.boxes + b.boxes;
    row.bytes = a.bytes + b.bytes;
    row.greatest_depth = std::max(a.greatest_depth, b.greatest_depth);
    row.build_ns = a.build_ns + b.build_ns;
    compare_answers(row, costs);
    table_.rows.push_back(row);
  }

  /// The library's own distance is certified to 1e-12, the plain one of a few last places; all others are the same.
  void compare_answers(const CostRow& row, std::span<const QueryCost> costs) {
    std::vector<double>& known = row.workload == CostWorkload::rigid ? table_.answers : answers_of_updating_;
    if (known.empty())
      for (const QueryCost& cost : costs) known.push_back(cost.answer);
    for (std::size_t i = 0; i < costs.size(); ++i) {
      const double allowed = options_.task == CostTask::distance ? 0x1p-38 * size_ + 0x1p-38 * known[i] : 0;
      require(std::abs(known[i] - costs[i].answer) <= allowed,
              fmt::format("{} {} of arity {} by {} answers query {} with {}, and others with {}: this is an error of "
                          "the library, please report it",
                          name_of(row.workload), name_of(row.volume), row.arity, name_of(row.method), i,
                          costs[i].answer, known[i]));
    }
  }

  const TriangleMesh& mesh_a_;
  const TriangleMesh& mesh_b_;
  const CostOptions& options_;
  std::vector<PairQuery> rigid_;
  std::vector<PairQuery> updating_;
  std::vector<Triangle> a_;
  std::vector<Triangle> b_;
  CostPlan plan_;
  std::vector<WorldMeshes> worlds_;
  std::array<std::vector<FitTimes>, all_cost_volumes.size()> fit_times_;
  std::vector<double> answers_of_updating_;
  double size_ = 0;
  CostTable table_;
};

}  // namespace

CostTable measure_costs(const TriangleMesh& a, const TriangleMesh& b, std::span<const PairQuery> queries,
                        const CostOptions& options) {
  require(!queries.empty(), "there is no query: name at least one pair of poses");
  const CostOptions checked = checked_options(options);
  return Measurement(a, b, queries, checked).measure();
}

}  // namespace toccata
