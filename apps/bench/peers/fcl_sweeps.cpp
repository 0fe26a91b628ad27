#include <fcl/math/motion/interp_motion.h>
#include <fcl/math/motion/screw_motion.h>
#include <fcl/narrowphase/continuous_collision.h>

#include <memory>

#include "peers/fcl_models.hpp"
#include "peers/fcl_shapes.hpp"
#include "sweeps.hpp"

namespace toccata::bench {
namespace {

enum class Method { steps, interpolated, screw };

constexpr int step_count = 100;

/// `fcl::continuousCollide` of two geometries between two poses of each.
class FclSweeps : public SweepLibrary {
 public:
  explicit FclSweeps(Method method) : method_(method) {
    request_.ccd_motion_type = method == Method::screw ? fcl::CCDM_SCREW : fcl::CCDM_LINEAR;
    request_.gjk_solver_type = fcl::GST_LIBCCD;
    request_.ccd_solver_type = method == Method::steps ? fcl::CCDC_NAIVE : fcl::CCDC_CONSERVATIVE_ADVANCEMENT;
    if (method == Method::steps) request_.num_max_iterations = step_count;
  }

  Description description() const override {
    const std::string names[] = {"overlap at 100 steps, libccd", "conservative advancement, InterpMotion",
                                 "conservative advancement, ScrewMotion"};
    return {"fcl", names[static_cast<int>(method_)], TOCCATA_BENCH_FCL_VERSION, "as packaged; solver's templates -O3"};
  }

  void prepare(const SweepWork& work) override {
    work_ = &work;
    for (const SweepPair& pair : work.pairs) geometries_.push_back({geometry_of(pair.a), geometry_of(pair.b)});
    for (const SweepQuestion& question : work.questions)
      ways_.push_back({converted(question.a.start), converted(question.a.end), converted(question.b.start),
                       converted(question.b.end)});
  }

  void answer(std::size_t first, std::span<SweepAnswer> answers) override {
    for (std::size_t i = 0; i < answers.size(); ++i) {
      const auto& [a, b] = geometries_[work_->questions[first + i].pair];
      const Ways& ways = ways_[first + i];
      fcl::ContinuousCollisionResultd result;
      const auto motion_a = motion_of(ways.start_a, ways.end_a), motion_b = motion_of(ways.start_b, ways.end_b);
      fcl::continuousCollide(a.get(), motion_a.get(), b.get(), motion_b.get(), request_, result);
      answers[i] = {};
      if (result.is_collide) answers[i] = {true, true, result.time_of_contact, result.time_of_contact};
    }
  }

  PosePair poses_at(std::size_t number, double time) override {
    const Ways& ways = ways_[number];
    return {pose_at(ways.start_a, ways.end_a, time), pose_at(ways.start_b, ways.end_b, time)};
  }

 private:
  using Geometry = std::unique_ptr<fcl::CollisionGeometryd>;
  struct Geometries {
    Geometry a;
    Geometry b;
  };
  struct Ways {
    fcl::Transform3d start_a, end_a, start_b, end_b;
  };

  static Geometry geometry_of(const SweepBody& body) {
    if (const auto* mesh = std::get_if<std::shared_ptr<const TriangleMesh>>(&body))
      return fcl_model_of<fcl::OBBRSSd>(**mesh);
    if (const auto* sphere = std::get_if<Sphere>(&body)) return std::make_unique<fcl::Sphered>(converted(*sphere));
    if (const auto* capsule = std::get_if<Capsule>(&body)) return std::make_unique<fcl::Capsuled>(converted(*capsule));
    if (const auto* box = std::get_if<Box>(&body)) return std::make_unique<fcl::Boxd>(converted(*box));
    return std::make_unique<fcl::Convexd>(converted(std::get<ConvexHull>(body)));
  }

  /// Made of two transforms alone, an InterpMotion of FCL 0.7 turns about a point that it never sets.
  std::shared_ptr<fcl::MotionBase<double>> motion_of(const fcl::Transform3d& start, const fcl::Transform3d& end) const {
    if (method_ == Method::screw) return std::make_shared<fcl::ScrewMotion<double>>(start, end);
    return std::make_shared<fcl::InterpMotion<double>>(start.linear(), start.translation(), end.linear(),
                                                       end.translation(), fcl::Vector3d::Zero());
  }

  Pose pose_at(const fcl::Transform3d& start, const fcl::Transform3d& end, double time) const {
    const auto motion = motion_of(start, end);
    motion->integrate(time);
    fcl::Transform3d at;
    motion->getCurrentTransform(at);
    Pose pose;
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) pose.linear[i][j] = at.linear()(i, j);
      pose.offset[i] = at.translation()[i];
    }
    return pose;
  }

  Method method_;
  const SweepWork* work_ = nullptr;
  fcl::ContinuousCollisionRequestd request_;
  std::vector<Geometries> geometries_;
  std::vector<Ways> ways_;
};

}  // namespace

/// Overlap at steps takes seconds of meshes that are large.
SweepOffer fcl_sweeps(const SweepWork& work) {
  SweepOffer offer;
  const bool has_mesh = std::holds_alternative<std::shared_ptr<const TriangleMesh>>(work.pairs.front().a);
  for (const Method method : {Method::steps, Method::interpolated, Method::screw}) {
    if (method == Method::steps && has_mesh) continue;
    offer.libraries.push_back(std::make_unique<FclSweeps>(method));
  }
  return offer;
}

}  // namespace toccata::bench
