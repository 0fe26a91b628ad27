#include <BulletCollision/BroadphaseCollision/btDbvtBroadphase.h>
#include <BulletCollision/CollisionDispatch/btCollisionDispatcher.h>
#include <BulletCollision/CollisionDispatch/btCollisionObject.h>
#include <BulletCollision/CollisionDispatch/btCollisionWorld.h>
#include <BulletCollision/CollisionDispatch/btDefaultCollisionConfiguration.h>
#include <BulletCollision/CollisionShapes/btBvhTriangleMeshShape.h>
#include <BulletCollision/CollisionShapes/btTriangleIndexVertexArray.h>

#include <algorithm>
#include <memory>
#include <stdexcept>
#include <utility>
#include <variant>
#include <vector>

#include "peers/bullet_shapes.hpp"
#include "world.hpp"

namespace toccata::bench {
namespace {

/// A mesh for Bullet, which refers to the vertices and indices.
class BulletTerrain {
 public:
  explicit BulletTerrain(std::shared_ptr<const TriangleMesh> mesh) : mesh_(std::move(mesh)) {
    for (const auto& corners : mesh_->triangles())
      for (const Index corner : corners) indices_.push_back(static_cast<int>(corner));
    for (const Vec3& v : mesh_->vertices()) coordinates_.insert(coordinates_.end(), {v.x, v.y, v.z});
    view_ = std::make_unique<btTriangleIndexVertexArray>(
        static_cast<int>(mesh_->triangle_count()), indices_.data(), static_cast<int>(3 * sizeof(int)),
        static_cast<int>(mesh_->vertices().size()), coordinates_.data(), static_cast<int>(3 * sizeof(btScalar)));
  }
  [[nodiscard]] std::unique_ptr<btCollisionShape> shape() const {
    return without_margin(std::make_unique<btBvhTriangleMeshShape>(view_.get(), true));
  }

 private:
  std::shared_ptr<const TriangleMesh> mesh_;
  std::vector<int> indices_;
  std::vector<btScalar> coordinates_;
  std::unique_ptr<btTriangleIndexVertexArray> view_;
};

struct Convert {
  using Made = std::unique_ptr<btCollisionShape>;
  Made operator()(const HeightField& shape) const {
    terrains.push_back(std::make_unique<BulletTerrain>(shape.mesh()));
    return terrains.back()->shape();
  }
  Made operator()(const Sphere& shape) const { return converted(shape); }
  Made operator()(const Box& shape) const { return converted(shape); }
  Made operator()(const Capsule& shape) const { return converted(shape); }
  Made operator()(const ConvexHull& shape) const { return converted(shape); }
  template <class Other>
  Made operator()(const Other&) const {
    throw std::logic_error("a shape that crowds do not have");
  }

  std::vector<std::unique_ptr<BulletTerrain>>& terrains;
};

bool touch(const btPersistentManifold& manifold) {
  for (int i = 0; i < manifold.getNumContacts(); ++i)
    if (manifold.getContactPoint(i).getDistance() <= 0) return true;
  return false;
}

/// Bullet keeps up to four points of two bodies that may touch, which are looked up here.
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
      shapes_.push_back(std::visit(Convert{terrains_}, shapes[i]));
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
  std::vector<std::unique_ptr<BulletTerrain>> terrains_;
  std::vector<std::unique_ptr<btCollisionShape>> shapes_;
  std::vector<std::unique_ptr<btCollisionObject>> objects_;
};

}  // namespace

std::unique_ptr<WorldLibrary> bullet_world() { return std::make_unique<BulletWorld>(); }

}  // namespace toccata::bench
