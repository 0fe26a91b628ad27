// mpirun -np N toccata-check-ranks FILE…: what `toccata check FILE… --csv` tells, of scenes that no rank has all of. A
// program of its own, so that the command needs no MPI.
#include <fmt/format.h>
#include <mpi.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "free_names.hpp"
#include "number_checks.hpp"
#include "run_ranks.hpp"
#include "toccata/core/error.hpp"
#include "toccata/distributed.hpp"
#include "toccata/io/scene_file.hpp"
#include "toccata/reports/scene_question.hpp"

namespace toccata {
namespace {

struct Arguments {
  std::vector<std::string> files;
  double clearance = -1;  ///< below 0: none
  bool penetration = false;
  bool volume = false;
  std::string touching = "count";
  std::string solid = "auto";
  int threads = own_thread;
  bool costs = false;
};

std::vector<SceneInstance> read_part(const std::string& file, const Arguments& arguments) {
  Scene scene = read_scene(file);
  for (SceneObject& object : scene.objects)
    if (arguments.solid != "auto") object.solid = arguments.solid == "all" ? Solid::all : Solid::none;
  return scene_models(scene, arguments.threads);
}

/// The objects by the names that the command gives them: nothing else of them is in lines of values.
Scene named_objects(const DistributedScene& scene, const std::vector<std::string>& files) {
  Scene named;
  FreeNames names;
  std::set<std::string> known;
  for (std::size_t part = 0; part < files.size(); ++part) {
    const bool is_new = known.insert(files[part]).second;
    for (std::size_t i = scene.first_model(part); i < scene.first_model(part + 1); ++i) {
      SceneObject& object = named.objects.emplace_back();
      object.name = names.take(scene.name(i), files[part], is_new);
    }
  }
  return named;
}

void print_costs(const DistributedCheckCosts& own) {
  int rank = 0, ranks = 1;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  MPI_Comm_size(MPI_COMM_WORLD, &ranks);
  const std::array<double, 4> row{static_cast<double>(own.parts), static_cast<double>(own.elements),
                                  static_cast<double>(own.candidates), static_cast<double>(own.bytes_sent)};
  std::vector<double> rows(row.size() * static_cast<std::size_t>(ranks));
  MPI_Gather(row.data(), static_cast<int>(row.size()), MPI_DOUBLE, rows.data(), static_cast<int>(row.size()),
             MPI_DOUBLE, 0, MPI_COMM_WORLD);
  if (rank != 0) return;
  fmt::print(stderr, "{:>4}{:>8}{:>12}{:>10}{:>14}\n", "rank", "files", "elements", "pairs", "bytes sent");
  for (std::size_t i = 0; i < static_cast<std::size_t>(ranks); ++i)
    fmt::print(stderr, "{:>4}{:>8}{:>12}{:>10}{:>14}\n", i, rows[4 * i], rows[4 * i + 1], rows[4 * i + 2],
               rows[4 * i + 3]);
}

/// The exit code, on all ranks.
int check(const Arguments& arguments) {
  DistributedScene scene({MPI_Comm_c2f(MPI_COMM_WORLD)}, arguments.files.size(),
                         [&](std::size_t part) { return read_part(arguments.files[part], arguments); });
  if (scene.model_count() < 2)
    throw Error(fmt::format("{} in all; a check needs two: name another file or a scene with more objects",
                            scene.model_count() == 1 ? "there is one object" : "there are no objects"));
  CheckOptions options;
  options.threads = arguments.threads;
  options.penetration = arguments.penetration;
  options.volume = arguments.volume;
  if (arguments.clearance >= 0) options.clearance = arguments.clearance;
  const CheckAnswer answer = scene.check(options);
  int code = 0;
  if (scene.rank() == 0) {
    CheckQuestion question;
    question.touching = arguments.touching == "ignore" ? Touching::ignore : Touching::count;
    question.penetration = options.penetration;
    question.volume = options.volume;
    question.clearance = options.clearance;
    const CheckReport report = make_check_report({}, answer, question);
    fmt::print("{}", report_csv(named_objects(scene, arguments.files), report));
    code = std::any_of(report.pairs.begin(), report.pairs.end(), is_clash) ? 1 : 0;
  }
  MPI_Bcast(&code, 1, MPI_INT, 0, MPI_COMM_WORLD);
  if (arguments.costs) print_costs(scene.costs());
  return code;
}

int main_of(int count, char** words) {
  Arguments arguments;
  CLI::App app(
      "Which objects touch, decided exactly: as lines of values the bytes that `toccata check --csv` writes. Each rank "
      "of mpirun reads the files that its pairs are in, and no other.");
  app.add_option("files", arguments.files, "meshes or scenes, two or more objects together")->required();
  app.add_option("--clearance", arguments.clearance, "also which are nearer to each other than this, in world units")
      ->check(number_from(0));
  app.add_flag("--penetration", arguments.penetration, "how deep solids overlap");
  app.add_flag("--volume", arguments.volume, "how much volume solids have in common");
  app.add_option("--touching", arguments.touching, "whether pairs that merely touch are told")
      ->check(CLI::IsMember({"count", "ignore"}))
      ->capture_default_str();
  app.add_option("--solid", arguments.solid, "auto: watertight meshes are solids; all, none")
      ->check(CLI::IsMember({"auto", "all", "none"}))
      ->capture_default_str();
  app.add_option("--threads", arguments.threads, "of each rank; 0: all that the machine has")
      ->check(whole_number(0, 1024))
      ->capture_default_str();
  app.add_flag("--costs", arguments.costs, "what each rank had to read and to decide, on the standard error");
  app.footer("Exit code: 0 nothing touches or is nearer than its clearance, 1 something is, 2 trouble.");
  if (const std::optional<int> code = end_by_words(app, count, words)) return *code;
  return check(arguments);
}

}  // namespace
}  // namespace toccata

int main(int count, char** words) {
  return toccata::run_ranks(count, words, "toccata-check-ranks", [&] { return toccata::main_of(count, words); });
}
