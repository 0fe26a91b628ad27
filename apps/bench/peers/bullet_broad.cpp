#include <BulletCollision/BroadphaseCollision/btAxisSweep3.h>
#include <BulletCollision/BroadphaseCollision/btDbvtBroadphase.h>

#include <algorithm>
#include <utility>

#include "broad.hpp"

namespace toccata::bench {
namespace {

btVector3 converted(const Vec3& v) { return {v.x, v.y, v.z}; }

/// Its pair cache keeps pairs from step to step. The sweep does not look at the dispatcher, which is of the narrow
/// phase.
class BulletBroad final : public BroadLibrary {
 public:
  BulletBroad(std::string variant, std::unique_ptr<btBroadphaseInterface> phase)
      : variant_(std::move(variant)), phase_(std::move(phase)) {}
  BulletBroad(const BulletBroad&) = delete;
  BulletBroad& operator=(const BulletBroad&) = delete;
  ~BulletBroad() override {
    for (btBroadphaseProxy* proxy : proxies_) phase_->destroyProxy(proxy, nullptr);
  }

  Description description() const override { return {"bullet", variant_, TOCCATA_BENCH_BULLET_VERSION, "as packaged"}; }
  void add(std::span<const Aabb> boxes) override {
    numbers_.resize(boxes.size());
    for (Index number = 0; number < boxes.size(); ++number) {
      numbers_[number] = number;
      proxies_.push_back(phase_->createProxy(converted(boxes[number].lower), converted(boxes[number].upper), 0,
                                             &numbers_[number], btBroadphaseProxy::DefaultFilter,
                                             btBroadphaseProxy::AllFilter, nullptr));
    }
    phase_->calculateOverlappingPairs(nullptr);
  }
  void step(std::span<const Index> moved, std::span<const Aabb> boxes) override {
    for (const Index number : moved)
      phase_->setAabb(proxies_[number], converted(boxes[number].lower), converted(boxes[number].upper), nullptr);
    phase_->calculateOverlappingPairs(nullptr);
  }
  std::vector<IndexPair> pairs() const override {
    std::vector<IndexPair> pairs;
    const btBroadphasePairArray& found = phase_->getOverlappingPairCache()->getOverlappingPairArray();
    for (int i = 0; i < found.size(); ++i) {
      const Index one = *static_cast<Index*>(found[i].m_pProxy0->m_clientObject);
      const Index other = *static_cast<Index*>(found[i].m_pProxy1->m_clientObject);
      pairs.push_back({std::min(one, other), std::max(one, other)});
    }
    return pairs;
  }

 private:
  std::string variant_;
  std::unique_ptr<btBroadphaseInterface> phase_;
  std::vector<btBroadphaseProxy*> proxies_;
  std::vector<Index> numbers_;
};

}  // namespace

BroadLibraries bullet_broad_libraries(std::span<const Aabb> first) {
  BroadLibraries libraries;
  libraries.push_back(std::make_unique<BulletBroad>("btDbvtBroadphase", std::make_unique<btDbvtBroadphase>()));
  Aabb world;
  for (const Aabb& box : first) world = merge(world, box);
  const Vec3 rim = 0.1 * (world.upper - world.lower);
  if (first.size() <= 20'000)  // its sweep takes minutes to add more
    libraries.push_back(std::make_unique<BulletBroad>(
        "bt32BitAxisSweep3",
        std::make_unique<bt32BitAxisSweep3>(converted(world.lower - rim), converted(world.upper + rim),
                                            static_cast<unsigned>(first.size() + 2))));
  return libraries;
}

}  // namespace toccata::bench
