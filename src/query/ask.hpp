#pragma once

#include <array>
#include <concepts>
#include <optional>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "query/posed_shape.hpp"
#include "query/search_scratch.hpp"
#include "toccata/core/error.hpp"
#include "toccata/query/contacts.hpp"
#include "toccata/query/pairs.hpp"

// A question is an object with overloads for two shapes at their places, each pair of types in one order only. Here it
// is asked of any two: as it is, else the other way round, else the table of pairs.hpp has to say why not.
namespace toccata {

template <class>
inline constexpr ShapeClass posed_class = ShapeClass::convex;
template <>
inline constexpr ShapeClass posed_class<PosedHalfSpace> = ShapeClass::half_space;
template <>
inline constexpr ShapeClass posed_class<PosedTriangles> = ShapeClass::triangles;
template <>
inline constexpr ShapeClass posed_class<PosedQuadric> = ShapeClass::quadric;

/// Some pair of kinds of these classes has a defined answer.
constexpr bool table_defines(ShapeQuestion question, ShapeClass a, ShapeClass b) {
  for (std::size_t i = 0; i < shape_kind_count; ++i)
    for (std::size_t j = 0; j < shape_kind_count; ++j) {
      const auto kind_a = static_cast<ShapeKind>(i), kind_b = static_cast<ShapeKind>(j);
      if (class_of(kind_a) == a && class_of(kind_b) == b &&
          pair_cell(question, kind_a, kind_b).state == PairState::defined)
        return true;
    }
  return false;
}

/// The table defines the question for the two models' shapes.
inline bool is_defined(ShapeQuestion question, const Model& a, const Model& b) {
  return pair_cell(question, kind_of(a.shape()), kind_of(b.shape())).state == PairState::defined;
}

/// Throws Error, with the reason, unless the table defines the question for the two kinds.
inline void require_answered(ShapeQuestion question, ShapeKind a, ShapeKind b) {
  const PairCell cell = pair_cell(question, a, b);
  if (cell.state != PairState::defined)
    throw Error(
        fmt::format("{} of a {} and a {} is not defined: {}", name_of(question), name_of(a), name_of(b), cell.text));
}

template <class Asked, class A, class B>
auto ask(const Asked& question, const A& a, const B& b) {
  constexpr bool defined = table_defines(Asked::question, posed_class<A>, posed_class<B>);
  if constexpr (std::invocable<const Asked&, const A&, const B&>) {
    static_assert(defined, "an algorithm of which the table does not know");
    return question(a, b);
  } else if constexpr (std::invocable<const Asked&, const B&, const A&>) {
    static_assert(defined, "an algorithm of which the table does not know");
    return flipped(question(b, a));
  } else {
    static_assert(!defined, "no algorithm for this pair");
    using Answer = decltype(question(std::declval<const PosedPolytope&>(), std::declval<const PosedPolytope&>()));
    // The table was asked before.
    return Answer{};
  }
}

/// Asks the question about two posed shapes, whichever they are. Throws Error for what the table does not define.
template <class Asked>
auto ask(const Asked& question, const PosedPart& a, const PosedPart& b) {
  require_answered(Asked::question, a.kind, b.kind);
  return std::visit([&](const auto& x, const auto& y) { return ask(question, x, y); }, a.shape, b.shape);
}

/// Throws Error for what the table does not define of any two parts, the first two of each two kinds.
inline void require_all_answered(ShapeQuestion question, const PosedModel& a, const PosedModel& b) {
  const auto kinds_of = [](const PosedModel& model) {
    std::array<bool, shape_kind_count> kinds{};
    for (const PosedPart& part : model.parts) kinds[static_cast<std::size_t>(part.kind)] = true;
    return kinds;
  };
  const auto kinds_a = kinds_of(a), kinds_b = kinds_of(b);
  for (std::size_t i = 0; i < shape_kind_count; ++i)
    for (std::size_t j = 0; j < shape_kind_count; ++j)
      if (kinds_a[i] && kinds_b[j]) require_answered(question, static_cast<ShapeKind>(i), static_cast<ShapeKind>(j));
}

/// Two models at their places, each the union of its parts. The parts lie in memory that is lent by a scratch.
struct PosedModelPair {
  PosedModelPair(const Model& model_a, const Model& model_b, const PairQuery& query, SearchScratch& scratch)
      : a(pose_model(model_a, query.pose_a, query.solid_a, "model a", std::move(scratch.posed[0]))),
        b(pose_model(model_b, query.pose_b, query.solid_b, "model b", std::move(scratch.posed[1]))),
        lender_(scratch) {}
  ~PosedModelPair() {
    give_back(a, lender_.posed[0]);
    give_back(b, lender_.posed[1]);
  }
  PosedModelPair(const PosedModelPair&) = delete;
  PosedModelPair& operator=(const PosedModelPair&) = delete;

  /// Each of the two is one part.
  [[nodiscard]] bool are_single() const { return a.parts.size() == 1 && b.parts.size() == 1; }

  PosedModel a;
  PosedModel b;

 private:
  /// Memory alone: a scratch keeps no model alive.
  static void give_back(PosedModel& model, std::vector<PosedPart>& lender) {
    model.parts.clear();
    lender = std::move(model.parts);
  }

  SearchScratch& lender_;
};

/// Asks the question about two models that are one shape each, as all are for which the table defines such a question.
/// Throws Error where it does not.
template <class Asked>
auto ask_single(const Model& a, const Model& b, const PairQuery& query, SearchScratch& scratch) {
  require_answered(Asked::question, kind_of(a.shape()), kind_of(b.shape()));
  const PosedModelPair models(a, b, query, scratch);
  return ask(Asked{scratch}, models.a.parts[0], models.b.parts[0]);
}

}  // namespace toccata
