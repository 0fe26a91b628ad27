#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "arguments.hpp"
#include "ask.hpp"
#include "case_asked.hpp"
#include "check_input.hpp"
#include "clearance.hpp"
#include "mesh_output.hpp"
#include "number_checks.hpp"
#include "option_kinds.hpp"
#include "output.hpp"
#include "subcommands.hpp"
#include "toccata/core/error.hpp"
#include "view.hpp"
#include "words.hpp"

namespace toccata::command {
namespace {

struct DecomposeArguments : PosedArguments {
  DecomposeQuestion question;  ///< but for its concavity
  std::string concavity;       ///< a length; empty: 0
  std::string mesh;            ///< a file for the parts that is no GLB; empty: none
};

std::string percent_text(const ConvexParts& parts) {
  if (!std::isfinite(parts.hull_volume) || parts.mesh_volume == 0) return "";
  return fmt::format(" ({:.2f} % more)", 100 * (parts.excess / parts.mesh_volume));
}

/// A volume that doubles cannot hold is said to be so; one that has none is flat.
std::string volume_text(double volume, int digits, bool is_flat) {
  if (std::isinf(volume)) return "more than 1.8e308";
  if (volume == 0 && !is_flat) return "less than 4.9e-324";
  return fmt::format("{:.{}g}", volume, digits);
}

/// A GLB file is written with what was found, by -o as by --glb.
void take_glb(DecomposeArguments& arguments) {
  if (!is_glb(arguments.mesh)) return;
  if (!arguments.glb.empty()) throw Error("-o and --glb both name a GLB file: leave out one of the two");
  arguments.glb = std::exchange(arguments.mesh, {});
  arguments.glb_option = "-o";
}

bool are_flat(const ConvexParts& parts) {
  return std::ranges::all_of(parts.parts, [](const ConvexPart& part) { return part.hull.dimension() < 3; });
}

std::string written_parts(const DecomposeReport& report, const std::string& file) {
  const UninterruptedWriting writing;
  write_parts(report, file);
  return fmt::format("{}: {}.\n", printable(file), counted(report.parts.parts.size(), "convex part"));
}

int run_decompose(const DecomposeArguments& arguments) {
  require_mesh_output(arguments, arguments.mesh);
  const AlsoWritten mesh = [&](const CheckInput&, const SceneAnswer& answer) {
    const auto* report = std::get_if<DecomposeReport>(&answer);
    return arguments.mesh.empty() || report == nullptr ? std::string() : written_parts(*report, arguments.mesh);
  };
  const bool asks_itself =
      changes_objects(arguments) || arguments.question != DecomposeQuestion{} || !arguments.concavity.empty();
  if (const auto code = answered_case(arguments, {"decompose", asks_itself}, mesh)) return *code;
  const CheckInput input = read_check_input(arguments);
  DecomposeQuestion question = arguments.question;
  if (!arguments.concavity.empty())
    question.concavity = read_length("--concavity", arguments.concavity,
                                     length_units(input.loaded.scene, arguments.input), Longest::finite);
  const SceneAnswer answer = answer_to(question, input, arguments, "cutting", mesh);
  const std::size_t parts = std::get<DecomposeReport>(answer).parts.parts.size();
  if (arguments.format == Format::table)
    print_answer(written_lines(target_of(arguments), counted(parts, "convex part")));
  return 0;
}

}  // namespace

std::string table_of(const CheckInput&, const DecomposeReport& report) {
  constexpr std::size_t shown = 12;
  const ConvexParts& parts = report.parts;
  const Scene pieces = parts_scene(report, "");
  std::vector<std::vector<std::string>> rows{{"part", "volume", "vertices", "faces of the mesh", "from the solid"}};
  for (std::size_t i = 0; i < std::min(shown, parts.parts.size()); ++i) {
    const ConvexPart& part = parts.parts[i];
    rows.push_back({printable(pieces.objects[i].name), volume_text(part.volume, 4, part.hull.dimension() < 3),
                    grouped(part.hull.vertex_count()), grouped(part.faces.size()),
                    part.concavity == 0 ? "nowhere" : fmt::format("at most {:.3g}", part.concavity)});
  }
  std::string text = columns(rows, 0);
  if (parts.parts.size() > shown) text += fmt::format("… and {} more (all with --json)\n", parts.parts.size() - shown);
  return text +
         fmt::format("{} with {} in all around a solid of {}{}; no point of them is farther from it than {:.3g}.\n",
                     counted(parts.parts.size(), "convex part"), volume_text(parts.hull_volume, 6, are_flat(parts)),
                     volume_text(parts.mesh_volume, 6, are_flat(parts)), percent_text(parts), parts.concavity);
}

Summary summary_of(const DecomposeReport& report) { return {counted(report.parts.parts.size(), "convex part")}; }

Subcommand add_decompose(CLI::App& app) {
  const auto arguments = std::make_shared<DecomposeArguments>();
  CLI::App* decompose = app.add_subcommand("decompose", "cut a closed mesh into convex parts that contain it");
  add_input(*decompose, arguments->input, "a file with one closed mesh");
  decompose->add_option("--parts", arguments->question.max_parts, "at most so many")
      ->check(whole_number(1, 4096))
      ->capture_default_str();
  add_length(*decompose, "--concavity", arguments->concavity,
             "cut no further where no point of a part is farther than this from the solid: a length in units of "
             "--unit or the scene, or with its own (0.5, 2mm, 0.1in)");
  add_file(*decompose, "-o,--output", arguments->mesh,
           "write the parts: as one mesh file (OBJ and STL with their names, OFF, PLY), or for Blender as GLB", "FILE");
  add_glb(*decompose, *arguments);
  add_pages(*decompose, *arguments);
  add_save_case(*decompose, arguments->save_case);
  add_threads(*decompose, arguments->threads, "parts");
  add_json(*decompose, arguments->format, "write JSON (docs/reference/decompose-report.md)");
  decompose->footer(with_name(
      "Each part is convex, and together they contain the whole solid; how much more they are is told "
      "(docs/methods/convex-decomposition.md).\n\nExit code: 0, or 2 for trouble.\n\n"
      "Example:\n  {0} decompose part.stl -o parts.obj\n  {0} decompose gen:torus --parts 16 --html parts.html"));
  return {decompose, [arguments] {
            take_glb(*arguments);
            return run_decompose(*arguments);
          }};
}

}  // namespace toccata::command
