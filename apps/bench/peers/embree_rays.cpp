#include <embree3/rtcore.h>

#include "rays.hpp"

namespace toccata::bench {
namespace {

/// rtcIntersect1: one ray at a time, as Toccata is asked, over the best tree that Embree builds. Vertices are floats.
class EmbreeRays : public RayLibrary {
 public:
  EmbreeRays(std::string variant, RTCSceneFlags flags)
      : variant_(std::move(variant)), flags_(flags), device_(rtcNewDevice("threads=1")) {}
  ~EmbreeRays() override {
    if (scene_ != nullptr) rtcReleaseScene(scene_);
    rtcReleaseDevice(device_);
  }
  EmbreeRays(const EmbreeRays&) = delete;
  EmbreeRays& operator=(const EmbreeRays&) = delete;

  Description description() const override { return {"embree", variant_, RTC_VERSION_STRING, "as packaged"}; }

  void prepare(const TriangleMesh& mesh, std::span<const RayQuestion> questions) override {
    questions_ = questions;
    scene_ = rtcNewScene(device_);
    rtcSetSceneBuildQuality(scene_, RTC_BUILD_QUALITY_HIGH);
    rtcSetSceneFlags(scene_, flags_);
    RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
    auto* vertex = static_cast<float*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                                               3 * sizeof(float), mesh.vertices().size()));
    for (const Vec3& v : mesh.vertices())
      for (int axis = 0; axis < 3; ++axis) *vertex++ = static_cast<float>(v[axis]);
    auto* index = static_cast<unsigned*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                                                 3 * sizeof(unsigned), mesh.triangle_count()));
    for (const auto& triangle : mesh.triangles())
      for (const Index corner : triangle) *index++ = corner;
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene_, geometry);
    rtcReleaseGeometry(geometry);
    rtcCommitScene(scene_);
  }

  void answer(std::size_t first, std::span<RayAnswer> answers) override {
    for (std::size_t i = 0; i < answers.size(); ++i) answers[i] = answer_to(questions_[first + i]);
  }

 private:
  [[nodiscard]] RayAnswer answer_to(const RayQuestion& q) const {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    RTCRayHit ray{};
    ray.ray.org_x = static_cast<float>(q.origin.x);
    ray.ray.org_y = static_cast<float>(q.origin.y);
    ray.ray.org_z = static_cast<float>(q.origin.z);
    ray.ray.dir_x = static_cast<float>(q.motion.x);
    ray.ray.dir_y = static_cast<float>(q.motion.y);
    ray.ray.dir_z = static_cast<float>(q.motion.z);
    ray.ray.tfar = 1;
    ray.ray.mask = ~0U;
    ray.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    rtcIntersect1(scene_, &context, &ray);
    return {ray.hit.geomID != RTC_INVALID_GEOMETRY_ID, static_cast<double>(ray.ray.tfar)};
  }

  std::string variant_;
  RTCSceneFlags flags_;
  RTCDevice device_;
  RTCScene scene_ = nullptr;
  std::span<const RayQuestion> questions_;
};

}  // namespace

RayLibraries embree_ray_libraries() {
  RayLibraries libraries;
  libraries.push_back(std::make_unique<EmbreeRays>("rtcIntersect1", RTC_SCENE_FLAG_NONE));
  libraries.push_back(std::make_unique<EmbreeRays>("rtcIntersect1, robust", RTC_SCENE_FLAG_ROBUST));
  return libraries;
}

}  // namespace toccata::bench
