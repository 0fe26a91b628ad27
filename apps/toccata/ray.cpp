#include <fmt/format.h>

#include <algorithm>

#include "arguments.hpp"
#include "check_input.hpp"
#include "output.hpp"
#include "toccata/core/error.hpp"
#include "toccata/io/ray_report.hpp"
#include "toccata/io/rays_file.hpp"
#include "words.hpp"

namespace toccata::command {
namespace {

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

std::vector<RayHit> hits_of(const Posed& target, std::vector<RayQuery> rays, int threads) {
  for (RayQuery& ray : rays) {
    ray.pose = target.pose;
    ray.solid = target.solid;
  }
  BatchOptions options;
  options.threads = threads;
  return asked_of(target.name, [&] { return cast_ray_each(rays, target.model, options); });
}

/// Of all objects the one that is met first, by (upper, place in the scene).
std::vector<ReportedRay> first_hits(const CheckInput& input, const std::vector<RayQuery>& rays, int threads) {
  std::vector<ReportedRay> reported;
  for (const RayQuery& ray : rays) reported.push_back({ray, {}, 0});
  for (std::size_t object = 0; object < input.models.size(); ++object) {
    const std::vector<RayHit> hits = hits_of(input.models[object], rays, threads);
    for (std::size_t i = 0; i < hits.size(); ++i)
      if (hits[i].hit && (!reported[i].hit.hit || hits[i].upper < reported[i].hit.upper))
        reported[i] = {rays[i], hits[i], static_cast<Index>(object)};
  }
  return reported;
}

std::string ray_table(const CheckInput& input, const std::vector<ReportedRay>& rays) {
  std::vector<std::vector<std::string>> rows;
  std::size_t met = 0;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const ReportedRay& ray = rays[i];
    rows.push_back({fmt::format("ray {}", i), "meets nothing"});
    if (!ray.hit.hit) continue;
    ++met;
    const Posed& target = input.models[ray.object];
    const std::string where = target.model.has_mesh() ? fmt::format("face {}", ray.hit.face) : "";
    rows.back() = {rows.back()[0], "meets " + printable(target.name), where, "at " + point_text(ray.hit.point),
                   fmt::format("after {:.12g} of the way", ray.hit.upper)};
  }
  for (auto& row : rows) row.resize(5);
  return columns(rows, 2) +
         fmt::format("{} of {} met something, decided exactly.\n", grouped(met), counted(rows.size(), "ray"));
}

std::string text_of(const CheckInput& input, const std::vector<ReportedRay>& rays, Format format) {
  const LoadedScene& loaded = input.loaded;
  if (format == Format::json) return ray_report_json(loaded.scene, input.models, rays, loaded.warnings);
  return format == Format::csv ? ray_report_csv(loaded.scene, rays) : ray_table(input, rays);
}

}  // namespace

int run_ray(const RayArguments& arguments) {
  const std::vector<RayQuery> rays = rays_asked(arguments);
  const CheckInput input = read_check_input(arguments);
  const std::vector<ReportedRay> reported = first_hits(input, rays, arguments.threads);
  const std::string text = text_of(input, reported, arguments.format);
  print_warnings(input.loaded.warnings);
  print_answer(text);
  return std::any_of(reported.begin(), reported.end(), [](const ReportedRay& ray) { return ray.hit.hit; }) ? 1 : 0;
}

}  // namespace toccata::command
