#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "convex_library.hpp"
#include "toccata/core/version.hpp"
#include "toccata/narrow/box_box.hpp"
#include "toccata/narrow/convex_convex.hpp"
#include "toccata/narrow/pair_arrays.hpp"
#include "toccata/narrow/primitives.hpp"
#include "toccata/narrow/quadrics.hpp"

namespace toccata::bench {
namespace {

double bytes_of(const std::vector<ConvexPair>& pairs) {
  const auto* hull = std::get_if<ConvexHull>(&pairs.front().a);
  return hull == nullptr ? 0 : static_cast<double>(hull->memory()) / hull->vertex_count();
}

ConvexAnswer asked(ConvexTask task, const PosedPolytope& a, const PosedPolytope& b, SimplexCache* workspace) {
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

template <class A, class B>
concept OneIsAQuadric = std::is_same_v<A, PosedQuadric> || std::is_same_v<B, PosedQuadric>;

/// A manifold of shapes with round sides tells how deep it is too.
template <class A, class B>
requires OneIsAQuadric<A, B> ConvexAnswer asked(ConvexTask task, const A& a, const B& b, SimplexCache*) {
  if (task == ConvexTask::overlap) return {overlap(a, b)};
  if (task == ConvexTask::penetration) {
    const Penetration p = penetration(a, b);
    return {p.upper > 0, p.lower, p.upper, p.direction};
  }
  if (task == ConvexTask::manifold) {
    const Manifold m = manifold(a, b);
    const double depth = std::max(m.points[0].depth, 0.0);
    return {m.count > 0, depth, depth, m.normal, m.count};
  }
  const Distance d = distance(a, b);
  return {d.lower == 0, d.lower, d.upper};
}

enum class ConvexPosing { for_each_question, before };

/// Asks with a workspace where the questions follow each other.
template <class A, class B>
class ToccataConvex : public ConvexLibrary {
 public:
  explicit ToccataConvex(ConvexPosing posing) : posing_(posing) {}

  Description description() const override {
    return {"toccata", posing_ == ConvexPosing::before ? "posed before" : "posed for each question", version,
            fmt::format("{}, {} -ffp-contract=off", TOCCATA_BENCH_COMPILER, TOCCATA_BENCH_FLAGS)};
  }

  void prepare(const ConvexWork& work) override {
    work_ = &work;
    bytes_per_vertex_ = bytes_of(work.pairs);
    for (const ConvexPair& pair : work.pairs) {
      a_.push_back(std::get<A>(pair.a));
      b_.push_back(std::get<B>(pair.b));
    }
    if (posing_ == ConvexPosing::for_each_question) return;
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
      SimplexCache* const workspace = work_->coherent ? &workspace_ : nullptr;
      answers[i] = posing_ == ConvexPosing::before
                       ? asked(work_->task, posed_a_[first + i], posed_b_[first + i], workspace)
                       : asked(work_->task, PosedAs<A>(a_[question.pair], question.a),
                               PosedAs<B>(b_[question.pair], question.b), workspace);
    }
  }

 private:
  ConvexPosing posing_;
  const ConvexWork* work_ = nullptr;
  std::vector<A> a_;
  std::vector<B> b_;
  std::vector<PosedAs<A>> posed_a_;
  std::vector<PosedAs<B>> posed_b_;
  SimplexCache workspace_;
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
  overlap(placed(a, pose), placed(b, pose));
};

/// Is the task one of the pair's own functions?
template <class A, class B>
bool has_own_form(ConvexTask task) {
  using PlacedA = decltype(placed(std::declval<A>(), Pose{}));
  using PlacedB = decltype(placed(std::declval<B>(), Pose{}));
  if (task == ConvexTask::overlap) return requires(const PlacedA& a, const PlacedB& b) {
      overlap(a, b);
    };
  if (task == ConvexTask::distance) return requires(const PlacedA& a, const PlacedB& b) {
      distance(a, b);
    };
  if (task == ConvexTask::penetration) return requires(const PlacedA& a, const PlacedB& b) {
      penetration(a, b);
    };
  return requires(const PlacedA& a, const PlacedB& b) { manifold(a, b); };
}

/// By the function for just this pair of kinds of shape, where there is one.
template <class A, class B>
ConvexAnswer asked_of_own_form(ConvexTask task, const A& a, const B& b) {
  if constexpr (requires { distance(a, b); })
    if (task == ConvexTask::distance) {
      const Distance d = distance(a, b);
      return {d.upper == 0, d.lower, d.upper};
    }
  if constexpr (requires { penetration(a, b); })
    if (task == ConvexTask::penetration) {
      const Penetration p = penetration(a, b);
      return {p.upper > 0, p.lower, p.upper, p.direction};
    }
  if constexpr (requires { manifold(a, b); })
    if (task == ConvexTask::manifold) {
      const Manifold m = manifold(a, b);
      return {m.count > 0, 0, 0, m.normal, m.count};
    }
  return {overlap(a, b)};
}

template <class S>
using PlacedAs = decltype(placed(std::declval<const S&>(), std::declval<const Pose&>()));

/// The functions for just this pair of kinds of shape.
template <class A, class B>
class ToccataOwnForms : public ConvexLibrary {
 public:
  explicit ToccataOwnForms(ConvexPosing posing) : posing_(posing) {}

