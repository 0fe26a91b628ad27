#include <BulletCollision/NarrowPhaseCollision/btContinuousConvexCollision.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkConvexCast.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkEpaPenetrationDepthSolver.h>
#include <BulletCollision/NarrowPhaseCollision/btSubSimplexConvexCast.h>
#include <BulletCollision/NarrowPhaseCollision/btVoronoiSimplexSolver.h>
#include <LinearMath/btTransformUtil.h>

#include "peers/bullet_shapes.hpp"
#include "sweeps.hpp"

namespace toccata::bench {
namespace {

enum class Method { continuous, gjk, subsimplex };

/// Its casts of two convex shapes between two poses of each. Only the first turns them.
class BulletSweeps : public SweepLibrary {
 public:
  explicit BulletSweeps(Method method) : method_(method) {}

  Description description() const override {
    const std::string names[] = {"btContinuousConvexCollision of doubles", "btGjkConvexCast of doubles",
                                 "btSubsimplexConvexCast of doubles"};
    return {"bullet", names[static_cast<int>(method_)], TOCCATA_BENCH_BULLET_VERSION, "as packaged"};
  }

  void prepare(const SweepWork& work) override {
    work_ = &work;
    for (const SweepPair& pair : work.pairs) shapes_.push_back({shape_of(pair.a), shape_of(pair.b)});
    for (const SweepQuestion& question : work.questions)
      ways_.push_back({converted(question.a.start), converted(question.a.end), converted(question.b.start),
                       converted(question.b.end)});
  }

  void answer(std::size_t first, std::span<SweepAnswer> answers) override {
    for (std::size_t i = 0; i < answers.size(); ++i) {
      const auto& [a, b] = shapes_[work_->questions[first + i].pair];
      answers[i] = asked(*a, *b, ways_[first + i]);
    }
  }

  PosePair poses_at(std::size_t number, double time) override {
    const Ways& ways = ways_[number];
    return {pose_at(ways.start_a, ways.end_a, time), pose_at(ways.start_b, ways.end_b, time)};
  }

 private:
  struct Shapes {
    std::unique_ptr<btConvexShape> a;
    std::unique_ptr<btConvexShape> b;
  };
  struct Ways {
    btTransform start_a, end_a, start_b, end_b;
  };

  static std::unique_ptr<btConvexShape> shape_of(const SweepBody& body) {
    if (const auto* sphere = std::get_if<Sphere>(&body)) return converted(*sphere);
    if (const auto* capsule = std::get_if<Capsule>(&body)) return converted(*capsule);
    if (const auto* box = std::get_if<Box>(&body)) return converted(*box);
    return converted(std::get<ConvexHull>(body));
  }

  static Pose pose_at(const btTransform& start, const btTransform& end, double time) {
    btVector3 linear, angular;
    btTransform at;
    btTransformUtil::calculateVelocity(start, end, 1, linear, angular);
    btTransformUtil::integrateTransform(start, linear, angular, time, at);
    Pose pose;
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) pose.linear[i][j] = at.getBasis()[i][j];
      pose.offset[i] = at.getOrigin()[i];
    }
    return pose;
  }

  SweepAnswer asked(const btConvexShape& a, const btConvexShape& b, const Ways& ways) {
    if (method_ == Method::subsimplex) return answer_by(btSubsimplexConvexCast(&a, &b, &simplex_), ways);
    if (method_ == Method::gjk) return answer_by(btGjkConvexCast(&a, &b, &simplex_), ways);
    return answer_by(btContinuousConvexCollision(&a, &b, &simplex_, &penetration_), ways);
  }

  template <class Caster>
  static SweepAnswer answer_by(Caster caster, const Ways& ways) {
    btConvexCast::CastResult result;
    result.m_fraction = 1;
    if (!caster.calcTimeOfImpact(ways.start_a, ways.end_a, ways.start_b, ways.end_b, result)) return {};
    return {true, true, result.m_fraction, result.m_fraction};
  }

  Method method_;
  const SweepWork* work_ = nullptr;
  btVoronoiSimplexSolver simplex_;
  btGjkEpaPenetrationDepthSolver penetration_;
  std::vector<Shapes> shapes_;
  std::vector<Ways> ways_;
};

bool turns(const SweepWay& way) { return !(way.start.linear == way.end.linear); }

}  // namespace

SweepOffer bullet_sweeps(const SweepWork& work) {
  SweepOffer offer;
  if (std::holds_alternative<std::shared_ptr<const TriangleMesh>>(work.pairs.front().a)) {
    offer.unasked.push_back({{"bullet", "", TOCCATA_BENCH_BULLET_VERSION, "as packaged"}, "it sweeps no meshes"});
    return offer;
  }
  offer.libraries.push_back(std::make_unique<BulletSweeps>(Method::continuous));
  for (const SweepQuestion& question : work.questions)
    if (turns(question.a) || turns(question.b)) return offer;
  for (const Method method : {Method::gjk, Method::subsimplex})
    offer.libraries.push_back(std::make_unique<BulletSweeps>(method));
  return offer;
}

}  // namespace toccata::bench
