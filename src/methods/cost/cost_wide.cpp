#include "methods/cost/cost_wide.hpp"

#include <algorithm>
#include <optional>

#include "toccata/query/contacts.hpp"
#include "toccata/query/distance.hpp"
#include "toccata/query/overlap.hpp"
#include "toccata/query/pair_query.hpp"
#include "trees/oriented_boxes.hpp"

namespace toccata {
namespace {

double answer_of(const Model& a, const Model& b, const PairQuery& query, CostTask task, Workspace& workspace) {
  switch (task) {
    case CostTask::overlap:
      return overlap(a, b, query, workspace) ? 1 : 0;
    case CostTask::contacts:
      return static_cast<double>(contacts(a, b, query, workspace).size());
    case CostTask::distance:
      break;
  }
  return distance(a, b, query, workspace).upper;
}

PairQuery of_surfaces(PairQuery query) {
  query.solid_a = query.solid_b = Solid::none;
  query.threads = 1;
  return query;
}

struct TimedModel {
  Model model;
  double time;
};

TimedModel build_model(const TriangleMesh& mesh, CostTask task) {
  std::optional<Model> model;
  const double time = nanoseconds_of([&] {
    model.emplace(mesh);
    if (task == CostTask::distance) (void)model->oriented_boxes();
  });
  return {*model, time};
}

void add_update(QueryCost& cost, std::size_t count, double time) {
  cost.update = {count, time};
  cost.counts.volumes_updated = count;
  cost.measured_ns += time;
}

LibraryBvh measured(const TimedModel& built, CostTask task) {
  const WideBvh& tree = built.model.wide_bvh();
  LibraryBvh result{0, tree.blocks.size() * sizeof(WideBlock) + tree.items.size() * sizeof(Index), 0, built.time};
  std::vector<int> depths(tree.blocks.size(), 0);
  for (std::size_t i = 0; i < tree.blocks.size(); ++i)
    for (std::uint32_t lane = 0; lane < tree.blocks[i].count; ++lane) {
      ++result.boxes;
      result.greatest_depth = std::max(result.greatest_depth, depths[i] + 1);
      if (!tree.blocks[i].is_item(lane)) depths[static_cast<std::size_t>(tree.blocks[i].child[lane])] = depths[i] + 1;
    }
  if (task == CostTask::distance) {
    result.bytes += built.model.oriented_boxes().size_bytes();
    result.boxes *= 2;
  }
  return result;
}

}  // namespace

QueryCost cost_of_library(const Model& a, const Model& b, const PairQuery& query, CostTask task) {
  Workspace workspace;
  QueryCost cost;
  const PairQuery asked = of_surfaces(query);
  cost.answer = answer_of(a, b, asked, task, workspace);
  cost.counts = workspace.counts();
  // The boxes around both meshes are compared before all others.
  cost.counts.volume_tests = std::max<std::size_t>(cost.counts.volume_tests, 1);
  cost.measured_ns = timed(1, [&] { (void)answer_of(a, b, asked, task, workspace); }).nanoseconds;
  cost.test = {cost.counts.volume_tests, cost.measured_ns};
  return cost;
}

QueryCost cost_of_library_anew(const TriangleMesh& a, const TriangleMesh& b, const MovedVertices& moved,
                               CostTask task) {
  const TimedModel model_a = build_model(a.with_vertices({moved.a.begin(), moved.a.end()}), task);
  const TimedModel model_b = build_model(b.with_vertices({moved.b.begin(), moved.b.end()}), task);
  QueryCost cost = cost_of_library(model_a.model, model_b.model, {}, task);
  add_update(cost, measured(model_a, task).boxes + measured(model_b, task).boxes, model_a.time + model_b.time);
  return cost;
}

QueryCost cost_of_library_deformed(const Model& a, const Model& b, const MovedVertices& moved, CostTask task) {
  // The first time a deformed model stops sharing its tree with others.
  std::array<Model, 2> models{a, b};
  std::array<Refit, 2> refits;
  double time = 0;
  for (int run = 0; run < 2; ++run)
    time = nanoseconds_of([&] {
      refits = {models[0].deform({moved.a.begin(), moved.a.end()}), models[1].deform({moved.b.begin(), moved.b.end()})};
      if (task != CostTask::distance) return;
      for (const Model& model : models) (void)model.oriented_boxes();
    });
  QueryCost cost = cost_of_library(models[0], models[1], {}, task);
  const std::size_t each = task == CostTask::distance ? 2 : 1;
  add_update(cost, each * (refits[0].volumes_updated + refits[1].volumes_updated), time);
  return cost;
}

LibraryBvh library_bvh(const TriangleMesh& mesh, CostTask task) { return measured(build_model(mesh, task), task); }

}  // namespace toccata
