#include "toccata/io/report.hpp"

#include <fmt/format.h>

#include "io/formats/utf8.hpp"
#include "io/reports/report_parts.hpp"

namespace toccata {

using io::Json;

namespace {

std::string line_of(const Scene& scene, std::span<const ReportedRay> rays, std::size_t i) {
  const ReportedRay& ray = rays[i];
  io::Json line = {{"ray", i},
                   {"from", io::json_of(ray.query.origin)},
                   {"motion", io::json_of(ray.query.motion)},
                   {"hit", ray.hit.hit}};
  if (ray.hit.hit) {
    line["object"] = io::as_utf8(scene.objects[ray.object].name);
    line["object_index"] = ray.object;
    line["face"] = ray.hit.face;
    line["lower"] = ray.hit.lower;
    line["upper"] = ray.hit.upper;
    line["point"] = io::json_of(ray.hit.point);
    line["normal"] = io::json_of(ray.hit.normal);
  }
  line["status"] = name_of(ray.hit.status);
  return io::line_of(line);
}

std::string csv_of(const Scene& scene, const ReportedRay& ray) {
  if (!ray.hit.hit) return ",,,,,,,,,,";
  const RayHit& hit = ray.hit;
  return fmt::format("{},{},{},{},{},{},{},{},{},{},", io::csv_field(io::as_utf8(scene.objects[ray.object].name)),
                     hit.face, hit.lower, hit.upper, hit.point.x, hit.point.y, hit.point.z, hit.normal.x, hit.normal.y,
                     hit.normal.z);
}

}  // namespace

std::string ray_report_json(const Scene& scene, std::span<const SceneInstance> models,
                            std::span<const ReportedRay> rays, std::span<const std::string> warnings) {
  return io::with_list(io::document(io::report_head("toccata/ray/1", scene, models, warnings)), "rays", rays.size(),
                       [&](std::size_t i) { return line_of(scene, rays, i); });
}

std::string ray_report_csv(const Scene& scene, std::span<const ReportedRay> rays) {
  std::string csv = "ray,hit,object,face,lower,upper,x,y,z,normal_x,normal_y,normal_z,status\n";
  for (std::size_t i = 0; i < rays.size(); ++i)
    csv += fmt::format("{},{},{}{}\n", i, rays[i].hit.hit ? 1 : 0, csv_of(scene, rays[i]), name_of(rays[i].hit.status));
  return csv;
}

}  // namespace toccata
