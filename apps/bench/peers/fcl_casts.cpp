#include <fcl/narrowphase/continuous_collision.h>

#include <memory>

#include "casts.hpp"
#include "peers/fcl_shapes.hpp"

namespace toccata::bench {
namespace {

enum class Method { advancement, steps };

template <class Shape>
using Converted = decltype(converted(std::declval<const Shape&>()));

/// `fcl::continuousCollide` of two shapes, one of which is moved without turning.
template <class Moving, class Standing>
class FclCasts : public CastLibrary {
 public:
  explicit FclCasts(Method method) : method_(method) {
    request_.ccd_motion_type = fcl::CCDM_TRANS;
    request_.gjk_solver_type = fcl::GST_LIBCCD;
    request_.ccd_solver_type = method == Method::steps ? fcl::CCDC_NAIVE : fcl::CCDC_CONSERVATIVE_ADVANCEMENT;
    if (method == Method::steps) request_.num_max_iterations = 1000;
  }

  Description description() const override {
    return {"fcl", method_ == Method::steps ? "overlap at 1,000 steps, libccd" : "conservative advancement, libccd",
            TOCCATA_BENCH_FCL_VERSION, "as packaged; solver's templates -O3"};
  }

  void prepare(const CastWork& work) override {
    work_ = &work;
    for (const CastPair& pair : work.pairs) {
      moving_.push_back(converted(std::get<Moving>(pair.moving)));
      standing_.push_back(converted(std::get<Standing>(pair.standing)));
    }
    for (const CastQuestion& question : work.questions) {
      Pose end = question.start;
      end.offset = end.offset + question.motion;
      ways_.push_back({converted(question.start), converted(end), converted(question.standing)});
    }
  }

  void answer(std::size_t first, std::span<CastAnswer> answers) override {
    for (std::size_t i = 0; i < answers.size(); ++i) {
      const std::size_t pair = work_->questions[first + i].pair;
      const Way& way = ways_[first + i];
      fcl::ContinuousCollisionResultd result;
      fcl::continuousCollide(&moving_[pair], way.start, way.end, &standing_[pair], way.standing, way.standing, request_,
                             result);
      answers[i] = {};
      if (result.is_collide) answers[i] = {true, result.time_of_contact, result.time_of_contact};
    }
  }

 private:
  struct Way {
    fcl::Transform3d start;
    fcl::Transform3d end;
    fcl::Transform3d standing;
  };

  Method method_;
  const CastWork* work_ = nullptr;
  fcl::ContinuousCollisionRequestd request_;
  std::vector<Converted<Moving>> moving_;
  std::vector<Converted<Standing>> standing_;
  std::vector<Way> ways_;
};

template <class Moving, class Standing>
CastOffer offer_for() {
  CastOffer offer;
  if constexpr (std::is_same_v<Moving, Point>)
    offer.unasked.push_back({{"fcl", "", TOCCATA_BENCH_FCL_VERSION, "as packaged"}, "it has no rays"});
  else
    // Its table of conservative advancement has no ellipsoids.
    offer.libraries.push_back(std::make_unique<FclCasts<Moving, Standing>>(
        std::is_same_v<Moving, Ellipsoid> ? Method::steps : Method::advancement));
  return offer;
}

}  // namespace

CastOffer fcl_casts(const CastWork& work) {
  return with_cast_types(work.pair, []<class Moving, class Standing>() { return offer_for<Moving, Standing>(); });
}

}  // namespace toccata::bench
