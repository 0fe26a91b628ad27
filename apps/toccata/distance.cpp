#include <fmt/format.h>

#include <algorithm>

#include "arguments.hpp"
#include "check_input.hpp"
#include "output.hpp"
#include "toccata/core/error.hpp"
#include "toccata/core/parallel.hpp"
#include "toccata/io/distance_report.hpp"
#include "words.hpp"

namespace toccata::command {
namespace {

bool in_one_group(const Posed& a, const Posed& b) { return !a.group.empty() && a.group == b.group; }

Distance distance_of(const Posed& a, const Posed& b, Workspace& workspace) {
  try {
    return distance(a.model, b.model, {a.pose, b.pose, a.solid, b.solid}, workspace);
  } catch (const Error& error) {
    throw Error(fmt::format("'{}' (a) and '{}' (b): {}", a.name, b.name, error.what()));
  }
}

/// Of two files, the pairs of one object of each; of one, all pairs. Objects of one group are no pair.
std::vector<ReportedDistance> distances_in(const CheckInput& input, int threads) {
  const std::vector<Posed>& models = input.models;
  const bool two_files = input.loaded.first_object.size() == 3;
  const std::size_t first_end = two_files ? input.loaded.first_object[1] : models.size();
  std::vector<std::vector<ReportedDistance>> of_first(first_end);
  parallel_for(first_end, threads, [&](std::size_t i) {
    Workspace workspace;
    for (std::size_t j = two_files ? first_end : i + 1; j < models.size(); ++j)
      if (!in_one_group(models[i], models[j]))
        of_first[i].push_back(
            {static_cast<Index>(i), static_cast<Index>(j), distance_of(models[i], models[j], workspace)});
  });
  std::vector<ReportedDistance> distances;
  for (const auto& some : of_first) distances.insert(distances.end(), some.begin(), some.end());
  return distances;
}

std::string distance_table(const Scene& scene, const std::vector<ReportedDistance>& distances) {
  std::vector<std::vector<std::string>> rows;
  for (const ReportedDistance& pair : distances) {
    const Distance& d = pair.distance;
    rows.push_back({printable(scene.objects[pair.a].name), printable(scene.objects[pair.b].name), distance_text(d),
                    nearest_text(d)});
  }
  return columns(rows, 2);
}

std::string text_of(const CheckInput& input, const std::vector<ReportedDistance>& distances, Format format) {
  const LoadedScene& loaded = input.loaded;
  if (format == Format::json) return distance_report_json(loaded.scene, input.models, distances, loaded.warnings);
  return format == Format::csv ? distance_report_csv(loaded.scene, distances) : distance_table(loaded.scene, distances);
}

}  // namespace

int run_distance(const DistanceArguments& arguments) {
  if (!arguments.poses.empty()) return run_distance_poses(arguments);
  const CheckInput input = read_check_input(arguments);
  const LoadedScene& loaded = input.loaded;
  if (loaded.scene.objects.size() < 2)
    throw Error(fmt::format("{} holds one object; a distance is between two: name another file or a scene with more",
                            arguments.input.files.front()));
  const std::vector<ReportedDistance> distances = distances_in(input, arguments.threads);
  const std::string text = text_of(input, distances, arguments.format);
  print_warnings(loaded.warnings);
  print_answer(text);
  return std::any_of(distances.begin(), distances.end(),
                     [](const ReportedDistance& pair) { return pair.distance.upper == 0; })
             ? 1
             : 0;
}

}  // namespace toccata::command
