#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "arguments.hpp"
#include "refits.hpp"
#include "report.hpp"
#include "single_mesh.hpp"
#include "toccata/bounds/aabb.hpp"
#include "toccata/core/error.hpp"
#include "toccata/core/random.hpp"
#include "toccata/query/distance.hpp"

namespace toccata::bench {
namespace {

constexpr std::size_t probe_count = 200;

/// The mesh as a jelly: waves of 2 % of its size run through it. Its coordinates are floats, which is what some peers
/// take.
TriangleMesh frame_of(const TriangleMesh& mesh, int frame) {
  const Aabb box = fit_aabb(mesh.vertices());
  const Vec3 size = box.upper - box.lower;
  const double length = std::max({size.x, size.y, size.z}), height = 0.02 * length;
  const auto wave = [&](double along) { return height * std::sin(20 * along / length + frame); };
  std::vector<Vec3> vertices;
  for (const Vec3& v : mesh.vertices())
    vertices.push_back({static_cast<float>(v.x + wave(v.y)), static_cast<float>(v.y + wave(v.z)),
                        static_cast<float>(v.z + wave(v.x))});
  return mesh.with_vertices(std::move(vertices));
}

Probes probes_at(const TriangleMesh& mesh, std::uint64_t seed) {
  const Aabb box = fit_aabb(mesh.vertices());
  Random random(seed);
  const auto point = [&] {
    Vec3 p;
    for (int axis = 0; axis < 3; ++axis) p[axis] = static_cast<float>(random.between(box.lower[axis], box.upper[axis]));
    return p;
  };
  const Vec3 size = box.upper - box.lower;
  Probes probes;
  while (probes.segments.size() < probe_count) {
    probes.segments.emplace_back(point(), point());
    probes.balls.emplace_back(point(), 0.02 * random.unit() * std::sqrt(dot(size, size)));
  }
  return probes;
}

struct MeasuredRefits {
  Result result;
  ProbeAnswers answers;
};

MeasuredRefits measured(RefitLibrary& library, const std::vector<TriangleMesh>& frames, const Probes& probes,
                        int rounds, int threads) {
  MeasuredRefits one;
  one.result.build_ms = 1e3 * seconds_of([&] { library.build(frames.front()); });
  std::vector<double> times;
  for (int round = 0; round < rounds; ++round)
    for (std::size_t i = 1; i < frames.size(); ++i) {
      library.give(frames[i]);
      times.push_back(1e6 * seconds_of([&] { library.refit(); }));
    }
  one.answers = library.answers(probes);
  one.result.queries = times.size();
  summarise(std::move(times), one.result);
  one.result.who = library.description();
  one.result.task = "refit";
  one.result.threads = threads;
  return one;
}

std::size_t differences(const std::vector<bool>& a, const std::vector<bool>& b) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) count += a[i] != b[i] ? 1 : 0;
  return count;
}

/// Toccata's second row is that of the whole model, which answers. All are judged by a model that is built from the
/// last frame.
void judge(const TriangleMesh& last, const Probes& probes, std::vector<MeasuredRefits>& all) {
  auto built = std::move(toccata_refit_libraries(1).back());
  built->build(last);
  const ProbeAnswers right = built->answers(probes);
  const ProbeAnswers deformed = all[1].answers;
  for (MeasuredRefits& one : all) {
    one.result.wrong = differences(one.answers.segments, right.segments) + differences(one.answers.balls, right.balls);
    one.result.disagreements =
        differences(one.answers.segments, deformed.segments) + differences(one.answers.balls, deformed.balls);
  }
}

}  // namespace

int run_refit(const RefitArguments& arguments) {
  RefitLibraries libraries = toccata_refit_libraries(arguments.threads);
  for (const std::string& peer : arguments.peers)
    for (auto& library : peer == "embree" ? embree_refit_libraries(arguments.threads) : fcl_refit_libraries())
      libraries.push_back(std::move(library));
  const auto mesh = single_mesh(arguments.mesh);
  std::vector<TriangleMesh> frames;
  for (int frame = 0; frame < 4; ++frame) frames.push_back(frame_of(*mesh, frame));
  const Probes probes = probes_at(frames.back(), arguments.seed);
  std::vector<MeasuredRefits> all;
  for (auto& library : libraries) {
    all.push_back(measured(*library, frames, probes, arguments.rounds, arguments.threads));
    library.reset();
  }
  judge(frames.back(), probes, all);
  Measurements measurements;
  for (const MeasuredRefits& one : all) measurements.results.push_back(one.result);
  const double millions = 1e-6 * mesh->triangle_count();
  auto report = report_of("refit", {{"mesh", arguments.mesh},
                                    {"triangles", mesh->triangle_count()},
                                    {"seed", arguments.seed},
                                    {"rounds", arguments.rounds},
                                    {"ms_per_million", 1e-3 * measurements.results[0].median_us / millions}});
  return print_results(std::move(report), measurements, arguments.json);
}

}  // namespace toccata::bench
