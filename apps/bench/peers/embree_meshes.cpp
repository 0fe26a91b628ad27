#include <embree3/rtcore.h>

#include <atomic>
#include <cmath>
#include <optional>

#include "library.hpp"
#include "toccata/bounds/aabb.hpp"
#include "toccata/narrow/triangle_triangle.hpp"

namespace toccata::bench {
namespace {

/// On one thread, which Embree can only set for the whole process. Counts what is allocated.
class Device {
 public:
  Device() : device_(rtcNewDevice("threads=1")) { rtcSetDeviceMemoryMonitorFunction(device_, count, this); }
  ~Device() { rtcReleaseDevice(device_); }
  Device(const Device&) = delete;
  Device& operator=(const Device&) = delete;

  RTCDevice get() const { return device_; }
  std::size_t bytes() const { return static_cast<std::size_t>(bytes_.load()); }

 private:
  static bool count(void* device, ssize_t bytes, bool) {
    static_cast<Device*>(device)->bytes_ += bytes;
    return true;
  }

  RTCDevice device_;
  std::atomic<ssize_t> bytes_ = 0;
};

float rounded_down(double x) {
  const float near = static_cast<float>(x);
  return near <= x ? near : std::nextafter(near, -INFINITY);
}

float rounded_up(double x) { return -rounded_down(-x); }

/// A scene of one user geometry: a box for each triangle of a mesh, which may be moved.
class BoxScene {
 public:
  BoxScene(const Device& device, const TriangleMesh& mesh, RTCBuildQuality moved_by) : mesh_(mesh) {
    scene_ = rtcNewScene(device.get());
    geometry_ = rtcNewGeometry(device.get(), RTC_GEOMETRY_TYPE_USER);
    rtcSetSceneFlags(scene_, moved_by == RTC_BUILD_QUALITY_REFIT ? RTC_SCENE_FLAG_DYNAMIC : RTC_SCENE_FLAG_NONE);
    rtcSetSceneBuildQuality(scene_, moved_by == RTC_BUILD_QUALITY_REFIT ? RTC_BUILD_QUALITY_LOW : moved_by);
    rtcSetGeometryBuildQuality(geometry_, moved_by);
    rtcSetGeometryUserPrimitiveCount(geometry_, mesh.triangle_count());
    rtcSetGeometryUserData(geometry_, this);
    rtcSetGeometryBoundsFunction(geometry_, give_box, nullptr);
    rtcAttachGeometry(scene_, geometry_);
    move({});
  }
  ~BoxScene() {
    rtcReleaseGeometry(geometry_);
    rtcReleaseScene(scene_);
  }
  BoxScene(const BoxScene&) = delete;
  BoxScene& operator=(const BoxScene&) = delete;

  void move(const Pose& pose) {
    vertices_.clear();
    for (const Vec3& vertex : mesh_.vertices()) vertices_.push_back(transform(pose, vertex));
    rtcCommitGeometry(geometry_);
    rtcCommitScene(scene_);
  }

  RTCScene get() const { return scene_; }

  Triangle triangle(Index number) const {
    const auto& corner = mesh_.triangles()[number];
    return {{vertices_[corner[0]], vertices_[corner[1]], vertices_[corner[2]]}};
  }

 private:
  static void give_box(const RTCBoundsFunctionArguments* wanted) {
    const auto* scene = static_cast<const BoxScene*>(wanted->geometryUserPtr);
    const Aabb box = fit_aabb(scene->triangle(wanted->primID).vertex);
    *wanted->bounds_o = {rounded_down(box.lower.x), rounded_down(box.lower.y), rounded_down(box.lower.z), 0,
                         rounded_up(box.upper.x),   rounded_up(box.upper.y),   rounded_up(box.upper.z),   0};
  }

  const TriangleMesh& mesh_;
  std::vector<Vec3> vertices_;
  RTCScene scene_;
  RTCGeometry geometry_;
};

struct Search {
  const BoxScene& a;
  const BoxScene& b;
  Task task;
  Answer answer;
};

void visit(void* pointer, RTCCollision* candidates, unsigned count) {
  Search& search = *static_cast<Search*>(pointer);
  for (unsigned i = 0; i < count; ++i) {
    // Embree cannot be told to stop.
    if (search.task == Task::overlap && search.answer.overlap) return;
    const Index a = candidates[i].primID0, b = candidates[i].primID1;
    if (!overlap(search.a.triangle(a), search.b.triangle(b))) continue;
    search.answer.overlap = true;
    if (search.task == Task::contacts) search.answer.pairs.emplace_back(a, b);
  }
}

/// The pose of B in A's frame, for rigid poses.
Pose relative(const PosePair& poses) {
  Pose b_in_a;
  const Vec3 offset = poses.b.offset - poses.a.offset;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) b_in_a.linear[i][j] = dot(poses.a.linear.column(i), poses.b.linear.column(j));
    b_in_a.offset[i] = dot(poses.a.linear.column(i), offset);
  }
  return b_in_a;
}

/// rtcCollide takes no poses, so the boxes of B are made anew in A's frame for each query, which is part of its time,
/// and their tree is built again or fitted again. Embree tests no triangles: Toccata's exact test does, in A's frame.
class EmbreeMeshes : public MeshLibrary {
 public:
  EmbreeMeshes(std::string variant, RTCBuildQuality moved_by) : variant_(std::move(variant)), moved_by_(moved_by) {}

  Description description() const override {
    return {"embree", variant_, RTC_VERSION_STRING, "as packaged; triangles by Toccata's test, -O3 -DNDEBUG"};
  }

  void build(const TriangleMesh& a, const TriangleMesh& b) override {
    b_.reset();
    a_.reset();
    device_.emplace();
    a_.emplace(*device_, a, RTC_BUILD_QUALITY_MEDIUM);
    b_.emplace(*device_, b, moved_by_);
  }

  std::size_t bytes() const override { return device_->bytes(); }

  std::string obstacle(Task task, int threads) const override {
    if (task == Task::distance) return "tells no distance of two meshes";
    return threads > 1 ? "B's tree is moved for each query, and Embree's threads are the whole process's" : "";
  }

  Answer answer(Task task, const PosePair& poses) const override {
    b_->move(relative(poses));
    Search search{*a_, *b_, task, {}};
    rtcCollide(a_->get(), b_->get(), visit, &search);
    return std::move(search.answer);
  }

 private:
  std::string variant_;
  RTCBuildQuality moved_by_;
  std::optional<Device> device_;
  std::optional<BoxScene> a_;
  mutable std::optional<BoxScene> b_;
};

}  // namespace

MeshLibraries embree_mesh_libraries() {
  MeshLibraries libraries;
  libraries.push_back(std::make_unique<EmbreeMeshes>("rtcCollide, B built per query", RTC_BUILD_QUALITY_LOW));
  libraries.push_back(std::make_unique<EmbreeMeshes>("rtcCollide, B fitted per query", RTC_BUILD_QUALITY_REFIT));
  return libraries;
}

}  // namespace toccata::bench
