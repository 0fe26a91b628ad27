#include <fmt/format.h>

#include <cmath>

#include "toccata/core/version.hpp"
#include "toccata/world/world_queries.hpp"
#include "world_queries.hpp"

namespace toccata::bench {
namespace {

class ToccataWorldQueries : public WorldQueryLibrary {
 public:
  Description description() const override {
    return {"toccata", "WorldQueries", version,
            fmt::format("{}, {} -ffp-contract=off", TOCCATA_BENCH_COMPILER, TOCCATA_BENCH_FLAGS)};
  }

  void build(const WorldWork& work) override {
    std::vector<Body> bodies;
    bodies.reserve(work.bodies.size());
    for (const SceneInstance& body : work.bodies) {
      bodies.push_back({body.model, body.pose});
      bodies.back().solid = body.solid;
    }
    world_.add(bodies);
    queries_.update();
  }
  void prepare(const WorldWork& work) override { work_ = &work; }

  void answer(std::size_t first, std::span<double> answers) override {
    const BatchOptions options{.threads = 1};
    std::size_t next = 0;
    if (work_->task == WorldTask::ray)
      for (const auto& hit : queries_.cast_ray_each(of(work_->rays, first, answers), {}, options))
        answers[next++] = hit ? hit->upper : 1;
    if (work_->task == WorldTask::cast)
      for (const auto& hit : queries_.cast_shape_each(of(work_->moving, first, answers), {}, options))
        answers[next++] = hit ? hit->upper : 1;
    if (work_->task == WorldTask::nearest)
      for (const auto& one : queries_.nearest_each(of(work_->shapes, first, answers), HUGE_VAL, {}, options))
        answers[next++] = one->upper;
    if (work_->task == WorldTask::overlap)
      for (const auto& met : queries_.overlapping_each(of(work_->shapes, first, answers), {}, options))
        answers[next++] = static_cast<double>(met.size());
  }

 private:
  template <class Question>
  static std::span<const Question> of(const std::vector<Question>& all, std::size_t first, std::span<double> answers) {
    return std::span(all).subspan(first, answers.size());
  }

  World world_;
  WorldQueries queries_{world_};
  const WorldWork* work_ = nullptr;
};

}  // namespace

WorldQueryLibraries toccata_world_query_libraries() {
  WorldQueryLibraries libraries;
  libraries.push_back(std::make_unique<ToccataWorldQueries>());
  return libraries;
}

}  // namespace toccata::bench
