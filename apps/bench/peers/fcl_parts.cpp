#include <fcl/broadphase/broadphase_dynamic_AABB_tree.h>
#include <fcl/math/bv/OBBRSS.h>
#include <fcl/narrowphase/collision.h>

#include <algorithm>
#include <map>

#include "parts.hpp"
#include "peers/fcl_models.hpp"
#include "peers/fcl_shapes.hpp"

namespace toccata::bench {
namespace {

bool note_intersection(fcl::CollisionObjectd* one, fcl::CollisionObjectd* other, void* pairs) {
  fcl::CollisionResultd result;
  if (fcl::collide(one, other, fcl::CollisionRequestd(), result) == 0) return false;
  const auto number_of = [](const fcl::CollisionObjectd* object) {
    return *static_cast<Index*>(object->getUserData());
  };
  const Index a = number_of(one), b = number_of(other);
  static_cast<std::vector<IndexPair>*>(pairs)->push_back({std::min(a, b), std::max(a, b)});
  return false;
}

class FclParts final : public PartsLibrary {
 public:
  Description description() const override {
    return {"fcl", "OBBRSS, DynamicAABBTree", TOCCATA_BENCH_FCL_VERSION, "-O3 -DNDEBUG, library as packaged"};
  }
  void build(std::span<const SceneInstance> parts) override {
    parts_ = parts;
    for (const SceneInstance& part : parts) {
      std::shared_ptr<fcl::CollisionGeometryd>& model = models_[&part.model.mesh()];
      if (!model) model = fcl_model_of<fcl::OBBRSSd>(part.model.mesh());
    }
  }
  std::vector<IndexPair> pairs() override {
    std::vector<fcl::CollisionObjectd> objects;
    std::vector<Index> numbers(parts_.size());
    objects.reserve(parts_.size());
    std::vector<fcl::CollisionObjectd*> all;
    for (Index number = 0; number < parts_.size(); ++number) {
      numbers[number] = number;
      objects.emplace_back(models_.at(&parts_[number].model.mesh()), converted(parts_[number].pose));
      objects.back().setUserData(&numbers[number]);
      all.push_back(&objects.back());
    }
    fcl::DynamicAABBTreeCollisionManagerd manager;
    manager.registerObjects(all);
    manager.setup();
    std::vector<IndexPair> found;
    manager.collide(&found, note_intersection);
    return found;
  }

 private:
  std::span<const SceneInstance> parts_;
  std::map<const TriangleMesh*, std::shared_ptr<fcl::CollisionGeometryd>> models_;
};

}  // namespace

PartsLibraries fcl_parts() {
  PartsLibraries libraries;
  libraries.push_back(std::make_unique<FclParts>());
  return libraries;
}

}  // namespace toccata::bench
