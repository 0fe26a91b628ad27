#include <fcl/math/bv/OBB.h>
#include <fcl/math/bv/OBBRSS.h>
#include <fcl/math/bv/RSS.h>
#include <fcl/narrowphase/collision.h>
#include <fcl/narrowphase/distance.h>

#include <limits>
#include <type_traits>

#include "library.hpp"
#include "peers/fcl_models.hpp"
#include "peers/fcl_shapes.hpp"

namespace toccata::bench {
namespace {

template <class Volume>
using FclModel = fcl::BVHModel<Volume>;

template <class Volume>
std::size_t bytes_of(const FclModel<Volume>& model) {
  return static_cast<std::size_t>(model.getNumBVs()) * sizeof(fcl::BVNode<Volume>) +
         static_cast<std::size_t>(model.num_tris) * sizeof(unsigned int);
}

template <class Volume>
class FclMeshes : public MeshLibrary {
 public:
  Description description() const override {
    const char* const volume = is_plain ? "OBB" : is_swept ? "RSS" : "OBBRSS";
    return {"fcl", volume, TOCCATA_BENCH_FCL_VERSION, "as packaged"};
  }

  std::string obstacle(Task task, int) const override {
    if (asks_distance(task) && is_plain) return "has no distance";
    return !asks_distance(task) && is_swept ? "copies both models for every question" : "";
  }

  void build(const TriangleMesh& a, const TriangleMesh& b) override {
    a_ = fcl_model_of<Volume>(a);
    b_ = fcl_model_of<Volume>(b);
  }

  std::size_t bytes() const override { return bytes_of(*a_) + bytes_of(*b_); }

  Answer answer(Task task, const PosePair& poses) const override {
    if (asks_distance(task)) return distance_answer(poses);
    const std::size_t wanted = task == Task::overlap ? 1 : std::numeric_limits<std::size_t>::max();
    const fcl::CollisionRequestd request(wanted, false);
    fcl::CollisionResultd result;
    fcl::collide(a_.get(), converted(poses.a), b_.get(), converted(poses.b), request, result);
    Answer answer{result.isCollision(), {}};
    if (task == Task::overlap) return answer;
    for (std::size_t i = 0; i < result.numContacts(); ++i)
      answer.pairs.emplace_back(result.getContact(i).b1, result.getContact(i).b2);
    return answer;
  }

 private:
  static constexpr bool is_plain = std::is_same_v<Volume, fcl::OBBd>;
  static constexpr bool is_swept = std::is_same_v<Volume, fcl::RSSd>;

  Answer distance_answer(const PosePair& poses) const {
    const fcl::DistanceRequestd request(false);
    fcl::DistanceResultd result;
    fcl::distance(a_.get(), converted(poses.a), b_.get(), converted(poses.b), request, result);
    const auto number = [](auto index) { return static_cast<Index>(index); };
    return {result.min_distance <= 0, {{number(result.b1), number(result.b2)}}, result.min_distance};
  }

  std::unique_ptr<FclModel<Volume>> a_;
  std::unique_ptr<FclModel<Volume>> b_;
};

}  // namespace

MeshLibraries fcl_mesh_libraries() {
  MeshLibraries libraries;
  libraries.push_back(std::make_unique<FclMeshes<fcl::OBBd>>());
  libraries.push_back(std::make_unique<FclMeshes<fcl::OBBRSSd>>());
  libraries.push_back(std::make_unique<FclMeshes<fcl::RSSd>>());
  return libraries;
}

}  // namespace toccata::bench
