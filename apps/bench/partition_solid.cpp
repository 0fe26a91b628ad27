#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <optional>
#include <tuple>

#include "arguments.hpp"
#include "report.hpp"
#include "single_mesh.hpp"
#include "toccata/core/random.hpp"
#include "toccata/methods/bsp_tree.hpp"
#include "toccata/query/casts.hpp"
#include "toccata/query/overlap.hpp"

// A BSP tree beside the mesh's own tree: the same questions about a closed mesh, every answer compared (METHODS B6).
namespace toccata::bench {
namespace {

using Json = nlohmann::ordered_json;

/// A question, in microseconds.
struct SolidRow {
  std::string question;
  double bsp_us = 0;
  double mesh_us = 0;
  std::size_t hits = 0;   ///< of the mesh's own tree
  std::size_t wrong = 0;  ///< answers that differ
};

/// The row of a trace; what is free has to be so.
struct TraceRow {
  std::string question;
  double us = 0;
  std::size_t hits = 0;
  std::size_t false_hits = 0;
  std::size_t wrong = 0;
};

/// A shape at its place, as the two trees want it.
struct PlacedShape {
  template <class S>
  PlacedShape(const S& shape, const Pose& at) : model(shape), pose(at), posed(shape, at) {}

  Model model;
  Pose pose;
  PosedPolytope posed;
};

/// What is asked, about the box of the mesh and a little beyond.
class SolidQuestions {
 public:
  SolidQuestions(const Model& model, const PartitionsArguments& arguments)
      : box_(model.bounds()),
        random_(arguments.seed),
        count_(arguments.queries),
        rounds_(arguments.rounds),
        clock_(arguments.clock == "thread" ? Clock::thread : Clock::wall) {}

  [[nodiscard]] std::vector<Vec3> points() {
    std::vector<Vec3> all;
    while (all.size() < count_) all.push_back(point());
    return all;
  }

  /// Boxes, capsules and balls in turn, of a radius that is this part of the mesh, turned.
  [[nodiscard]] std::vector<PlacedShape> shapes(double part) {
    const Vec3 sides = box_.upper - box_.lower;
    const double size = 0.5 * part * std::max({sides.x, sides.y, sides.z});
    std::vector<PlacedShape> all;
    while (all.size() < count_) {
      const Quaternion turn{random_.between(-1, 1), random_.between(-1, 1), random_.between(-1, 1),
                            random_.between(0.1, 1)};
      const Pose pose = Pose::rigid(turn, point());
      switch (all.size() % 3) {
        case 0:
          all.emplace_back(Box({size, 0.5 * size, 0.5 * size}), pose);
          break;
        case 1:
          all.emplace_back(Capsule({-0.5 * size, 0, 0}, {0.5 * size, 0, 0}, 0.5 * size), pose);
          break;
        default:
          all.emplace_back(Sphere(size), pose);
      }
    }
    return all;
  }

  /// In microseconds a question, in the fastest round.
  [[nodiscard]] double time(const std::function<void(std::size_t)>& ask) const {
    double best = 1e30;
    for (int round = 0; round < rounds_; ++round)
      best = std::min(best, seconds_of(
                                [&] {
                                  for (std::size_t i = 0; i < count_; ++i) ask(i);
                                },
                                clock_));
    return 1e6 * best / static_cast<double>(count_);
  }

  /// Both are asked, and what they answer is compared; `is_hit` tells of the mesh's own answer.
  template <class Answer>
  [[nodiscard]] SolidRow row(const std::string& question, const std::function<Answer(std::size_t)>& of_bsp,
                             const std::function<Answer(std::size_t)>& of_mesh,
                             const std::function<bool(const Answer&)>& is_hit) const {
    std::vector<Answer> bsp(count_), mesh(count_);
    SolidRow result{.question = question};
    result.bsp_us = time([&](std::size_t i) { bsp[i] = of_bsp(i); });
    result.mesh_us = time([&](std::size_t i) { mesh[i] = of_mesh(i); });
    for (std::size_t i = 0; i < count_; ++i) {
      result.hits += is_hit(mesh[i]) ? 1U : 0U;
      result.wrong += bsp[i] == mesh[i] ? 0U : 1U;
    }
    return result;
  }

