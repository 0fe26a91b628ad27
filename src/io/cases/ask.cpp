#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "io/cases/ask_convex.hpp"
#include "io/cases/ask_cost.hpp"
#include "io/cases/ask_inspect.hpp"
#include "io/cases/ask_nearest.hpp"
#include "io/cases/asked_of.hpp"
#include "toccata/core/error.hpp"
#include "toccata/core/parallel.hpp"
#include "toccata/io/scene_question.hpp"
#include "toccata/query/self_contacts.hpp"

namespace toccata {
namespace {

bool in_one_group(const SceneInstance& a, const SceneInstance& b) { return !a.group.empty() && a.group == b.group; }

Distance distance_of(const SceneInstance& a, const SceneInstance& b, Workspace& workspace) {
  try {
    return distance(a.model, b.model, {a.pose, b.pose, a.solid, b.solid}, workspace);
  } catch (const Error& error) {
    throw Error(fmt::format("'{}' (a) and '{}' (b): {}", a.name, b.name, error.what()));
  }
}

/// Asks one question after the other.
class Asking {
 public:
  /// `scene`, where it is known, is the models'.
  Asking(std::span<const SceneInstance> models, const AskOptions& options, const Scene* scene = nullptr)
      : models_(models), options_(options), scene_(scene) {}

  SceneAnswer operator()(const CheckQuestion& question) const {
    CheckOptions options;
    options.contacts = question.faces;
    options.penetration = question.penetration;
    options.clearance = question.clearance;
    options.pair_clearances = question.pair_clearances;
    options.threads = options_.threads;
    options.progress = options_.progress;
    return make_check_report(models_, check_all(models_, options), question);
  }

  SceneAnswer operator()(const CheckPosesQuestion& question) const {
    require_two();
    const Model &a = models_[0].model, &b = models_[1].model;
    PosesReport report;
    report.queries = question.queries;
    report.touching = question.touching;
    const Batch<PairQuery> poses(a, b, report.queries);
    report.relations = relation_each(poses, batch());
    if (question.faces) report.counts = count_contacts_each(poses, batch());
    if (!question.penetration) return report;
    report.penetrations = penetration_each(poses, batch());
    if (a.has_mesh() && b.has_mesh()) report.regions = contact_regions_each(poses, batch());
    return report;
  }

  SceneAnswer operator()(const SelfQuestion& question) const {
    return make_self_report(models_, self_contacts_each(models_, batch()), question.faces);
  }

  SceneAnswer operator()(const DistanceQuestion& question) const {
    const bool two_sides = question.first_objects > 0;
    const std::size_t first_end = two_sides ? std::min(question.first_objects, models_.size()) : models_.size();
    std::vector<std::vector<ReportedDistance>> of_first(first_end);
    parallel_for(first_end, options_.threads, [&](std::size_t i) {
      Workspace workspace;
      for (std::size_t j = two_sides ? first_end : i + 1; j < models_.size(); ++j)
        if (!in_one_group(models_[i], models_[j]))
          of_first[i].push_back(
              {static_cast<Index>(i), static_cast<Index>(j), distance_of(models_[i], models_[j], workspace)});
    });
    DistanceReport report;
    for (const auto& some : of_first) report.pairs.insert(report.pairs.end(), some.begin(), some.end());
    return report;
  }

  SceneAnswer operator()(const DistancePosesQuestion& question) const {
    require_two();
    return DistancePosesReport{question.queries,
                               distance_each({models_[0].model, models_[1].model, question.queries}, batch())};
  }

  /// Of all objects the one that is met first, by (upper, place in the scene).
  SceneAnswer operator()(const RayQuestion& question) const {
    RayReport report;
    for (const RayQuery& ray : question.rays)
      report.rays.push_back({{.origin = ray.origin, .motion = ray.motion}, {}, 0});
    for (std::size_t object = 0; object < models_.size(); ++object) {
      const std::vector<RayHit> hits = hits_of(models_[object], question.rays);
      for (std::size_t i = 0; i < hits.size(); ++i) {
        ReportedRay& ray = report.rays[i];
        if (!hits[i].hit || (ray.hit.hit && !(hits[i].upper < ray.hit.upper))) continue;
        ray.hit = hits[i];
        ray.object = static_cast<Index>(object);
      }
    }
    return report;
  }

  SceneAnswer operator()(const FacesQuestion& question) const {
    FacesReport report{question.region, {}};
    Workspace workspace;
    for (std::size_t i = 0; i < models_.size(); ++i) {
      const SceneInstance& posed = models_[i];
      const auto here = io::asked_of(
          posed.name, [&] { return faces_in_region(question.region, posed.model, posed.pose, workspace); });
      if (!here.empty()) report.found.push_back({static_cast<Index>(i), {here.begin(), here.end()}});
    }
    return report;
  }

  SceneAnswer operator()(const NearestQuestion& question) const { return io::ask_nearest(models_, question, batch()); }

  SceneAnswer operator()(const InspectQuestion& question) const {
    return io::ask_inspect(models_, question, options_.progress);
  }

  SceneAnswer operator()(const HierarchyQuestion&) const {
    if (scene_ == nullptr)
      throw Error("this is asked about a scene's tree of nodes: hand the scene over, ask(scene, models, question)");
    return rebalance_report(*scene_);
  }

  SceneAnswer operator()(const CostQuestion& question) const {
    return io::ask_cost(models_, question, options_.progress);
  }

  SceneAnswer operator()(const CrowdQuestion& question) const { return run_crowd(question, options_.progress); }

