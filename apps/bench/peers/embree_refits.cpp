#include <embree3/rtcore.h>
#include <fmt/format.h>

#include "refits.hpp"

namespace toccata::bench {
namespace {

/// A dynamic scene of one geometry of quality REFIT; the vertices lie in its buffer when the clock starts.
class EmbreeRefits : public RefitLibrary {
 public:
  explicit EmbreeRefits(int threads) : device_(rtcNewDevice(fmt::format("threads={}", threads).c_str())) {}
  ~EmbreeRefits() override {
    if (scene_ != nullptr) rtcReleaseScene(scene_);
    rtcReleaseDevice(device_);
  }
  EmbreeRefits(const EmbreeRefits&) = delete;
  EmbreeRefits& operator=(const EmbreeRefits&) = delete;

  Description description() const override { return {"embree", "refit of a scene", RTC_VERSION_STRING, "as packaged"}; }

  void build(const TriangleMesh& mesh) override {
    scene_ = rtcNewScene(device_);
    rtcSetSceneFlags(scene_, RTC_SCENE_FLAG_DYNAMIC | RTC_SCENE_FLAG_ROBUST);
    RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
    rtcSetGeometryBuildQuality(geometry, RTC_BUILD_QUALITY_REFIT);
    vertices_ = static_cast<float*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                                            3 * sizeof(float), mesh.vertices().size()));
    auto* index = static_cast<unsigned*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                                                 3 * sizeof(unsigned), mesh.triangle_count()));
    for (const auto& triangle : mesh.triangles())
      for (const Index corner : triangle) *index++ = corner;
    write(mesh);
    rtcCommitGeometry(geometry);
    geometry_number_ = rtcAttachGeometry(scene_, geometry);
    rtcReleaseGeometry(geometry);
    rtcCommitScene(scene_);
  }

  void give(const TriangleMesh& mesh) override { write(mesh); }

  void refit() override {
    RTCGeometry geometry = rtcGetGeometry(scene_, geometry_number_);
    rtcUpdateGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0);
    rtcCommitGeometry(geometry);
    rtcCommitScene(scene_);
  }

  ProbeAnswers answers(const Probes& probes) override {
    ProbeAnswers answers;
    for (const Segment& segment : probes.segments) answers.segments.push_back(is_met(segment));
    return answers;
  }

 private:
  void write(const TriangleMesh& mesh) {
    float* to = vertices_;
    for (const Vec3& v : mesh.vertices())
      for (int axis = 0; axis < 3; ++axis) *to++ = static_cast<float>(v[axis]);
  }

  [[nodiscard]] bool is_met(const Segment& segment) const {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    const Vec3 from = segment.start(), motion = segment.end() - from;
    RTCRay ray{};
    ray.org_x = static_cast<float>(from.x);
    ray.org_y = static_cast<float>(from.y);
    ray.org_z = static_cast<float>(from.z);
    ray.dir_x = static_cast<float>(motion.x);
    ray.dir_y = static_cast<float>(motion.y);
    ray.dir_z = static_cast<float>(motion.z);
    ray.tfar = 1;
    ray.mask = ~0U;
    rtcOccluded1(scene_, &context, &ray);
    return ray.tfar < 0;
  }

  RTCDevice device_;
  RTCScene scene_ = nullptr;
  unsigned geometry_number_ = 0;
  float* vertices_ = nullptr;
};

}  // namespace

RefitLibraries embree_refit_libraries(int threads) {
  RefitLibraries libraries;
  libraries.push_back(std::make_unique<EmbreeRefits>(threads));
  return libraries;
}

}  // namespace toccata::bench
