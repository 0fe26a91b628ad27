#include <chrono>

#include "io/questions/question_kinds.hpp"
#include "io/questions/question_parts.hpp"
#include "io/reports/crowd_parts.hpp"
#include "toccata/core/error.hpp"
#include "toccata/core/version.hpp"
#include "toccata/generate/crowds.hpp"
#include "toccata/io/crowd_report.hpp"
#include "toccata/io/pages.hpp"
#include "toccata/world/world.hpp"

namespace toccata {
namespace {

void require_something(const CrowdWorldQuestion& question) {
  if (question.count == 0 || question.frames == 0) throw Error("a crowd has at least one body and one step");
  io::require_threads(question.threads);
}

/// The bodies of a question, and the World that they fly in.
class FlyingBodies {
 public:
  explicit FlyingBodies(const CrowdWorldQuestion& question, WorldOptions options = {})
      : crowd_(question.count, 0.05, question.seed), world_(with_those_of(question, options)) {
    std::vector<Body> bodies;
    for (std::size_t i = 0; i < crowd_.shapes().size(); ++i)
      bodies.push_back({Model(crowd_.shapes()[i]), crowd_.poses()[i]});
    ids_ = world_.add(bodies);
    world_.step();
  }

  [[nodiscard]] const World& world() const { return world_; }
  void fly() { crowd_.step(); }
  const WorldStep& step() {
    world_.move(ids_, crowd_.poses());
    return world_.step();
  }

 private:
  static WorldOptions with_those_of(const CrowdWorldQuestion& question, WorldOptions options) {
    options.broad_phase = question.method;
    options.threads = question.threads;
    return options;
  }

  BodyCrowd crowd_;
  World world_;
  std::vector<BodyId> ids_;
};

PairDigest digest_of_contacts(const World& world) {
  std::vector<IndexPair> pairs;
  for (const PairReport& pair : world.pairs()) pairs.push_back({pair.a.index, pair.b.index});
  return digest_of(pairs);
}

struct CrowdWorldKind {
  using Question = CrowdWorldQuestion;
  using Report = CrowdWorldReport;
  static constexpr const char* name = "crowd-world";

  static io::Json write(const CrowdWorldQuestion& question) {
    return {{"count", question.count},
            {"frames", question.frames},
            {"method", name_of(question.method)},
            {"seed", std::to_string(question.seed)},
            {"threads", question.threads}};
  }

  static CrowdWorldQuestion read(const io::JsonValue& value) {
    value.expect_keys({"question", "count", "frames", "method", "seed", "threads"});
    CrowdWorldQuestion question;
    take_flight(question, value);
    if (value.has("method"))
      question.method = io::one_named<BroadPhaseMethod>(value.at("method"), broad_phase_methods());
    return question;
  }

  static CrowdWorldReport ask(const CrowdWorldQuestion& question, const io::Asking& asking) {
    return run_crowd_world(question, asking.options.progress);
  }

  static std::string json(const CrowdWorldReport& report, const io::Reporting&) {
    const CrowdWorldQuestion& question = report.question;
    return io::document({{"schema", "toccata/crowd-world/2"},
                         {"version", version},
                         {"count", question.count},
                         {"frames", question.frames},
                         {"seed", question.seed},
                         {"threads", question.threads},
                         {"method", name_of(question.method)},
                         {"used_method", name_of(report.used)},
                         {"median_ms", report.frames.median_ms()},
                         {"worst_ms", report.frames.worst_ms()},
                         {"pairs", report.pairs()},
                         {"begin", report.begin},
                         {"end", report.end},
                         {"digest", io::text_of(report.frames.pairs)}});
  }
};

}  // namespace

CrowdWorldReport run_crowd_world(const CrowdWorldQuestion& question, const Progress& progress) {
  using Clock = std::chrono::steady_clock;
  require_something(question);
  FlyingBodies bodies(question);
  CrowdWorldReport report{question, {}};
  for (std::size_t frame = 0; frame < question.frames; ++frame) {
    bodies.fly();
    const auto start = Clock::now();
    const WorldStep& step = bodies.step();
    report.frames.milliseconds.push_back(std::chrono::duration<double, std::milli>(Clock::now() - start).count());
    report.frames.pairs.push_back(digest_of_contacts(bodies.world()));
    report.begin += step.begin.size();
    report.end += step.end.size();
    if (progress) progress(frame + 1, question.frames);
  }
  report.used = bodies.world().broad_phase().method();
  return report;
}

WorldRecording record_crowd_world(const CrowdWorldQuestion& question, const Progress& progress) {
  require_something(question);
  FlyingBodies bodies(question, {.relation = true, .manifold = true, .penetration = true});
  WorldRecording recording;
  recording.add(bodies.world());
  for (std::size_t frame = 0; frame < question.frames; ++frame) {
    bodies.fly();
    bodies.step();
    recording.add(bodies.world());
    if (progress) progress(frame + 1, question.frames);
  }
  return recording;
}

namespace io {
constinit const QuestionKind crowd_world_kind = question_kind<CrowdWorldKind>();
}  // namespace io

}  // namespace toccata
