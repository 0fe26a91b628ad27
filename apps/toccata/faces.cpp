#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>

#include "arguments.hpp"
#include "ask.hpp"
#include "case_asked.hpp"
#include "check_input.hpp"
#include "load.hpp"
#include "option_kinds.hpp"
#include "subcommands.hpp"
#include "table_names.hpp"
#include "toccata/core/error.hpp"
#include "view.hpp"
#include "words.hpp"

namespace toccata::command {
namespace {

struct FacesArguments : PosedArguments {
  std::optional<Region> region;
  std::vector<std::string> box, ball;  ///< as they are written
};

/// One that touches within 10⁻¹² of its size is counted as within, undecided (docs/truth.md).
bool has_quadric(const Shape& shape) {
  const ShapeKind kind = kind_of(shape);
  if (is_quadric(kind)) return true;
  const auto* compound = std::get_if<Compound>(&shape);
  return compound != nullptr && std::any_of(compound->parts().begin(), compound->parts().end(),
                                            [](const CompoundPart& part) { return has_quadric(part.shape); });
}

int run_faces(const FacesArguments& arguments) {
  const bool asks_itself = arguments.region || changes_objects(arguments);
  if (const auto code = answered_case(arguments, {"faces", asks_itself, false, true})) return *code;
  if (!arguments.region)
    throw Error("no region is given: --box X0 Y0 Z0 X1 Y1 Z1, the least corner and the greatest, or --ball X Y Z R");
  require_view(arguments);
  const CheckInput input = read_check_input(arguments);
  const FacesQuestion question{*arguments.region};
  return exit_code_of(answer_to(question, input, arguments, "looking"));
}

}  // namespace

/// The first faces of every object, and how many there are.
std::string table_of(const CheckInput& input, const FacesReport& report) {
  constexpr std::size_t shown = 12;
  const std::vector<std::string> names = table_names(input.loaded.scene.objects);
  std::vector<std::vector<std::string>> rows;
  std::size_t total = 0;
  bool is_exact = true;
  for (const ReportedFaces& of_object : report.found) {
    const std::vector<Index> faces = distinct_faces(of_object.found);
    total += faces.size();
    is_exact = is_exact && (faces.empty() || !has_quadric(input.loaded.scene.objects[of_object.object].shape));
    std::string list;
    for (std::size_t i = 0; i < std::min(shown, faces.size()); ++i)
      list += fmt::format("{}{}", i == 0 ? "" : " ", faces[i]);
    if (faces.size() > shown) list += " … (all with --csv or --json)";
    rows.push_back({names[of_object.object], counted(faces.size(), "face"), list});
  }
  return columns(rows, 2) +
         fmt::format(
             "{} within, decided exactly{}.\n", counted(total, "face"),
             is_exact ? "" : " but of cylinders, cones and ellipsoids: those may be outside by 10⁻¹² of their size");
}

Summary summary_of(const FacesReport& report) {
  return {counted(report.found.size(), "object") + " in the region", !report.found.empty()};
}

Subcommand add_faces(CLI::App& app) {
  const auto arguments = std::make_shared<FacesArguments>();
  CLI::App* faces = app.add_subcommand("faces", "which faces lie in a box or a ball, wholly or in part");
  add_input(*faces, arguments->input, any_files);
  CLI::Option* box = add_numbers(*faces, "--box", arguments->box, "the least corner and the greatest, in the world", 6,
                                 "X0 Y0 Z0 X1 Y1 Z1");
  add_numbers(*faces, "--ball", arguments->ball, "centre and radius", 4, "X Y Z R")->excludes(box);
  add_writing(*faces, *arguments, "docs/reference/faces-report.md");
  faces->footer(
      with_name("Touching counts. Faces are the files' own, from 0.\n\n"
                "Exit code: 0 there is none, 1 there is one, 2 trouble.\n\nExample:\n"
                "  {0} faces part.stl --box 0 0 0  1 1 1\n  {0} faces scene.json --ball 0 0 5 0.25 --csv"));
  return {faces, [arguments] {
            take_words(*arguments);
            if (!arguments->box.empty()) arguments->region = parse_box(arguments->box, "--box");
            if (!arguments->ball.empty()) arguments->region = parse_ball(arguments->ball, "--ball");
            return run_faces(*arguments);
          }};
}

}  // namespace toccata::command
