#include <BulletCollision/CollisionDispatch/SphereTriangleDetector.h>
#include <BulletCollision/CollisionDispatch/btBoxBoxDetector.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkEpaPenetrationDepthSolver.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkPairDetector.h>
#include <BulletCollision/NarrowPhaseCollision/btVoronoiSimplexSolver.h>

#include "convex_library.hpp"
#include "peers/bullet_shapes.hpp"

namespace toccata::bench {
namespace {

using Detector = btDiscreteCollisionDetectorInterface;

/// The least distance among the points that a detector tells; negative for a depth.
class Deepest : public Detector::Result {
 public:
  void setShapeIdentifiersA(int, int) override {}
  void setShapeIdentifiersB(int, int) override {}
  void addContactPoint(const btVector3& normal_on_b, const btVector3&, btScalar distance) override {
    ++count;
    if (distance >= least) return;
    least = distance;
    normal = normal_on_b;
  }

  int count = 0;
  double least = BT_LARGE_FLOAT;
  btVector3 normal{0, 0, 0};  ///< towards A
};

ConvexAnswer answer_of(ConvexTask task, const Deepest& deepest) {
  ConvexAnswer answer{deepest.count > 0 && deepest.least <= 0};
  answer.points = deepest.count;
  const double number = task == ConvexTask::distance ? deepest.least : -deepest.least;
  answer.lower = answer.upper = deepest.count > 0 ? std::max(number, 0.0) : 0;
  answer.direction = {-deepest.normal.x(), -deepest.normal.y(), -deepest.normal.z()};
  return answer;
}

template <class Shape>
using Converted = decltype(converted(std::declval<const Shape&>()));

enum class Method { gjk, own };

/// GJK and EPA, which Bullet has for all convex shapes.
class General {
 public:
  void ask(const btConvexShape& a, const btConvexShape& b, const Detector::ClosestPointInput& input, bool warm,
           Deepest& deepest) {
    btGjkPairDetector detector(&a, &b, &simplex_, &penetration_);
    if (warm) detector.setCachedSeparatingAxis(axis_);
    detector.getClosestPointsNonVirtual(input, deepest, nullptr);
    axis_ = detector.getCachedSeparatingAxis();
  }

 private:
  btVoronoiSimplexSolver simplex_;
  btGjkEpaPenetrationDepthSolver penetration_;
  btVector3 axis_{0, 1, 0};
};

template <class A, class B>
class BulletConvex : public ConvexLibrary {
 public:
  explicit BulletConvex(Method method) : method_(method) {}

  Description description() const override {
    return {"bullet", method_ == Method::gjk ? "GJK and EPA of doubles" : "the pair's own detector, of doubles",
            TOCCATA_BENCH_BULLET_VERSION, "as packaged"};
  }

  void prepare(const ConvexWork& work) override {
    work_ = &work;
    for (const ConvexPair& pair : work.pairs) {
      a_.push_back(converted(std::get<A>(pair.a)));
      b_.push_back(converted(std::get<B>(pair.b)));
    }
    for (const ConvexQuestion& question : work.questions) {
      Detector::ClosestPointInput input;
      input.m_transformA = converted(question.a);
      input.m_transformB = converted(question.b);
      inputs_.push_back(input);
    }
  }

  void answer(std::size_t first, std::span<ConvexAnswer> answers) override {
    for (std::size_t i = 0; i < answers.size(); ++i) {
      const ConvexQuestion& question = work_->questions[first + i];
      Deepest deepest;
      if (method_ == Method::gjk)
        general_.ask(*a_[question.pair], *b_[question.pair], inputs_[first + i], question.follows, deepest);
      else
        ask_own(*a_[question.pair], *b_[question.pair], inputs_[first + i], deepest);
      answers[i] = answer_of(work_->task, deepest);
    }
  }

 private:
  template <class ShapeA, class ShapeB>
  void ask_own(ShapeA& a, ShapeB& b, const Detector::ClosestPointInput& input, Deepest& deepest) {
    if constexpr (std::is_same_v<ShapeA, btBoxShape> && std::is_same_v<ShapeB, btBoxShape>) {
      btBoxBoxDetector(&a, &b).getClosestPoints(input, deepest, nullptr);
    } else if constexpr (std::is_same_v<ShapeB, btTriangleShape>) {
      SphereTriangleDetector(&a, &b, 100).getClosestPoints(input, deepest, nullptr);
    }
  }

  Method method_;
  const ConvexWork* work_ = nullptr;
  General general_;
  std::vector<Converted<A>> a_;
  std::vector<Converted<B>> b_;
  std::vector<Detector::ClosestPointInput> inputs_;
};

/// Box–box tells nothing of boxes that are apart.
bool has_own_detector(const ConvexWork& work) {
  return work.pair == "sphere-triangle" || (work.pair == "box" && work.task != ConvexTask::distance);
}

template <class A, class B>
ConvexOffer offer_for(const ConvexWork& work) {
  ConvexOffer offer;
  auto general = std::make_unique<BulletConvex<A, B>>(Method::gjk);
  // The one point of a round shape has the depth and the normal that are compared.
  if (work.task == ConvexTask::manifold && !has_quadric(work.pair))
    offer.unasked.push_back({general->description(), "it gives one point; manifolds grow from frame to frame"});
  else
    offer.libraries.push_back(std::move(general));
  if (has_own_detector(work)) offer.libraries.push_back(std::make_unique<BulletConvex<A, B>>(Method::own));
  return offer;
}

template <>
ConvexOffer offer_for<Ellipsoid, Ellipsoid>(const ConvexWork&) {
  ConvexOffer offer;
  offer.unasked.push_back(
      {{"bullet", "GJK and EPA of doubles", TOCCATA_BENCH_BULLET_VERSION, "as packaged"}, "it has no ellipsoid"});
  return offer;
}

}  // namespace

ConvexOffer bullet_convex(const ConvexWork& work) {
  return with_types(work.pair, [&]<class A, class B>() { return offer_for<A, B>(work); });
}

}  // namespace toccata::bench
