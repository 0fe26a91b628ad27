#include "io/view/view_layers.hpp"

#include <vector>

#include "io/view/contact_geometry.hpp"

namespace toccata::io {
namespace {

using Json = nlohmann::ordered_json;

class PairLayers {
 public:
  PairLayers(std::size_t pair, const ViewMeshes& meshes, ViewData& data, Json& layers)
      : pair_(pair), meshes_(meshes), data_(data), layers_(layers) {}

  void add(const ReportedPair& pair) {
    add_faces(pair.a, meeting_faces(pair, &ReportedFacePair::face_a));
    add_faces(pair.b, meeting_faces(pair, &ReportedFacePair::face_b));
    add_meetings(pair);
    if (pair.penetration && pair.penetration->upper > 0)
      add_length("depth", pair.penetration->on_a, pair.penetration->on_b, pair.penetration->upper);
    if (pair.distance && pair.distance->upper > 0)
      add_length("distance", pair.distance->on_a, pair.distance->on_b, pair.distance->upper);
    add_normals(pair);
  }

 private:
  void append(std::vector<float>& numbers, const Vec3& world) const {
    const std::array<float, 3> shown = meshes_.frame().shown(world);
    numbers.insert(numbers.end(), shown.begin(), shown.end());
  }

  Json& add_layer(const char* kind, const char* role, Json array) {
    layers_.push_back({{"kind", kind}, {"role", role}, {"pair", pair_}, {"data", std::move(array)}});
    return layers_.back();
  }

  void add_numbers(const char* kind, const char* role, const std::vector<float>& numbers) {
    if (!numbers.empty()) add_layer(kind, role, data_.add(numbers));
  }

  void add_faces(Index object, const std::vector<Index>& faces) {
    const std::vector<Index> triangles = meshes_.triangles_of(object, faces);
    if (!triangles.empty())
      add_layer("faces", "contact", data_.add(std::span<const std::uint32_t>(triangles)))["object"] = object;
  }

  void add_meetings(const ReportedPair& pair) {
    const ContactGeometry found = contact_geometry(pair);
    add_numbers("triangles", "contact", shown(found.triangles));
    add_numbers("segments", "contact", shown(found.segments));
    add_numbers("points", "contact", shown(found.points));
  }

  [[nodiscard]] std::vector<float> shown(const std::vector<Vec3>& points) const {
    std::vector<float> numbers;
    numbers.reserve(3 * points.size());
    for (const Vec3& point : points) append(numbers, point);
    return numbers;
  }

  /// A length beyond the largest double is written as null.
  void add_length(const char* role, const Vec3& from, const Vec3& to, double length) {
    if (!is_finite(from) || !is_finite(to)) return;
    std::vector<float> ends;
    append(ends, from);
    append(ends, to);
    add_layer("segments", role, data_.add(ends))["length"] = length;
    add_numbers("points", role, ends);
  }

  void add_normals(const ReportedPair& pair) {
    std::vector<float> arrows;
    const auto add_arrow = [&](const Vec3& point, const Vec3& normal) {
      if (normal == Vec3{}) return;
      append(arrows, point);
      for (int axis = 0; axis < 3; ++axis) arrows.push_back(static_cast<float>(normal[axis]));
    };
    for (const ContactRegion& region : pair.regions) add_arrow(region.deepest, region.normal);
    for (int i = 0; pair.manifold && i < pair.manifold->count; ++i)
      add_arrow(pair.manifold->points[static_cast<std::size_t>(i)].position, pair.manifold->normal);
    add_numbers("arrows", "normal", arrows);
  }

  std::size_t pair_;
  const ViewMeshes& meshes_;
  ViewData& data_;
  Json& layers_;
};

}  // namespace

Json pair_layers(const CheckReport& report, const ViewMeshes& meshes, ViewData& data) {
  Json layers = Json::array();
  for (std::size_t i = 0; i < report.pairs.size(); ++i) PairLayers(i, meshes, data, layers).add(report.pairs[i]);
  return layers;
}

}  // namespace toccata::io
