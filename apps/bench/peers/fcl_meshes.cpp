#include <fcl/geometry/bvh/BVH_model.h>
#include <fcl/math/bv/OBB.h>
#include <fcl/math/bv/OBBRSS.h>
#include <fcl/math/bv/RSS.h>
#include <fcl/narrowphase/collision.h>
#include <fcl/narrowphase/distance.h>

#include <limits>
#include <type_traits>

#include "library.hpp"

namespace toccata::bench {
namespace {

template <class Volume>
using FclModel = fcl::BVHModel<Volume>;

template <class Volume>
std::unique_ptr<FclModel<Volume>> model_of(const TriangleMesh& mesh) {
  std::vector<fcl::Vector3d> vertices;
  std::vector<fcl::Triangle> triangles;
  for (const Vec3& v : mesh.vertices()) vertices.emplace_back(v.x, v.y, v.z);
  for (const auto& corner : mesh.triangles()) triangles.emplace_back(corner[0], corner[1], corner[2]);
  auto model = std::make_unique<FclModel<Volume>>();
  model->beginModel(static_cast<int>(triangles.size()), static_cast<int>(vertices.size()));
  model->addSubModel(vertices, triangles);
  model->endModel();
  return model;
}

fcl::Transform3d transform_of(const Pose& pose) {
  fcl::Transform3d transform = fcl::Transform3d::Identity();
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) transform.linear()(i, j) = pose.linear[i][j];
    transform.translation()[i] = pose.offset[i];
  }
  return transform;
}

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
    a_ = model_of<Volume>(a);
    b_ = model_of<Volume>(b);
  }

  std::size_t bytes() const override { return bytes_of(*a_) + bytes_of(*b_); }

  Answer answer(Task task, const PosePair& poses) const override {
    if (asks_distance(task)) return distance_answer(poses);
    const std::size_t wanted = task == Task::overlap ? 1 : std::numeric_limits<std::size_t>::max();
    const fcl::CollisionRequestd request(wanted, false);
    fcl::CollisionResultd result;
    fcl::collide(a_.get(), transform_of(poses.a), b_.get(), transform_of(poses.b), request, result);
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
    fcl::distance(a_.get(), transform_of(poses.a), b_.get(), transform_of(poses.b), request, result);
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
