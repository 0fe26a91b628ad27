#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "arguments.hpp"
#include "float_mesh.hpp"
#include "nearest.hpp"
#include "oracle/convex.hpp"
#include "report.hpp"
#include "single_mesh.hpp"
#include "toccata/bounds/aabb.hpp"

namespace toccata::bench {
namespace {

constexpr std::size_t nearest_block = 100;

double diagonal_of(const Aabb& box) {
  const Vec3 size = box.upper - box.lower;
  return std::sqrt(dot(size, size));
}

/// Two diagonals away from the middle of the mesh's box.
Vec3 far_point(const Aabb& box, Random& random) {
  return 0.5 * (box.lower + box.upper) + 2 * diagonal_of(box) * random_direction(random);
}

/// Off a random triangle by up to 1 % of the diagonal.
Vec3 near_point(const TriangleMesh& mesh, const Aabb& box, Random& random) {
  const auto& corner = mesh.triangles()[random.below(mesh.triangle_count())];
  const Vec3 a = mesh.vertices()[corner[0]], u = mesh.vertices()[corner[1]] - a, v = mesh.vertices()[corner[2]] - a;
  const double s = random.unit(), t = random.unit() * (1 - s);
  const double off = random.between(0, 0.01 * diagonal_of(box));
  return a + s * u + t * v + off * random_direction(random);
}

std::vector<Vec3> points_asked(const TriangleMesh& mesh, const NearestArguments& arguments) {
  const Aabb box = fit_aabb(mesh.vertices());
  Random random(arguments.seed);
  std::vector<Vec3> points;
  while (points.size() < arguments.count)
    points.push_back(as_floats(arguments.where == "far" ? far_point(box, random) : near_point(mesh, box, random)));
  return points;
}

struct MeasuredNearest {
  Result result;
  std::vector<double> distances;
  double tolerance = 0;
};

MeasuredNearest measured(NearestLibrary& library, const TriangleMesh& mesh, std::span<const Vec3> points, int rounds) {
  MeasuredNearest one;
  one.tolerance = library.tolerance();
  one.result.build_ms = 1e3 * seconds_of([&] { library.prepare(mesh); });
  one.distances.resize(points.size());
  const auto ask = [&](std::size_t first, auto distances) {
    library.answer(points.subspan(first, distances.size()), distances);
  };
  summarise(fastest_of_blocks(std::span(one.distances), nearest_block, rounds, Clock::wall, ask), one.result);
  one.result.who = library.description();
  one.result.task = "nearest-point";
  one.result.queries = points.size();
  return one;
}

/// Every triangle in rationals.
double truth(const TriangleMesh& mesh, const Vec3& point) {
  const auto p = oracle::point_set(point);
  std::optional<oracle::Rational> least;
  for (const auto& corner : mesh.triangles()) {
    const auto& v = mesh.vertices();
    const auto squared = oracle::squared_distance(p, oracle::triangle_set(v[corner[0]], v[corner[1]], v[corner[2]]));
    if (!least || squared < *least) least = squared;
  }
  return least ? std::sqrt(static_cast<double>(*least)) : 0;
}

void judge(const TriangleMesh& mesh, std::span<const Vec3> points, bool all, std::vector<MeasuredNearest>& measured) {
  const double size = diagonal_of(fit_aabb(mesh.vertices()));
  const auto agree = [&](double a, double b, double tolerance) {
    return std::fabs(a - b) <= tolerance * (size + std::max(a, b));
  };
  for (std::size_t i = 0; i < points.size(); ++i) {
    bool differ = false;
    for (MeasuredNearest& one : measured)
      if (!agree(one.distances[i], measured.front().distances[i], one.tolerance)) {
        differ = true;
        ++one.result.disagreements;
      }
    if (differ) ++measured.front().result.disagreements;
    if (!differ && !all) continue;
    const double right = truth(mesh, points[i]);
    for (MeasuredNearest& one : measured)
      if (!agree(one.distances[i], right, one.tolerance)) ++one.result.wrong;
  }
}

NearestLibraries libraries_asked(const NearestArguments& arguments) {
  NearestLibraries libraries = toccata_nearest_libraries();
  for (const std::string& peer : arguments.peers)
    for (auto& library : peer == "embree" ? embree_nearest_libraries() : cgal_nearest_libraries())
      libraries.push_back(std::move(library));
  return libraries;
}

}  // namespace

int run_nearest(const NearestArguments& arguments) {
  NearestLibraries libraries = libraries_asked(arguments);
  const TriangleMesh mesh = of_floats(*single_mesh(arguments.mesh));
  const std::vector<Vec3> points = points_asked(mesh, arguments);
  std::vector<MeasuredNearest> all;
  for (auto& library : libraries) {
    all.push_back(measured(*library, mesh, points, arguments.rounds));
    library.reset();
  }
  judge(mesh, points, arguments.verify, all);
  Measurements measurements;
  for (const MeasuredNearest& one : all) measurements.results.push_back(one.result);
  auto report = report_of("nearest", {{"mesh", arguments.mesh},
                                      {"triangles", mesh.triangle_count()},
                                      {"where", arguments.where},
                                      {"seed", arguments.seed},
                                      {"block", nearest_block},
                                      {"rounds", arguments.rounds}});
  return print_results(std::move(report), measurements, arguments.json);
}

}  // namespace toccata::bench
