#include <BulletCollision/CollisionShapes/btTriangleIndexVertexArray.h>
#include <BulletCollision/Gimpact/btGImpactShape.h>

#include <optional>

#include "library.hpp"

namespace toccata::bench {
namespace {

/// A view of the mesh's own vertices and indices.
btIndexedMesh view_of(const TriangleMesh& mesh) {
  const auto vertices = mesh.vertices();
  const auto triangles = mesh.triangles();
  btIndexedMesh view;
  view.m_numTriangles = static_cast<int>(triangles.size());
  view.m_triangleIndexBase = reinterpret_cast<const unsigned char*>(triangles.data());
  view.m_triangleIndexStride = sizeof triangles[0];
  view.m_numVertices = static_cast<int>(vertices.size());
  view.m_vertexBase = reinterpret_cast<const unsigned char*>(vertices.data());
  view.m_vertexStride = sizeof(Vec3);
  view.m_indexType = PHY_INTEGER;
  view.m_vertexType = PHY_DOUBLE;
  return view;
}

btTransform transform_of(const Pose& pose) {
  const Mat3& m = pose.linear;
  const btMatrix3x3 linear(m[0].x, m[0].y, m[0].z, m[1].x, m[1].y, m[1].z, m[2].x, m[2].y, m[2].z);
  return btTransform(linear, btVector3(pose.offset.x, pose.offset.y, pose.offset.z));
}

class BulletMesh {
 public:
  explicit BulletMesh(const TriangleMesh& mesh) {
    view_.addIndexedMesh(view_of(mesh));
    shape_.emplace(&view_);
    shape_->setMargin(0);
    shape_->updateBound();
    part().lockChildShapes();  // for good: nothing changes the vertices, and threads may then share them
  }
  ~BulletMesh() { part().unlockChildShapes(); }
  BulletMesh(const BulletMesh&) = delete;
  BulletMesh& operator=(const BulletMesh&) = delete;

  const btGImpactQuantizedBvh& tree() const { return *part().getBoxSet(); }

  btPrimitiveTriangle triangle(int number, const btTransform& pose) const {
    btPrimitiveTriangle triangle;
    part().getPrimitiveTriangle(number, triangle);
    triangle.applyTransform(pose);
    triangle.buildTriPlane();
    return triangle;
  }

  std::size_t bytes() const { return static_cast<std::size_t>(tree().getNodeCount()) * sizeof(BT_QUANTIZED_BVH_NODE); }

 private:
  const btGImpactMeshShapePart& part() const { return *shape_->getMeshPart(0); }

  btTriangleIndexVertexArray view_;
  std::optional<btGImpactMeshShape> shape_;
};

/// As btGImpactCollisionAlgorithm does it: all pairs of boxes, then their triangles. Without the rest of that class,
/// which makes manifolds of the contact points and cannot stop at the first.
class BulletMeshes : public MeshLibrary {
 public:
  Description description() const override {
    return {"bullet", "GImpact of doubles, quantised AABB tree", TOCCATA_BENCH_BULLET_VERSION, "as packaged"};
  }

  void build(const TriangleMesh& a, const TriangleMesh& b) override {
    a_.emplace(a);
    b_.emplace(b);
  }

  std::size_t bytes() const override { return a_->bytes() + b_->bytes(); }

  std::string obstacle(Task task, int) const override {
    return task == Task::distance ? "tells contacts, and no distance" : "";
  }

  Answer answer(Task task, const PosePair& poses) const override {
    const btTransform pose_a = transform_of(poses.a), pose_b = transform_of(poses.b);
    btPairSet near;
    btGImpactQuantizedBvh::find_collision(&a_->tree(), pose_a, &b_->tree(), pose_b, near);
    Answer answer;
    for (int i = 0; i < near.size() && !(task == Task::overlap && answer.overlap); ++i) {
      btPrimitiveTriangle a = a_->triangle(near[i].m_index1, pose_a), b = b_->triangle(near[i].m_index2, pose_b);
      GIM_TRIANGLE_CONTACT contact;
      if (!a.overlap_test_conservative(b) || !a.find_triangle_collision_clip_method(b, contact)) continue;
      answer.overlap = true;
      if (task == Task::contacts)
        answer.pairs.emplace_back(static_cast<Index>(near[i].m_index1), static_cast<Index>(near[i].m_index2));
    }
    return answer;
  }

 private:
  std::optional<BulletMesh> a_;
  std::optional<BulletMesh> b_;
};

}  // namespace

MeshLibraries bullet_mesh_libraries() {
  MeshLibraries libraries;
  libraries.push_back(std::make_unique<BulletMeshes>());
  return libraries;
}

}  // namespace toccata::bench
