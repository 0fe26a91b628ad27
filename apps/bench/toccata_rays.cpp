#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "rays.hpp"
#include "toccata/core/version.hpp"
#include "toccata/query/batch.hpp"
#include "toccata/query/ray_caster.hpp"

namespace toccata::bench {
namespace {

RayAnswer ray_answer_of(const std::optional<RayHit>& hit) {
  return hit ? RayAnswer{true, 0.5 * (hit->lower + hit->upper)} : RayAnswer{};
}

class ToccataRays : public RayLibrary {
 public:
  explicit ToccataRays(std::string variant) : variant_(std::move(variant)) {}

  Description description() const override {
    return {"toccata", variant_, version,
            fmt::format("{}, {} -ffp-contract=off", TOCCATA_BENCH_COMPILER, TOCCATA_BENCH_FLAGS)};
  }
  void prepare(const TriangleMesh& mesh, std::span<const RayQuestion> questions) override {
    model_.emplace(mesh);
    queries_.clear();
    for (const RayQuestion& q : questions) queries_.push_back({q.origin, q.motion, {}, Solid::none});
  }

 protected:
  std::string variant_;
  std::optional<Model> model_;
  std::vector<RayQuery> queries_;
};

class ArraysOfRays : public ToccataRays {
 public:
  using ToccataRays::ToccataRays;
  void answer(std::size_t first, std::span<RayAnswer> answers) override {
    BatchOptions options;
    options.threads = 1;
    const auto hits = cast_ray_each(std::span(queries_).subspan(first, answers.size()), *model_, options);
    std::transform(hits.begin(), hits.end(), answers.begin(), ray_answer_of);
  }
};

class SingleRays : public ToccataRays {
 public:
  using ToccataRays::ToccataRays;
  void answer(std::size_t first, std::span<RayAnswer> answers) override {
    for (std::size_t i = 0; i < answers.size(); ++i) {
      const RayQuery& query = queries_[first + i];
      answers[i] = ray_answer_of(cast_ray(query.origin, query.motion, *model_, query.pose, query.solid));
    }
  }
};

class PosedRays : public ToccataRays {
 public:
  using ToccataRays::ToccataRays;
  void prepare(const TriangleMesh& mesh, std::span<const RayQuestion> questions) override {
    ToccataRays::prepare(mesh, questions);
    caster_.emplace(*model_, Pose{}, Solid::none);
  }
  void answer(std::size_t first, std::span<RayAnswer> answers) override {
    for (std::size_t i = 0; i < answers.size(); ++i) {
      const RayQuery& query = queries_[first + i];
      answers[i] = ray_answer_of(caster_->cast_ray(query.origin, query.motion));
    }
  }

 private:
  std::optional<RayCaster> caster_;
};

}  // namespace

RayLibraries toccata_ray_libraries() {
  RayLibraries libraries;
  libraries.push_back(std::make_unique<ArraysOfRays>("arrays of rays"));
  libraries.push_back(std::make_unique<SingleRays>("one ray, posed for each"));
  libraries.push_back(std::make_unique<PosedRays>("one ray, posed before"));
  return libraries;
}

}  // namespace toccata::bench
