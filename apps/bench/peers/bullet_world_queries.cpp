#include <BulletCollision/BroadphaseCollision/btDbvtBroadphase.h>
#include <BulletCollision/CollisionDispatch/btCollisionDispatcher.h>
#include <BulletCollision/CollisionDispatch/btCollisionWorld.h>
#include <BulletCollision/CollisionDispatch/btDefaultCollisionConfiguration.h>
#include <BulletCollision/CollisionShapes/btBoxShape.h>
#include <BulletCollision/CollisionShapes/btBvhTriangleMeshShape.h>
#include <BulletCollision/CollisionShapes/btCapsuleShape.h>
#include <BulletCollision/CollisionShapes/btConeShape.h>
#include <BulletCollision/CollisionShapes/btConvexHullShape.h>
#include <BulletCollision/CollisionShapes/btCylinderShape.h>
#include <BulletCollision/CollisionShapes/btSphereShape.h>
#include <BulletCollision/CollisionShapes/btTriangleMesh.h>

#include <ranges>
#include <set>

#include "toccata/query/contacts.hpp"
#include "world_queries.hpp"

namespace toccata::bench {
namespace {

btVector3 converted(const Vec3& v) { return {v.x, v.y, v.z}; }

btTransform converted(const Pose& pose) {
  const Mat3& m = pose.linear;
  return btTransform(btMatrix3x3(m[0].x, m[0].y, m[0].z, m[1].x, m[1].y, m[1].z, m[2].x, m[2].y, m[2].z),
                     converted(pose.offset));
}

std::unique_ptr<btCollisionShape> converted(const ConvexHull& hull) {
  auto points = std::make_unique<btConvexHullShape>();
  for (Index i = 0; i < hull.vertex_count(); ++i) points->addPoint(converted(hull.vertex(i)), false);
  points->recalcLocalAabb();
  points->setMargin(0);
  return points;
}

/// The shape converted to Bullet's own, for the kinds that there are.
std::unique_ptr<btCollisionShape> converted(const Shape& shape) {
  if (const auto* hull = std::get_if<ConvexHull>(&shape)) return converted(*hull);
  if (const auto* cylinder = std::get_if<Cylinder>(&shape)) {
    auto round =
        std::make_unique<btCylinderShapeZ>(btVector3(cylinder->radius(), cylinder->radius(), cylinder->half_height()));
    round->setMargin(0);
    return round;
  }
  if (const auto* cone = std::get_if<Cone>(&shape)) {
    auto round = std::make_unique<btConeShapeZ>(cone->radius(), 2 * cone->half_height());
    round->setMargin(0);
    return round;
  }
  if (const auto* sphere = std::get_if<Sphere>(&shape)) return std::make_unique<btSphereShape>(sphere->radius());
  if (const auto* capsule = std::get_if<Capsule>(&shape))
    return std::make_unique<btCapsuleShapeZ>(capsule->radius(), 2 * capsule->end().z);
  auto box = std::make_unique<btBoxShape>(converted(std::get<Box>(shape).half_extents()));
  box->setMargin(0);
  return box;
}

/// An object and its shape, which refers to its triangles.
struct BulletObject {
  explicit BulletObject(const SceneInstance& posed) {
    if (posed.model.has_mesh()) {
      for (const Index i : std::views::iota(Index{0}, posed.model.element_count())) {
        const Triangle t = world_triangle(posed.model, {}, i);
        triangles.addTriangle(converted(t[0]), converted(t[1]), converted(t[2]));
      }
      shape = std::make_unique<btBvhTriangleMeshShape>(&triangles, true);
      shape->setMargin(0);
    } else {
      shape = converted(posed.model.shape());
    }
    object.setCollisionShape(shape.get());
    object.setWorldTransform(converted(posed.pose));
  }
  btTriangleMesh triangles;
  std::unique_ptr<btCollisionShape> shape;
  btCollisionObject object;
};

/// Who is in contact with the object that is asked about.
class Met : public btCollisionWorld::ContactResultCallback {
 public:
  btScalar addSingleResult(btManifoldPoint& point, const btCollisionObjectWrapper* one, int, int,
                           const btCollisionObjectWrapper* other, int, int) override {
    if (point.getDistance() <= 0) {
      objects.insert(one->getCollisionObject());
      objects.insert(other->getCollisionObject());
    }
    return 0;
  }
  std::set<const btCollisionObject*> objects;
};

class BulletWorld : public WorldQueryLibrary {
 public:
  BulletWorld() : dispatcher_(&configuration_), world_(&dispatcher_, &broad_phase_, &configuration_) {}
  BulletWorld(const BulletWorld&) = delete;
  BulletWorld& operator=(const BulletWorld&) = delete;
  ~BulletWorld() override {
    for (const auto& body : bodies_) world_.removeCollisionObject(&body->object);
  }