  Description description() const override {
    return {
        "toccata",
        posing_ == ConvexPosing::before ? "the pair's own, posed before" : "the pair's own, posed for each question",
        version, fmt::format("{}, {} -ffp-contract=off", TOCCATA_BENCH_COMPILER, TOCCATA_BENCH_FLAGS)};
  }

  void prepare(const ConvexWork& work) override {
    work_ = &work;
    for (const ConvexPair& pair : work.pairs) {
      a_.push_back(std::get<A>(pair.a));
      b_.push_back(std::get<B>(pair.b));
    }
    if (posing_ == ConvexPosing::for_each_question) return;
    for (const ConvexQuestion& question : work.questions) {
      placed_a_.push_back(placed(a_[question.pair], question.a));
      placed_b_.push_back(placed(b_[question.pair], question.b));
    }
  }

  void answer(std::size_t first, std::span<ConvexAnswer> answers) override {
    for (std::size_t i = 0; i < answers.size(); ++i) {
      const ConvexQuestion& question = work_->questions[first + i];
      answers[i] = posing_ == ConvexPosing::before
                       ? asked_of_own_form(work_->task, placed_a_[first + i], placed_b_[first + i])
                       : asked_of_own_form(work_->task, placed(a_[question.pair], question.a),
                                           placed(b_[question.pair], question.b));
    }
  }

 private:
  ConvexPosing posing_;
  const ConvexWork* work_ = nullptr;
  std::vector<A> a_;
  std::vector<B> b_;
  std::vector<PlacedAs<A>> placed_a_;
  std::vector<PlacedAs<B>> placed_b_;
};

/// Does the pair's own function take shapes and poses for this task?
template <class A, class B>
bool takes_given(ConvexTask task) {
  if (task == ConvexTask::distance) return requires(const A& a, const B& b, const Pose& pose) {
      distance(a, pose, b, pose);
    };
  if (task == ConvexTask::penetration) return requires(const A& a, const B& b, const Pose& pose) {
      penetration(a, pose, b, pose);
    };
  if (task == ConvexTask::manifold) return requires(const A& a, const B& b, const Pose& pose) {
      manifold(a, pose, b, pose);
    };
  return requires(const A& a, const B& b, const Pose& pose) { overlap(a, pose, b, pose); };
}

/// The functions that take shapes and poses.
template <class A, class B>
class ToccataGiven : public ConvexLibrary {
 public:
  Description description() const override {
    return {"toccata", "the pair's own, shapes and poses given", version,
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
    for (std::size_t i = 0; i < answers.size(); ++i) answers[i] = answer_to(work_->questions[first + i]);
  }

 private:
  ConvexAnswer answer_to(const ConvexQuestion& question) const {
    const A& a = a_[question.pair];
    const B& b = b_[question.pair];
    if constexpr (requires { distance(a, question.a, b, question.b); })
      if (work_->task == ConvexTask::distance) {
        const Distance d = distance(a, question.a, b, question.b);
        return {d.upper == 0, d.lower, d.upper};
      }
    if constexpr (requires { penetration(a, question.a, b, question.b); })
      if (work_->task == ConvexTask::penetration) {
        const Penetration p = penetration(a, question.a, b, question.b);
        return {p.upper > 0, p.lower, p.upper, p.direction};
      }
    if constexpr (requires { manifold(a, question.a, b, question.b); })
      if (work_->task == ConvexTask::manifold) {
        const Manifold m = manifold(a, question.a, b, question.b);
        return {m.count > 0, 0, 0, m.normal, m.count};
      }
    return {overlap(a, question.a, b, question.b)};
  }

  const ConvexWork* work_ = nullptr;
  std::vector<A> a_;
  std::vector<B> b_;
};

template <class Placed>
struct ArrayFor {};
template <>
struct ArrayFor<PosedSphere> {
  using Type = SphereArray;
};
template <>
struct ArrayFor<Triangle> {
  using Type = TriangleArray;
};
template <>
struct ArrayFor<PosedBox> {
  using Type = BoxArray;
};
template <>
struct ArrayFor<PosedCapsule> {
  using Type = CapsuleArray;
};

template <class S>
using ArrayOf = typename ArrayFor<PlacedAs<S>>::Type;

template <class A, class B>
concept HasArrays = requires(const ArrayOf<A>& a, const ArrayOf<B>& b) {
  overlap_each(a, b);
  distance_each(a, b);
};

/// Arrays of pairs, a block in each.
template <class A, class B>
class ToccataArrays : public ConvexLibrary {
 public:
  Description description() const override {
    return {"toccata", fmt::format("arrays of {} pairs, posed before", convex_block), version,
            fmt::format("{}, {} -ffp-contract=off", TOCCATA_BENCH_COMPILER, TOCCATA_BENCH_FLAGS)};
  }

