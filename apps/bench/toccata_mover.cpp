#include "movers.hpp"
#include "toccata/core/version.hpp"
#include "toccata/world/character_mover.hpp"

namespace toccata::bench {
namespace {

class ToccataMover : public MoverLibrary {
 public:
  Description description() const override { return {"toccata", "move_character", version, TOCCATA_BENCH_FLAGS}; }

  void build(const WalkWork& work) override { level_ = SceneIndex(work.models); }

  void place(const Vec3& foot) override {
    state_ = {Pose::translation(foot), {}};
    falling_ = 0;
  }

  void step(const Vec3& wish) override {
    falling_ = state_.ground ? 0 : falling_ + walk_seconds * walk_gravity;
    state_ = move_character(level_, walker_, state_, wish - Vec3{0, 0, walk_seconds * falling_}).state;
  }

  Vec3 foot() const override { return state_.pose.offset; }

 private:
  SceneIndex level_;
  Model walker_ = walker_model();
  MoverState<Index> state_;
  double falling_ = 0;
};

}  // namespace

Model walker_model() {
  const double r = WalkerShape::radius;
  return Capsule({0, 0, r}, {0, 0, WalkerShape::height - r}, r);
}

MoverLibraries toccata_movers() {
  MoverLibraries libraries;
  libraries.push_back(std::make_unique<ToccataMover>());
  return libraries;
}

}  // namespace toccata::bench
