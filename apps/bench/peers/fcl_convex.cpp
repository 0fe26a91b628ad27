#include <fcl/narrowphase/detail/gjk_solver_indep.h>
#include <fcl/narrowphase/detail/gjk_solver_libccd.h>

#include "convex_library.hpp"
#include "peers/fcl_shapes.hpp"

namespace toccata::bench {
namespace {

using fcl::Vector3d;
using Solver = fcl::detail::GJKSolver_libccd<double>;
using OwnSolver = fcl::detail::GJKSolver_indep<double>;

using bench::converted;

Vec3 converted(const Vector3d& v) { return {v.x(), v.y(), v.z()}; }
Triangle converted(const Triangle& triangle) { return triangle; }

template <class Shape>
using Converted = decltype(converted(std::declval<const Shape&>()));

template <class AnySolver, class A, class B>
bool overlaps(const AnySolver& solver, const A& a, const fcl::Transform3d& pose_a, const B& b,
              const fcl::Transform3d& pose_b) {
  return solver.shapeIntersect(a, pose_a, b, pose_b, nullptr);
}

template <class AnySolver, class A>
bool overlaps(const AnySolver& solver, const A& a, const fcl::Transform3d& pose_a, const Triangle& b,
              const fcl::Transform3d& pose_b) {
  return solver.shapeTriangleIntersect(a, pose_a, converted(b[0]), converted(b[1]), converted(b[2]), pose_b);
}

template <class AnySolver, class A, class B>
ConvexAnswer distance_of(const AnySolver& solver, const A& a, const fcl::Transform3d& pose_a, const B& b,
                         const fcl::Transform3d& pose_b) {
  double distance = 0;
  Vector3d on_a, on_b;
  const bool apart = solver.shapeDistance(a, pose_a, b, pose_b, &distance, &on_a, &on_b);
  return apart ? ConvexAnswer{false, distance, distance} : ConvexAnswer{true};
}

template <class AnySolver, class A>
ConvexAnswer distance_of(const AnySolver& solver, const A& a, const fcl::Transform3d& pose_a, const Triangle& b,
                         const fcl::Transform3d& pose_b) {
  double distance = 0;
  Vector3d on_a, on_b;
  const bool apart = solver.shapeTriangleDistance(a, pose_a, converted(b[0]), converted(b[1]), converted(b[2]), pose_b,
                                                  &distance, &on_a, &on_b);
  return apart ? ConvexAnswer{false, distance, distance} : ConvexAnswer{true};
}

/// Whether FCL has a closed form for the pair: for a sphere and itself, a box, a capsule or a cylinder, and for two
/// boxes.
template <class A, class B>
constexpr bool has_closed_form =
    std::is_same_v<A, fcl::Boxd> ? std::is_same_v<B, fcl::Boxd>
                                 : std::is_same_v<A, fcl::Sphered> && !std::is_same_v<B, fcl::Convexd>;

/// For pairs without a closed form FCL's own solver gives the depth below zero and the normal in A's frame; both are
/// put right here, since that is what its users have to do.
template <class AnySolver, class A, class B>
constexpr bool is_in_frame_of_a = std::is_same_v<AnySolver, OwnSolver> && !has_closed_form<A, B>;

template <class AnySolver, class A, class B>
ConvexAnswer contacts_of(const AnySolver& solver, const A& a, const fcl::Transform3d& pose_a, const B& b,
                         const fcl::Transform3d& pose_b) {
  thread_local std::vector<fcl::ContactPoint<double>> contacts;
  contacts.clear();
  if (!solver.shapeIntersect(a, pose_a, b, pose_b, &contacts)) return {};
  ConvexAnswer answer{true};
  for (const auto& contact : contacts) {
    if (answer.points++ > 0 && contact.penetration_depth <= answer.upper) continue;
    answer.lower = answer.upper = contact.penetration_depth;
    answer.direction = converted(contact.normal);
    if constexpr (is_in_frame_of_a<AnySolver, A, B>) {
      answer.lower = answer.upper = -contact.penetration_depth;
      answer.direction = converted(Vector3d(pose_a.linear() * contact.normal));
    }
  }
  return answer;
}

template <class AnySolver, class A>
ConvexAnswer contacts_of(const AnySolver& solver, const A& a, const fcl::Transform3d& pose_a, const Triangle& b,
                         const fcl::Transform3d& pose_b) {
  double depth = 0;
  Vector3d point, normal;
  if (!solver.shapeTriangleIntersect(a, pose_a, converted(b[0]), converted(b[1]), converted(b[2]), pose_b, &point,
                                     &depth, &normal))
    return {};
  return {true, depth, depth, converted(normal), 1};
}

template <class AnySolver>
std::string name_of_solver() {
  return std::is_same_v<AnySolver, Solver> ? "libccd" : "own GJK and EPA";
}

/// The narrow phase alone, as fcl::collide and fcl::distance call it; their dispatch takes some time more.
template <class AnySolver, class A, class B>
class FclConvex : public ConvexLibrary {
 public:
  Description description() const override {
    return {"fcl", name_of_solver<AnySolver>(), TOCCATA_BENCH_FCL_VERSION, "as packaged; solver's templates -O3"};
  }

  void prepare(const ConvexWork& work) override {
    work_ = &work;
    for (const ConvexPair& pair : work.pairs) {
      a_.push_back(converted(std::get<A>(pair.a)));
      b_.push_back(converted(std::get<B>(pair.b)));
    }
    for (const ConvexQuestion& question : work.questions) {
      poses_a_.push_back(converted(question.a));
      poses_b_.push_back(converted(question.b));
    }
  }

  void answer(std::size_t first, std::span<ConvexAnswer> answers) override {
    for (std::size_t i = 0; i < answers.size(); ++i) {
      const ConvexQuestion& question = work_->questions[first + i];
      // Where the last search ended is kept from step to step.
      if (work_->coherent) solver_.enableCachedGuess(question.follows);
      answers[i] = asked(a_[question.pair], poses_a_[first + i], b_[question.pair], poses_b_[first + i]);
    }
  }

 private:
  ConvexAnswer asked(const Converted<A>& a, const fcl::Transform3d& pose_a, const Converted<B>& b,
                     const fcl::Transform3d& pose_b) const {
    if (work_->task == ConvexTask::overlap) return {overlaps(solver_, a, pose_a, b, pose_b)};
    if (work_->task == ConvexTask::distance) return distance_of(solver_, a, pose_a, b, pose_b);
    return contacts_of(solver_, a, pose_a, b, pose_b);
  }

  const ConvexWork* work_ = nullptr;
  AnySolver solver_;
  std::vector<Converted<A>> a_;
  std::vector<Converted<B>> b_;
  std::vector<fcl::Transform3d> poses_a_;
  std::vector<fcl::Transform3d> poses_b_;
};

}  // namespace

ConvexOffer fcl_convex(const ConvexWork& work) {
  return with_types(work.pair, []<class A, class B>() {
    ConvexOffer offer;
    offer.libraries.push_back(std::make_unique<FclConvex<Solver, A, B>>());
    offer.libraries.push_back(std::make_unique<FclConvex<OwnSolver, A, B>>());
    return offer;
  });
}

}  // namespace toccata::bench
