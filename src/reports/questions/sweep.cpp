#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <tuple>

#include "io/formats/number_rows.hpp"
#include "io/formats/utf8.hpp"
#include "reports/questions/question_kinds.hpp"
#include "reports/questions/question_parts.hpp"
#include "reports/report_parts.hpp"
#include "toccata/core/error.hpp"
#include "toccata/core/parallel.hpp"
#include "toccata/reports/report.hpp"

namespace toccata {
namespace {

constexpr std::size_t numbers_of_key = 13;  // its time, then its pose

io::Json json_of(const std::vector<MotionKey>& keys) {
  std::vector<double> numbers;
  for (const MotionKey& key : keys) {
    numbers.push_back(key.time);
    io::append(numbers, key.pose);
  }
  return io::json_of_rows(numbers, numbers_of_key);
}

std::vector<MotionKey> keys_of(const io::JsonValue& value) {
  const std::vector<double> numbers = io::rows_of_numbers(value, numbers_of_key, "key");
  std::vector<MotionKey> keys;
  for (std::size_t i = 0; i < numbers.size(); i += numbers_of_key)
    keys.push_back({numbers[i], io::pose_at(numbers, i + 1)});
  return keys;
}

Vec3 vector_of(const io::JsonValue& value) {
  const std::vector<double> numbers = io::rows_of_numbers(value, 1, "coordinate");
  if (numbers.size() != 3) value.fail("these are not three numbers", "write x, y and z");
  return io::vector_at(numbers, 0);
}

/// Every two of which one moves and the other stands, but for those of one group.
std::vector<ReportedSweep> pairs_asked(std::span<const SceneInstance> models, std::size_t moving) {
  std::vector<ReportedSweep> pairs;
  for (std::size_t a = 0; a < moving; ++a)
    for (std::size_t b = moving; b < models.size(); ++b)
      if (!io::in_one_group(models[a], models[b])) pairs.push_back({static_cast<Index>(a), static_cast<Index>(b), {}});
  return pairs;
}

std::optional<ShapeHit> swept(const SceneInstance& a, const RigidMotion& motion, const SceneInstance& b,
                              double stop_before) {
  try {
    return sweep(a.model, motion, b.model, b.pose,
                 {.solid_a = a.solid, .solid_b = b.solid, .stop_before = stop_before});
  } catch (const Error& error) {
    throw Error(fmt::format("'{}' (a) and '{}' (b): {}", a.name, b.name, error.what()));
  }
}

bool meets_sooner(const ReportedSweep& one, const ReportedSweep& other) {
  const auto key = [](const ReportedSweep& pair) {
    return std::tuple(!pair.hit, pair.hit ? pair.hit->upper : 0, pair.a, pair.b);
  };
  return key(one) < key(other);
}

std::string line_of(const Scene& scene, const SweepReport& report, const ReportedSweep& pair) {
  const std::optional<ShapeHit>& hit = pair.hit;
  io::Json line = {{"a", io::as_utf8(scene.objects[pair.a].name)},
                   {"b", io::as_utf8(scene.objects[pair.b].name)},
                   {"a_index", pair.a},
                   {"b_index", pair.b},
                   {"hit", hit.has_value()},
                   {"status", name_of(hit ? hit->status : Status::exact)}};
  if (!hit) return io::line_of(line);
  line["lower"] = hit->lower;
  line["upper"] = hit->upper;
  line["point"] = io::json_of(hit->point);
  line["normal"] = io::json_of(hit->normal);
  line["face_a"] = hit->face_a;
  line["face_b"] = hit->face_b;
  line["pose_a"] = motion_of(report.question, scene.objects[pair.a].pose).at(hit->upper).numbers();
  return io::line_of(line);
}

std::string csv_of(const std::optional<ShapeHit>& hit) {
  if (!hit) return ",,,,,,,,,";
  return fmt::format("{},{},{},{},{},{},{},{},{},{}", hit->lower, hit->upper, hit->point.x, hit->point.y, hit->point.z,
                     hit->normal.x, hit->normal.y, hit->normal.z, hit->face_a, hit->face_b);
}

struct SweepKind {
  using Question = SweepQuestion;
  using Report = SweepReport;
  static constexpr const char* name = "sweep";

