#pragma once

#include <type_traits>

#include "reports/questions/question_kind.hpp"

namespace toccata::io {

/// In the order of SceneQuestion's alternatives.
inline constexpr auto question_kinds =
    SceneQuestions::of_each([]<class Listed>(std::type_identity<Listed>) { return &Listed::Question::kind; });

inline const QuestionKind& question_kind_of(const SceneQuestion& question) { return *question_kinds[question.index()]; }
inline const QuestionKind& question_kind_of(const SceneAnswer& answer) { return *question_kinds[answer.index()]; }

/// The "query" of a case, and back. Reading throws Error naming the place.
[[nodiscard]] Json json_of(const SceneQuestion& question);
[[nodiscard]] SceneQuestion question_of(const JsonValue& value);

}  // namespace toccata::io
