#include <BulletCollision/CollisionDispatch/btCollisionWorld.h>
#include <BulletCollision/NarrowPhaseCollision/btContinuousConvexCollision.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkConvexCast.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkEpaPenetrationDepthSolver.h>
#include <BulletCollision/NarrowPhaseCollision/btSubSimplexConvexCast.h>
#include <BulletCollision/NarrowPhaseCollision/btVoronoiSimplexSolver.h>

#include "casts.hpp"
#include "peers/bullet_shapes.hpp"

namespace toccata::bench {
namespace {

enum class Method { subsimplex, gjk, continuous };

std::string name_of(Method method) {
  if (method == Method::subsimplex) return "btSubsimplexConvexCast of doubles";
  return method == Method::gjk ? "btGjkConvexCast of doubles" : "btContinuousConvexCollision of doubles";
}

struct Way {
  btTransform start;
  btTransform end;
  btTransform standing;
};

Way way_of(const CastQuestion& question) {
  Pose end = question.start;
  end.offset = end.offset + question.motion;
  return {converted(question.start), converted(end), converted(question.standing)};
}

CastAnswer answer_of(bool hit, double time) {
  if (!hit) return {};
  return {true, time, time};
}

template <class Shape>
using Converted = decltype(converted(std::declval<const Shape&>()));

/// Its casts of a convex shape at another: that of `rayTest`, and that of `convexSweepTest`, the last.
template <class Moving, class Standing>
class BulletCasts : public CastLibrary {
 public:
  explicit BulletCasts(Method method) : method_(method) {}

  Description description() const override {
    return {"bullet", name_of(method_), TOCCATA_BENCH_BULLET_VERSION, "as packaged"};
  }

  void prepare(const CastWork& work) override {
    work_ = &work;
    for (const CastPair& pair : work.pairs) {
      moving_.push_back(converted(std::get<Moving>(pair.moving)));
      standing_.push_back(converted(std::get<Standing>(pair.standing)));
    }
    for (const CastQuestion& question : work.questions) ways_.push_back(way_of(question));
  }

  void answer(std::size_t first, std::span<CastAnswer> answers) override {
    for (std::size_t i = 0; i < answers.size(); ++i) {
      const std::size_t pair = work_->questions[first + i].pair;
      answers[i] = asked(*moving_[pair], *standing_[pair], ways_[first + i]);
    }
  }

 private:
  CastAnswer asked(const btConvexShape& moving, const btConvexShape& standing, const Way& way) {
    if (method_ == Method::subsimplex) return answer_by(btSubsimplexConvexCast(&moving, &standing, &simplex_), way);
    if (method_ == Method::gjk) return answer_by(btGjkConvexCast(&moving, &standing, &simplex_), way);
    return answer_by(btContinuousConvexCollision(&moving, &standing, &simplex_, &penetration_), way);
  }

  template <class Caster>
  static CastAnswer answer_by(Caster caster, const Way& way) {
    btConvexCast::CastResult result;
    result.m_fraction = 1;
    const bool hit = caster.calcTimeOfImpact(way.start, way.end, way.standing, way.standing, result);
    return answer_of(hit, result.m_fraction);
  }

  Method method_;
  const CastWork* work_ = nullptr;
  btVoronoiSimplexSolver simplex_;
  btGjkEpaPenetrationDepthSolver penetration_;
  std::vector<Converted<Moving>> moving_;
  std::vector<Converted<Standing>> standing_;
  std::vector<Way> ways_;
};

/// `rayTest` at a single shape.
template <class Standing>
class BulletRays : public CastLibrary {
 public:
  Description description() const override {
    return {"bullet", "rayTestSingle of doubles", TOCCATA_BENCH_BULLET_VERSION, "as packaged"};
  }

  void prepare(const CastWork& work) override {
    work_ = &work;
    for (const CastPair& pair : work.pairs) standing_.push_back(converted(std::get<Standing>(pair.standing)));
    for (const CastQuestion& question : work.questions) ways_.push_back(way_of(question));
  }

  void answer(std::size_t first, std::span<CastAnswer> answers) override {
    for (std::size_t i = 0; i < answers.size(); ++i) {
      const Way& way = ways_[first + i];
      btCollisionWorld::ClosestRayResultCallback closest(way.start.getOrigin(), way.end.getOrigin());
      btCollisionWorld::rayTestSingle(way.start, way.end, &object_, standing_[work_->questions[first + i].pair].get(),
                                      way.standing, closest);
      answers[i] = answer_of(closest.hasHit(), closest.m_closestHitFraction);
    }
  }

 private:
  const CastWork* work_ = nullptr;
  btCollisionObject object_;
  std::vector<Converted<Standing>> standing_;
  std::vector<Way> ways_;
};

template <class Moving, class Standing>
CastOffer offer_for() {
  CastOffer offer;
  if constexpr (std::is_same_v<Standing, Ellipsoid>) {
    offer.unasked.push_back({{"bullet", "", TOCCATA_BENCH_BULLET_VERSION, "as packaged"}, "it has no ellipsoid"});
  } else if constexpr (std::is_same_v<Moving, Point>) {
    offer.libraries.push_back(std::make_unique<BulletRays<Standing>>());
  } else {
    for (const Method method : {Method::subsimplex, Method::gjk, Method::continuous})
      offer.libraries.push_back(std::make_unique<BulletCasts<Moving, Standing>>(method));
  }
  return offer;
}

}  // namespace

CastOffer bullet_casts(const CastWork& work) {
  return with_cast_types(work.pair, []<class Moving, class Standing>() { return offer_for<Moving, Standing>(); });
}

}  // namespace toccata::bench
