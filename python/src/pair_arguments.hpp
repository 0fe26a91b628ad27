#pragma once

#include <nanobind/nanobind.h>

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include <toccata/query/batch.hpp>

#include "arrays.hpp"
#include "calls.hpp"
#include "shapes.hpp"

// What questions about two shapes are asked with: `a, b, pose_a, pose_b`, and of many the same in the plural.
namespace toccata::python {

[[nodiscard]] PairQuery query_of(const PoseLike& pose_a, const PoseLike& pose_b, Solid solid_a, Solid solid_b);

/// What a batch asks about: two shapes at many poses, or pairs of shapes. A shape or a pose of which there is one
/// stands for all. Poses of arrays stay where they are.
class PairsAsked {
 public:
  /// Throws Error where the counts differ.
  PairsAsked(const ShapesLike& a, const ShapesLike& b, const PosesLike& poses_a, const PosesLike& poses_b,
             Solid solid_a, Solid solid_b);

  /// Refers to this.
  [[nodiscard]] Batch<PairQuery> batch() const;
  /// The models and the query of question i.
  [[nodiscard]] const Model& a(std::size_t i) const { return a_[i]; }
  [[nodiscard]] const Model& b(std::size_t i) const { return b_[i]; }
  [[nodiscard]] PairQuery query(std::size_t i) const {
    return {.pose_a = poses_a_[i], .pose_b = poses_b_[i], .solid_a = solid_a_, .solid_b = solid_b_};
  }
  /// The same, as a batch asks for it.
  PairQuery operator()(std::size_t i) const { return query(i); }

 private:
  Models a_, b_;
  Poses poses_a_, poses_b_;
  Solid solid_a_, solid_b_;
  std::size_t count_;
  std::vector<ModelPair> pairs_;  ///< where there are many of one of the shapes
};

/// `ask(batch, options)`, without the lock and so that Ctrl-C ends it.
template <class Ask>
auto asked_of_pairs(const PairsAsked& pairs, int threads, const Ask& ask) {
  const Batch<PairQuery> batch = pairs.batch();
  const Interruptible call(threads);
  return call.ask([&](const BatchOptions& options) { return ask(batch, options); });
}

/// `one` with the arguments that a question about two shapes has.
template <class Function>
void def_pair_question(nb::module_& module, const char* name, const char* doc, Function one) {
  module.def(name, one, nb::arg("a"), nb::arg("b"), nb::arg("pose_a") = nb::none(), nb::arg("pose_b") = nb::none(),
             nb::kw_only(), nb::arg("solid_a") = Solid::automatic, nb::arg("solid_b") = Solid::automatic, doc);
}

/// The question for many: `told(pairs, threads)`.
template <class Tell>
void def_pair_questions(nb::module_& module, const char* name, const char* doc, Tell tell) {
  module.def(
      name,
      [tell](const ShapesLike& a, const ShapesLike& b, const PosesLike& poses_a, const PosesLike& poses_b,
             Solid solid_a, Solid solid_b,
             int threads) { return tell(PairsAsked(a, b, poses_a, poses_b, solid_a, solid_b), threads); },
      nb::arg("a"), nb::arg("b"), nb::arg("poses_a") = nb::none(), nb::arg("poses_b") = nb::none(), nb::kw_only(),
      nb::arg("solid_a") = Solid::automatic, nb::arg("solid_b") = Solid::automatic, nb::arg("threads") = all_threads,
      doc);
}

}  // namespace toccata::python
