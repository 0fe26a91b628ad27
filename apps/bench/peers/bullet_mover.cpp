#include <BulletCollision/BroadphaseCollision/btDbvtBroadphase.h>
#include <BulletCollision/CollisionDispatch/btCollisionDispatcher.h>
#include <BulletCollision/CollisionDispatch/btCollisionWorld.h>
#include <BulletCollision/CollisionDispatch/btDefaultCollisionConfiguration.h>
#include <BulletCollision/CollisionDispatch/btGhostObject.h>
#include <BulletCollision/CollisionShapes/btBvhTriangleMeshShape.h>
#include <BulletCollision/CollisionShapes/btTriangleMesh.h>
#include <BulletDynamics/Character/btKinematicCharacterController.h>

#include <ranges>

#include "movers.hpp"
#include "peers/bullet_shapes.hpp"
#include "toccata/query/contacts.hpp"

namespace toccata::bench {
namespace {

/// As much of a step as Toccata's character climbs.
constexpr double step_height = 0.3;

/// Something of the level, with the margin that Bullet gives it: its characters need one.
struct LevelObject {
  explicit LevelObject(const SceneInstance& posed) {
    if (posed.model.has_mesh()) {
      for (const Index i : std::views::iota(Index{0}, posed.model.element_count())) {
        const Triangle t = world_triangle(posed.model, {}, i);
        triangles.addTriangle(converted(t[0]), converted(t[1]), converted(t[2]));
      }
      shape = std::make_unique<btBvhTriangleMeshShape>(&triangles, true);
    } else {
      shape = std::make_unique<btBoxShape>(converted(std::get<Box>(posed.model.shape()).half_extents()));
    }
    object.setCollisionShape(shape.get());
    object.setWorldTransform(converted(posed.pose));
    object.setCollisionFlags(btCollisionObject::CF_STATIC_OBJECT);
  }
  btTriangleMesh triangles;
  std::unique_ptr<btCollisionShape> shape;
  btCollisionObject object;
};

/// Everything that a world needs, in the order in which it is torn down.
struct LevelWorld {
  LevelWorld() : dispatcher(&configuration), world(&dispatcher, &broad_phase, &configuration) {
    broad_phase.getOverlappingPairCache()->setInternalGhostPairCallback(&ghost_pairs);
  }
  btDefaultCollisionConfiguration configuration;
  btCollisionDispatcher dispatcher;
  btGhostPairCallback ghost_pairs;
  btDbvtBroadphase broad_phase;
  btCollisionWorld world;
  std::vector<std::unique_ptr<LevelObject>> objects;
};

class BulletMover : public MoverLibrary {
 public:
  BulletMover() = default;
  BulletMover(const BulletMover&) = delete;
  BulletMover& operator=(const BulletMover&) = delete;
  ~BulletMover() override {
    remove_character();
    for (const auto& one : level_.objects) level_.world.removeCollisionObject(&one->object);
  }

  Description description() const override {
    return {"bullet", "btKinematicCharacterController of doubles", TOCCATA_BENCH_BULLET_VERSION, "as packaged"};
  }

  void build(const WalkWork& work) override {
    for (const SceneInstance& posed : work.models) {
      level_.objects.push_back(std::make_unique<LevelObject>(posed));
      level_.world.addCollisionObject(&level_.objects.back()->object, btBroadphaseProxy::StaticFilter,
                                      btBroadphaseProxy::AllFilter ^ btBroadphaseProxy::StaticFilter);
    }
    level_.world.updateAabbs();
    level_.broad_phase.optimize();
  }

  void place(const Vec3& foot) override {
    remove_character();
    ghost_ = std::make_unique<btPairCachingGhostObject>();
    ghost_->setCollisionShape(&capsule_);
    ghost_->setCollisionFlags(btCollisionObject::CF_CHARACTER_OBJECT);
    ghost_->setWorldTransform(converted(Pose::translation(foot + Vec3{0, 0, WalkerShape::height / 2})));
    level_.world.addCollisionObject(ghost_.get(), btBroadphaseProxy::CharacterFilter, btBroadphaseProxy::StaticFilter);
    controller_ =
        std::make_unique<btKinematicCharacterController>(ghost_.get(), &capsule_, step_height, btVector3(0, 0, 1));
    controller_->setGravity(btVector3(0, 0, -walk_gravity));
  }

  /// As a world of dynamics does it in each step: boxes first, then its actions, of which the character is one.
  void step(const Vec3& wish) override {
    level_.world.updateSingleAabb(ghost_.get());
    controller_->setWalkDirection(converted(wish));
    controller_->updateAction(&level_.world, walk_seconds);
  }

  Vec3 foot() const override {
    const btVector3& middle = ghost_->getWorldTransform().getOrigin();
    return {middle.x(), middle.y(), middle.z() - WalkerShape::height / 2};
  }

 private:
  void remove_character() {
    if (ghost_ != nullptr) level_.world.removeCollisionObject(ghost_.get());
    controller_.reset();
    ghost_.reset();
  }

  LevelWorld level_;
  btCapsuleShapeZ capsule_{WalkerShape::radius, WalkerShape::height - 2 * WalkerShape::radius};
  std::unique_ptr<btPairCachingGhostObject> ghost_;
  std::unique_ptr<btKinematicCharacterController> controller_;
};

}  // namespace

MoverLibraries bullet_movers() {
  MoverLibraries libraries;
  libraries.push_back(std::make_unique<BulletMover>());
  return libraries;
}

}  // namespace toccata::bench
