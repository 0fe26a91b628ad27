#include <fmt/format.h>

#include <optional>

#include "convex_library.hpp"
#include "toccata/core/version.hpp"
#include "toccata/narrow/capsule.hpp"
#include "toccata/narrow/convex_convex.hpp"
#include "toccata/narrow/sphere.hpp"

namespace toccata::bench {
namespace {

double bytes_of(const std::vector<ConvexPair>& pairs) {
  const auto* hull = std::get_if<ConvexHull>(&pairs.front().a);
  return hull == nullptr ? 0 : static_cast<double>(hull->memory()) / hull->vertex_count();
}

ConvexAnswer asked(ConvexTask task, const PosedConvex& a, const PosedConvex& b, ConvexWorkspace* workspace) {
  if (task == ConvexTask::overlap) return {overlap(a, b, workspace)};
  if (task == ConvexTask::distance) {
    const Distance d = distance(a, b, workspace);
    return {d.upper == 0, d.lower, d.upper};
  }
  if (task == ConvexTask::penetration) {
    const Penetration p = penetration(a, b, workspace);
    return {p.upper > 0, p.lower, p.upper, p.direction};
  }
  const Manifold m = manifold(a, b, workspace);
  return {m.count > 0, 0, 0, m.normal, m.count};
}

enum class Posing { for_each_question, before };

/// Asks with a workspace where the questions follow each other.
template <class A, class B>
class ToccataConvex : public ConvexLibrary {
 public:
  explicit ToccataConvex(Posing posing) : posing_(posing) {}

  Description description() const override {
    return {"toccata", posing_ == Posing::before ? "posed before" : "posed for each question", version,
            fmt::format("{}, {} -ffp-contract=off", TOCCATA_BENCH_COMPILER, TOCCATA_BENCH_FLAGS)};
  }

  void prepare(const ConvexWork& work) override {
    work_ = &work;
    bytes_per_vertex_ = bytes_of(work.pairs);
    for (const ConvexPair& pair : work.pairs) {
      a_.push_back(std::get<A>(pair.a));
      b_.push_back(std::get<B>(pair.b));
    }
    if (posing_ == Posing::for_each_question) return;
    for (const ConvexQuestion& question : work.questions) {
      posed_a_.emplace_back(a_[question.pair], question.a);
      posed_b_.emplace_back(b_[question.pair], question.b);
    }
  }

  double bytes_per_vertex() const override { return bytes_per_vertex_; }

  void answer(std::size_t first, std::span<ConvexAnswer> answers) override {
    for (std::size_t i = 0; i < answers.size(); ++i) {
      const ConvexQuestion& question = work_->questions[first + i];
      if (!question.follows) workspace_ = {};
      ConvexWorkspace* const workspace = work_->coherent ? &workspace_ : nullptr;
      answers[i] = posing_ == Posing::before ? asked(work_->task, posed_a_[first + i], posed_b_[first + i], workspace)
                                             : asked(work_->task, PosedConvex(a_[question.pair], question.a),
                                                     PosedConvex(b_[question.pair], question.b), workspace);
    }
  }

 private:
  Posing posing_;
  const ConvexWork* work_ = nullptr;
  std::vector<A> a_;
  std::vector<B> b_;
  std::vector<PosedConvex> posed_a_;
  std::vector<PosedConvex> posed_b_;
  ConvexWorkspace workspace_;
  double bytes_per_vertex_ = 0;
};

PosedSphere placed(const Sphere& shape, const Pose& pose) { return PosedSphere(shape, pose); }
PosedCapsule placed(const Capsule& shape, const Pose& pose) { return PosedCapsule(shape, pose); }
PosedBox placed(const Box& shape, const Pose& pose) { return PosedBox(shape, pose); }
Triangle placed(const Triangle& shape, const Pose& pose) {
  return {{transform(pose, shape[0]), transform(pose, shape[1]), transform(pose, shape[2])}};
}

template <class A, class B>
concept HasOwnForms = requires(const A& a, const B& b, const Pose& pose) {
  distance(placed(a, pose), placed(b, pose));
  overlap(placed(a, pose), placed(b, pose));
};

/// The functions for just this pair of kinds of shape.
template <class A, class B>
class ToccataOwnForms : public ConvexLibrary {
 public:
  Description description() const override {
    return {"toccata", "the pair's own, posed for each", version,
            fmt::format("{}, {} -ffp-contract=off", TOCCATA_BENCH_COMPILER, TOCCATA_BENCH_FLAGS)};
  }

  void prepare(const ConvexWork& work) override {
    work_ = &work;
    for (const ConvexPair& pair : work.pairs) {
      a_.push_back(std::get<A>(pair.a));
      b_.push_back(std::get<B>(pair.b));
    }
  }

  void answer(std::size_t first, std::span<ConvexAnswer> answers) override {
    for (std::size_t i = 0; i < answers.size(); ++i) {
      const ConvexQuestion& question = work_->questions[first + i];
      const auto a = placed(a_[question.pair], question.a);
      const auto b = placed(b_[question.pair], question.b);
      if (work_->task == ConvexTask::overlap) {
        answers[i] = {overlap(a, b)};
        continue;
      }
      const Distance d = distance(a, b);
      answers[i] = {d.upper == 0, d.lower, d.upper};
    }
  }

 private:
  const ConvexWork* work_ = nullptr;
  std::vector<A> a_;
  std::vector<B> b_;
};

}  // namespace

ConvexOffer toccata_convex(const ConvexWork& work) {
  return with_types(work.pair, [&]<class A, class B>() {
    ConvexOffer offer;
    offer.libraries.push_back(std::make_unique<ToccataConvex<A, B>>(Posing::for_each_question));
    offer.libraries.push_back(std::make_unique<ToccataConvex<A, B>>(Posing::before));
    if constexpr (HasOwnForms<A, B>)
      if (work.task == ConvexTask::overlap || work.task == ConvexTask::distance)
        offer.libraries.push_back(std::make_unique<ToccataOwnForms<A, B>>());
    return offer;
  });
}

}  // namespace toccata::bench
