#include <malloc.h>

#include <cstring>
#include <optional>

#include "library.hpp"
#include "peers/ode_shapes.hpp"

namespace toccata::bench {
namespace {

std::size_t heap_in_use() {
  const auto heap = mallinfo2();
  return heap.uordblks + heap.hblkhd;
}

/// A geometry over the mesh's own vertices and indices.
class OdeMesh {
 public:
  explicit OdeMesh(const TriangleMesh& mesh) {
    const std::size_t before = heap_in_use();
    const auto vertices = mesh.vertices();
    const auto triangles = mesh.triangles();
    data_ = dGeomTriMeshDataCreate();
    dGeomTriMeshDataBuildDouble(data_, vertices.data(), sizeof(Vec3), static_cast<int>(vertices.size()),
                                triangles.data(), static_cast<int>(3 * triangles.size()), sizeof triangles[0]);
    geometry_ = dCreateTriMesh(nullptr, data_, nullptr, nullptr, nullptr);
    bytes_ = heap_in_use() - before;
  }
  ~OdeMesh() {
    dGeomDestroy(geometry_);
    dGeomTriMeshDataDestroy(data_);
  }
  OdeMesh(const OdeMesh&) = delete;
  OdeMesh& operator=(const OdeMesh&) = delete;

  dGeomID posed(const Pose& pose) const {
    const Mat3& m = pose.linear;
    const dMatrix3 rotation{m[0].x, m[0].y, m[0].z, 0, m[1].x, m[1].y, m[1].z, 0, m[2].x, m[2].y, m[2].z, 0};
    dGeomSetPosition(geometry_, pose.offset.x, pose.offset.y, pose.offset.z);
    dGeomSetRotation(geometry_, rotation);
    return geometry_;
  }
  std::size_t bytes() const { return bytes_; }

 private:
  dTriMeshDataID data_;
  dGeomID geometry_;
  std::size_t bytes_ = 0;
};

class OdeMeshes : public MeshLibrary {
 public:
  Description description() const override {
    const bool opcode = std::strstr(dGetConfiguration(), "ODE_EXT_opcode") != nullptr;
    return {"ode", opcode ? "trimesh, OPCODE's AABB tree" : "trimesh, GIMPACT's AABB tree", TOCCATA_BENCH_ODE_VERSION,
            "as packaged"};
  }

  void build(const TriangleMesh& a, const TriangleMesh& b) override {
    a_.emplace(a);
    b_.emplace(b);
  }

  std::size_t bytes() const override { return a_->bytes() + b_->bytes(); }

  std::string obstacle(Task task, int threads) const override {
    if (task == Task::distance) return "tells contacts, and no distance";
    if (task == Task::contacts) return "dCollide gives contact points, merged, and not which triangles meet";
    return threads > 1 ? "a pose is kept in the geometry, so one query at a time" : "";
  }

  Answer answer(Task, const PosePair& poses) const override {
    dContactGeom contact;
    const unsigned flags = CONTACTS_UNIMPORTANT | 1;
    const int found =
        dCollide(a_->posed(poses.a), b_->posed(poses.b), static_cast<int>(flags), &contact, sizeof contact);
    return {found > 0, {}};
  }

 private:
  OdeEngine engine_;
  std::optional<OdeMesh> a_;
  std::optional<OdeMesh> b_;
};

}  // namespace

MeshLibraries ode_mesh_libraries() {
  MeshLibraries libraries;
  libraries.push_back(std::make_unique<OdeMeshes>());
  return libraries;
}

}  // namespace toccata::bench
