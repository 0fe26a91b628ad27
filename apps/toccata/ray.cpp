#include <fmt/format.h>

#include <cmath>

#include "answer.hpp"
#include "arguments.hpp"
#include "ask.hpp"
#include "case_asked.hpp"
#include "check_input.hpp"
#include "table_names.hpp"
#include "toccata/core/error.hpp"
#include "toccata/io/query_files.hpp"
#include "view.hpp"
#include "words.hpp"

namespace toccata::command {
namespace {

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

}  // namespace

std::string table_of(const CheckInput& input, const RayReport& report) {
  const std::vector<ReportedRay>& rays = report.rays;
  const std::vector<std::string> names = table_names(input.loaded.scene.objects);
  std::vector<std::vector<std::string>> rows;
  std::size_t met = 0, undecided = 0;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const ReportedRay& ray = rays[i];
    rows.push_back({fmt::format("ray {}", i), "meets nothing"});
    if (!ray.hit.hit) continue;
    ++met;
    if (ray.hit.status == Status::undecided) ++undecided;
    const SceneInstance& target = input.models[ray.object];
    const std::string where = target.model.has_mesh() ? fmt::format("face {}", ray.hit.face) : "";
    rows.back() = {rows.back()[0], "meets " + names[ray.object], where, "at " + point_text(ray.hit.point),
                   fmt::format("hit distance {:.12g}, fraction {:.12g}", ray.hit.upper * ray_length(ray.query.motion),
                               ray.hit.upper)};
  }
  for (auto& row : rows) row.resize(5);
  return columns(rows, 2) + fmt::format("{} of {} met something, {}.\n", grouped(met), counted(rows.size(), "ray"),
                                        decided_text(undecided));
}

int run_ray(const RayArguments& arguments) {
  const bool asks_itself = arguments.from || arguments.to || !arguments.rays.empty() || changes_objects(arguments);
  if (const auto code = answered_case(arguments, {"ray", asks_itself, false, true})) return *code;
  const RayQuestion question{rays_asked(arguments)};
  require_view(arguments);
  const CheckInput input = read_check_input(arguments);
  return exit_code_of(answer_to(question, input, arguments, "following rays"));
}

}  // namespace toccata::command
