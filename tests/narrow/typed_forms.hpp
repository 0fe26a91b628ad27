#pragma once

#include <optional>

#include "support/convex_cases.hpp"
#include "toccata/narrow/primitives.hpp"

// The functions for just two kinds of shape, asked of a case.
namespace toccata::test {

inline PosedSphere placed(const Sphere& s, const Pose& pose) { return PosedSphere(s, pose); }
inline PosedCapsule placed(const Capsule& c, const Pose& pose) { return PosedCapsule(c, pose); }
inline PosedBox placed(const Box& b, const Pose& pose) { return PosedBox(b, pose); }
inline Triangle placed(const Triangle& t, const Pose& pose) {
  return {{transform(pose, t[0]), transform(pose, t[1]), transform(pose, t[2])}};
}
inline Segment placed(const Segment& s, const Pose& pose) {
  return Segment(transform(pose, s.start()), transform(pose, s.end()));
}

struct TypedAnswers {
  bool overlap = false;
  Distance distance{};
};

/// Which common point of two cores the search names may depend on the frames that its shapes come from; a formula does
/// not know them.
inline bool same_answer(const Distance& typed, const Distance& generic, bool by_formula) {
  if (by_formula || generic.upper > 0) return typed == generic;
  return typed.upper == 0;
}

/// Nothing where there are no such functions, in this order.
inline std::optional<TypedAnswers> typed_answers(const ConvexCase& pair) {
  return std::visit(
      [&](const auto& a, const auto& b) -> std::optional<TypedAnswers> {
        if constexpr (requires {
                        distance(placed(a, Pose{}), placed(b, Pose{}));
                        overlap(placed(a, Pose{}), placed(b, Pose{}));
                      }) {
          const auto placed_a = placed(a, pair.a.pose);
          const auto placed_b = placed(b, pair.b.pose);
          return TypedAnswers{overlap(placed_a, placed_b), distance(placed_a, placed_b)};
        } else {
          return {};
        }
      },
      pair.a.shape, pair.b.shape);
}

/// By the functions that take shapes and their poses; nothing where there are none, in this order.
inline std::optional<TypedAnswers> answers_of_given(const ConvexCase& pair) {
  return std::visit(
      [&](const auto& a, const auto& b) -> std::optional<TypedAnswers> {
        if constexpr (requires { distance(a, pair.a.pose, b, pair.b.pose); })
          return TypedAnswers{overlap(a, pair.a.pose, b, pair.b.pose), distance(a, pair.a.pose, b, pair.b.pose)};
        else
          return {};
      },
      pair.a.shape, pair.b.shape);
}

}  // namespace toccata::test
