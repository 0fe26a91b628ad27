#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <memory>

#include "convex_library.hpp"
#include "convex_questions.hpp"
#include "toccata/core/version.hpp"
#include "toccata/methods/sphere_ways.hpp"
#include "toccata/narrow/convex_convex.hpp"
#include "toccata/narrow/primitives.hpp"

// The methods that can be called on their own, each as a library: the lecture's ways for spheres, separating axes, GJK
// in each manner, expansion. Asked for as the peer "ways".
namespace toccata::bench {
namespace {

/// One function of two bodies at their places, which are posed for each question.
class OneWay : public ConvexLibrary {
 public:
  using Way = std::function<ConvexAnswer(const ConvexPair&, const ConvexQuestion&)>;

  OneWay(std::string name, Way way) : name_(std::move(name)), way_(std::move(way)) {}

  Description description() const override {
    return {"toccata", name_, version,
            fmt::format("{}, {} -ffp-contract=off", TOCCATA_BENCH_COMPILER, TOCCATA_BENCH_FLAGS)};
  }
  void prepare(const ConvexWork& work) override { work_ = &work; }
  void answer(std::size_t first, std::span<ConvexAnswer> answers) override {
    for (std::size_t i = 0; i < answers.size(); ++i) {
      const ConvexQuestion& question = work_->questions[first + i];
      answers[i] = way_(work_->pairs[question.pair], question);
    }
  }

 private:
  std::string name_;
  Way way_;
  const ConvexWork* work_ = nullptr;
};

using SphereTriangle = bool (*)(const PosedSphere&, const Triangle&);

OneWay::Way asked_by(SphereTriangle way) {
  return [way](const ConvexPair& pair, const ConvexQuestion& q) {
    const auto& local = std::get<Triangle>(pair.b);
    const Triangle b{{transform(q.b, local[0]), transform(q.b, local[1]), transform(q.b, local[2])}};
    return ConvexAnswer{way(PosedSphere(std::get<Sphere>(pair.a), q.a), b)};
  };
}

using SphereBox = bool (*)(const PosedSphere&, const Vec3& lower, const Vec3& upper);

/// In the frame of the box, where it lies along the axes.
OneWay::Way asked_by(SphereBox way) {
  return [way](const ConvexPair& pair, const ConvexQuestion& q) {
    const PosedSphere ball(std::get<Sphere>(pair.a), q.a);
    const auto& box = std::get<Box>(pair.b);
    const Vec3 from = ball.centre - q.b.offset;
    const Mat3& r = q.b.linear;
    const Vec3 centre{dot(r.column(0), from), dot(r.column(1), from), dot(r.column(2), from)};
    return ConvexAnswer{
        way(PosedSphere(centre, ball.radius), box.centre() - box.half_extents(), box.centre() + box.half_extents())};
  };
}

using Depth = Penetration (*)(const PosedPolytope&, const PosedPolytope&);

OneWay::Way asked_by(Depth way) {
  return [way](const ConvexPair& pair, const ConvexQuestion& q) {
    const Penetration p = way(posed(pair.a, q.a), posed(pair.b, q.b));
    return ConvexAnswer{p.upper > 0, p.lower, p.upper, p.direction};
  };
}

ConvexAnswer overlap_by_axes(const ConvexPair& pair, const ConvexQuestion& q) {
  return {overlap_by_separating_axes(posed(pair.a, q.a), posed(pair.b, q.b))};
}

/// GJK in one manner, with a workspace where the questions follow each other. Names the steps and the heights of
/// vertices that a question has taken.
class ByGjk : public ConvexLibrary {
 public:
  explicit ByGjk(const GjkOptions& options) : options_(options) {}

  Description description() const override {
    const std::string support = options_.support == GjkSupport::scan ? "scan" : "hill climbing";
    const std::string momentum = options_.acceleration == GjkAcceleration::none ? "" : ", momentum";
    const ConvexCounts& counts = workspace_.counts;
    const double asked = std::max(1.0, static_cast<double>(asked_));
    return {"toccata", fmt::format("by GJK, {}{}", support, momentum), version,
            fmt::format("{}, {} -ffp-contract=off; {:.1f} steps, {:.0f} heights a question", TOCCATA_BENCH_COMPILER,
                        TOCCATA_BENCH_FLAGS, static_cast<double>(counts.steps) / asked,
                        static_cast<double>(counts.heights) / asked)};
  }
  void prepare(const ConvexWork& work) override { work_ = &work; }
  void answer(std::size_t first, std::span<ConvexAnswer> answers) override {
    for (std::size_t i = 0; i < answers.size(); ++i) {
      const ConvexQuestion& q = work_->questions[first + i];
      const ConvexPair& pair = work_->pairs[q.pair];
      if (!q.follows) workspace_.simplex_size = 0, workspace_.direction = {};
      answers[i] = asked(posed(pair.a, q.a), posed(pair.b, q.b));
    }
    asked_ += answers.size();
  }

 private:
  ConvexAnswer asked(const PosedPolytope& a, const PosedPolytope& b) {
    if (work_->task == ConvexTask::overlap) return {overlap_by_gjk(a, b, options_, &workspace_)};
    const Distance d = distance_by_gjk(a, b, options_, &workspace_);
    return {d.upper == 0, d.lower, d.upper};
  }

  GjkOptions options_;
  const ConvexWork* work_ = nullptr;
  SimplexCache workspace_;
  std::size_t asked_ = 0;
};

void add(std::string name, OneWay::Way way, ConvexOffer& offer) {
  offer.libraries.push_back(std::make_unique<OneWay>(std::move(name), std::move(way)));
}

}  // namespace

ConvexOffer toccata_ways(const ConvexWork& work) {
  ConvexOffer offer;
  if (has_quadric(work.pair)) return offer;
  if (work.task == ConvexTask::penetration) {
    add("by separating axes", asked_by(penetration_by_separating_axes), offer);
    add("by expansion", asked_by(penetration_by_expansion), offer);
  }
  if (work.task == ConvexTask::distance || work.task == ConvexTask::overlap)
    for (const GjkSupport support : {GjkSupport::scan, GjkSupport::hill_climbing})
      for (const GjkAcceleration acceleration : {GjkAcceleration::none, GjkAcceleration::nesterov})
        offer.libraries.push_back(std::make_unique<ByGjk>(GjkOptions{support, acceleration}));
  if (work.task != ConvexTask::overlap) return offer;
  add("by separating axes", overlap_by_axes, offer);
  if (work.pair == "sphere-triangle") {
    add("by plane projection", asked_by(overlap_by_plane_projection), offer);
    add("by features", asked_by(overlap_by_features), offer);
    add("by minimisation", asked_by(overlap_by_minimisation), offer);
    add("by Voronoi regions", asked_by(overlap_by_voronoi_regions), offer);
  }
  if (work.pair == "sphere-box") {
    add("by 27 regions, in the box's frame", asked_by(overlap_by_regions), offer);
    add("by clamping, in the box's frame", asked_by(overlap_by_clamping), offer);
  }
  return offer;
}

}  // namespace toccata::bench
