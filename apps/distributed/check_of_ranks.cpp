// mpirun -np N toccata-check-ranks FILE…: what `toccata check FILE…` tells, of scenes that no rank
// has all of. A program of its own, so that the command needs no MPI.
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <mpi.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "case_asked.hpp"
#include "check_command.hpp"
#include "check_input.hpp"
#include "check_table.hpp"
#include "distributed/ranks.hpp"
#include "distributed/wanted_of_scene.hpp"
#include "io/formats/tree_bytes.hpp"
#include "memory.hpp"
#include "named_files.hpp"
#include "number_checks.hpp"
#include "option_kinds.hpp"
#include "output.hpp"
#include "reports/questions/found_report.hpp"
#include "reports/questions/question_kinds.hpp"
#include "reports/report_parts.hpp"
#include "run_ranks.hpp"
#include "saved.hpp"
#include "toccata/core/error.hpp"
#include "toccata/distributed.hpp"
#include "toccata/reports/scene_question.hpp"
#include "told_part.hpp"
#include "view.hpp"

namespace toccata::command {
namespace {

/// What is asked over ranks, in the words of `check`.
struct Arguments : CheckCommand {
  bool costs = false;
  double patience_seconds = 1800;  ///< for what other ranks read and decide
};

/// Throws Error on all ranks where what one of them read is another than on rank 0.
void require_same(Ranks& ranks, std::string_view own, const char* what) {
  MessageWriter writer;
  writer.put(io::checksum_of(own));
  if (const std::optional<std::ptrdiff_t> other = ranks.unlike_first(writer.take()))
    throw Error(
        fmt::format("rank {} has other {} than rank 0: all ranks read them, so they have to be the same on all "
                    "machines, and not from standard input, which rank 0 alone has",
                    *other, what));
}

/// A file with its models.
struct PartRead {
  ConvertedScene file;
  std::vector<SceneInstance> models;
};

/// What all ranks know of the files.
struct ToldFiles {
  LoadedScene loaded;                ///< shapes are not the objects' own (ToldPart)
  std::vector<ToldObject> objects;   ///< of all files
  std::vector<SceneInstance> named;  ///< of which names and groups are the objects' own
};

std::map<std::size_t, ToldPart> parts_in(std::span<const Bytes> messages) {
  std::map<std::size_t, ToldPart> parts;
  for (const Bytes& bytes : messages)
    for (MessageReader reader(bytes); !reader.is_at_end();) {
      const auto number = reader.get<std::uint64_t>();
      parts.emplace(number, get_told_part(reader));
    }
  return parts;
}

/// Files over ranks, none of which has all.
class FilesOverRanks {
 public:
  FilesOverRanks(Ranks& ranks, MpiCommunicator all, const Arguments& arguments) : arguments_(arguments) {
    look(ranks, all);
    why_metres_ = command::why_metres(files_);
    if (!why_metres_.empty()) look(ranks, all);
    told_.loaded = joined(arguments_.input, files_);
    for (const SceneObject& object : told_.loaded.scene.objects)
      told_.named.push_back({Model(Point{}), object.pose, object.solid, object.name, object.group});
  }
  FilesOverRanks(const FilesOverRanks&) = delete;
  FilesOverRanks& operator=(const FilesOverRanks&) = delete;

  [[nodiscard]] DistributedScene& scene() { return *scene_; }
  [[nodiscard]] ToldFiles& told() { return told_; }

  /// Reads a file once more.
  [[nodiscard]] PartRead read(std::size_t part) const {
    const std::string& name = arguments_.input.files[part];
    require_memory({std::filesystem::path(name)});
    PartRead read{read_file(name, arguments_.input), {}};
    if (!why_metres_.empty()) make_metres(read.file, name, why_metres_);
    if (arguments_.solid)
      for (SceneObject& object : read.file.scene.objects) object.solid = *arguments_.solid;
    read.models = scene_models(read.file.scene, arguments_.threads);
    return read;
  }

 private:
  /// Every file is read by one rank, which tells the others of it.
  void look(Ranks& ranks, MpiCommunicator all) {
    MessageWriter own;
    telling_ = &own;
    const ReadPart read_and_tell = [this](std::size_t part) {
      PartRead one = read(part);
      if (telling_ != nullptr) {
        telling_->put(std::uint64_t{part});
        put_told_part(*telling_, one.file, one.models);
      }
      return std::move(one.models);
    };
    scene_.emplace(all, arguments_.input.files.size(), read_and_tell, arguments_.patience_seconds);
    telling_ = nullptr;
    files_.clear();
    told_.objects.clear();
    for (auto& [number, part] : parts_in(ranks.of_all(own.take()))) {
      told_.objects.insert(told_.objects.end(), part.objects.begin(), part.objects.end());
      files_.emplace(arguments_.input.files[number], std::move(part.file));
    }
  }

