#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
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
#include "toccata/io/query_files.hpp"
#include "view.hpp"
#include "words.hpp"

namespace toccata::command {
namespace {

struct RayArguments : PosedArguments {
  std::optional<Vec3> from;
  std::optional<Vec3> to;
  std::string rays;                               ///< a file of rays; empty: the one from `from` to `to`
  std::vector<std::string> from_words, to_words;  ///< as they are written
};

double ray_length(const Vec3& v) { return std::hypot(v.x, v.y, v.z); }

std::vector<RayQuery> rays_asked(const RayArguments& arguments) {
  if (!arguments.rays.empty()) return read_rays(arguments.rays);
  if (!arguments.from && !arguments.to)
    throw Error("no ray is given: name where it starts and ends with --from X Y Z --to X Y Z, or a file with --rays");
  if (!arguments.from || !arguments.to)
    throw Error(
        fmt::format("{} is missing: a ray goes from --from X Y Z to --to X Y Z", arguments.from ? "--to" : "--from"));
  if (*arguments.from == *arguments.to) throw Error("the ray ends where it starts: --from and --to are one point");
  const Vec3 motion = *arguments.to - *arguments.from;
  if (!is_finite(motion)) throw Error("--from and --to are farther apart than doubles can tell");
  return {{.origin = *arguments.from, .motion = motion}};
}

int run_ray(const RayArguments& arguments) {
  const bool asks_itself = arguments.from || arguments.to || !arguments.rays.empty() || changes_objects(arguments);
  if (const auto code = answered_case(arguments, {"ray", asks_itself, false, true})) return *code;
  const RayQuestion question{rays_asked(arguments)};
  require_view(arguments);
  const CheckInput input = read_check_input(arguments);
  return exit_code_of(answer_to(question, input, arguments, "following rays"));
}

}  // namespace

std::string table_of(const CheckInput& input, const RayReport& report) {
  const std::vector<ReportedRay>& rays = report.rays;
  const std::vector<std::string> names = table_names(input.loaded.scene.objects);
  std::vector<std::vector<std::string>> rows;
  std::size_t met = 0, undecided = 0;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const ReportedRay& ray = rays[i];
    rows.push_back({fmt::format("ray {}", i), "meets nothing"});
    if (!ray.hit) continue;
    ++met;
    if (ray.hit->status == Status::undecided) ++undecided;
    const SceneInstance& target = input.models[ray.object];
    const std::string where = target.model.has_mesh() ? fmt::format("face {}", ray.hit->face) : "";
    rows.back() = {rows.back()[0], "meets " + names[ray.object], where, "at " + point_text(ray.hit->point),
                   fmt::format("hit distance {:.12g}, fraction {:.12g}", ray.hit->upper * ray_length(ray.query.motion),
                               ray.hit->upper)};
  }
  for (auto& row : rows) row.resize(5);
  return columns(rows, 2) + fmt::format("{} of {} met something, {}.\n", grouped(met), counted(rows.size(), "ray"),
                                        decided_text(undecided));
}

Summary summary_of(const RayReport& report) {
  const auto hits = [](const ReportedRay& ray) { return ray.hit.has_value(); };
  return {counted(report.rays.size(), "ray"), std::any_of(report.rays.begin(), report.rays.end(), hits)};
}

Subcommand add_ray(CLI::App& app) {
  const auto arguments = std::make_shared<RayArguments>();
  CLI::App* ray = app.add_subcommand("ray", "what a ray meets first, decided exactly");
  add_input(*ray, arguments->input, any_files);
  CLI::Option* from = add_point(*ray, "--from", arguments->from_words, "where the ray starts, in the world");
  CLI::Option* to = add_point(*ray, "--to", arguments->to_words, "where it ends");
  add_file(*ray, "--rays", arguments->rays, "many rays: a file with six numbers a line, where each starts and ends")
      ->excludes(from)
      ->excludes(to);
  add_solid(*ray, *arguments);
  add_writing(*ray, *arguments, "docs/reference/ray-report.md");
  ray->footer(
      with_name("A solid is met at once by a ray that starts inside; --solid=none asks about surfaces alone.\n\n"
                "Exit code: 0 nothing is met, 1 something is, 2 trouble.\n\nExample:\n"
                "  {0} ray part.stl --from 0 0 5 --to 0 0 -5\n  {0} ray scene.json --rays rays.txt --csv"));
  return {ray, [arguments] {
            take_words(*arguments);
            if (!arguments->from_words.empty()) arguments->from = parse_point(arguments->from_words, "--from");
            if (!arguments->to_words.empty()) arguments->to = parse_point(arguments->to_words, "--to");
            return run_ray(*arguments);
          }};
}

}  // namespace toccata::command