  SceneAnswer operator()(const CrowdWorldQuestion& question) const {
    return run_crowd_world(question, options_.progress);
  }

  SceneAnswer operator()(const DecomposeQuestion& question) const {
    return io::ask_decompose(models_, question, options_);
  }

  SceneAnswer operator()(const MinkowskiQuestion& question) const { return io::ask_minkowski(models_, question); }

 private:
  void require_two() const {
    if (models_.size() != 2)
      throw Error(
          fmt::format("poses are asked about two objects, the first placed as A and the second as B; here {} {}",
                      models_.size() == 1 ? "is" : "are", models_.size()));
  }

  [[nodiscard]] std::vector<RayHit> hits_of(const SceneInstance& target, std::vector<RayQuery> rays) const {
    for (RayQuery& ray : rays) {
      ray.pose = target.pose;
      ray.solid = target.solid;
    }
    return io::asked_of(target.name, [&] { return cast_ray_each(rays, target.model, batch()); });
  }

  [[nodiscard]] BatchOptions batch() const {
    BatchOptions batch;
    batch.threads = options_.threads;
    batch.progress = options_.progress;
    return batch;
  }

  std::span<const SceneInstance> models_;
  const AskOptions& options_;
  const Scene* scene_;
};

/// Writes the report of one answer after the other.
struct ReportWriter {
  const Scene& scene;
  std::span<const SceneInstance> models;
  std::span<const std::string> warnings;

  std::string operator()(const CheckReport& r) const { return check_report_json(scene, models, r, warnings); }
  std::string operator()(const PosesReport& r) const { return poses_report_json(scene, models, r, warnings); }
  std::string operator()(const SelfReport& r) const { return self_report_json(scene, models, r, warnings); }
  std::string operator()(const DistanceReport& r) const {
    return distance_report_json(scene, models, r.pairs, warnings);
  }
  std::string operator()(const DistancePosesReport& r) const {
    return distance_poses_report_json(scene, models, r, warnings);
  }
  std::string operator()(const RayReport& r) const { return ray_report_json(scene, models, r.rays, warnings); }
  std::string operator()(const FacesReport& r) const {
    return faces_report_json(scene, models, r.region, r.found, warnings);
  }
  std::string operator()(const NearestReport& r) const {
    return nearest_report_json(scene, models, r.points, warnings);
  }
  std::string operator()(const InspectReport& r) const {
    return inspect_report_json(io::with_sources(r, scene).objects, scene.unit, warnings);
  }
  std::string operator()(const RebalanceReport& r) const { return hierarchy_report_json(scene, models, r, warnings); }
  std::string operator()(const CostReport& r) const { return cost_report_json(scene, models, r.table, warnings); }
  std::string operator()(const CrowdReport& r) const { return crowd_report_json(r); }
  std::string operator()(const CrowdWorldReport& r) const { return crowd_world_report_json(r); }
  std::string operator()(const DecomposeReport& r) const { return decompose_report_json(scene, models, r, warnings); }
  std::string operator()(const MinkowskiReport& r) const { return minkowski_report_json(scene, models, r, warnings); }
};

struct CsvWriter {
  const Scene& scene;

  std::string operator()(const CheckReport& r) const { return check_report_csv(scene, r); }
  std::string operator()(const PosesReport& r) const { return poses_report_csv(r); }
  std::string operator()(const SelfReport& r) const { return self_report_csv(scene, r); }
  std::string operator()(const DistanceReport& r) const { return distance_report_csv(scene, r.pairs); }
  std::string operator()(const DistancePosesReport& r) const { return distance_poses_report_csv(r); }
  std::string operator()(const RayReport& r) const { return ray_report_csv(scene, r.rays); }
  std::string operator()(const FacesReport& r) const { return faces_report_csv(scene, r.found); }
  std::string operator()(const NearestReport& r) const { return nearest_report_csv(scene, r.points, r.sides); }
  std::string operator()(const CostReport& r) const { return cost_report_csv(r.table); }
  template <class Other>
  std::string operator()(const Other&) const {
    throw Error("this answer has no form in lines of values; take JSON");
  }
};

}  // namespace

SceneAnswer ask(std::span<const SceneInstance> models, const SceneQuestion& question, const AskOptions& options) {
  return std::visit(Asking(models, options), question);
}

SceneAnswer ask(const Scene& scene, std::span<const SceneInstance> models, const SceneQuestion& question,
                const AskOptions& options) {
  return std::visit(Asking(models, options, &scene), question);
}

bool is_of_crowd(const SceneQuestion& question) {
  return std::holds_alternative<CrowdQuestion>(question) || std::holds_alternative<CrowdWorldQuestion>(question);
}

std::string name_of(const SceneQuestion& question) {
  constexpr std::array<const char*, std::variant_size_v<SceneQuestion>> names = {
      "check",   "check-poses", "check-self", "distance", "distance-poses", "ray",       "faces",      "nearest",
      "inspect", "hierarchy",   "cost",       "crowd",    "decompose",      "minkowski", "crowd-world"};
  return names[question.index()];
}

std::string report_json(const Scene& scene, std::span<const SceneInstance> models, const SceneAnswer& answer,
                        std::span<const std::string> warnings) {
  return std::visit(ReportWriter{scene, models, warnings}, answer);
}

std::string report_csv(const Scene& scene, const SceneAnswer& answer) { return std::visit(CsvWriter{scene}, answer); }

}  // namespace toccata