  static io::Json write(const SweepQuestion& q) {
    io::Json json = {{"moving_objects", q.moving_objects}, {"keys", json_of(q.keys)}};
    if (q.screw) json["screw"] = true;
    if (q.centre != Vec3{}) json["centre"] = io::json_of(q.centre);
    if (q.stop_before != 0) json["stop_before"] = q.stop_before;
    return json;
  }

  static SweepQuestion read(const io::JsonValue& value) {
    value.expect_keys({"question", "moving_objects", "keys", "screw", "centre", "stop_before"});
    SweepQuestion q;
    q.moving_objects = value.whole_or("moving_objects", std::numeric_limits<Index>::max(), 1);
    q.keys = keys_of(value.at("keys"));
    q.screw = value.flag_or("screw", false);
    if (value.has("centre")) q.centre = vector_of(value.at("centre"));
    if (value.has("stop_before")) q.stop_before = value.at("stop_before").number();
    return q;
  }

  static SweepReport ask(const SweepQuestion& question, const io::Asking& asking) {
    if (question.moving_objects == 0 || question.moving_objects >= asking.models.size())
      throw Error(fmt::format("{} of {} objects move: at least one has to, and one has to stand",
                              question.moving_objects, asking.models.size()));
    SweepReport report{question, pairs_asked(asking.models, question.moving_objects)};
    std::vector<RigidMotion> motions;
    for (std::size_t a = 0; a < question.moving_objects; ++a)
      motions.push_back(motion_of(question, asking.models[a].pose));
    parallel_for(report.pairs.size(), asking.options.threads, [&](std::size_t i) {
      ReportedSweep& pair = report.pairs[i];
      pair.hit = swept(asking.models[pair.a], motions[pair.a], asking.models[pair.b], question.stop_before);
    });
    std::sort(report.pairs.begin(), report.pairs.end(), meets_sooner);
    return report;
  }

  static std::string json(const SweepReport& report, const io::Reporting& reporting) {
    io::Json head = reporting.head("toccata/sweep/1");
    head["meeting"] = meeting_count(report);
    head["motion"] = write(report.question);
    return io::with_list(io::document(head), "pairs", report.pairs.size(),
                         [&](std::size_t i) { return line_of(reporting.scene, report, report.pairs[i]); });
  }

  static std::string csv(const SweepReport& report, const Scene& scene) {
    std::string csv = "a,b,hit,status,lower,upper,x,y,z,normal_x,normal_y,normal_z,face_a,face_b\n";
    for (const ReportedSweep& pair : report.pairs)
      csv += fmt::format("{},{},{},{},{}\n", io::csv_field(io::as_utf8(scene.objects[pair.a].name)),
                         io::csv_field(io::as_utf8(scene.objects[pair.b].name)), pair.hit ? 1 : 0,
                         name_of(pair.hit ? pair.hit->status : Status::exact), csv_of(pair.hit));
    return csv;
  }
};

}  // namespace

std::size_t meeting_count(const SweepReport& report) {
  return static_cast<std::size_t>(std::count_if(report.pairs.begin(), report.pairs.end(),
                                                [](const ReportedSweep& pair) { return pair.hit.has_value(); }));
}

RigidMotion motion_of(const SweepQuestion& question, const Pose& pose) {
  if (question.screw && question.keys.size() != 2)
    throw Error(fmt::format("a screw goes from one pose to another; here are {}", question.keys.size()));
  const RigidMotion body = question.screw ? RigidMotion::screw(question.keys[0].pose, question.keys[1].pose)
                                          : RigidMotion::through(question.keys, question.centre);
  return body.carrying(pose);
}

constinit const io::QuestionKind SweepQuestion::kind = io::question_kind<SweepKind>();

}  // namespace toccata
