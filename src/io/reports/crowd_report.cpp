#include "toccata/io/crowd_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>

#include "io/reports/report_parts.hpp"
#include "toccata/core/error.hpp"
#include "toccata/core/version.hpp"
#include "toccata/generate/crowds.hpp"
#include "toccata/io/crowd_page.hpp"

namespace toccata {
namespace {

using io::Json;

/// Takes over what moved and finds all pairs.
void update(BroadPhase& phase, std::span<const Index> moved, const std::vector<Aabb>& to) {
  phase.move(moved, to);
  phase.update();
}

std::vector<Aabb> boxes_of(std::span<const Index> moved, const std::vector<Aabb>& boxes) {
  std::vector<Aabb> to;
  to.reserve(moved.size());
  for (const Index number : moved) to.push_back(boxes[number]);
  return to;
}

/// Gives the milliseconds.
double timed_update(BroadPhase& phase, std::span<const Index> moved, const std::vector<Aabb>& boxes) {
  using Clock = std::chrono::steady_clock;
  const std::vector<Aabb> to = boxes_of(moved, boxes);
  const auto start = Clock::now();
  update(phase, moved, to);
  return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

CrowdRun run_of(BroadPhaseMethod method, const CrowdQuestion& question, const Progress& progress, std::size_t done) {
  const std::size_t total = question.methods.size() * question.frames;
  Crowd crowd(question.scene, question.count, question.seed);
  BroadPhase phase({method, question.threads});
  phase.add(crowd.boxes());
  phase.update();
  CrowdRun run;
  run.method = method;
  run.frames = run_frames(
      crowd, question.frames, [&](std::span<const Index> moved) { return timed_update(phase, moved, crowd.boxes()); },
      [&] {
        const PairChanges changes = phase.changes();
        run.begun += changes.begun.size();
        run.ended += changes.ended.size();
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
    if (run.begun != first.begun || run.ended != first.ended)
      throw Error(fmt::format("of {} and {} other pairs began or ended: this is a defect of Toccata",
                              name_of(run.method), name_of(first.method)));
  }
}

void require_something(const CrowdQuestion& question) {
  if (question.count == 0 || question.frames == 0 || question.methods.empty())
    throw Error("a crowd has at least one box, one frame, and one method that finds its pairs");
}

Json json_of(const CrowdRun& run) {
  return {{"method", name_of(run.method)},
          {"median_ms", run.frames.median_ms()},
          {"worst_ms", run.frames.worst_ms()},
          {"pairs", run.pairs()},
          {"begun", run.begun},
          {"ended", run.ended},
          {"bytes_per_body", run.bytes_per_body},
          {"reason", run.reason}};
}

}  // namespace

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
  Crowd crowd(question.scene, question.count, question.seed);
  BroadPhase phase({question.methods.front(), question.threads});
  phase.add(crowd.boxes());
  phase.update();
  CrowdRecording recording;
  const auto record = [&] {
    if (cells)
      recording.add(phase, cells(crowd.boxes()));
    else
      recording.add(phase);
  };
  record();
  for (std::size_t frame = 0; frame < question.frames; ++frame) {
    const std::span<const Index> moved = crowd.step();
    update(phase, moved, boxes_of(moved, crowd.boxes()));
    record();
    if (progress) progress(frame + 1, question.frames);
  }
  return recording;
}

std::string crowd_report_json(const CrowdReport& report) {
  const CrowdQuestion& question = report.question;
  Json json = {{"schema", "toccata/crowd/1"}, {"version", version},        {"scene", question.scene},
               {"count", question.count},     {"frames", question.frames}, {"seed", question.seed},
               {"threads", question.threads}, {"methods", Json::array()}};
  for (const CrowdRun& run : report.runs) json["methods"].push_back(json_of(run));
  return io::document(json);
}

}  // namespace toccata
