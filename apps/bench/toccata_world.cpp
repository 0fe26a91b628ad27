#include <fmt/format.h>

#include "toccata/core/version.hpp"
#include "toccata/world/world.hpp"
#include "world.hpp"

namespace toccata::bench {
namespace {

class ToccataWorld final : public WorldLibrary {
 public:
  ToccataWorld(int threads, bool manifolds) : world_({.manifold = manifolds, .threads = threads}) {}

  Description description() const override {
    return {"toccata", world_.options().manifold ? "World with manifolds" : "World", version,
            fmt::format("{}, {} -ffp-contract=off", TOCCATA_BENCH_COMPILER, TOCCATA_BENCH_FLAGS)};
  }
  void add(std::span<const Shape> shapes, std::span<const Pose> poses) override {
    std::vector<Body> bodies;
    for (std::size_t i = 0; i < shapes.size(); ++i) bodies.push_back({Model(shapes[i]), poses[i]});
    ids_ = world_.add(bodies);
    world_.prepare();
  }
  void step(std::span<const Pose> poses) override {
    world_.move(ids_, poses);
    world_.step();
  }
  std::vector<IndexPair> contacts() const override {
    std::vector<IndexPair> pairs;
    for (const PairReport& report : world_.pairs()) pairs.push_back({report.a.index, report.b.index});
    return pairs;
  }

 private:
  World world_;
  std::vector<BodyId> ids_;
};

}  // namespace

std::unique_ptr<WorldLibrary> toccata_world(int threads, bool manifolds) {
  return std::make_unique<ToccataWorld>(threads, manifolds);
}

}  // namespace toccata::bench
