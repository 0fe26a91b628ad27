#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <string>
#include <vector>

#include "arguments.hpp"
#include "measure.hpp"
#include "report.hpp"
#include "single_mesh.hpp"
#include "toccata/bounds/obb.hpp"
#include "toccata/core/version.hpp"
#include "toccata/methods/cost.hpp"
#include "toccata/query/model.hpp"
#include "toccata/trees/builders.hpp"

namespace toccata::bench {
namespace {

/// What tells two trees apart, but for their volumes, which follow from the rest.
struct Fingerprint {
  std::vector<Index> numbers;
  double size = 0;
  friend bool operator==(const Fingerprint&, const Fingerprint&) = default;
};

/// A tree that is built on some number of threads; the last one is kept for a look.
struct Builder {
  std::string variant;
  std::function<void(int threads)> build;
  std::function<Fingerprint()> look;
  std::function<double()> bytes;
};

Builder of_model(const std::shared_ptr<const TriangleMesh>& mesh) {
  const auto tree = std::make_shared<WideBvh>();
  return {"Model, eight wide", [=](int threads) { *tree = Model(mesh, threads).wide_bvh(); },
          [=] {
            Fingerprint found{tree->items, tree->built_size};
            for (const WideBlock& block : tree->blocks)
              for (const auto child : block.child) found.numbers.push_back(static_cast<Index>(child));
            return found;
          },
          [=] {
            return static_cast<double>(tree->blocks.size() * sizeof(WideBlock) + tree->items.size() * sizeof(Index));
          }};
}

template <class Volume>
Builder of_method(const std::vector<Triangle>& triangles, BvhMethod method, CostVolume kind) {
  const auto tree = std::make_shared<Bvh<Volume>>();
  return {
      fmt::format("{}, {}", name_of(method), name_of(kind)),
      [=, &triangles](int threads) { *tree = build_bvh<Volume>(triangles, {.method = method, .threads = threads}); },
      [=] {
        Fingerprint found{tree->items, tree->built_size};
        for (const auto& node : tree->nodes)
          found.numbers.insert(found.numbers.end(), {node.first, node.count, node.child_count});
        return found;
      },
      [=] {
        return static_cast<double>(tree->nodes.size() * sizeof(BvhNode<Volume>) + tree->items.size() * sizeof(Index));
      }};
}

std::vector<Builder> all_builders(const std::shared_ptr<const TriangleMesh>& mesh,
                                  const std::vector<Triangle>& triangles) {
  std::vector<Builder> builders{of_model(mesh)};
  for (const BvhMethod method : {BvhMethod::mean, BvhMethod::median, BvhMethod::heuristic, BvhMethod::agglomeration,
                                 BvhMethod::insertion, BvhMethod::morton, BvhMethod::equal_regions}) {
    builders.push_back(of_method<Aabb>(triangles, method, cost_volume<Aabb>));
    builders.push_back(of_method<Obb>(triangles, method, cost_volume<Obb>));
  }
  return builders;
}

struct BuildRow {
  Result result;
  std::vector<double> times;
  Fingerprint tree;
};

/// Threads take turns within a round, so that other programs disturb all alike.
std::vector<BuildRow> measured(const Builder& builder, const BuildArguments& arguments) {
  std::vector<BuildRow> rows(arguments.threads.size());
  for (int round = 0; round < arguments.rounds; ++round)
    for (std::size_t i = 0; i < rows.size(); ++i) {
      rows[i].times.push_back(1e6 * seconds_of([&] { builder.build(arguments.threads[i]); }));
      rows[i].tree = builder.look();
    }
  for (std::size_t i = 0; i < rows.size(); ++i) {
    Result& result = rows[i].result;
    result.who = {"toccata", builder.variant, version,
                  fmt::format("{}, {} -ffp-contract=off", TOCCATA_BENCH_COMPILER, TOCCATA_BENCH_FLAGS)};
    result.task = "build";
    result.threads = arguments.threads[i];
    result.queries = rows[i].times.size();
    result.build_ms = 1e-3 * *std::min_element(rows[i].times.begin(), rows[i].times.end());
    result.wrong = rows[i].tree == rows.front().tree ? 0 : 1;
    summarise(std::move(rows[i].times), result);
  }
  return rows;
}

}  // namespace

int run_build(const BuildArguments& arguments) {
  const auto mesh = single_mesh(arguments.mesh);
  std::vector<Triangle> triangles;
  for (const auto& corner : mesh->triangles())
    triangles.push_back({{mesh->vertices()[corner[0]], mesh->vertices()[corner[1]], mesh->vertices()[corner[2]]}});
  Measurements measurements;
  nlohmann::ordered_json gains = nlohmann::ordered_json::array();
  for (const Builder& builder : all_builders(mesh, triangles)) {
    const std::vector<BuildRow> rows = measured(builder, arguments);
    const double bytes = builder.bytes() / static_cast<double>(mesh->triangle_count());
    for (const BuildRow& row : rows) {
      measurements.results.push_back(row.result);
      measurements.results.back().bytes_per_triangle = bytes;
      gains.push_back({{"variant", row.result.who.variant},
                       {"threads", row.result.threads},
                       {"gain", rows.front().result.build_ms / row.result.build_ms}});
    }
  }
  if (!arguments.json)
    for (const auto& gain : gains)
      fmt::print("{:<24}{:>3} threads: {:.2f} times as fast as on {}\n", gain["variant"].get<std::string>(),
                 gain["threads"].get<int>(), gain["gain"].get<double>(), arguments.threads.front());
  auto report = report_of("build", {{"mesh", arguments.mesh},
                                    {"triangles", mesh->triangle_count()},
                                    {"rounds", arguments.rounds},
                                    {"gains", gains}});
  return print_results(std::move(report), measurements, arguments.json);
}

}  // namespace toccata::bench
