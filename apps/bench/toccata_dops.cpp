#include <fmt/format.h>

#include <memory>

#include "convex_library.hpp"
#include "dop_bodies.hpp"
#include "toccata/bounds/kdop.hpp"
#include "toccata/core/version.hpp"

// A sphere against a k-DOP by the slabs that its centre is beyond.
namespace toccata::bench {
namespace {

/// In the frame of the k-DOP, where its planes have the fixed normals.
template <std::size_t k>
class ByRegionCodes : public ConvexLibrary {
 public:
  Description description() const override {
    return {"toccata", "by region codes, in the k-DOP's frame", version,
            fmt::format("{}, {} -ffp-contract=off", TOCCATA_BENCH_COMPILER, TOCCATA_BENCH_FLAGS)};
  }

  void prepare(const ConvexWork& work) override {
    work_ = &work;
    for (const ConvexPair& pair : work.pairs) {
      const auto& hull = std::get<ConvexHull>(pair.b);
      std::vector<Vec3> corners;
      for (Index i = 0; i < hull.vertex_count(); ++i) corners.push_back(hull.vertex(i));
      dops_.push_back(fit<Kdop<k>>(corners));
    }
  }

  void answer(std::size_t first, std::span<ConvexAnswer> answers) override {
    for (std::size_t i = 0; i < answers.size(); ++i) {
      const ConvexQuestion& q = work_->questions[first + i];
      const PosedSphere ball(std::get<Sphere>(work_->pairs[q.pair].a), q.a);
      const Vec3 from = ball.centre - q.b.offset;
      const Mat3& r = q.b.linear;
      const Vec3 centre{dot(r.column(0), from), dot(r.column(1), from), dot(r.column(2), from)};
      answers[i] = {overlap_by_regions(PosedSphere(centre, ball.radius), dops_[q.pair])};
    }
  }

 private:
  const ConvexWork* work_ = nullptr;
  std::vector<Kdop<k>> dops_;
};

}  // namespace

ConvexOffer toccata_dops(const ConvexWork& work) {
  ConvexOffer offer;
  if (work.task == ConvexTask::overlap && work.pair.ends_with("-dop"))
    with_planes(work.pair.substr(work.pair.find('-') + 1),
                [&]<std::size_t k>() { offer.libraries.push_back(std::make_unique<ByRegionCodes<k>>()); });
  return offer;
}

}  // namespace toccata::bench
