#include "toccata/reports/crowd_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <numeric>

#include "reports/questions/question_kinds.hpp"
#include "reports/questions/question_parts.hpp"
#include "toccata/bounds/ball.hpp"
#include "toccata/bounds/obb.hpp"
#include "toccata/core/error.hpp"
#include "toccata/core/random.hpp"
#include "toccata/core/version.hpp"
#include "toccata/generate/crowds.hpp"
#include "toccata/math/pose.hpp"
#include "toccata/reports/pages.hpp"
#include "toccata/world/world.hpp"

namespace toccata {
namespace {

/// The pairs of all frames, each in its place, as 16 hexadecimal digits.
std::string text_of(std::span<const PairDigest> frames) {
  std::uint64_t digest = 0;
  for (const PairDigest& frame : frames) digest = Random(digest + frame.sum).bits() + frame.count;
  return fmt::format("{:016x}", digest);
}

void require_threads(int threads) {
  constexpr int most = 1024;
  if (threads < 0 || threads > most)
    throw Error(fmt::format("{} threads cannot be: say from 1 to {}, or 0 for as many as there are", threads, most));
}

/// Around the box: its corners are as far from its middle, but for rounding.
Ball ball_around_box(const Aabb& box, Index) {
  const std::array<Vec3, 2> corners{box.lower, box.upper};
  return fit_ball_fast(corners);
}

/// Turns the box by the golden angle: no two that are near in number stand alike.
Obb turned_box(const Aabb& box, Index number) {
  const Vec3 half = 0.5 * (box.upper - box.lower);
  return {box.lower + half, rotation_about({0, 0, 1}, std::fmod(137.5 * number, 360.0)), half};
}

/// The boxes of a crowd in a broad phase, bounded as it is asked.
class BoundedCrowd {
 public:
  explicit BoundedCrowd(const CrowdQuestion& question, BroadPhaseMethod method)
      : bounds_(question.bounds),
        crowd_(question.scene, question.count, question.seed),
        phase_({method, question.threads}) {
    std::vector<Index> all(crowd_.boxes().size());
    std::iota(all.begin(), all.end(), Index{0});
    with_bounds(all, [&](const auto& bounds) { phase_.add(bounds); });
    phase_.update();
  }

  [[nodiscard]] Crowd& crowd() { return crowd_; }
  [[nodiscard]] const BroadPhase& phase() const { return phase_; }

  /// Takes over what moved and finds all pairs. Gives the milliseconds.
  double update(std::span<const Index> moved) {
    using Clock = std::chrono::steady_clock;
    double milliseconds = 0;
    with_bounds(moved, [&](const auto& to) {
      const auto start = Clock::now();
      phase_.move(moved, to);
      phase_.update();
      milliseconds = std::chrono::duration<double, std::milli>(Clock::now() - start).count();
    });
    return milliseconds;
  }

 private:
  template <class Take>
  void with_bounds(std::span<const Index> numbers, const Take& take) const {
    const auto made = [&](const auto& bound_of) {
      std::vector<decltype(bound_of(crowd_.boxes()[0], Index{0}))> bounds;
      bounds.reserve(numbers.size());
      for (const Index number : numbers) bounds.push_back(bound_of(crowd_.boxes()[number], number));
      take(bounds);
    };
    if (bounds_ == CrowdBounds::balls) return made(ball_around_box);
    if (bounds_ == CrowdBounds::oriented) return made(turned_box);
    made([](const Aabb& box, Index) { return box; });
  }

  CrowdBounds bounds_;
  Crowd crowd_;
  BroadPhase phase_;
};

CrowdRun run_of(BroadPhaseMethod method, const CrowdQuestion& question, const Progress& progress, std::size_t done) {
  const std::size_t total = question.methods.size() * question.frames;
  BoundedCrowd crowd(question, method);
  const BroadPhase& phase = crowd.phase();
  CrowdRun run;
  run.method = method;
  run.frames = run_frames(
      crowd.crowd(), question.frames, [&](std::span<const Index> moved) { return crowd.update(moved); },
      [&] {
        const PairChanges changes = phase.changes();
        run.begin += changes.begin.size();
        run.end += changes.end.size();
        if (progress) progress(++done, total);
        return digest_of(phase.pairs());
      });
  run.bytes_per_body = static_cast<double>(phase.bytes()) / static_cast<double>(question.count);
  run.reason = phase.reason();
  return run;
}

/// The methods check each other, frame by frame.
void require_same(const std::vector<CrowdRun>& runs) {
  const CrowdRun& first = runs.front();
  for (const CrowdRun& run : runs) {
    const auto differ = std::mismatch(run.frames.pairs.begin(), run.frames.pairs.end(), first.frames.pairs.begin());
    if (differ.first != run.frames.pairs.end())
      throw Error(fmt::format("{} and {} found different pairs in frame {}: this is a defect of Toccata",
                              name_of(run.method), name_of(first.method), differ.first - run.frames.pairs.begin() + 1));
    if (run.begin != first.begin || run.end != first.end)
      throw Error(fmt::format("of {} and {} other pairs began or ended: this is a defect of Toccata",
                              name_of(run.method), name_of(first.method)));
  }
}

void require_something(const CrowdQuestion& question) {
  if (question.count == 0 || question.frames == 0 || question.methods.empty())
    throw Error("a crowd has at least one box, one frame, and one method that finds its pairs");
  require_threads(question.threads);
}

io::Json json_of(const CrowdRun& run) {
  return {{"method", name_of(run.method)},
          {"median_ms", run.frames.median_ms()},
          {"worst_ms", run.frames.worst_ms()},
          {"pairs", run.pairs()},
          {"begin", run.begin},
          {"end", run.end},
          {"digest", text_of(run.frames.pairs)},
          {"bytes_per_body", run.bytes_per_body},
          {"reason", run.reason}};
}

/// A text, as JSON's numbers tell only 2⁵³ of them apart.
std::uint64_t seed_of(const io::JsonValue& value) {
  const std::string text = value.text();
  std::uint64_t seed = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), seed);
  if (error != std::errc() || end != text.data() + text.size())
    value.fail(fmt::format("{} is no seed", text), "write a whole number below 2^64 as a text, \"1\"");
  return seed;
}

