#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "io/formats/number_rows.hpp"
#include "io/formats/utf8.hpp"
#include "reports/questions/question_kinds.hpp"
#include "reports/questions/question_parts.hpp"
#include "reports/report_parts.hpp"
#include "toccata/core/error.hpp"
#include "toccata/query/scene_index.hpp"
#include "toccata/reports/report.hpp"

namespace toccata {
namespace {

constexpr std::array<const char*, 5> walk_outcome_names{"done", "arrived", "hindered", "fallen", "unfinished"};

void require_of_walk(bool is_fine, const char* name, double value, const char* range) {
  if (!is_fine) throw Error(fmt::format("a walk: its {} is {}; it has to be {}", name, value, range));
}

/// What `move_character` does not look at.
void require_walk(const WalkQuestion& question) {
  require_of_walk(question.fall >= 0 && std::isfinite(question.fall), "fall", question.fall, "a length of 0 or more");
  if (!question.motions.empty()) return;
  require_of_walk(question.stride > 0 && std::isfinite(question.stride), "stride", question.stride, "a length above 0");
  if (!is_finite(question.to)) throw Error("a walk: where it leads to has a coordinate that is not finite");
}

/// A walk that is under way.
class WalkUnderWay {
 public:
  WalkUnderWay(const WalkQuestion& question, std::span<const SceneInstance> models)
      : level_(models),
        walker_(question.walker),
        up_(normalized(question.options.up)),
        state_{Pose::translation(question.from.x, question.from.y, question.from.z), {}},
        report_{question, {}, WalkOutcome::done},
        nearest_(length(level_way())) {}

  WalkReport whole() {
    if (report_.question.motions.empty()) {
      report_.end = way_to_its_end();
    } else {
      for (const Vec3& motion : report_.question.motions) take_step(motion);
    }
    return std::move(report_);
  }

 private:
  const WalkQuestion& question() const { return report_.question; }

  /// What is left to go, square to `up`.
  Vec3 level_way() const {
    const Vec3 way = question().to - state_.pose.offset;
    return way - dot(way, up_) * up_;
  }

  bool has_arrived() const {
    const double above = dot(state_.pose.offset - question().to, up_), skin = question().options.skin;
    return state_.ground && length(level_way()) <= skin && std::abs(above) <= question().options.step_height + skin;
  }

  void take_step(const Vec3& wanted) {
    const double fall = question().fall;
    falling_ = state_.ground || fall == 0 ? 0 : std::min(falling_, fallen_) + fall;
    const Vec3 motion = wanted - falling_ * up_;
    MoverStep<Index> step = move_character(level_, walker_, state_, motion, question().options);
    fallen_ = std::max(0.0, -dot(step.moved - step.pushed_out, up_));
    state_ = step.state;
    report_.steps.push_back({motion, std::move(step)});
  }

  bool is_above_something() const {
    constexpr double strides = 1e6;
    return level_.cast_shape({{walker_, state_.pose}, -strides * question().stride * up_}).has_value();
  }

  /// Whether the last step brought it nearer, or down to something.
  bool has_got_on() {
    const double least = question().stride / 1000, left = length(level_way());
    const bool is_nearer = left < nearest_ && left <= nearest_ - least;
    if (is_nearer) nearest_ = left;
    if (state_.ground) past_all_ = 0;
    const bool has_fallen = falling_ > 0 && fallen_ >= std::min(least, falling_ / 2);
    if (state_.ground || !has_fallen) return is_nearer;
    past_all_ = is_above_something() ? 0 : past_all_ + 1;
    return true;
  }

  WalkOutcome way_to_its_end() {
    constexpr int patience = 8, longest_fall = 30;
    for (int in_vain = 0; report_.steps.size() < question().most_steps;) {
      if (has_arrived()) return WalkOutcome::arrived;
      const Vec3 way = level_way();
      const double left = length(way), stride = question().stride;
      take_step(left <= stride ? way : (stride / left) * way);
      in_vain = has_got_on() ? 0 : in_vain + 1;
      if (past_all_ == longest_fall) return WalkOutcome::fallen;
      if (in_vain == patience && !has_arrived()) return WalkOutcome::hindered;
    }
    return has_arrived() ? WalkOutcome::arrived : WalkOutcome::unfinished;
  }