  const Arguments& arguments_;
  std::string why_metres_;            ///< empty: they keep their units
  MessageWriter* telling_ = nullptr;  ///< while they are read for the first time
  std::optional<DistributedScene> scene_;
  std::map<std::string, ConvertedScene> files_;  ///< without their shapes; one that is named twice is here once
  ToldFiles told_;
};

/// The parts of the first open meshes are read once more: what keeps these from being closed is seen in their shapes.
void warn_of_told_meshes(FilesOverRanks& files) {
  ToldFiles& told = files.told();
  std::vector<std::string> open;
  std::vector<SceneInstance> shown;
  PartRead read;
  std::optional<std::size_t> part_read;
  const std::vector<std::size_t>& first_of = told.loaded.first_object;
  for (std::size_t i = 0; i < told.objects.size(); ++i) {
    if (!told.objects[i].is_open) continue;
    open.push_back(told.loaded.scene.objects[i].name);
    if (shown.size() == most_told_open_meshes) continue;
    const auto part = static_cast<std::size_t>(std::ranges::upper_bound(first_of, i) - first_of.begin()) - 1;
    if (part != part_read) read = files.read(part);
    part_read = part;
    shown.push_back(read.models[i - first_of[part]]);
    shown.back().name = open.back();
  }
  if (!open.empty()) warn_of_open_meshes(told.loaded, open, shown);
}

/// With the warnings of one process, in their order; rank 0 prints those that come before the work.
CheckQuestion question_about(FilesOverRanks& files, const Arguments& arguments, bool is_printing) {
  LoadedScene& loaded = files.told().loaded;
  if (is_printing) warn_of_told_meshes(files);
  std::vector<std::string> left_out;
  const DepthOptions depth = depth_options(arguments, left_out);
  if (is_printing) warn_at_once(loaded, left_out);
  return question_of(arguments, loaded, files.told().named, depth);
}

CheckReport report_of(const ToldFiles& told, const CheckQuestion& question, const CheckPairRules& rules,
                      const WantedAnswer& found) {
  const auto placed = [&](Index object) {
    const SceneInstance& one = told.named[object];
    return FormerObject{one.name, one.pose, told.objects[object].box};
  };
  return io::report_on(question, {told.named, rules, placed}, found);
}

std::vector<AskedFile> asked_files(const ToldFiles& told, std::span<const std::string> summaries,
                                   const std::vector<std::string>& names) {
  const std::span<const SceneObject> objects = told.loaded.scene.objects;
  std::vector<AskedFile> files;
  for (std::size_t i = 0; i < names.size(); ++i) {
    const std::size_t first = told.loaded.first_object[i], count = told.loaded.first_object[i + 1] - first;
    files.push_back({names[i], content_digest(objects.subspan(first, count), summaries.subspan(first, count),
                                              told.loaded.units[i])});
  }
  return files;
}

std::string json_of(const ToldFiles& told, const Arguments& arguments, const CheckQuestion& question,
                    const CheckReport& report) {
  std::vector<std::string> summaries;
  for (const ToldObject& object : told.objects) summaries.push_back(object.summary);
  return with_asked(check_report_json(told.loaded.scene, summaries, report, told.loaded.warnings),
                    asked_of(asked_files(told, summaries, arguments.input.files), arguments, question));
}

std::string table_of(const ToldFiles& told, const CheckReport& report) {
  std::vector<TableObject> objects;
  for (const ToldObject& object : told.objects) objects.push_back(object.table);
  return check_table(told.loaded.scene, objects, report) + scaling_line(told.loaded);
}

void print_report(const ToldFiles& told, const Arguments& arguments, const CheckQuestion& question,
                  const CheckReport& report) {
  print_warnings(untold_warnings(told.loaded));
  if (arguments.format == Format::json)
    print_answer(json_of(told, arguments, question, report));
  else
    print_answer(arguments.format == Format::csv ? report_csv(told.loaded.scene, report) : table_of(told, report));
}

/// `bytes_told` are of what ranks tell each other of their files.
void print_costs(const DistributedCheckCosts& own, std::uint64_t bytes_told) {
  int rank = 0, ranks = 1;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  MPI_Comm_size(MPI_COMM_WORLD, &ranks);
  const std::array<double, 4> row{static_cast<double>(own.parts), static_cast<double>(own.elements),
                                  static_cast<double>(own.candidates),
                                  static_cast<double>(own.bytes_sent + bytes_told)};
  std::vector<double> rows(row.size() * static_cast<std::size_t>(ranks));
  MPI_Gather(row.data(), static_cast<int>(row.size()), MPI_DOUBLE, rows.data(), static_cast<int>(row.size()),
             MPI_DOUBLE, 0, MPI_COMM_WORLD);
  if (rank != 0) return;
  fmt::print(stderr, "{:>4}{:>8}{:>12}{:>10}{:>14}\n", "rank", "files", "elements", "pairs", "bytes sent");
  for (std::size_t i = 0; i < static_cast<std::size_t>(ranks); ++i)
    fmt::print(stderr, "{:>4}{:>8}{:>12}{:>10}{:>14}\n", i, rows[4 * i], rows[4 * i + 1], rows[4 * i + 2],
               rows[4 * i + 3]);
}

void require_files(const InputArguments& input) {
  if (input.files.empty()) throw Error("no file was named: name " + input.wanted);
  if (std::ranges::find(input.files, standard_input) != input.files.end())
    throw Error("standard input (-) is there for one process: over ranks name a file");
  if (!input.cache.empty()) throw Error("over ranks no trees are kept: leave out --cache");
  if (names_case(input.files))
    throw Error(fmt::format("{0} holds a question of its own: `toccata check {0}` answers it, in one process",
                            input.files.front()));
  require_use_of_unit(input);
}

/// The exit code, on rank 0.
int check(const Arguments& arguments) {
  require_files(arguments.input);
  require_depths(arguments, arguments.penetration || !arguments.tolerance.empty() || !arguments.rules.files.empty());
  const MpiCommunicator all{MPI_Comm_c2f(MPI_COMM_WORLD)};
  Ranks ranks(all.fortran_handle, arguments.patience_seconds);
  require_same(ranks, fmt::format("{}", fmt::join(arguments.input.files, "\n")), "names of files");
  FilesOverRanks files(ranks, all, arguments);
  DistributedScene& scene = files.scene();
  if (scene.model_count() < 2)
    throw Error(fmt::format("{} in all; a check needs two: name another file or a scene with more objects",
                            scene.model_count() == 1 ? "there is one object" : "there are no objects"));
  const bool is_first = ranks.rank() == 0;
  const CheckQuestion question = question_about(files, arguments, is_first);
  require_same(ranks, io::line_of(io::json_of(SceneQuestion(question))), "rules or another baseline");
  CheckOptions options = check_all_options(question);
  options.threads = arguments.threads;
  const CheckPairRules rules = io::rules_of(question, files.told().named);
  const WantedAnswer found = check_wanted(scene, options, rules);
  if (arguments.costs) print_costs(scene.costs(), ranks.bytes_sent());
  if (!is_first) return 0;
  const CheckReport report = report_of(files.told(), question, rules, found);
  print_report(files.told(), arguments, question, report);
  return code_of(report, arguments.fail_on);
}

/// What one process does alone, and why.
struct LeftToOne {
  const char* why;
  std::vector<const char*> options;
};

const std::vector<LeftToOne>& left_to_one() {
  static const std::vector<LeftToOne> all = {
      {"it takes the shapes of all objects, which no rank has",
       {"--faces", "--self", "--close", "--html", "--png", "--look", "--size", "--up", "--glb", "--junit", "--sarif",
        "--bcf", "--bcf-version", "--overlap-bodies"}},
      {"it asks about two objects, and not about the pairs of a scene", {"--poses", "--pose-a", "--pose-b"}},
      {"all ranks are heard before anything is told", {"--stream", "--stop-after"}},
      {"each rank reads its own part", {"--save-case"}},
  };
  return all;
}

/// Options of `check` that are known here, to be refused with the reason.
void add_refusals(CLI::App& app) {
  for (const LeftToOne& some : left_to_one())
    for (const char* option : some.options) {
      const auto refuse = [option, why = some.why](const CLI::results_t&) -> bool {
        throw CLI::ValidationError(
            fmt::format("{} is for one process: {}; leave it out, or leave out --distributed", option, why));
      };
      app.add_option(option, refuse)->expected(0, CLI::detail::expected_max_vector_size)->group("");
    }
}

void add_options(CLI::App& app, Arguments& arguments) {
  add_input(app, arguments.input, any_files);
  app.get_option("--cache")->group("");  // it is refused
  add_solid(app, arguments);
  add_pair_questions(app, arguments);
  add_rules_of_clashes(app, arguments);
  add_order(app, arguments);
  add_formats(app, arguments.format, "docs/reference/check-report.md");
  app.add_option("--threads", arguments.threads, "of each rank; 0: all that the machine has")
      ->check(whole_number(0, 1024))
      ->capture_default_str();
  app.add_flag("--costs", arguments.costs, "what each rank had to read and to decide, on the standard error");
  app.add_option("--patience", arguments.patience_seconds,
                 "seconds after which ranks that wait for another end with an error")
      ->check(number_above_0())
      ->type_name("SECONDS")
      ->capture_default_str();
  add_refusals(app);
}

int main_of(int count, char** words) {
  Arguments arguments;
  arguments.threads = own_thread;
  CLI::App app(
      "Which objects touch, decided exactly: to the byte what `toccata check` writes with the same words. Each rank of "
      "mpirun reads the files that its pairs are in, and no other.");
  add_options(app, arguments);
  app.footer(
      "Exit code: 0 nothing touches or is nearer than its clearance, 1 something is (--fail-on says what counts), 2 "
      "trouble.");
  if (const std::optional<int> code = end_by_words(app, count, words)) return *code;
  take_words(arguments);
  take_choices(arguments);
  return check(arguments);
}

}  // namespace
}  // namespace toccata::command

int main(int count, char** words) {
  return toccata::run_ranks(count, words, "toccata-check-ranks",
                            [&] { return toccata::command::main_of(count, words); });
}