  Description description() const override {
    return {"bullet", "btCollisionWorld, btDbvtBroadphase", TOCCATA_BENCH_BULLET_VERSION, "as packaged"};
  }

  void build(const WorldWork& work) override {
    for (const SceneInstance& posed : work.bodies) {
      bodies_.push_back(std::make_unique<BulletObject>(posed));
      world_.addCollisionObject(&bodies_.back()->object);
    }
    world_.updateAabbs();
    broad_phase_.optimize();
  }

  void prepare(const WorldWork& work) override {
    task_ = work.task;
    for (const Ray& ray : work.rays) rays_.push_back({converted(ray.origin), converted(ray.origin + ray.motion)});
    for (const MovingShape& moving : work.moving) {
      shapes_.push_back(std::make_unique<BulletObject>(moving.shape));
      Pose to = moving.shape.pose;
      to.offset = to.offset + moving.motion;
      ends_.push_back(converted(to));
    }
    for (const SceneInstance& shape : work.shapes) shapes_.push_back(std::make_unique<BulletObject>(shape));
  }

  void answer(std::size_t first, std::span<double> answers) override {
    for (std::size_t i = 0; i < answers.size(); ++i)
      answers[i] = task_ == WorldTask::ray    ? time_of(rays_[first + i])
                   : task_ == WorldTask::cast ? time_of(*shapes_[first + i], ends_[first + i])
                                              : count_of(*shapes_[first + i]);
  }

 private:
  struct Way {
    btVector3 from;
    btVector3 to;
  };

  double time_of(const Way& way) const {
    btCollisionWorld::ClosestRayResultCallback closest(way.from, way.to);
    world_.rayTest(way.from, way.to, closest);
    return closest.m_closestHitFraction;
  }
  double time_of(const BulletObject& moving, const btTransform& to) const {
    const btTransform& from = moving.object.getWorldTransform();
    btCollisionWorld::ClosestConvexResultCallback closest(from.getOrigin(), to.getOrigin());
    world_.convexSweepTest(static_cast<const btConvexShape*>(moving.shape.get()), from, to, closest);
    return closest.m_closestHitFraction;
  }
  double count_of(BulletObject& shape) {
    Met met;
    world_.contactTest(&shape.object, met);
    return met.objects.empty() ? 0 : static_cast<double>(met.objects.size() - 1);  // without the one that asks
  }

  btDefaultCollisionConfiguration configuration_;
  btCollisionDispatcher dispatcher_;
  btDbvtBroadphase broad_phase_;
  btCollisionWorld world_;
  std::vector<std::unique_ptr<BulletObject>> bodies_;
  WorldTask task_ = WorldTask::ray;
  std::vector<Way> rays_;
  std::vector<std::unique_ptr<BulletObject>> shapes_;
  std::vector<btTransform> ends_;
};

}  // namespace

/// It has no question for what is nearest.
WorldQueryLibraries bullet_world_query_libraries(WorldTask task) {
  WorldQueryLibraries libraries;
  if (task != WorldTask::nearest) libraries.push_back(std::make_unique<BulletWorld>());
  return libraries;
}

}  // namespace toccata::bench
