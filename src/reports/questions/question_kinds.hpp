#pragma once

#include <array>
#include <variant>

#include "reports/questions/question_kind.hpp"

namespace toccata::io {

// Each in a file of its own, where all of its kind is.
extern const QuestionKind check_kind, check_poses_kind, self_kind, distance_kind, distance_poses_kind, ray_kind,
    faces_kind, nearest_kind, inspect_kind, hierarchy_kind, cost_kind, crowd_kind, decompose_kind, minkowski_kind,
    crowd_world_kind;

/// In the order of SceneQuestion's alternatives.
inline constexpr std::array question_kinds = {&check_kind,          &check_poses_kind, &self_kind,       &distance_kind,
                                              &distance_poses_kind, &ray_kind,         &faces_kind,      &nearest_kind,
                                              &inspect_kind,        &hierarchy_kind,   &cost_kind,       &crowd_kind,
                                              &decompose_kind,      &minkowski_kind,   &crowd_world_kind};
static_assert(question_kinds.size() == std::variant_size_v<SceneQuestion> &&
              question_kinds.size() == std::variant_size_v<SceneAnswer>);

inline const QuestionKind& question_kind_of(const SceneQuestion& question) { return *question_kinds[question.index()]; }
inline const QuestionKind& question_kind_of(const SceneAnswer& answer) { return *question_kinds[answer.index()]; }

/// The "query" of a case, and back. Reading throws Error naming the place.
[[nodiscard]] Json json_of(const SceneQuestion& question);
[[nodiscard]] SceneQuestion question_of(const JsonValue& value);

}  // namespace toccata::io
