#include <fcl/broadphase/broadphase_dynamic_AABB_tree.h>
#include <fcl/narrowphase/collision.h>

#include <algorithm>
#include <stdexcept>
#include <variant>

#include "peers/fcl_models.hpp"
#include "peers/fcl_shapes.hpp"
#include "world.hpp"

namespace toccata::bench {
namespace {

struct Convert {
  using Made = std::shared_ptr<fcl::CollisionGeometryd>;
  Made operator()(const Sphere& shape) const { return std::make_shared<fcl::Sphered>(converted(shape)); }
  Made operator()(const Box& shape) const { return std::make_shared<fcl::Boxd>(converted(shape)); }
  Made operator()(const Capsule& shape) const { return std::make_shared<fcl::Capsuled>(converted(shape)); }
  Made operator()(const ConvexHull& shape) const { return std::make_shared<fcl::Convexd>(converted(shape)); }
  Made operator()(const HeightField& shape) const { return fcl_model_of<fcl::OBBRSSd>(*shape.mesh()); }
  template <class Other>
  Made operator()(const Other&) const {
    throw std::logic_error("a shape that crowds do not have");
  }
};

Index number_of(const fcl::CollisionObjectd* object) { return *static_cast<Index*>(object->getUserData()); }

bool note_contact(fcl::CollisionObjectd* one, fcl::CollisionObjectd* other, void* pairs) {
  fcl::CollisionResultd result;
  if (fcl::collide(one, other, fcl::CollisionRequestd(), result) == 0) return false;
  const Index a = number_of(one), b = number_of(other);
  static_cast<std::vector<IndexPair>*>(pairs)->push_back({std::min(a, b), std::max(a, b)});
  return false;
}

class FclWorld final : public WorldLibrary {
 public:
  Description description() const override {
    return {"fcl", "DynamicAABBTree, collide", TOCCATA_BENCH_FCL_VERSION, "-O3 -DNDEBUG, library as packaged"};
  }
  void add(std::span<const Shape> shapes, std::span<const Pose> poses) override {
    numbers_.resize(shapes.size());
    for (std::size_t i = 0; i < shapes.size(); ++i) {
      objects_.push_back(
          std::make_unique<fcl::CollisionObjectd>(std::visit(Convert{}, shapes[i]), converted(poses[i])));
      numbers_[i] = static_cast<Index>(i);
      objects_[i]->setUserData(&numbers_[i]);
      all_.push_back(objects_[i].get());
    }
    manager_.registerObjects(all_);
    manager_.setup();
  }
  void step(std::span<const Pose> poses) override {
    for (std::size_t i = 0; i < poses.size(); ++i) {
      objects_[i]->setTransform(converted(poses[i]));
      objects_[i]->computeAABB();
    }
    manager_.update();
    pairs_.clear();
    manager_.collide(&pairs_, note_contact);
  }
  std::vector<IndexPair> contacts() const override { return pairs_; }

 private:
  fcl::DynamicAABBTreeCollisionManagerd manager_;
  std::vector<std::unique_ptr<fcl::CollisionObjectd>> objects_;
  std::vector<fcl::CollisionObjectd*> all_;
  std::vector<Index> numbers_;
  std::vector<IndexPair> pairs_;
};

}  // namespace

std::unique_ptr<WorldLibrary> fcl_world() { return std::make_unique<FclWorld>(); }

}  // namespace toccata::bench
