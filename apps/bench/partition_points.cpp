#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <functional>
#include <optional>

#include "arguments.hpp"
#include "report.hpp"
#include "single_mesh.hpp"
#include "toccata/core/random.hpp"
#include "toccata/methods/msp_tree.hpp"

// Where points lie, by the mesh's own tree, a BSP and an MSP tree: the same points, every answer compared (METHODS B6).
namespace toccata::bench {
namespace {

/// What was made of the mesh.
struct PointTree {
  const char* name;
  double build_s = 0;  ///< of the two others with the test that the mesh is closed and does not intersect itself
  std::size_t nodes = 0;
  double growth = 0;  ///< pieces of a triangle
  std::size_t depth = 0;
  std::size_t bytes = 0;
};

struct PointTrees {
  Model model;
  BspTree bsp;
  MspTree msp;
  std::array<PointTree, 3> costs;
};

/// The depth of a mesh's wide tree: nodes on the longest way from the root to a triangle.
std::size_t depth_of(const WideBvh& tree) {
  std::vector<std::size_t> depths(tree.blocks.size(), 1);
  for (std::size_t i = 0; i < tree.blocks.size(); ++i)
    for (std::size_t lane = 0; lane < tree.blocks[i].count; ++lane)
      if (!tree.blocks[i].is_item(lane)) depths[static_cast<std::size_t>(tree.blocks[i].child[lane])] = depths[i] + 1;
  return *std::max_element(depths.begin(), depths.end());
}

PointTrees built_trees(const std::string& file, Clock clock) {
  const std::shared_ptr<const TriangleMesh> mesh = single_mesh(file);
  std::optional<Model> model;
  std::optional<BspTree> bsp;
  std::optional<MspTree> msp;
  const double of_model = seconds_of([&] { model.emplace(mesh); }, clock);
  const double of_bsp = seconds_of([&] { bsp.emplace(*model); }, clock);
  const double of_msp = seconds_of([&] { msp.emplace(*model); }, clock);
  const BspStatistics& b = bsp->statistics();
  const MspStatistics& m = msp->statistics();
  const auto triangles = static_cast<double>(m.triangles);
  const WideBvh& wide = model->wide_bvh();
  return {*model,
          *bsp,
          *msp,
          {{{"mesh's own", of_model, wide.blocks.size(), 1, depth_of(wide),
             wide.blocks.size() * sizeof wide.blocks[0] + wide.items.size() * sizeof wide.items[0]},
            {"BSP", of_bsp, b.nodes, b.growth(), b.depth, b.bytes},
            {"MSP", of_msp, m.planes + m.lines + m.points, (triangles + static_cast<double>(m.splits)) / triangles,
             m.depth, m.bytes}}}};
}

/// Points of one kind, and the microseconds that each of the three takes for one.
struct PointRow {
  std::string where;
  std::array<double, 3> us{};
  std::size_t inside = 0;
  std::size_t on_surface = 0;
  std::size_t wrong = 0;
};

class PointKinds {
 public:
  PointKinds(const Model& model, const PartitionsArguments& arguments)
      : mesh_(model.mesh()), box_(model.bounds()), random_(arguments.seed), count_(arguments.queries) {}

  [[nodiscard]] std::vector<Vec3> in_box() {
    return many([&] {
      Vec3 p;
      for (int axis = 0; axis < 3; ++axis)
        p[axis] = box_.lower[axis] + random_.between(-0.1, 1.1) * (box_.upper[axis] - box_.lower[axis]);
      return p;
    });
  }

  [[nodiscard]] std::vector<Vec3> vertices() {
    return many([&] { return corner(any_triangle(), 0); });
  }

  /// Rounded, so most of them lie beside the edge or the face.
  [[nodiscard]] std::vector<Vec3> middles_of_edges() {
    return many([&] {
      const Index t = any_triangle();
      return 0.5 * corner(t, 0) + 0.5 * corner(t, 1);
    });
  }
  [[nodiscard]] std::vector<Vec3> middles_of_faces() {
    return many([&] {
      const Index t = any_triangle();
      return (1.0 / 3) * corner(t, 0) + (1.0 / 3) * corner(t, 1) + (1.0 / 3) * corner(t, 2);
    });
  }

 private:
  [[nodiscard]] std::vector<Vec3> many(const std::function<Vec3()>& one) const {
    std::vector<Vec3> points;
    while (points.size() < count_) points.push_back(one());
    return points;
  }
  [[nodiscard]] Index any_triangle() { return static_cast<Index>(random_.below(mesh_.triangle_count())); }
  [[nodiscard]] Vec3 corner(Index triangle, std::size_t i) const {
    return mesh_.vertices()[mesh_.triangles()[triangle][i]];
  }