  SceneIndex level_;
  Model walker_;
  Vec3 up_;
  MoverState<Index> state_;
  WalkReport report_;
  double nearest_;  ///< that it has come to the place, square to `up`
  double falling_ = 0, fallen_ = 0;
  int past_all_ = 0;  ///< steps in the air with nothing below
};

io::Json json_of(const Shape& walker) {
  return io::json_of(walker, [](const auto&) -> io::Json {
    throw Error("a walker is a mesh: it has to be one bounded convex shape, as a capsule");
  });
}

io::Json json_of(const MoverOptions& options) {
  return {{"up", io::json_of(options.up)},
          {"skin", options.skin},
          {"max_slope_degrees", options.max_slope_degrees},
          {"step_height", options.step_height},
          {"snap_distance", options.snap_distance},
          {"max_slides", options.max_slides}};
}

MoverOptions options_of(const io::JsonValue& value) {
  value.expect_keys({"up", "skin", "max_slope_degrees", "step_height", "snap_distance", "max_slides"});
  MoverOptions options;
  if (value.has("up")) options.up = value.at("up").vector();
  const auto take = [&](const char* key, double& number) {
    if (value.has(key)) number = value.at(key).number();
  };
  take("skin", options.skin);
  take("max_slope_degrees", options.max_slope_degrees);
  take("step_height", options.step_height);
  take("snap_distance", options.snap_distance);
  options.max_slides = static_cast<int>(value.whole_or("max_slides", 1'000'000, 8));
  return options;
}

io::Json json_of(const io::Reporting& reporting, const MoverContact<Index>& contact) {
  const Model& model = reporting.models[contact.object].model;
  return {{"object", io::as_utf8(reporting.scene.objects[contact.object].name)},
          {"object_index", contact.object},
          {"face", model.has_mesh() ? model.mesh().face_of(contact.element) : 0},
          {"triangle", contact.element},
          {"point", io::json_of(contact.point)},
          {"normal", io::json_of(contact.normal)}};
}

std::string line_of(const io::Reporting& reporting, const WalkedStep& walked, std::size_t i) {
  const MoverStep<Index>& step = walked.step;
  const auto& ground = step.state.ground;
  io::Json contacts = io::Json::array();
  for (const MoverContact<Index>& contact : step.contacts) contacts.push_back(json_of(reporting, contact));
  io::Json line = {{"step", i + 1},
                   {"motion", io::json_of(walked.motion)},
                   {"position", io::json_of(step.state.pose.offset)},
                   {"ground", ground ? json_of(reporting, *ground) : io::Json()},
                   {"contacts", std::move(contacts)},
                   {"met_wall", step.met_wall},
                   {"met_ceiling", step.met_ceiling},
                   {"stepped", step.stepped},
                   {"tight", step.tight},
                   {"stuck", step.stuck},
                   {"crushed", step.crushed},
                   {"cut_short", step.cut_short}};
  if (step.carried != Vec3{}) line["carried"] = io::json_of(step.carried);
  if (step.pushed_out != Vec3{}) line["pushed_out"] = io::json_of(step.pushed_out);
  return io::line_of(line);
}

struct WalkKind {
  using Question = WalkQuestion;
  using Report = WalkReport;
  static constexpr const char* name = "walk";

  static io::Json write(const WalkQuestion& q) {
    io::Json json = {{"walker", json_of(q.walker)},
                     {"from", io::json_of(q.from)},
                     {"fall", q.fall},
                     {"options", json_of(q.options)}};
    if (q.motions.empty()) {
      json.update({{"to", io::json_of(q.to)}, {"stride", q.stride}, {"most_steps", q.most_steps}});
      return json;
    }
    std::vector<double> numbers;
    for (const Vec3& motion : q.motions) io::append(numbers, motion);
    json["motions"] = io::json_of_rows(numbers, 3);
    return json;
  }

  static WalkQuestion read(const io::JsonValue& value) {
    value.expect_keys({"question", "walker", "from", "fall", "options", "to", "stride", "most_steps", "motions"});
    if (value.has("to") == value.has("motions"))
      value.fail("a walk leads to a place or takes motions", "write either \"to\" or \"motions\"");
    WalkQuestion q;
    if (value.has("walker"))
      q.walker =
          io::shape_of(value.at("walker"), [](const io::JsonValue& holder) -> std::shared_ptr<const TriangleMesh> {
            holder.fail("a walker is of a file", "write its points here");
          });
    q.from = value.at("from").vector();
    if (value.has("fall")) q.fall = value.at("fall").number();
    if (value.has("options")) q.options = options_of(value.at("options"));
    if (value.has("to")) q.to = value.at("to").vector();
    if (value.has("stride")) q.stride = value.at("stride").number();
    q.most_steps = value.whole_or("most_steps", 1'000'000'000, q.most_steps);
    if (!value.has("motions")) return q;
    const std::vector<double> numbers = io::rows_of_numbers(value.at("motions"), 3, "motion");
    if (numbers.empty()) value.at("motions").fail("there is no motion", "write one for each step");
    for (std::size_t i = 0; i < numbers.size(); i += 3) q.motions.push_back(io::vector_at(numbers, i));
    return q;
  }

  static WalkReport ask(const WalkQuestion& question, const io::Asking& asking) {
    require_walk(question);
    return WalkUnderWay(question, asking.models).whole();
  }

  static std::string json(const WalkReport& report, const io::Reporting& reporting) {
    io::Json head = reporting.head("toccata/walk/1");
    head["walk"] = write(report.question);
    head["end"] = name_of(report.end);
    head["position"] = io::json_of(place_after(report, report.steps.size()));
    return io::with_list(io::document(head), "steps", report.steps.size(),
                         [&](std::size_t i) { return line_of(reporting, report.steps[i], i); });
  }

  static std::string csv(const WalkReport& report, const Scene& scene) {
    std::string csv = "step,x,y,z,ground,contacts,met_wall,met_ceiling,stepped,tight,stuck,crushed,cut_short\n";
    for (std::size_t i = 0; i < report.steps.size(); ++i) {
      const MoverStep<Index>& step = report.steps[i].step;
      const Vec3& at = step.state.pose.offset;
      const std::string ground =
          step.state.ground ? io::csv_field(io::as_utf8(scene.objects[step.state.ground->object].name)) : "";
      csv += fmt::format("{},{},{},{},{},{},{:d},{:d},{:d},{:d},{:d},{:d},{:d}\n", i + 1, at.x, at.y, at.z, ground,
                         step.contacts.size(), step.met_wall, step.met_ceiling, step.stepped, step.tight, step.stuck,
                         step.crushed, step.cut_short);
    }
    return csv;
  }
};

}  // namespace

const char* name_of(WalkOutcome end) { return walk_outcome_names[static_cast<std::size_t>(end)]; }

Vec3 place_after(const WalkReport& report, std::size_t steps) {
  return steps == 0 ? report.question.from : report.steps[steps - 1].step.state.pose.offset;
}

constinit const io::QuestionKind WalkQuestion::kind = io::question_kind<WalkKind>();

}  // namespace toccata