  void prepare(const ConvexWork& work) override {
    task_ = work.task;
    for (std::size_t i = 0; i < work.questions.size(); ++i) {
      const ConvexQuestion& question = work.questions[i];
      if (i % convex_block == 0) a_.emplace_back(), b_.emplace_back();
      a_.back().append(placed(std::get<A>(work.pairs[question.pair].a), question.a));
      b_.back().append(placed(std::get<B>(work.pairs[question.pair].b), question.b));
    }
  }

  void answer(std::size_t first, std::span<ConvexAnswer> answers) override {
    const ArrayOf<A>& a = a_[first / convex_block];
    const ArrayOf<B>& b = b_[first / convex_block];
    if (task_ == ConvexTask::overlap) {
      const std::vector<std::uint8_t> found = overlap_each(a, b);
      for (std::size_t i = 0; i < answers.size(); ++i) answers[i] = {found[i] != 0};
      return;
    }
    const std::vector<Distance> found = distance_each(a, b);
    for (std::size_t i = 0; i < answers.size(); ++i) answers[i] = {found[i].upper == 0, found[i].lower, found[i].upper};
  }

 private:
  ConvexTask task_ = ConvexTask::overlap;
  std::vector<ArrayOf<A>> a_;
  std::vector<ArrayOf<B>> b_;
};

}  // namespace

ConvexOffer toccata_convex(const ConvexWork& work) {
  return with_types(work.pair, [&]<class A, class B>() {
    ConvexOffer offer;
    offer.libraries.push_back(std::make_unique<ToccataConvex<A, B>>(ConvexPosing::for_each_question));
    offer.libraries.push_back(std::make_unique<ToccataConvex<A, B>>(ConvexPosing::before));
    const bool has_arrays = work.task == ConvexTask::overlap || work.task == ConvexTask::distance;
    if constexpr (HasOwnForms<A, B>)
      if (has_own_form<A, B>(work.task))
        for (const ConvexPosing posing : {ConvexPosing::for_each_question, ConvexPosing::before})
          offer.libraries.push_back(std::make_unique<ToccataOwnForms<A, B>>(posing));
    if constexpr (requires(const A& a, const B& b, const Pose& pose) { overlap(a, pose, b, pose); })
      if (takes_given<A, B>(work.task)) offer.libraries.push_back(std::make_unique<ToccataGiven<A, B>>());
    if constexpr (HasOwnForms<A, B>)
      if constexpr (HasArrays<A, B>)
        if (has_arrays) offer.libraries.push_back(std::make_unique<ToccataArrays<A, B>>());
    return offer;
  });
}

}  // namespace toccata::bench