  const TriangleMesh& mesh_;
  Aabb box_;
  Random random_;
  std::size_t count_;
};

/// In microseconds a point, in the fastest round.
double time_of_points(const PartitionsArguments& arguments, std::size_t count,
                      const std::function<void(std::size_t)>& ask) {
  const Clock clock = arguments.clock == "thread" ? Clock::thread : Clock::wall;
  double best = 1e30;
  for (int round = 0; round < arguments.rounds; ++round)
    best = std::min(best, seconds_of(
                              [&] {
                                for (std::size_t i = 0; i < count; ++i) ask(i);
                              },
                              clock));
  return 1e6 * best / static_cast<double>(count);
}

/// It is the vertex, edge or face that the MSP tree names: of a vertex, the point itself.
bool is_named_rightly(const MspLocation& found, const TriangleMesh& mesh, const Vec3& point) {
  if (found.side != Side::boundary || found.feature.kind != FeatureKind::vertex) return true;
  return mesh.vertices()[mesh.triangles()[found.triangle][found.feature.index]] == point;
}

PointRow row_of(const std::string& where, const std::vector<Vec3>& points, const PointTrees& trees,
                const PartitionsArguments& arguments) {
  PointRow row{where, {}, 0, 0, 0};
  std::vector<PointLocation> own(points.size());
  std::vector<BspLocation> bsp(points.size());
  std::vector<MspLocation> msp(points.size());
  row.us = {time_of_points(arguments, points.size(), [&](std::size_t i) { own[i] = locate(points[i], trees.model); }),
            time_of_points(arguments, points.size(), [&](std::size_t i) { bsp[i] = trees.bsp.locate(points[i]); }),
            time_of_points(arguments, points.size(), [&](std::size_t i) { msp[i] = trees.msp.locate(points[i]); })};
  for (std::size_t i = 0; i < points.size(); ++i) {
    row.inside += own[i].side == Side::inside ? 1U : 0U;
    row.on_surface += own[i].side == Side::boundary ? 1U : 0U;
    const bool agree = bsp[i].side == own[i].side && bsp[i].winding_number == own[i].winding_number &&
                       msp[i].side == own[i].side && msp[i].winding_number == own[i].winding_number &&
                       msp[i].triangle == bsp[i].triangle;
    row.wrong += agree && is_named_rightly(msp[i], trees.model.mesh(), points[i]) ? 0U : 1U;
  }
  return row;
}

nlohmann::ordered_json json_of(const PointTree& tree) {
  return {{"tree", tree.name},     {"build_s", tree.build_s}, {"nodes", tree.nodes},
          {"growth", tree.growth}, {"depth", tree.depth},     {"bytes", tree.bytes}};
}

nlohmann::ordered_json json_of(const PointRow& row) {
  return {{"points", row.where},  {"mesh_us", row.us[0]},         {"bsp_us", row.us[1]}, {"msp_us", row.us[2]},
          {"inside", row.inside}, {"on_surface", row.on_surface}, {"wrong", row.wrong}};
}

void print_points(const PointTrees& trees, const std::vector<PointRow>& rows) {
  fmt::print("{} triangles\n{:<20}{:>12}{:>12}{:>10}{:>8}{:>10}\n", trees.model.mesh().triangle_count(), "tree",
             "build, s", "nodes", "growth", "depth", "MB");
  for (const PointTree& tree : trees.costs)
    fmt::print("{:<20}{:>12.3f}{:>12}{:>10.2f}{:>8}{:>10.1f}\n", tree.name, tree.build_s, tree.nodes, tree.growth,
               tree.depth, 1e-6 * static_cast<double>(tree.bytes));
  fmt::print("{:<20}{:>12}{:>12}{:>10}{:>8}{:>10}{:>8}\n", "points, in us", "mesh's own", "BSP", "MSP", "inside",
             "on it", "wrong");
  for (const PointRow& row : rows)
    fmt::print("{:<20}{:>12.2f}{:>12.2f}{:>10.2f}{:>8}{:>10}{:>8}\n", row.where, row.us[0], row.us[1], row.us[2],
               row.inside, row.on_surface, row.wrong);
}

}  // namespace

int run_partition_points(const PartitionsArguments& arguments) {
  const PointTrees trees = built_trees(arguments.mesh, arguments.clock == "thread" ? Clock::thread : Clock::wall);
  PointKinds kinds(trees.model, arguments);
  const std::vector<PointRow> rows = {row_of("in the box", kinds.in_box(), trees, arguments),
                                      row_of("vertices", kinds.vertices(), trees, arguments),
                                      row_of("middles of edges", kinds.middles_of_edges(), trees, arguments),
                                      row_of("middles of faces", kinds.middles_of_faces(), trees, arguments)};
  const bool is_wrong = std::any_of(rows.begin(), rows.end(), [](const PointRow& row) { return row.wrong > 0; });
  if (!arguments.json) {
    print_points(trees, rows);
    return is_wrong ? 1 : 0;
  }
  nlohmann::ordered_json report = report_of("partitions", {{"mesh", arguments.mesh},
                                                           {"triangles", trees.model.mesh().triangle_count()},
                                                           {"task", arguments.task},
                                                           {"queries", arguments.queries},
                                                           {"seed", arguments.seed},
                                                           {"clock", arguments.clock},
                                                           {"rounds", arguments.rounds}});
  for (const PointTree& tree : trees.costs) report["trees"].push_back(json_of(tree));
  for (const PointRow& row : rows) report["results"].push_back(json_of(row));
  fmt::print("{}\n", report.dump(2));
  return is_wrong ? 1 : 0;
}

}  // namespace toccata::bench
