#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <functional>
#include <string>
#include <vector>

#include "arguments.hpp"
#include "library.hpp"
#include "measure.hpp"
#include "report.hpp"
#include "toccata/core/error.hpp"
#include "toccata/generate/meshes.hpp"
#include "toccata/generate/scenes.hpp"
#include "toccata/methods/cost.hpp"
#include "toccata/narrow/triangle_triangle.hpp"
#include "toccata/query/overlap.hpp"

// Two claims of the second lecture, measured: that the time of a question depends on how near the objects are, and that
// every triangle against every triangle is of use below about a hundred of them.
namespace toccata::bench {
namespace {

using Json = nlohmann::ordered_json;

struct CloseScene {
  std::string name;
  Scene (*at_gap)(double gap);
};

constexpr std::array gaps{1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8};

/// All are free by the gap, times the tube's radius, an edge, or the ball's.
const std::vector<CloseScene>& close_scenes() {
  static const std::vector<CloseScene> scenes{
      {"helices", [](double gap) { return interleaved_helices(gap); }},
      {"boxes", [](double gap) { return fields_of_boxes(gap, 16); }},
      {"shells", [](double gap) { return nested_shells(1 - gap, 1); }},
      {"mould", [](double gap) {
         return inside_negative_image(noise_sphere_mesh({1, 0.3, 3, 1}), {.factor = 1 - gap});
       }}};
  return scenes;
}

CostOptions proximity_options() {
  CostOptions options;
  options.workloads = {CostWorkload::rigid};
  options.volumes = {cost_volume<Aabb>,     cost_volume<Obb>,  cost_volume<Rss>,
                     cost_volume<Kdop<18>>, cost_volume<Ball>, CostVolume::wide};
  options.arities = {2};
  options.methods = {BvhMethod::heuristic};
  options.most_work = 1e12;
  return options;
}

/// A row for each scene, volume and gap. The counts depend on the input alone.
Json rows_of_gaps() {
  Json rows = Json::array();
  for (const CloseScene& scene : close_scenes())
    for (const double gap : gaps) {
      const Scene close = scene.at_gap(gap);
      const SceneObject &a = close.objects[0], &b = close.objects[1];
      const PairQuery query{a.pose, b.pose, Solid::none, Solid::none};
      const bool meet = overlap(Model(*a.mesh()), Model(*b.mesh()), query);
      for (const CostRow& row : measure_costs(*a.mesh(), *b.mesh(), std::span(&query, 1), proximity_options()).rows)
        rows.push_back({{"scene", scene.name},
                        {"triangles", a.mesh()->triangle_count() + b.mesh()->triangle_count()},
                        {"gap", gap},
                        {"volume", name_of(row.volume)},
                        {"N_bv", row.counts.volume_tests},
                        {"N_p", row.counts.items},
                        {"microseconds", 1e-3 * row.measured_ns},
                        {"wrong", meet}});
    }
  return rows;
}

void print_gaps(const Json& rows) {
  fmt::print("| scene, triangles | volume | count |");
  for (const double gap : gaps) fmt::print(" {:g} |", gap);
  fmt::print("\n|---|---|---|");
  for (std::size_t i = 0; i < gaps.size(); ++i) fmt::print("---|");
  fmt::print("\n");
  for (const CloseScene& scene : close_scenes())
    for (const CostVolume volume : proximity_options().volumes)
      for (const std::string what : {"N_bv", "N_p", "microseconds"}) {
        bool first = true;
        for (const Json& row : rows) {
          if (row["scene"] != scene.name || row["volume"] != name_of(volume)) continue;
          if (first) fmt::print("| {}, {} | {} | {} |", scene.name, row["triangles"].get<int>(), name_of(volume), what);
          first = false;
          fmt::print(" {:.3g} |", row[what].get<double>());
        }
        fmt::print("\n");
      }
}

/// Where it stands, each number rounded: some peers take rigid poses alone, and shells are scaled.
TriangleMesh mesh_in_world(const SceneObject& object) {
  const std::shared_ptr<const TriangleMesh> mesh = object.mesh();
  std::vector<Vec3> placed;
  for (const Vec3& v : mesh->vertices()) placed.push_back(transform(object.pose, v));
  return TriangleMesh(std::move(placed), {mesh->triangles().begin(), mesh->triangles().end()});
}

/// A row for each scene, gap, and library that tells a yes or no: microseconds of the thread, the least of the rounds.
/// The truth is no.
Json rows_of_libraries(const ProximityArguments& arguments) {
  Json rows = Json::array();
  for (const CloseScene& scene : close_scenes())
    for (const double gap : gaps) {
      const Scene close = scene.at_gap(gap);
      const TriangleMesh a = mesh_in_world(close.objects[0]), b = mesh_in_world(close.objects[1]);
      for (const auto& library : mesh_libraries(arguments.peers)) {
        if (!library->obstacle(Task::overlap, 1).empty()) continue;
        library->build(a, b);
        const Answered one =
            measure_queries(*library, Task::overlap, {PosePair{}}, {1, arguments.rounds, Clock::thread});
        rows.push_back({{"scene", scene.name},
                        {"triangles", a.triangle_count() + b.triangle_count()},
                        {"gap", gap},
                        {"library", library->description().library},
                        {"variant", library->description().variant},
                        {"microseconds", one.result.median_us},
                        {"wrong", one.answers[0].overlap}});
      }
    }
  return rows;
}

/// Lines of all gaps; a wrong answer has an exclamation mark.
void print_libraries(const Json& rows) {
  fmt::print("\n| scene, triangles | library, µs |");
  for (const double gap : gaps) fmt::print(" {:g} |", gap);
  fmt::print("\n|---|---|");
  for (std::size_t i = 0; i < gaps.size(); ++i) fmt::print("---|");
  std::vector<std::pair<std::string, std::string>> lines;
  for (const Json& row : rows) {
    const std::string place = fmt::format("{}, {}", row["scene"].get<std::string>(), row["triangles"].get<int>()),
                      who = fmt::format("{} {}", row["library"].get<std::string>(), row["variant"].get<std::string>());
    auto line = std::ranges::find_if(lines, [&](const auto& one) { return one.first == place + " | " + who; });
    if (line == lines.end()) line = lines.insert(line, {place + " | " + who, ""});
    line->second += fmt::format(" {:.3g}{} |", row["microseconds"].get<double>(), row["wrong"].get<bool>() ? "!" : "");
  }
  for (const auto& [head, times] : lines) fmt::print("\n| {} |{}", head, times);
  fmt::print("\n");
}

std::vector<Triangle> loose_triangles(const TriangleMesh& mesh) {
  std::vector<Triangle> loose;
  const auto vertices = mesh.vertices();
  for (const auto& [a, b, c] : mesh.triangles()) loose.push_back({{vertices[a], vertices[b], vertices[c]}});
  return loose;
}

/// Every triangle against every triangle: whether any two meet.
bool overlap_by_all_pairs(const TriangleMesh& a, const TriangleMesh& b) {
  const std::vector<Triangle> ours = loose_triangles(a), others = loose_triangles(b);
  return std::any_of(ours.begin(), ours.end(), [&](const Triangle& one) {
    return std::any_of(others.begin(), others.end(), [&](const Triangle& other) { return overlap(one, other); });
  });
}

/// The least of several times, in microseconds.
double least_us(int rounds, const std::function<void()>& work) {
  double least = seconds_of(work, Clock::thread);
  for (int i = 1; i < rounds; ++i) least = std::min(least, seconds_of(work, Clock::thread));
  return 1e6 * least;
}

/// Balls of so many triangles that do not meet though their boxes do, so that no test ends early.
Json rows_of_sizes(const ProximityArguments& arguments) {
  Json rows = Json::array();
  for (const int along : {2, 3, 4, 5, 6, 8, 12, 16, 24, 32, 48}) {
    const TriangleMesh a = uv_sphere_mesh(1, along + 1, along);
    std::vector<Vec3> moved;
    for (const Vec3& v : a.vertices()) moved.push_back(v + Vec3{1.4, 1.4, 0.5});
    const TriangleMesh b(std::move(moved), {a.triangles().begin(), a.triangles().end()});
    const PairQuery as_surfaces{{}, {}, Solid::none, Solid::none};
    const Model model_a(a), model_b(b);
    bool by_all = false, by_built = false, by_kept = false;
    const double all_pairs = least_us(arguments.rounds, [&] { by_all = overlap_by_all_pairs(a, b); });
    const double built = least_us(arguments.rounds, [&] { by_built = overlap(Model(a), Model(b), as_surfaces); });
    const double kept = least_us(arguments.rounds, [&] { by_kept = overlap(model_a, model_b, as_surfaces); });
    rows.push_back({{"triangles", a.triangle_count()},
                    {"all_pairs_us", all_pairs},
                    {"built_us", built},
                    {"kept_us", kept},
                    {"meet", by_all},
                    {"wrong", by_built != by_all || by_kept != by_all}});
  }
  return rows;
}

void print_sizes(const Json& rows) {
  fmt::print(
      "| triangles of each | every pair µs | trees, with building them µs | trees that are there µs "
      "|\n|---|---|---|---|\n");
  for (const Json& row : rows)
    fmt::print("| {} | {:.3g} | {:.3g} | {:.3g} |\n", row["triangles"].get<int>(), row["all_pairs_us"].get<double>(),
               row["built_us"].get<double>(), row["kept_us"].get<double>());
}

}  // namespace

int run_proximity(const ProximityArguments& arguments) {
  const bool of_gaps = arguments.task == "gap";
  if (!of_gaps && !arguments.peers.empty()) throw Error("proximity: peers are asked with --task gap");
  const Json rows = of_gaps ? rows_of_gaps() : rows_of_sizes(arguments);
  const Json libraries = of_gaps ? rows_of_libraries(arguments) : Json::array();
  const auto is_wrong = [](const Json& row) {
    return row["wrong"].get<bool>() && (!row.contains("library") || row["library"] == "toccata");
  };
  if (arguments.json) {
    Json report = report_of("proximity", {{"task", arguments.task}, {"rounds", arguments.rounds}});
    report["results"] = rows;
    if (of_gaps) report["libraries"] = libraries;
    fmt::print("{}\n", report.dump(2));
  } else if (of_gaps) {
    print_gaps(rows);
    print_libraries(libraries);
  } else {
    print_sizes(rows);
  }
  return std::ranges::any_of(rows, is_wrong) || std::ranges::any_of(libraries, is_wrong) ? 1 : 0;
}

}  // namespace toccata::bench
