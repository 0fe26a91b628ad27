#include <fmt/format.h>

#include <array>

#include "io/formats/number_rows.hpp"
#include "io/formats/utf8.hpp"
#include "reports/glb/glb_findings.hpp"
#include "reports/questions/asked_of.hpp"
#include "reports/questions/question_kinds.hpp"
#include "reports/questions/question_parts.hpp"
#include "reports/view/finding_layers.hpp"
#include "reports/view/pair_methods.hpp"
#include "toccata/core/error.hpp"
#include "toccata/reports/report.hpp"

namespace toccata {
namespace {

/// That nothing is met is proved.
Status status_of(const ReportedRay& ray) { return ray.hit ? ray.hit->status : Status::exact; }

std::string line_of(const Scene& scene, std::span<const ReportedRay> rays, std::size_t i) {
  const ReportedRay& ray = rays[i];
  io::Json line = {{"ray", i},
                   {"from", io::json_of(ray.query.origin)},
                   {"motion", io::json_of(ray.query.motion)},
                   {"hit", ray.hit.has_value()}};
  if (ray.hit) {
    line["object"] = io::as_utf8(scene.objects[ray.object].name);
    line["object_index"] = ray.object;
    line["face"] = ray.hit->face;
    line["lower"] = ray.hit->lower;
    line["upper"] = ray.hit->upper;
    line["point"] = io::json_of(ray.hit->point);
    line["normal"] = io::json_of(ray.hit->normal);
  }
  line["status"] = name_of(status_of(ray));
  return io::line_of(line);
}

std::string csv_of(const Scene& scene, const ReportedRay& ray) {
  if (!ray.hit) return ",,,,,,,,,,";
  const RayHit& hit = *ray.hit;
  return fmt::format("{},{},{},{},{},{},{},{},{},{},", io::csv_field(io::as_utf8(scene.objects[ray.object].name)),
                     hit.face, hit.lower, hit.upper, hit.point.x, hit.point.y, hit.point.z, hit.normal.x, hit.normal.y,
                     hit.normal.z);
}

std::vector<std::optional<RayHit>> hits_of(const SceneInstance& target, std::vector<RayQuery> rays,
                                           const BatchOptions& batch) {
  for (RayQuery& ray : rays) {
    ray.pose = target.pose;
    ray.solid = target.solid;
  }
  return io::asked_of(target.name, [&] { return cast_ray_each(rays, target.model, batch); });
}

struct RayKind {
  using Question = RayQuestion;
  using Report = RayReport;
  static constexpr const char* name = "ray";

  static io::Json write(const RayQuestion& q) {
    std::vector<double> numbers;
    for (const RayQuery& ray : q.rays) {
      io::append(numbers, ray.origin);
      io::append(numbers, ray.motion);
    }
    return {{"rays", io::json_of_rows(numbers, 6)}};
  }

  static RayQuestion read(const io::JsonValue& value) {
    value.expect_keys({"question", "rays"});
    const std::vector<double> numbers = io::rows_of_numbers(value.at("rays"), 6, "ray");
    RayQuestion q;
    for (std::size_t i = 0; i < numbers.size(); i += 6)
      q.rays.push_back({.origin = io::vector_at(numbers, i), .motion = io::vector_at(numbers, i + 3)});
    return q;
  }

  /// Finds for each ray the object that is met first of all, by (upper, place in the scene).
  static RayReport ask(const RayQuestion& question, const io::Asking& asking) {
    RayReport report;
    for (const RayQuery& ray : question.rays)
      report.rays.push_back({{.origin = ray.origin, .motion = ray.motion}, {}, 0});
    for (std::size_t object = 0; object < asking.models.size(); ++object) {
      const std::vector<std::optional<RayHit>> hits = hits_of(asking.models[object], question.rays, asking.batch());
      for (std::size_t i = 0; i < hits.size(); ++i) {
        ReportedRay& ray = report.rays[i];
        if (!hits[i] || (ray.hit && !(hits[i]->upper < ray.hit->upper))) continue;
        ray.hit = hits[i];
        ray.object = static_cast<Index>(object);
      }
    }
    return report;
  }

  static std::string json(const RayReport& report, const io::Reporting& reporting) {
    return io::with_list(io::document(reporting.head("toccata/ray/1")), "rays", report.rays.size(),
                         [&](std::size_t i) { return line_of(reporting.scene, report.rays, i); });
  }

  static std::string csv(const RayReport& report, const Scene& scene) {
    std::string csv = "ray,hit,object,face,lower,upper,x,y,z,normal_x,normal_y,normal_z,status\n";
    for (std::size_t i = 0; i < report.rays.size(); ++i)
      csv += fmt::format("{},{},{}{}\n", i, report.rays[i].hit ? 1 : 0, csv_of(scene, report.rays[i]),
                         name_of(status_of(report.rays[i])));
    return csv;
  }

  static void mark(const RayReport& report, io::LayerWriter& layers) {
    for (std::size_t i = 0; i < report.rays.size(); ++i) {
      const auto& [query, hit, object] = report.rays[i];
      layers.begin(i);
      const Vec3 end = query.origin + query.motion;
      layers.add_segments("ray", std::array{query.origin, hit ? hit->point : end});
      layers.add_points("start", std::array{query.origin});
      if (!hit) continue;
      layers.add_points("hit", std::array{hit->point});
      std::vector<io::Arrow> normal;
      io::add_arrow(normal, hit->point, hit->normal);
      layers.add_arrows("normal", normal);
    }
  }

  static io::Json words(const RayReport& report, io::PairMethods& methods) {
    io::Json words = io::Json::array();
    for (const ReportedRay& ray : report.rays) {
      words.push_back(io::Json::object());
      if (ray.hit)
        words.back()["methods"] = {{"cast", methods.number_of(ShapeQuestion::cast_ray, ray.object, ray.object)}};
    }
    return words;
  }

  static void show(const RayReport& report, io::GlbFindings& nodes) {
    for (std::size_t i = 0; i < report.rays.size(); ++i) {
      const auto& [query, hit, object] = report.rays[i];
      const Vec3 end = hit ? hit->point : query.origin + query.motion;
      io::Json extras = io::Json::object();
      if (hit) extras = {{"meets", nodes.glb().name_of(object)}, {"fraction", hit->upper}};
      nodes.add_node(fmt::format("ray {}", i),
                     std::vector<io::Shown>{{{query.origin, end}, io::GlbMode::lines, io::lengths}}, std::move(extras));
    }
    nodes.glb().add_group("rays", nodes.nodes());
  }
};

}  // namespace

constinit const io::QuestionKind RayQuestion::kind = io::question_kind<RayKind>();

}  // namespace toccata
