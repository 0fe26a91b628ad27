#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <optional>

#include "arguments.hpp"
#include "measure.hpp"
#include "report.hpp"
#include "toccata/core/random.hpp"
#include "toccata/generate/meshes.hpp"
#include "toccata/motion/deforming_mesh.hpp"

namespace toccata::bench {
namespace {

/// A cloth of cells × cells squares that lies folded over itself, wrinkled, and what it does in one step: the upper
/// layer sinks, and near one place it reaches the lower. Lengths are in cells.
struct FoldedCloth {
  explicit FoldedCloth(int squares) : cells(squares) {}

  [[nodiscard]] TriangleMesh mesh() const {
    const TriangleMesh flat = height_field_mesh({.cells_x = cells, .cells_y = cells, .cell = 1, .height = 0});
    std::vector<Vec3> vertices;
    for (const Vec3& v : flat.vertices()) vertices.push_back(place(v.x + 0.5 * cells, v.y + 0.5 * cells));
    return flat.with_vertices(std::move(vertices));
  }

  /// Where the vertices go from where they are, another way for each frame.
  [[nodiscard]] std::vector<Vec3> end(std::span<const Vec3> start, int frame) const {
    Random random(static_cast<std::uint64_t>(frame) + 1);
    std::vector<Vec3> end(start.begin(), start.end());
    for (Vec3& v : end) {
      const double x = v.x - 0.25 * cells, y = v.y - 0.5 * cells, dent = std::exp(-0.05 * (x * x + y * y));
      const bool is_above = v.z > radius;
      v += Vec3{random.between(-0.1, 0.1), random.between(-0.1, 0.1), is_above ? -0.5 - 3.5 * dent : 0};
    }
    return end;
  }

  /// Along x a line that turns back in a half circle.
  [[nodiscard]] Vec3 place(double x, double y) const {
    const double half = 0.5 * (cells - bend), wrinkle = 0.3 * std::sin(0.7 * x) * std::cos(0.5 * y);
    if (x < half) return {half - x, y, wrinkle};
    if (x > half + bend) return {x - half - bend, y, 2 * radius + wrinkle};
    const double angle = (x - half) / radius;
    return {-radius * std::sin(angle), y, radius - radius * std::cos(angle) + wrinkle * std::cos(angle)};
  }

  static constexpr double radius = 1.75;
  static constexpr double bend = 3.14159265358979 * radius;  ///< the length of the half circle
  int cells;
};

struct DeformingRow {
  std::size_t triangles = 0;
  int threads = 1;
  double build_ms = 0;
  double refit_ms = 0;
  double impacts_ms = 0;
  double free_steps_ms = 0;
  std::size_t impacts = 0;
  bool same = true;  ///< as on one thread

