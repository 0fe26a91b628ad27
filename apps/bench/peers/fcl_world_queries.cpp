#include <fcl/broadphase/broadphase_dynamic_AABB_tree.h>
#include <fcl/geometry/shape/box.h>
#include <fcl/geometry/shape/capsule.h>
#include <fcl/geometry/shape/sphere.h>
#include <fcl/narrowphase/collision.h>
#include <fcl/narrowphase/distance.h>

#include <algorithm>
#include <limits>

#include "world_queries.hpp"

namespace toccata::bench {
namespace {

/// The shape converted to FCL's own, for the three kinds that there are.
std::shared_ptr<fcl::CollisionGeometryd> converted(const Shape& shape) {
  if (const auto* sphere = std::get_if<Sphere>(&shape)) return std::make_shared<fcl::Sphered>(sphere->radius());
  if (const auto* capsule = std::get_if<Capsule>(&shape))
    return std::make_shared<fcl::Capsuled>(capsule->radius(), 2 * capsule->end().z);
  const Vec3 size = 2.0 * std::get<Box>(shape).half_extents();
  return std::make_shared<fcl::Boxd>(size.x, size.y, size.z);
}

std::unique_ptr<fcl::CollisionObjectd> converted(const SceneInstance& posed) {
  fcl::Transform3d pose = fcl::Transform3d::Identity();
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) pose.linear()(i, j) = posed.pose.linear[i][j];
    pose.translation()[i] = posed.pose.offset[i];
  }
  return std::make_unique<fcl::CollisionObjectd>(converted(posed.model.shape()), pose);
}

bool count_met(fcl::CollisionObjectd* one, fcl::CollisionObjectd* other, void* count) {
  const fcl::CollisionRequestd request;
  fcl::CollisionResultd result;
  if (fcl::collide(one, other, request, result) > 0) ++*static_cast<int*>(count);
  return false;
}

bool keep_nearest(fcl::CollisionObjectd* one, fcl::CollisionObjectd* other, void* least, double& distance) {
  const fcl::DistanceRequestd request;
  fcl::DistanceResultd result;
  double& nearest = *static_cast<double*>(least);
  nearest = std::min(nearest, std::max(fcl::distance(one, other, request, result), 0.0));
  distance = nearest;
  return nearest <= 0;
}

class FclWorld : public WorldQueryLibrary {
 public:
  Description description() const override {
    return {"fcl", "DynamicAABBTree", TOCCATA_BENCH_FCL_VERSION, "-O3 -DNDEBUG, library as packaged"};
  }

  void build(const WorldWork& work) override {
    std::vector<fcl::CollisionObjectd*> all;
    for (const SceneInstance& body : work.bodies) {
      bodies_.push_back(converted(body));
      all.push_back(bodies_.back().get());
    }
    manager_.registerObjects(all);
    manager_.setup();
  }

  void prepare(const WorldWork& work) override {
    task_ = work.task;
    for (const SceneInstance& shape : work.shapes) shapes_.push_back(converted(shape));
  }

  void answer(std::size_t first, std::span<double> answers) override {
    for (std::size_t i = 0; i < answers.size(); ++i)
      answers[i] = task_ == WorldTask::nearest ? nearest_to(*shapes_[first + i]) : count_of(*shapes_[first + i]);
  }

 private:
  double nearest_to(fcl::CollisionObjectd& shape) {
    double least = std::numeric_limits<double>::max();
    manager_.distance(&shape, &least, keep_nearest);
    return least;
  }
  double count_of(fcl::CollisionObjectd& shape) {
    int count = 0;
    manager_.collide(&shape, &count, count_met);
    return count;
  }

  fcl::DynamicAABBTreeCollisionManagerd manager_;
  std::vector<std::unique_ptr<fcl::CollisionObjectd>> bodies_;
  std::vector<std::unique_ptr<fcl::CollisionObjectd>> shapes_;
  WorldTask task_ = WorldTask::nearest;
};

}  // namespace

/// It has neither rays nor casts at all bodies.
WorldQueryLibraries fcl_world_query_libraries(WorldTask task) {
  WorldQueryLibraries libraries;
  if (task == WorldTask::nearest || task == WorldTask::overlap) libraries.push_back(std::make_unique<FclWorld>());
  return libraries;
}

}  // namespace toccata::bench
