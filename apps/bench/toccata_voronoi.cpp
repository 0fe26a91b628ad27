#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "convex_library.hpp"
#include "convex_questions.hpp"
#include "toccata/core/version.hpp"
#include "toccata/methods/voronoi.hpp"
#include "toccata/narrow/convex_convex.hpp"

// Hulls that move by small steps: walking through Voronoi regions, and what it is to be compared with.
namespace toccata::bench {
namespace {

/// Poses are made before, so that what is measured is the question alone.
class OfTracked : public ConvexLibrary {
 public:
  void prepare(const ConvexWork& work) override {
    work_ = &work;
    for (const ConvexQuestion& q : work.questions) {
      posed_a_.push_back(posed(work.pairs[q.pair].a, q.a));
      posed_b_.push_back(posed(work.pairs[q.pair].b, q.b));
    }
  }
  void answer(std::size_t first, std::span<ConvexAnswer> answers) override {
    for (std::size_t i = 0; i < answers.size(); ++i) {
      const ConvexQuestion& q = work_->questions[first + i];
      answers[i] = asked(q, posed_a_[first + i], posed_b_[first + i]);
    }
  }

 protected:
  [[nodiscard]] static Description as(const std::string& variant, const std::string& more = "") {
    return {"toccata", variant + ", posed before", version,
            fmt::format("{}, {} -ffp-contract=off{}", TOCCATA_BENCH_COMPILER, TOCCATA_BENCH_FLAGS, more)};
  }
  virtual ConvexAnswer asked(const ConvexQuestion& q, const PosedPolytope& a, const PosedPolytope& b) = 0;

  const ConvexWork* work_ = nullptr;

 private:
  std::vector<PosedPolytope> posed_a_;
  std::vector<PosedPolytope> posed_b_;
};

ConvexAnswer answer_of(const Distance& d) { return {d.upper == 0, d.lower, d.upper}; }

class ByVoronoiWalk : public OfTracked {
 public:
  Description description() const override {
    const VoronoiCounts& c = tracked_.counts;
    const double asked = std::max(1.0, static_cast<double>(c.questions));
    const auto share = [=](std::uint64_t part) { return static_cast<double>(part) / asked; };
    return as("by Voronoi walk", fmt::format("; a question: {:.2f} kept, {:.2f} walked, {:.3f} searched, {:.2f} steps",
                                             share(c.kept), share(c.walked), share(c.searched), share(c.steps)));
  }
  void prepare(const ConvexWork& work) override {
    OfTracked::prepare(work);
    for (const ConvexPair& pair : work.pairs) {
      regions_a_.emplace_back(std::get<ConvexHull>(pair.a));
      regions_b_.emplace_back(std::get<ConvexHull>(pair.b));
    }
  }
  double bytes_per_vertex() const override {
    return static_cast<double>(regions_a_.front().memory()) / regions_a_.front().vertex_count();
  }

 private:
  ConvexAnswer asked(const ConvexQuestion& q, const PosedPolytope& a, const PosedPolytope& b) override {
    if (!q.follows) tracked_.state = TrackedPair::State::unknown, tracked_.cores_meet = false;
    return answer_of(distance_by_voronoi_walk(a, regions_a_[q.pair], b, regions_b_[q.pair], tracked_));
  }

  std::vector<VoronoiRegions> regions_a_, regions_b_;
  TrackedPair tracked_;
};

class ByColdGjk : public OfTracked {
 public:
  Description description() const override { return as("by GJK, cold"); }

 private:
  ConvexAnswer asked(const ConvexQuestion&, const PosedPolytope& a, const PosedPolytope& b) override {
    return answer_of(distance_by_gjk(a, b));
  }
};

/// Tells whether they meet, not how far apart they are.
class ByKeptAxis : public OfTracked {
 public:
  Description description() const override { return as("overlap by separating axes, the last first"); }

 private:
  ConvexAnswer asked(const ConvexQuestion& q, const PosedPolytope& a, const PosedPolytope& b) override {
    if (!q.follows) workspace_ = {};
    return {overlap_by_separating_axes(a, b, &workspace_)};
  }

  SimplexCache workspace_;
};

}  // namespace

ConvexOffer toccata_tracked(const ConvexWork& work) {
  ConvexOffer offer;
  if (work.pair != "hull" || !work.coherent) return offer;
  if (work.task != ConvexTask::overlap && work.task != ConvexTask::distance) return offer;
  offer.libraries.push_back(std::make_unique<ByVoronoiWalk>());
  if (work.task == ConvexTask::overlap)
    offer.libraries.push_back(std::make_unique<ByKeptAxis>());
  else
    offer.libraries.push_back(std::make_unique<ByColdGjk>());
  return offer;
}

}  // namespace toccata::bench