  [[nodiscard]] double step_ms() const { return refit_ms + impacts_ms; }
};

double least_ms(int rounds, const std::function<void()>& work) {
  double least = HUGE_VAL;
  for (int round = 0; round < rounds; ++round) least = std::min(least, 1e3 * seconds_of(work));
  return least;
}

DeformingRow measured(int cells, int threads, int rounds) {
  const FoldedCloth cloth(cells);
  const TriangleMesh mesh = cloth.mesh();
  const std::vector<Vec3> end = cloth.end(mesh.vertices(), 1);
  DeformingRow row;
  row.threads = threads;
  row.triangles = mesh.triangle_count();
  row.build_ms = 1e3 * seconds_of([&] { static_cast<void>(DeformingMesh(mesh, end, threads)); });
  DeformingMesh moving(mesh, cloth.end(mesh.vertices(), 0), threads);
  row.refit_ms = least_ms(rounds, [&] { static_cast<void>(moving.move_to(end, threads)); });
  const ImpactOptions options{.threads = threads};
  std::vector<MeshImpact> found;
  row.impacts_ms = least_ms(rounds, [&] { found = impacts(moving, options); });
  row.impacts = found.size();
  row.free_steps_ms = least_ms(rounds, [&] { static_cast<void>(free_steps(moving, options)); });
  row.same = found == impacts(DeformingMesh(mesh, end));
  return row;
}

nlohmann::ordered_json json_of(const DeformingRow& row) {
  return {{"triangles", row.triangles},         {"threads", row.threads},       {"build_ms", row.build_ms},
          {"refit_ms", row.refit_ms},           {"impacts_ms", row.impacts_ms}, {"step_ms", row.step_ms()},
          {"free_steps_ms", row.free_steps_ms}, {"impacts", row.impacts},       {"same", row.same}};
}

/// The exponent with which the time of a step grows from the smallest cloth to the largest.
double growth_exponent(const DeformingRow& least, const DeformingRow& greatest) {
  return std::log(greatest.step_ms() / least.step_ms()) /
         std::log(static_cast<double>(greatest.triangles) / static_cast<double>(least.triangles));
}

/// Two balls that fly through each other: all that meets is many thousand pairs, the first of which is soon found.
struct PassingRow {
  std::size_t triangles = 0;  ///< of each
  double separation = 0;
  double all_ms = 0;
  double first_ms = 0;
  double free_step_ms = 0;
  std::size_t impacts = 0;
  bool same = true;  ///< the first is the first of all, and the free step ends there
};

PassingRow passing(int subdivisions, double separation, int rounds) {
  const TriangleMesh ball = icosphere_mesh(1, subdivisions);
  const auto flying = [&](double from, double to) {
    std::vector<Vec3> start(ball.vertices().begin(), ball.vertices().end()), end = start;
    for (Vec3& v : start) v.x += from;
    for (Vec3& v : end) v.x += to;
    return DeformingMesh(ball.with_vertices(std::move(start)), end);
  };
  const DeformingMesh a = flying(-3, 3), b = flying(0.25, -0.25);
  const ImpactOptions options{.separation = separation};
  PassingRow row{.triangles = ball.triangle_count(), .separation = separation};
  std::vector<MeshImpact> all;
  std::optional<MeshImpact> first;
  FreeStep free;
  row.all_ms = least_ms(1, [&] { all = impacts(a, b, options); });
  row.first_ms = least_ms(rounds, [&] { first = first_impact(a, b, options); });
  row.free_step_ms = least_ms(rounds, [&] { free = free_step(a, b, options); });
  row.impacts = all.size();
  row.same = !all.empty() && first == all.front() && free.limited_by == first;
  return row;
}

std::vector<PassingRow> all_passing(const DeformingArguments& arguments) {
  std::vector<PassingRow> rows;
  for (int subdivisions = 3; 20ULL << (2 * subdivisions) <= std::min<std::size_t>(arguments.most, 25'000);
       ++subdivisions)
    for (const double separation : {0.0, 1e-3}) rows.push_back(passing(subdivisions, separation, arguments.rounds));
  return rows;
}

nlohmann::ordered_json json_of(const PassingRow& row) {
  return {{"triangles", row.triangles},
          {"separation", row.separation},
          {"all_ms", row.all_ms},
          {"first_ms", row.first_ms},
          {"free_step_ms", row.free_step_ms},
          {"impacts", row.impacts},
          {"same", row.same}};
}

void print(const std::vector<PassingRow>& rows) {
  std::cout << "\ntwo balls pass through each other\n"
               "triangles  separation     all ms   first ms  free step ms   impacts   same\n";
  for (const PassingRow& row : rows)
    std::cout << fmt::format("{:>9} {:>11} {:>10.1f} {:>10.2f} {:>13.2f} {:>9}   {}\n", row.triangles, row.separation,
                             row.all_ms, row.first_ms, row.free_step_ms, row.impacts, row.same ? "yes" : "NO");
}

void print(const std::vector<DeformingRow>& rows) {
  std::cout << "triangles  threads   build ms   refit ms  impacts ms   step ms  free steps ms   impacts   same\n";
  for (const DeformingRow& row : rows)
    std::cout << fmt::format("{:>9} {:>8} {:>10.2f} {:>10.2f} {:>11.2f} {:>9.2f} {:>14.2f} {:>9}   {}\n", row.triangles,
                             row.threads, row.build_ms, row.refit_ms, row.impacts_ms, row.step_ms(), row.free_steps_ms,
                             row.impacts, row.same ? "yes" : "NO");
}

}  // namespace

int run_deforming(const DeformingArguments& arguments) {
  auto report = report_of("deforming", {{"rounds", arguments.rounds}, {"most", arguments.most}});
  std::vector<DeformingRow> rows;
  bool are_same = true;
  for (const int threads : arguments.threads) {
    const std::size_t first = rows.size();
    for (int cells = 23; 2 * cells * cells <= 1.05 * static_cast<double>(arguments.most); cells = cells * 17783 / 10000)
      rows.push_back(measured(cells, threads, arguments.rounds));
    const double exponent = growth_exponent(rows[first], rows.back());
    report["growth"].push_back({{"threads", threads}, {"exponent", exponent}});
    if (!arguments.json)
      std::cout << fmt::format("{} threads: time grows as triangles to the {:.2f}\n", threads, exponent);
  }
  for (const DeformingRow& row : rows) {
    report["results"].push_back(json_of(row));
    are_same = are_same && row.same && row.impacts > 0;
  }
  const std::vector<PassingRow> balls = all_passing(arguments);
  for (const PassingRow& row : balls) {
    report["passing"].push_back(json_of(row));
    are_same = are_same && row.same;
  }
  if (arguments.json) {
    std::cout << report.dump(2) << "\n";
  } else {
    print(rows);
    print(balls);
  }
  return are_same ? 0 : 1;
}

}  // namespace toccata::bench
