#include <fmt/format.h>

#include <cmath>
#include <fstream>
#include <map>

#include "arguments.hpp"
#include "judge.hpp"
#include "poses.hpp"
#include "report.hpp"
#include "single_mesh.hpp"
#include "toccata/core/error.hpp"
#include "toccata/core/simd.hpp"
#include "toccata/generate/meshes.hpp"

namespace toccata::bench {
namespace {

using SharedMesh = std::shared_ptr<const TriangleMesh>;

constexpr std::size_t standard_queries = 1000;

Task task_of(const std::string& word) {
  static const std::map<std::string, Task> words{{"overlap", Task::overlap},
                                                 {"contacts", Task::contacts},
                                                 {"distance", Task::distance},
                                                 {"coherent-distance", Task::coherent_distance},
                                                 {"build", Task::build}};
  return words.at(word);
}

SimdLevel level_named(const std::string& name) {
  for (const SimdLevel level : {SimdLevel::scalar, SimdLevel::sse4, SimdLevel::avx2, SimdLevel::avx512})
    if (name_of(level) == name) return level;
  throw Error(fmt::format("there is no SIMD level '{}'", name));
}

Clock clock_of(const MeshArguments& arguments) { return arguments.clock == "wall" ? Clock::wall : Clock::thread; }

Nearness nearness_of(const MeshArguments& arguments) {
  if (arguments.gap) return {Nearness::Kind::gap, *arguments.gap};
  if (arguments.near) return {Nearness::Kind::close};
  return {asks_distance(task_of(arguments.task)) ? Nearness::Kind::separated : Nearness::Kind::jittered};
}

std::vector<PosePair> poses_of(const MeshArguments& arguments, const SharedMesh& a, const SharedMesh& b) {
  if (!arguments.poses.empty()) {
    std::vector<PosePair> poses = read_poses(arguments.poses);
    return arguments.random ? moved_together(poses, *arguments.random, arguments.seed) : poses;
  }
  if (task_of(arguments.task) == Task::coherent_distance)
    return poses_on_the_way(Model(a), Model(b), arguments.random.value_or(standard_queries), arguments.seed,
                            {arguments.motion, arguments.gap.value_or(0)});
  return random_poses(Model(a), Model(b), arguments.random.value_or(standard_queries), arguments.seed,
                      nearness_of(arguments), 0);
}

double diagonal_of(const TriangleMesh& mesh) {
  const Aabb box = fit_aabb(mesh.vertices());
  return std::sqrt(dot(box.upper - box.lower, box.upper - box.lower));
}

SharedMesh of_wanted_size(const SharedMesh& b, const TriangleMesh& a, const MeshArguments& arguments) {
  if (arguments.size_b == 0) return b;
  const double factor = arguments.size_b * diagonal_of(a) / diagonal_of(*b);
  if (!(factor > 0) || !std::isfinite(factor)) throw Error("--size-b: one of the meshes has no size");
  return std::make_shared<const TriangleMesh>(scaled_mesh(*b, factor));
}

void require_rigid(const std::vector<PosePair>& poses, const std::string& file) {
  for (std::size_t i = 0; i < poses.size(); ++i)
    if (!are_rigid(poses[i]))
      throw Error(
          fmt::format("{}: pose {} (from 0) is not a rotation and a translation, and peers take no others; "
                      "leave --peer out",
                      file, i));
}

std::string answer_text(Task task, const Answer& answer) {
  if (task == Task::distance) return fmt::format("{}", answer.distance);
  return fmt::format("{}", task == Task::overlap ? std::size_t{answer.overlap} : answer.pairs.size());
}

void write_answers(const std::string& file, Task task, const std::vector<Answer>& answers) {
  std::ofstream stream(file);
  for (std::size_t i = 0; i < answers.size(); ++i) stream << i << ' ' << answer_text(task, answers[i]) << '\n';
  if (!stream.flush()) throw Error(fmt::format("{}: cannot be written", file));
}

struct MeasuredMeshes {
  std::vector<Answered> answered;  ///< Toccata's first
  std::vector<NotMeasured> not_measured;
};

/// Its queries on each number of threads, into `measured`.
void measure_threads(MeshLibrary& library, const MeshArguments& arguments, const std::vector<PosePair>& poses,
                     const Result& build, MeasuredMeshes& measured) {
  const Task task = task_of(arguments.task);
  for (const int threads : arguments.threads) {
    const std::string obstacle = library.obstacle(task, threads);
    if (!obstacle.empty()) {
      measured.not_measured.push_back({build.who, arguments.task, threads, obstacle});
      continue;
    }
    Answered one = measure_queries(library, task, poses, {threads, arguments.rounds, clock_of(arguments)});
    one.result.who = build.who;
    one.result.task = arguments.task;
    one.result.build_ms = build.build_ms;
    one.result.bytes_per_triangle = build.bytes_per_triangle;
    measured.answered.push_back(std::move(one));
  }
}

/// One library after another, each gone before the next is built, so that memory holds one library's trees at a time.
MeasuredMeshes measure_all(MeshLibraries libraries, const MeshArguments& arguments, const SharedMesh& a,
                           const SharedMesh& b, const std::vector<PosePair>& poses) {
  const bool only_build = task_of(arguments.task) == Task::build;
  MeasuredMeshes measured;
  for (auto& library : libraries) {
    if (library != libraries.front() && !library->obstacle(task_of(arguments.task), 1).empty() &&
        library->description().library == "toccata")
      continue;
    Result build = measure_build(*library, *a, *b, {1, only_build ? arguments.rounds : 1, clock_of(arguments)});
    build.task = arguments.task;
    if (only_build)
      measured.answered.push_back({std::move(build), {}});
    else
      measure_threads(*library, arguments, poses, build, measured);
    library.reset();
  }
  return measured;
}

std::string words_for_poses(const MeshArguments& arguments) {
  if (!arguments.poses.empty()) return arguments.poses;
  if (arguments.gap) return fmt::format("random, at a gap of {:g}", *arguments.gap);
  return arguments.near ? "near contact" : "random";
}

nlohmann::ordered_json question_of(const MeshArguments& arguments, const SharedMesh& a, const SharedMesh& b) {
  return {{"mesh_a", arguments.mesh_a},
          {"mesh_b", arguments.mesh_b},
          {"triangles_a", a->triangle_count()},
          {"triangles_b", b->triangle_count()},
          {"size_b", arguments.size_b},
          {"poses", words_for_poses(arguments)},
          {"seed", arguments.seed},
          {"clock", arguments.clock},
          {"rounds", arguments.rounds}};
}

}  // namespace

int run_mesh(const MeshArguments& arguments) {
  if (clock_of(arguments) == Clock::thread && arguments.threads != std::vector<int>{1})
    throw Error("--clock thread tells only what one thread does; leave --threads out");
  if (arguments.gap && !arguments.poses.empty()) throw Error("--gap moves random poses; leave it or --poses out");
  if (arguments.gap && arguments.near) throw Error("--near draws the gaps itself; leave it or --gap out");
  if (task_of(arguments.task) == Task::coherent_distance && arguments.gap.value_or(0) < 0)
    throw Error("--gap: ways are moved apart, so of coherent-distance it is 0 or more");
  if (!arguments.simd.empty()) use_simd_level(level_named(arguments.simd));
  MeshLibraries libraries = mesh_libraries(arguments.peers);
  const SharedMesh a = single_mesh(arguments.mesh_a), b = of_wanted_size(single_mesh(arguments.mesh_b), *a, arguments);
  const Task task = task_of(arguments.task);
  const std::vector<PosePair> poses = task == Task::build ? std::vector<PosePair>{} : poses_of(arguments, a, b);
  if (!arguments.peers.empty()) require_rigid(poses, arguments.poses);
  MeasuredMeshes measured = measure_all(std::move(libraries), arguments, a, b, poses);
  std::vector<Answered>& answered = measured.answered;
  judge({task, *a, *b, poses, arguments.verify ? Judged::all : Judged::differing}, answered);
  if (!arguments.answers.empty()) write_answers(arguments.answers, task, answered.front().answers);
  auto question = question_of(arguments, a, b);
  if (task == Task::coherent_distance) {
    question["motion"] = arguments.motion;
    question["gap"] = arguments.gap.value_or(0);
  }
  question["touching"] = std::count_if(answered[0].answers.begin(), answered[0].answers.end(),
                                       [](const Answer& answer) { return answer.overlap; });
  Measurements measurements{{}, std::move(measured.not_measured)};
  for (const Answered& one : answered) measurements.results.push_back(one.result);
  return print_results(report_of("mesh", std::move(question)), measurements, arguments.json);
}

}  // namespace toccata::bench