/// How many fly, for how long, from which seed.
template <class Question>
void take_flight(Question& question, const io::JsonValue& value) {
  question.count = value.whole_or("count", 100'000'000, question.count);
  question.frames = value.whole_or("frames", 100'000'000, question.frames);
  if (value.has("seed")) question.seed = seed_of(value.at("seed"));
  question.threads = static_cast<int>(value.whole_or("threads", 1024, 1));
}

struct CrowdKind {
  using Question = CrowdQuestion;
  using Report = CrowdReport;
  static constexpr const char* name = "crowd";

  static io::Json write(const CrowdQuestion& question) {
    return {{"scene", question.scene},
            {"count", question.count},
            {"frames", question.frames},
            {"methods", io::names_of(question.methods)},
            {"seed", std::to_string(question.seed)},
            {"threads", question.threads},
            {"bounds", name_of(question.bounds)}};
  }

  static CrowdQuestion read(const io::JsonValue& value) {
    value.expect_keys({"question", "scene", "count", "frames", "methods", "seed", "threads", "bounds"});
    CrowdQuestion question;
    question.scene = value.text_or("scene", question.scene);
    take_flight(question, value);
    io::take_list<BroadPhaseMethod>(question.methods, value, "methods", broad_phase_methods());
    if (value.has("bounds")) question.bounds = io::one_named<CrowdBounds>(value.at("bounds"), all_crowd_bounds);
    return question;
  }

  static CrowdReport ask(const CrowdQuestion& question, const io::Asking& asking) {
    return run_crowd(question, asking.options.progress);
  }

  static std::string json(const CrowdReport& report, const io::Reporting&) {
    const CrowdQuestion& question = report.question;
    io::Json json = {{"schema", "toccata/crowd/2"}, {"version", version},
                     {"scene", question.scene},     {"bounds", name_of(question.bounds)},
                     {"count", question.count},     {"frames", question.frames},
                     {"seed", question.seed},       {"threads", question.threads},
                     {"methods", io::Json::array()}};
    for (const CrowdRun& run : report.runs) json["methods"].push_back(json_of(run));
    return io::document(json);
  }
};

void require_something(const CrowdWorldQuestion& question) {
  if (question.count == 0 || question.frames == 0) throw Error("a crowd has at least one body and one step");
  require_threads(question.threads);
}

/// The bodies of a question, and the World that they fly in.
class FlyingBodies {
 public:
  explicit FlyingBodies(const CrowdWorldQuestion& question, WorldOptions options = {})
      : crowd_(question.scene, question.count, question.seed), world_(with_those_of(question, options)) {
    std::vector<Body> bodies;
    for (std::size_t i = 0; i < crowd_.shapes().size(); ++i) {
      const BodyType type = i < crowd_.ground_count() ? BodyType::static_body : BodyType::dynamic_body;
      bodies.push_back({Model(crowd_.shapes()[i]), crowd_.poses()[i], type});
    }
    ids_ = world_.add(bodies);
    world_.prepare();
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
    return {{"scene", question.scene},
            {"count", question.count},
            {"frames", question.frames},
            {"method", name_of(question.method)},
            {"seed", std::to_string(question.seed)},
            {"threads", question.threads}};
  }

  static CrowdWorldQuestion read(const io::JsonValue& value) {
    value.expect_keys({"question", "scene", "count", "frames", "method", "seed", "threads"});
    CrowdWorldQuestion question;
    question.scene = value.text_or("scene", question.scene);
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
    return io::document({{"schema", "toccata/crowd-world/3"},
                         {"version", version},
                         {"scene", question.scene},
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
                         {"digest", text_of(report.frames.pairs)}});
  }
};

}  // namespace

std::string_view name_of(CrowdBounds bounds) {
  constexpr std::array<std::string_view, all_crowd_bounds.size()> names{"boxes", "balls", "oriented"};
  return names[static_cast<std::size_t>(bounds)];
}

CrowdReport run_crowd(const CrowdQuestion& question, const Progress& progress) {
  require_something(question);
  CrowdReport report{question, {}};
  for (std::size_t i = 0; i < question.methods.size(); ++i)
    report.runs.push_back(run_of(question.methods[i], question, progress, i * question.frames));
  require_same(report.runs);
  return report;
}

CrowdRecording record_crowd(const CrowdQuestion& question, const Progress& progress, const CrowdCells& cells) {
  require_something(question);
  BoundedCrowd crowd(question, question.methods.front());
  CrowdRecording recording;
  const auto record = [&] {
    if (cells)
      recording.add(crowd.phase(), cells(crowd.crowd().boxes()));
    else
      recording.add(crowd.phase());
  };
  record();
  for (std::size_t frame = 0; frame < question.frames; ++frame) {
    crowd.update(crowd.crowd().step());
    record();
    if (progress) progress(frame + 1, question.frames);
  }
  return recording;
}

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

constinit const io::QuestionKind CrowdQuestion::kind = io::question_kind<CrowdKind>();
constinit const io::QuestionKind CrowdWorldQuestion::kind = io::question_kind<CrowdWorldKind>();

}  // namespace toccata
