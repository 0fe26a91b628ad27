#include <fmt/format.h>

#include <algorithm>

#include "answer.hpp"
#include "arguments.hpp"
#include "ask.hpp"
#include "case_asked.hpp"
#include "check_input.hpp"
#include "table_names.hpp"
#include "toccata/core/error.hpp"
#include "view.hpp"
#include "words.hpp"

namespace toccata::command {

/// The first faces of every object, and how many there are.
std::string table_of(const CheckInput& input, const FacesReport& report) {
  constexpr std::size_t shown = 12;
  const std::vector<std::string> names = table_names(input.loaded.scene.objects);
  std::vector<std::vector<std::string>> rows;
  std::size_t total = 0;
  for (const ReportedFaces& of_object : report.found) {
    const std::vector<Index> faces = distinct_faces(of_object.found);
    total += faces.size();
    std::string list;
    for (std::size_t i = 0; i < std::min(shown, faces.size()); ++i)
      list += fmt::format("{}{}", i == 0 ? "" : " ", faces[i]);
    if (faces.size() > shown) list += " … (all with --csv or --json)";
    rows.push_back({names[of_object.object], counted(faces.size(), "face"), list});
  }
  return columns(rows, 2) + fmt::format("{} within, decided exactly.\n", counted(total, "face"));
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

}  // namespace toccata::command
