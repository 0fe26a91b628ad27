#include <fcl/geometry/bvh/BVH_model.h>
#include <fcl/geometry/shape/sphere.h>
#include <fcl/math/bv/OBBRSS.h>
#include <fcl/narrowphase/collision.h>

#include <type_traits>

#include "refits.hpp"

namespace toccata::bench {
namespace {

/// updateSubModel and endUpdateModel(refit, bottom up), which copies the vertices.
template <class Volume>
class FclRefits : public RefitLibrary {
 public:
  Description description() const override {
    return {"fcl", std::is_same_v<Volume, fcl::AABBd> ? "refit, AABB" : "refit, OBBRSS", TOCCATA_BENCH_FCL_VERSION,
            "as packaged"};
  }

  void build(const TriangleMesh& mesh) override {
    give(mesh);
    std::vector<fcl::Triangle> triangles;
    for (const auto& corner : mesh.triangles()) triangles.emplace_back(corner[0], corner[1], corner[2]);
    model_ = std::make_shared<fcl::BVHModel<Volume>>();
    model_->beginModel(static_cast<int>(triangles.size()), static_cast<int>(vertices_.size()));
    model_->addSubModel(vertices_, triangles);
    model_->endModel();
  }

  void give(const TriangleMesh& mesh) override {
    vertices_.clear();
    for (const Vec3& v : mesh.vertices()) vertices_.emplace_back(v.x, v.y, v.z);
  }

  void refit() override {
    model_->beginUpdateModel();
    model_->updateSubModel(vertices_);
    model_->endUpdateModel(true, true);
  }

  ProbeAnswers answers(const Probes& probes) override {
    const fcl::Transform3d still = fcl::Transform3d::Identity();
    ProbeAnswers answers;
    for (const auto& [centre, radius] : probes.balls) {
      fcl::Transform3d place = fcl::Transform3d::Identity();
      place.translation() = fcl::Vector3d(centre.x, centre.y, centre.z);
      const fcl::Sphered ball(radius);
      fcl::CollisionResultd result;
      fcl::collide(model_.get(), still, &ball, place, fcl::CollisionRequestd(), result);
      answers.balls.push_back(result.isCollision());
    }
    return answers;
  }

 private:
  std::vector<fcl::Vector3d> vertices_;
  std::shared_ptr<fcl::BVHModel<Volume>> model_;
};

}  // namespace

RefitLibraries fcl_refit_libraries() {
  RefitLibraries libraries;
  libraries.push_back(std::make_unique<FclRefits<fcl::AABBd>>());
  libraries.push_back(std::make_unique<FclRefits<fcl::OBBRSSd>>());
  return libraries;
}

}  // namespace toccata::bench
