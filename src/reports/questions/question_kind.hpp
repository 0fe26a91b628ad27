#pragma once

#include <array>
#include <concepts>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "io/formats/json.hpp"
#include "io/formats/json_value.hpp"
#include "toccata/reports/scene_question.hpp"

namespace toccata::io {

class GlbFindings;
class LayerWriter;
class PairMethods;

/// About what a question is asked, and how.
struct Asking {
  std::span<const SceneInstance> models;
  const AskOptions& options;
  const Scene* scene = nullptr;  ///< the models', where it is known

  [[nodiscard]] BatchOptions batch() const;
  /// Throws Error where there are not two models, which are asked about at many poses.
  void require_two() const;
};

/// What a report is about.
struct Reporting {
  const Scene& scene;
  std::span<const SceneInstance> models;
  std::span<const std::string> warnings;
  std::span<const std::string> summaries{};  ///< `object_summaries` instead of models, where these are elsewhere

  /// `report_head` of that schema.
  [[nodiscard]] Json head(const char* schema) const;
  /// Around each object in its own frame, or null where it has no end: by it and its pose another report knows whether
  /// it has moved since.
  [[nodiscard]] std::vector<Json> boxes() const;
};

/// The two objects that a finding is about; one alone is named twice.
using NamedObjects = std::array<Index, 2>;

/// All that is done with one kind of question and with what it found. What is null is left out: most kinds have no
/// need of it.
struct QuestionKind {
  const char* name;                         ///< as `name_of` tells it
  Json (*write)(const SceneQuestion&);      ///< the "query" of a case (docs/reference/scene-file.md)
  SceneQuestion (*read)(const JsonValue&);  ///< and back; throws Error naming the place
  SceneAnswer (*ask)(const SceneQuestion&, const Asking&);
  std::string (*json)(const SceneAnswer&, const Reporting&);
  std::string (*csv)(const SceneAnswer&, const Scene&);  ///< with a header line
  // What pages and GLB files show of an answer.
  void (*mark)(const SceneAnswer&, LayerWriter&);          ///< the layers of a page, finding by finding
  Json (*words)(const SceneAnswer&, PairMethods&);         ///< for each finding what a page says of it
  void (*show)(const SceneAnswer&, GlbFindings&);          ///< the nodes of a GLB file
  std::vector<NamedObjects> (*named)(const SceneAnswer&);  ///< the objects that are drawn in the colours of a pair
  void (*leave_out_drawn)(SceneAnswer&);                   ///< what is in layers the report of a page need not say
};

/// A struct of static functions that has the first five of these, and of the others those that it needs, for a
/// Question and a Report of its own.
template <class Kind>
concept DescribesQuestion = requires(const typename Kind::Question& question, const JsonValue& value,
                                     const typename Kind::Report& report, const Asking& asking,
                                     const Reporting& reporting) {
  { Kind::name } -> std::convertible_to<const char*>;
  { Kind::write(question) } -> std::same_as<Json>;
  { Kind::read(value) } -> std::same_as<typename Kind::Question>;
  { Kind::ask(question, asking) } -> std::same_as<typename Kind::Report>;
  { Kind::json(report, reporting) } -> std::same_as<std::string>;
};

/// The functions of a kind, which know their own types, behind those that take any question and answer.
template <DescribesQuestion Kind>
constexpr QuestionKind question_kind() {
  using Question = typename Kind::Question;
  using Report = typename Kind::Report;
  QuestionKind kind{};
  kind.name = Kind::name;
  kind.write = [](const SceneQuestion& q) { return Kind::write(std::get<Question>(q)); };
  kind.read = [](const JsonValue& value) { return SceneQuestion(Kind::read(value)); };
  kind.ask = [](const SceneQuestion& q, const Asking& asking) {
    return SceneAnswer(Kind::ask(std::get<Question>(q), asking));
  };
  kind.json = [](const SceneAnswer& a, const Reporting& of) { return Kind::json(std::get<Report>(a), of); };
  if constexpr (requires { &Kind::csv; })
    kind.csv = [](const SceneAnswer& a, const Scene& scene) { return Kind::csv(std::get<Report>(a), scene); };
  if constexpr (requires { &Kind::mark; })
    kind.mark = [](const SceneAnswer& a, LayerWriter& layers) { Kind::mark(std::get<Report>(a), layers); };
  if constexpr (requires { &Kind::words; })
    kind.words = [](const SceneAnswer& a, PairMethods& methods) { return Kind::words(std::get<Report>(a), methods); };
  if constexpr (requires { &Kind::show; })
    kind.show = [](const SceneAnswer& a, GlbFindings& nodes) { Kind::show(std::get<Report>(a), nodes); };
  if constexpr (requires { &Kind::named; })
    kind.named = [](const SceneAnswer& a) { return Kind::named(std::get<Report>(a)); };
  if constexpr (requires { &Kind::leave_out_drawn; })
    kind.leave_out_drawn = [](SceneAnswer& a) { Kind::leave_out_drawn(std::get<Report>(a)); };
  return kind;
}

}  // namespace toccata::io
