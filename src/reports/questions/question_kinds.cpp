#include "reports/questions/question_kinds.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "reports/report_parts.hpp"
#include "toccata/core/error.hpp"

namespace toccata {
namespace io {

BatchOptions Asking::batch() const {
  BatchOptions batch;
  batch.threads = options.threads;
  batch.progress = options.progress;
  return batch;
}

void Asking::require_two() const {
  if (models.size() != 2)
    throw Error(fmt::format("poses are asked about two objects, the first placed as A and the second as B; here {} {}",
                            models.size() == 1 ? "is" : "are", models.size()));
}

Json Reporting::head(const char* schema) const {
  return report_head(schema, scene, summaries.empty() ? objects_json(scene, models) : objects_json(scene, summaries),
                     warnings);
}

std::vector<Json> Reporting::boxes() const {
  std::vector<Json> boxes;
  for (const SceneInstance& model : models) boxes.push_back(box_json(model));
  for (const std::string& summary : summaries) boxes.push_back(Json::parse(summary)["box"]);
  return boxes;
}

Json json_of(const SceneQuestion& question) {
  const QuestionKind& kind = question_kind_of(question);
  Json json = {{"question", kind.name}};
  json.update(kind.write(question));
  return json;
}

SceneQuestion question_of(const JsonValue& value) {
  const std::string name = value.at("question").text();
  std::vector<std::string> known;
  for (const QuestionKind* kind : question_kinds) {
    if (name == kind->name) return kind->read(value);
    known.emplace_back(kind->name);
  }
  std::sort(known.begin(), known.end());
  const std::string near = nearest_word(name, known);
  value.at("question")
      .fail(fmt::format("there is no question {}", name),
            near.empty() ? "see docs/reference/scene-file.md" : fmt::format("did you mean {}?", near));
}

}  // namespace io

SceneAnswer ask(std::span<const SceneInstance> models, const SceneQuestion& question, const AskOptions& options) {
  return io::question_kind_of(question).ask(question, {models, options});
}

SceneAnswer ask(const Scene& scene, std::span<const SceneInstance> models, const SceneQuestion& question,
                const AskOptions& options) {
  return io::question_kind_of(question).ask(question, {models, options, &scene});
}

bool is_of_crowd(const SceneQuestion& question) {
  return std::holds_alternative<CrowdQuestion>(question) || std::holds_alternative<CrowdWorldQuestion>(question);
}

std::string name_of(const SceneQuestion& question) { return io::question_kind_of(question).name; }

std::string report_json(const Scene& scene, std::span<const SceneInstance> models, const SceneAnswer& answer,
                        std::span<const std::string> warnings) {
  return io::question_kind_of(answer).json(answer, {scene, models, warnings});
}

std::string check_report_json(const Scene& scene, std::span<const std::string> summaries, const CheckReport& report,
                              std::span<const std::string> warnings) {
  return CheckQuestion::kind.json(report, {scene, {}, warnings, summaries});
}

std::string report_csv(const Scene& scene, const SceneAnswer& answer) {
  const io::QuestionKind& kind = io::question_kind_of(answer);
  if (kind.csv == nullptr) throw Error("this answer has no form in lines of values; take JSON");
  return kind.csv(answer, scene);
}

}  // namespace toccata
