#include <fmt/format.h>

#include <algorithm>

#include "arguments.hpp"
#include "check_input.hpp"
#include "output.hpp"
#include "toccata/core/error.hpp"
#include "toccata/io/faces_report.hpp"
#include "words.hpp"

namespace toccata::command {
namespace {

std::vector<ReportedFaces> faces_of(const CheckInput& input, const Region& region) {
  std::vector<ReportedFaces> found;
  Workspace workspace;
  for (std::size_t i = 0; i < input.models.size(); ++i) {
    const Posed& posed = input.models[i];
    const auto here = asked_of(posed.name, [&] { return faces_within(region, posed.model, posed.pose, workspace); });
    if (!here.empty()) found.push_back({static_cast<Index>(i), {here.begin(), here.end()}});
  }
  return found;
}

/// The first faces of every object, and how many there are.
std::string faces_table(const CheckInput& input, const std::vector<ReportedFaces>& found) {
  constexpr std::size_t shown = 12;
  std::vector<std::vector<std::string>> rows;
  std::size_t total = 0;
  for (const ReportedFaces& of_object : found) {
    const std::vector<Index> faces = distinct_faces(of_object.found);
    total += faces.size();
    std::string list;
    for (std::size_t i = 0; i < std::min(shown, faces.size()); ++i)
      list += fmt::format("{}{}", i == 0 ? "" : " ", faces[i]);
    if (faces.size() > shown) list += " … (all with --csv or --json)";
    rows.push_back({printable(input.models[of_object.object].name), counted(faces.size(), "face"), list});
  }
  return columns(rows, 2) + fmt::format("{} within, decided exactly.\n", counted(total, "face"));
}

std::string text_of(const CheckInput& input, const Region& region, const std::vector<ReportedFaces>& found,
                    Format format) {
  const LoadedScene& loaded = input.loaded;
  if (format == Format::json) return faces_report_json(loaded.scene, input.models, region, found, loaded.warnings);
  return format == Format::csv ? faces_report_csv(loaded.scene, found) : faces_table(input, found);
}

}  // namespace

int run_faces(const FacesArguments& arguments) {
  if (!arguments.region)
    throw Error("no region is given: --box X0 Y0 Z0 X1 Y1 Z1, the least corner and the greatest, or --ball X Y Z R");
  const CheckInput input = read_check_input(arguments);
  const std::vector<ReportedFaces> found = faces_of(input, *arguments.region);
  const std::string text = text_of(input, *arguments.region, found, arguments.format);
  print_warnings(input.loaded.warnings);
  print_answer(text);
  return found.empty() ? 0 : 1;
}

}  // namespace toccata::command
