#include <fcl/broadphase/broadphase_dynamic_AABB_tree.h>
#include <fcl/math/bv/OBBRSS.h>
#include <fcl/narrowphase/collision.h>

#include <memory>
#include <vector>

#include "peers/fcl_models.hpp"
#include "peers/fcl_shapes.hpp"
#include "robots.hpp"

namespace toccata::bench {
namespace {

bool note_any(fcl::CollisionObjectd* one, fcl::CollisionObjectd* other, void* found) {
  fcl::CollisionResultd result;
  if (fcl::collide(one, other, fcl::CollisionRequestd(), result) == 0) return false;
  *static_cast<bool*>(found) = true;
  return true;
}

/// A link's body against the manager of the obstacles, and the pairs of bodies that Toccata looks at one by one: the
/// loop that FCL's users write.
class FclRobots final : public RobotLibrary {
 public:
  Description description() const override {
    return {"fcl", "OBBRSS, DynamicAABBTree", TOCCATA_BENCH_FCL_VERSION, "-O3 -DNDEBUG, library as packaged"};
  }

  void build(const RobotScene& scene) override {
    scene_ = &scene;
    for (const Robot::Body& body : scene.robot().bodies()) bodies_.push_back(object_of(body.model, {}));
    for (const SceneInstance& obstacle : scene.obstacles())
      obstacles_.push_back(object_of(obstacle.model, obstacle.pose));
    for (const auto& obstacle : obstacles_) manager_.registerObject(obstacle.get());
    manager_.setup();
    const auto links = scene.robot().bodies();
    for (std::size_t i = 0; i < links.size(); ++i)
      for (std::size_t j = i + 1; j < links.size(); ++j)
        if (scene.looks_at({links[i].link, false, links[j].link})) pairs_.emplace_back(i, j);
  }

  std::vector<std::uint8_t> meets(std::span<const double> configurations) override {
    const Robot& robot = scene_->robot();
    const std::size_t positions = robot.positions().size();
    std::vector<std::uint8_t> found;
    for (std::size_t i = 0; i < configurations.size(); i += positions)
      found.push_back(meets_at(robot.link_poses(configurations.subspan(i, positions))) ? 1 : 0);
    return found;
  }

 private:
  static std::unique_ptr<fcl::CollisionObjectd> object_of(const Model& model, const Pose& pose) {
    std::shared_ptr<fcl::CollisionGeometryd> geometry;
    if (const auto* box = std::get_if<Box>(&model.shape()))
      geometry = std::make_shared<fcl::Boxd>(converted(*box));
    else
      geometry = fcl_model_of<fcl::OBBRSSd>(model.mesh());
    auto object = std::make_unique<fcl::CollisionObjectd>(geometry, converted(pose));
    object->computeAABB();
    return object;
  }

  bool meets_at(const std::vector<Pose>& links) {
    const auto bodies = scene_->robot().bodies();
    for (std::size_t i = bodies_.size(); i-- > 0;) {
      bodies_[i]->setTransform(converted(links[bodies[i].link] * bodies[i].pose));
      bodies_[i]->computeAABB();
      bool found = false;
      manager_.collide(bodies_[i].get(), &found, note_any);
      if (found) return true;
    }
    for (const auto& [i, j] : pairs_) {
      bool found = false;
      if (bodies_[i]->getAABB().overlap(bodies_[j]->getAABB())) note_any(bodies_[i].get(), bodies_[j].get(), &found);
      if (found) return true;
    }
    return false;
  }

  const RobotScene* scene_ = nullptr;
  std::vector<std::unique_ptr<fcl::CollisionObjectd>> bodies_, obstacles_;
  fcl::DynamicAABBTreeCollisionManagerd manager_;
  std::vector<std::pair<std::size_t, std::size_t>> pairs_;
};

}  // namespace

RobotLibraries fcl_robots() {
  RobotLibraries libraries;
  libraries.push_back(std::make_unique<FclRobots>());
  return libraries;
}

}  // namespace toccata::bench
