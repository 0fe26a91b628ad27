#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "math/constants.hpp"
#include "reports/questions/question_parts.hpp"
#include "reports/view/swept_surface.hpp"
#include "toccata/reports/pages.hpp"

namespace toccata {
namespace {

constexpr int even_moments = 60;
constexpr std::size_t most_measured_pairs = 1000;  ///< of more, only those that meet are shown
constexpr std::size_t most_surface_corners = 1'000'000;
constexpr std::uint64_t in_motion = 1, at_rest = 2;

/// Times that a page shows, ascending: even ones, and those at which a pair first meets.
struct ShownMoment {
  double time = 0;
  bool is_contact = false;
};

std::vector<ShownMoment> moments_of(const SweepReport& report) {
  std::vector<ShownMoment> moments;
  for (const ReportedSweep& pair : report.pairs)
    if (pair.hit) moments.push_back({pair.hit->upper, true});
  for (int i = 0; i <= even_moments; ++i) moments.push_back({static_cast<double>(i) / even_moments, false});
  std::stable_sort(moments.begin(), moments.end(),
                   [](const ShownMoment& a, const ShownMoment& b) { return a.time < b.time; });
  const auto end = std::unique(moments.begin(), moments.end(),
                               [](const ShownMoment& a, const ShownMoment& b) { return a.time == b.time; });
  moments.erase(end, moments.end());
  return moments;
}

/// Those that move are compared with those that stand.
Body body_of(const SceneInstance& model, bool moves, bool is_measured) {
  Body body{.model = model.model, .pose = model.pose};
  body.solid = model.solid;
  body.name = model.name;
  body.category = moves ? in_motion : at_rest;
  body.mask = moves ? at_rest : in_motion;
  body.margin = is_measured ? infinity : 0;
  return body;
}

/// Pairs of one group, which are not asked about.
std::vector<IndexPair> apart_by_group(std::span<const SceneInstance> models, std::size_t moving) {
  std::vector<IndexPair> pairs;
  for (Index a = 0; a < moving; ++a)
    for (auto b = static_cast<Index>(moving); b < models.size(); ++b)
      if (io::in_one_group(models[a], models[b])) pairs.push_back({a, b});
  return pairs;
}

/// The volumes of all that move are one thing to be seen or not; where that is more than a part of a page, not.
WorldRecording::Surface swept_surface_of(std::span<const SceneInstance> models, std::span<const RigidMotion> motions) {
  WorldRecording::Surface surface{"Swept volume", {}};
  for (std::size_t i = 0; i < motions.size(); ++i) {
    const std::vector<Vec3> corners = io::swept_surface(models[i].model, motions[i], models[i].solid);
    surface.corners.insert(surface.corners.end(), corners.begin(), corners.end());
    if (surface.corners.size() > most_surface_corners) return {surface.name, {}};
  }
  return surface;
}

}  // namespace

WorldRecording record_sweep(std::span<const SceneInstance> models, const SweepReport& report) {
  const SweepQuestion& question = report.question;
  World world({.relation = true, .distance = true});
  const bool is_measured = report.pairs.size() <= most_measured_pairs;
  std::vector<BodyId> bodies, moving;
  std::vector<RigidMotion> motions;
  for (std::size_t i = 0; i < models.size(); ++i) {
    const bool moves = i < question.moving_objects;
    const BodyId id = world.add(body_of(models[i], moves, is_measured));
    bodies.push_back(id);
    if (!moves) continue;
    motions.push_back(motion_of(question, models[i].pose));
    moving.push_back(id);
  }
  for (const auto& [a, b] : apart_by_group(models, question.moving_objects))
    world.set_rule({.a = bodies[a], .b = bodies[b], .excluded = true});
  const char* const what = question.stop_before == 0 ? ": first contact" : ": as near as asked";
  WorldRecording recording;
  recording.add(swept_surface_of(models, motions));
  for (const ShownMoment& moment : moments_of(report)) {
    for (std::size_t i = 0; i < moving.size(); ++i) world.move(moving[i], motions[i].at(moment.time));
    world.step();
    recording.add(world, fmt::format("{:.6g}{}", moment.time, moment.is_contact ? what : ""));
  }
  return recording;
}

}  // namespace toccata
