#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "io/formats/utf8.hpp"
#include "toccata/reports/pages.hpp"

namespace toccata {
namespace {

constexpr std::size_t most_shown_steps = 2000;
constexpr std::uint64_t of_walker = 1, of_level = 2;

/// The walker is compared with the level, in which nothing is compared.
Body body_of_walk(const SceneInstance& model, bool is_walker) {
  Body body{.model = model.model, .pose = model.pose};
  body.solid = model.solid;
  body.name = model.name;
  body.category = is_walker ? of_walker : of_level;
  body.mask = is_walker ? of_level : of_walker;
  return body;
}

/// A name that the level has not.
std::string walker_name(std::span<const SceneInstance> models) {
  std::string name = "walker";
  const auto has_it = [&](const SceneInstance& model) { return model.name == name; };
  while (std::any_of(models.begin(), models.end(), has_it)) name.insert(0, "the ");
  return name;
}

std::string label_of(std::span<const SceneInstance> models, const WalkReport& report, std::size_t steps) {
  if (steps == 0) return "start";
  const MoverStep<Index>& step = report.steps[steps - 1].step;
  const auto name = [&](const MoverContact<Index>& contact) { return io::as_utf8(models[contact.object].name); };
  std::string label = fmt::format("step {}: ", steps);
  label += step.state.ground ? "on " + name(*step.state.ground) : "in the air";
  if (step.stepped) label += ", up a step";
  if (!step.contacts.empty()) label += ", meets " + name(step.contacts.front());
  if (step.contacts.size() > 1) label += fmt::format(" and {} more", step.contacts.size() - 1);
  if (step.tight) label += ", nearer than its skin";
  if (step.stuck) label += ", stuck";
  if (step.crushed) label += ", crushed";
  if (step.cut_short) label += ", cut short";
  return label;
}

/// Every so many steps are shown.
std::size_t stride_of(std::size_t steps) {
  return std::max<std::size_t>(1, (steps + most_shown_steps - 1) / most_shown_steps);
}

std::vector<WorldRecording::Touched> touched_after(const WalkReport& report, std::size_t steps) {
  std::vector<WorldRecording::Touched> touched;
  if (steps == 0) return touched;
  const MoverStep<Index>& step = report.steps[steps - 1].step;
  if (step.state.ground) touched.push_back({step.state.ground->point, step.state.ground->normal});
  for (const MoverContact<Index>& contact : step.contacts) touched.push_back({contact.point, contact.normal});
  return touched;
}

}  // namespace

WorldRecording record_walk(std::span<const SceneInstance> models, const WalkReport& report) {
  const WalkQuestion& question = report.question;
  World world({.relation = true, .distance = true});
  for (const SceneInstance& model : models) world.add(body_of_walk(model, false));
  const Pose start = Pose::translation(question.from.x, question.from.y, question.from.z);
  Body walker = body_of_walk({Model(question.walker), start, Solid::automatic, walker_name(models)}, true);
  walker.margin = 2 * question.options.skin;
  const BodyId id = world.add(walker);
  WorldRecording recording;
  WorldRecording::Path path{"Path", {}};
  const std::size_t count = report.steps.size(), stride = stride_of(count);
  for (std::size_t steps = 0; steps <= count; ++steps) {
    path.points.push_back(place_after(report, steps));
    if (steps % stride != 0 && steps != count) continue;
    if (steps > 0) world.move(id, report.steps[steps - 1].step.state.pose);
    world.step();
    recording.add(world, label_of(models, report, steps), touched_after(report, steps));
  }
  recording.add(std::move(path));
  return recording;
}

}  // namespace toccata
