#include <fcl/broadphase/broadphase_dynamic_AABB_tree.h>
#include <fcl/geometry/shape/box.h>
#include <algorithm>

#include "broad.hpp"

namespace toccata::bench {
namespace {

bool note_pair(fcl::CollisionObjectd* one, fcl::CollisionObjectd* other, void* pairs) {
  const auto number_of = [](const fcl::CollisionObjectd* object) {
    return *static_cast<Index*>(object->getUserData());
  };
  const Index a = number_of(one), b = number_of(other);
  static_cast<std::vector<IndexPair>*>(pairs)->push_back({std::min(a, b), std::max(a, b)});
  return false;
}

class FclBroad final : public BroadLibrary {
 public:
  Description description() const override {
    return {"fcl", "DynamicAABBTree", TOCCATA_BENCH_FCL_VERSION, "-O3 -DNDEBUG, library as packaged"};
  }
  void add(std::span<const Aabb> boxes) override {
    numbers_.resize(boxes.size());
    for (Index number = 0; number < boxes.size(); ++number) {
      const Vec3 size = boxes[number].upper - boxes[number].lower;
      objects_.push_back(std::make_unique<fcl::CollisionObjectd>(std::make_shared<fcl::Boxd>(size.x, size.y, size.z)));
      numbers_[number] = number;
      objects_.back()->setUserData(&numbers_[number]);
      place(number, boxes[number]);
    }
    std::vector<fcl::CollisionObjectd*> all;
    for (const auto& object : objects_) all.push_back(object.get());
    manager_.registerObjects(all);
    manager_.setup();
  }
  void step(std::span<const Index> moved, std::span<const Aabb> boxes) override {
    moved_.clear();
    for (const Index number : moved) {
      place(number, boxes[number]);
      moved_.push_back(objects_[number].get());
    }
    manager_.update(moved_);
    pairs_.clear();
    manager_.collide(&pairs_, note_pair);
  }
  std::vector<IndexPair> pairs() const override { return pairs_; }

 private:
  void place(Index number, const Aabb& box) {
    const Vec3 centre = 0.5 * (box.lower + box.upper);
    objects_[number]->setTranslation({centre.x, centre.y, centre.z});
    objects_[number]->computeAABB();
  }
  fcl::DynamicAABBTreeCollisionManagerd manager_;
  std::vector<std::unique_ptr<fcl::CollisionObjectd>> objects_;
  std::vector<fcl::CollisionObjectd*> moved_;
  std::vector<Index> numbers_;
  std::vector<IndexPair> pairs_;
};

}  // namespace

BroadLibraries fcl_broad_libraries() {
  BroadLibraries libraries;
  libraries.push_back(std::make_unique<FclBroad>());
  return libraries;
}

}  // namespace toccata::bench
