#include <BulletCollision/BroadphaseCollision/btDbvtBroadphase.h>
#include <BulletCollision/CollisionDispatch/btCollisionDispatcher.h>
#include <BulletCollision/CollisionDispatch/btCollisionObject.h>
#include <BulletCollision/CollisionDispatch/btCollisionWorld.h>
#include <BulletCollision/CollisionDispatch/btDefaultCollisionConfiguration.h>

#include <algorithm>
#include <stdexcept>
#include <variant>

#include "peers/bullet_shapes.hpp"
#include "world.hpp"

namespace toccata::bench {
namespace {

struct Convert {
  using Made = std::unique_ptr<btCollisionShape>;
  Made operator()(const Sphere& shape) const { return converted(shape); }
  Made operator()(const Box& shape) const { return converted(shape); }
  Made operator()(const Capsule& shape) const { return converted(shape); }
  Made operator()(const ConvexHull& shape) const { return converted(shape); }
  template <class Other>
  Made operator()(const Other&) const {
    throw std::logic_error("a shape that crowds do not have");
  }
};

bool touch(const btPersistentManifold& manifold) {
  for (int i = 0; i < manifold.getNumContacts(); ++i)
    if (manifold.getContactPoint(i).getDistance() <= 0) return true;
  return false;
}

/// Of two bodies that may touch it keeps up to four points, which it looks up here.
class BulletWorld final : public WorldLibrary {
 public:
  BulletWorld() = default;
  BulletWorld(const BulletWorld&) = delete;
  BulletWorld& operator=(const BulletWorld&) = delete;
  ~BulletWorld() override {
    for (const auto& object : objects_) world_.removeCollisionObject(object.get());
  }

  Description description() const override {
    return {"bullet", "btCollisionWorld", TOCCATA_BENCH_BULLET_VERSION, "as packaged"};
  }
  void add(std::span<const Shape> shapes, std::span<const Pose> poses) override {
    for (std::size_t i = 0; i < shapes.size(); ++i) {
      shapes_.push_back(std::visit(Convert{}, shapes[i]));
      objects_.push_back(std::make_unique<btCollisionObject>());
      btCollisionObject& object = *objects_.back();
      object.setCollisionShape(shapes_.back().get());
      object.setWorldTransform(converted(poses[i]));
      object.setCollisionFlags(0);
      object.setUserIndex(static_cast<int>(i));
      world_.addCollisionObject(&object, btBroadphaseProxy::DefaultFilter, btBroadphaseProxy::AllFilter);
    }
  }
  void step(std::span<const Pose> poses) override {
    for (std::size_t i = 0; i < poses.size(); ++i) objects_[i]->setWorldTransform(converted(poses[i]));
    world_.performDiscreteCollisionDetection();
  }
  std::vector<IndexPair> contacts() const override {
    std::vector<IndexPair> pairs;
    for (int i = 0; i < dispatcher_.getNumManifolds(); ++i) {
      const btPersistentManifold& manifold = *dispatcher_.getManifoldByIndexInternal(i);
      const auto one = static_cast<Index>(manifold.getBody0()->getUserIndex());
      const auto other = static_cast<Index>(manifold.getBody1()->getUserIndex());
      if (touch(manifold)) pairs.push_back({std::min(one, other), std::max(one, other)});
    }
    return pairs;
  }

 private:
  btDefaultCollisionConfiguration configuration_;
  btCollisionDispatcher dispatcher_{&configuration_};
  btDbvtBroadphase phase_;
  btCollisionWorld world_{&dispatcher_, &phase_, &configuration_};
  std::vector<std::unique_ptr<btCollisionShape>> shapes_;
  std::vector<std::unique_ptr<btCollisionObject>> objects_;
};

}  // namespace

std::unique_ptr<WorldLibrary> bullet_world() { return std::make_unique<BulletWorld>(); }

}  // namespace toccata::bench