 private:
  [[nodiscard]] Vec3 point() {
    Vec3 p;
    for (int axis = 0; axis < 3; ++axis)
      p[axis] = box_.lower[axis] + random_.between(-0.1, 1.1) * (box_.upper[axis] - box_.lower[axis]);
    return p;
  }

  Aabb box_;
  Random random_;
  std::size_t count_;
  int rounds_;
  Clock clock_;
};

/// What answers have to have in common, so that they can be compared by ==.
using Met = std::tuple<bool, double, Index>;
template <class Hit>
Met met(const std::optional<Hit>& hit, Index Hit::*element) {
  if (!hit) return {false, 0, 0};
  return {true, hit->upper, hit->upper > 0 ? (*hit).*element : 0};
}
bool is_met(const Met& answer) { return std::get<0>(answer); }
bool is_true(const char& answer) { return answer != 0; }

std::vector<SolidRow> of_points(const BspTree& tree, const Model& model, SolidQuestions& questions) {
  const std::vector<Vec3> from = questions.points(), to = questions.points();
  std::vector<SolidRow> rows;
  rows.push_back(questions.row<char>(
      "a point: inside?", [&](std::size_t i) { return tree.locate(from[i]).side == Side::inside; },
      [&](std::size_t i) { return locate(from[i], model).side == Side::inside; }, is_true));
  rows.push_back(questions.row<Met>(
      "a ray", [&](std::size_t i) { return met(tree.cast_ray(from[i], to[i] - from[i]), &RayHit::element); },
      [&](std::size_t i) { return met(cast_ray(from[i], to[i] - from[i], model), &RayHit::element); }, is_met));
  rows.push_back(questions.row<char>(
      "a segment: met?", [&](std::size_t i) { return tree.overlap(from[i], to[i]); },
      [&](std::size_t i) { return overlap(Segment(from[i], to[i]), model); }, is_true));
  return rows;
}

void of_shapes(const BspTree& tree, const Model& model, SolidQuestions& questions, double part,
               std::vector<SolidRow>& rows, std::vector<TraceRow>& traces) {
  const std::vector<PlacedShape> shapes = questions.shapes(part);
  const std::vector<Vec3> ends = questions.points();
  std::vector<Vec3> motions;
  for (std::size_t i = 0; i < shapes.size(); ++i) motions.push_back(ends[i] - shapes[i].pose.offset);
  const std::string size = fmt::format("of 1/{:g} of the mesh", 1 / part);
  rows.push_back(questions.row<char>(
      "a shape " + size + ": met?", [&](std::size_t i) { return tree.overlap(shapes[i].posed); },
      [&](std::size_t i) { return overlap(shapes[i].model, model, {.pose_a = shapes[i].pose}); }, is_true));
  std::vector<Met> truths(shapes.size());
  rows.push_back(questions.row<Met>(
      "a shape " + size + ", cast",
      [&](std::size_t i) { return met(tree.cast_shape(shapes[i].posed, motions[i]), &ShapeHit::element_b); },
      [&](std::size_t i) {
        const auto hit = cast_shape(shapes[i].model, motions[i], model, {.pose_a = shapes[i].pose});
        return truths[i] = met(hit, &ShapeHit::element_b);
      },
      is_met));
  for (const BspBevels bevels : {BspBevels::none, BspBevels::edges_and_corners}) {
    TraceRow row{.question = size + (bevels == BspBevels::none ? ", traced" : ", traced with bevels")};
    std::vector<std::optional<BspTrace>> found(shapes.size());
    row.us = questions.time([&](std::size_t i) { found[i] = tree.trace(shapes[i].posed, motions[i], bevels); });
    for (std::size_t i = 0; i < shapes.size(); ++i) {
      const auto& [hit, upper, element] = truths[i];
      row.hits += found[i] ? 1U : 0U;
      row.false_hits += found[i] && !hit ? 1U : 0U;
      row.wrong += hit && (!found[i] || found[i]->time > upper) ? 1U : 0U;
    }
    traces.push_back(row);
  }
}

/// In how many boxes of the tree's leaves the middle of a triangle lies, on average: space redundancy.
double boxes_at_a_triangle(const Model& model) {
  const auto& nodes = model.tree().nodes;
  std::size_t count = 0;
  std::vector<Index> waiting;
  for (const auto& corner : model.mesh().triangles()) {
    const auto vertices = model.mesh().vertices();
    const Vec3 middle = (1.0 / 3) * (vertices[corner[0]] + vertices[corner[1]] + vertices[corner[2]]);
    waiting.assign(1, 0);
    while (!waiting.empty()) {
      const auto& node = nodes[waiting.back()];
      waiting.pop_back();
      if (!overlap(node.volume, Aabb{middle, middle})) continue;
      count += node.is_leaf() ? 1U : 0U;
      for (Index child = 0; child < node.child_count && !node.is_leaf(); ++child) waiting.push_back(node.first + child);
    }
  }
  return static_cast<double>(count) / model.mesh().triangle_count();
}

Json json_of(const SolidRow& row) {
  return {{"question", row.question},
          {"bsp_us", row.bsp_us},
          {"mesh_us", row.mesh_us},
          {"hits", row.hits},
          {"wrong", row.wrong}};
}
Json json_of(const TraceRow& row) {
  return {{"question", row.question},
          {"us", row.us},
          {"hits", row.hits},
          {"false_hits", row.false_hits},
          {"wrong", row.wrong}};
}

}  // namespace

int run_partition_solid(const PartitionsArguments& arguments) {
  const Clock clock = arguments.clock == "thread" ? Clock::thread : Clock::wall;
  const std::shared_ptr<const TriangleMesh> mesh = single_mesh(arguments.mesh);
  std::optional<Model> model;
  const double mesh_build = seconds_of([&] { model.emplace(mesh); }, clock);
  std::optional<BspTree> tree;
  const double build = seconds_of([&] { tree.emplace(*model, BspOptions{}); }, clock);
  const BspStatistics& s = tree->statistics();
  const double boxes = boxes_at_a_triangle(*model);
  SolidQuestions questions(*model, arguments);
  std::vector<SolidRow> rows = of_points(*tree, *model, questions);
  std::vector<TraceRow> traces;
  for (const double part : {1.0 / 64, 1.0 / 8}) of_shapes(*tree, *model, questions, part, rows, traces);
  std::size_t wrong = 0;
  for (const SolidRow& row : rows) wrong += row.wrong;
  for (const TraceRow& row : traces) wrong += row.wrong;
  if (arguments.json) {
    Json report = report_of("partitions", {{"mesh", arguments.mesh},
                                           {"triangles", s.triangles},
                                           {"task", arguments.task},
                                           {"queries", arguments.queries},
                                           {"seed", arguments.seed},
                                           {"rounds", arguments.rounds}});
    report["bsp"] = {{"build_s", build}, {"growth", s.growth()},       {"nodes", s.nodes},
                     {"depth", s.depth}, {"mean_depth", s.mean_depth}, {"bytes", s.bytes}};
    report["mesh_tree"] = {{"build_s", mesh_build}, {"boxes_at_a_triangle", boxes}};
    for (const SolidRow& row : rows) report["questions"].push_back(json_of(row));
    for (const TraceRow& row : traces) report["traces"].push_back(json_of(row));
    report["wrong"] = wrong;
    fmt::print("{}\n", report.dump(2));
    return wrong > 0 ? 1U : 0U;
  }
  fmt::print(
      "{} triangles\n  BSP tree: {:.2f} s, {} nodes, depth {} ({:.1f} on average), {:.1f} MB; a triangle is in "
      "{:.2f} cells' planes, a point in one cell\n  mesh's own tree: {:.3f} s; a triangle is in one leaf, the "
      "middle of one in {:.2f} leaves' boxes\n",
      s.triangles, build, s.nodes, s.depth, s.mean_depth, 1e-6 * static_cast<double>(s.bytes), s.growth(), mesh_build,
      boxes);
  fmt::print("{:<44}{:>10}{:>12}{:>8}{:>8}\n", "in us", "BSP", "mesh's own", "hits", "wrong");
  for (const SolidRow& row : rows)
    fmt::print("{:<44}{:>10.2f}{:>12.2f}{:>8}{:>8}\n", row.question, row.bsp_us, row.mesh_us, row.hits, row.wrong);
  fmt::print("{:<44}{:>10}{:>12}{:>8}{:>8}\n", "expanded planes, in us", "BSP", "false hits", "hits", "wrong");
  for (const TraceRow& row : traces)
    fmt::print("{:<44}{:>10.2f}{:>12}{:>8}{:>8}\n", row.question, row.us, row.false_hits, row.hits, row.wrong);
  return wrong > 0 ? 1U : 0U;
}

}  // namespace toccata::bench
