#include <embree3/rtcore.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "nearest.hpp"

namespace toccata::bench {
namespace {

struct Floats {
  float x, y, z;
};

Floats operator-(const Floats& a, const Floats& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
Floats operator+(const Floats& a, const Floats& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
Floats operator*(float s, const Floats& v) { return {s * v.x, s * v.y, s * v.z}; }
float dot(const Floats& a, const Floats& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

/// From the nearest point of the triangle a, b, c to the origin: C. Ericson, "Real-Time Collision Detection",
/// 2005, 5.1.5.
Floats nearest_to_origin(const Floats& a, const Floats& b, const Floats& c) {
  const Floats ab = b - a, ac = c - a;
  const float d1 = -dot(ab, a), d2 = -dot(ac, a);
  if (d1 <= 0 && d2 <= 0) return a;
  const float d3 = -dot(ab, b), d4 = -dot(ac, b);
  if (d3 >= 0 && d4 <= d3) return b;
  const float d5 = -dot(ab, c), d6 = -dot(ac, c);
  if (d6 >= 0 && d5 <= d6) return c;
  const float vc = d1 * d4 - d3 * d2;
  if (vc <= 0 && d1 >= 0 && d3 <= 0) return a + (d1 / (d1 - d3)) * ab;
  const float vb = d5 * d2 - d1 * d6;
  if (vb <= 0 && d2 >= 0 && d6 <= 0) return a + (d2 / (d2 - d6)) * ac;
  const float va = d3 * d6 - d5 * d4;
  if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0) return b + ((d4 - d3) / ((d4 - d3) + (d5 - d6))) * (c - b);
  const float whole = 1 / (va + vb + vc);
  return a + (vb * whole) * ab + (vc * whole) * ac;
}

/// rtcPointQuery as its users call it: the function that looks at a triangle is theirs. Vertices are floats.
class EmbreeNearest : public NearestLibrary {
 public:
  EmbreeNearest() : device_(rtcNewDevice("threads=1")) {}
  ~EmbreeNearest() override {
    if (scene_ != nullptr) rtcReleaseScene(scene_);
    rtcReleaseDevice(device_);
  }
  EmbreeNearest(const EmbreeNearest&) = delete;
  EmbreeNearest& operator=(const EmbreeNearest&) = delete;

  Description description() const override {
    return {"embree", "rtcPointQuery", RTC_VERSION_STRING, "as packaged; triangles in floats, -O3 -DNDEBUG"};
  }
  double tolerance() const override { return 2e-6; }

  void prepare(const TriangleMesh& mesh) override {
    scene_ = rtcNewScene(device_);
    rtcSetSceneBuildQuality(scene_, RTC_BUILD_QUALITY_HIGH);
    RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
    vertex_ = static_cast<const Floats*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                                                 sizeof(Floats), mesh.vertices().size()));
    auto* vertex = const_cast<Floats*>(vertex_);
    for (const Vec3& v : mesh.vertices())
      *vertex++ = {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
    corner_ = static_cast<const std::array<unsigned, 3>*>(rtcSetNewGeometryBuffer(
        geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(unsigned), mesh.triangle_count()));
    auto* corner = const_cast<std::array<unsigned, 3>*>(corner_);
    for (const auto& triangle : mesh.triangles()) *corner++ = {triangle[0], triangle[1], triangle[2]};
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene_, geometry);
    rtcReleaseGeometry(geometry);
    rtcCommitScene(scene_);
  }

  void answer(std::span<const Vec3> points, std::span<double> distances) override {
    for (std::size_t i = 0; i < points.size(); ++i) distances[i] = distance_to(points[i]);
  }

 private:
  [[nodiscard]] double distance_to(const Vec3& p) {
    RTCPointQueryContext context;
    rtcInitPointQueryContext(&context);
    RTCPointQuery query{};
    query.x = static_cast<float>(p.x);
    query.y = static_cast<float>(p.y);
    query.z = static_cast<float>(p.z);
    query.radius = std::numeric_limits<float>::infinity();
    rtcPointQuery(scene_, &query, &context, see, this);
    return static_cast<double>(query.radius);
  }

  static bool see(RTCPointQueryFunctionArguments* arguments) {
    const auto& self = *static_cast<const EmbreeNearest*>(arguments->userPtr);
    RTCPointQuery& query = *arguments->query;
    const Floats p{query.x, query.y, query.z};
    const auto& corner = self.corner_[arguments->primID];
    const Floats d =
        nearest_to_origin(self.vertex_[corner[0]] - p, self.vertex_[corner[1]] - p, self.vertex_[corner[2]] - p);
    const float distance = std::sqrt(dot(d, d));
    if (!(distance < query.radius)) return false;
    query.radius = distance;
    return true;
  }

  RTCDevice device_;
  RTCScene scene_ = nullptr;
  const Floats* vertex_ = nullptr;
  const std::array<unsigned, 3>* corner_ = nullptr;
};

}  // namespace

NearestLibraries embree_nearest_libraries() {
  NearestLibraries libraries;
  libraries.push_back(std::make_unique<EmbreeNearest>());
  return libraries;
}

}  // namespace toccata::bench
