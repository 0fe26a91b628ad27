#pragma once

#include <optional>
#include <span>
#include <vector>

#include "io/formats/json.hpp"
#include "reports/view/view_data.hpp"
#include "reports/view/view_meshes.hpp"

namespace toccata::io {

/// A point and a direction of length 1, in the world.
struct Arrow {
  Vec3 point;
  Vec3 direction;
};

/// Writes layers of a page (docs/reference/view-page.md) for points in the world. What is empty, or too far away for
/// the floats of a graphics card, is left out.
class LayerWriter {
 public:
  LayerWriter(const ViewMeshes& meshes, ViewData& data) : meshes_(meshes), data_(data) {}

  /// Layers from here on are of this finding; before the first one, of none.
  void begin(std::size_t finding) { finding_ = finding; }

  void add_points(const char* role, std::span<const Vec3> points) { add("points", role, shown(points)); }
  void add_segments(const char* role, std::span<const Vec3> ends) { add("segments", role, shown(ends)); }
  void add_triangles(const char* role, std::span<const Vec3> corners) { add("triangles", role, shown(corners)); }
  void add_arrows(const char* role, std::span<const Arrow> arrows);
  /// The box that has these two corners.
  void add_box(const char* role, const Vec3& lower, const Vec3& upper);
  /// Faces of a model, ascending.
  void add_faces(const char* role, Index object, std::span<const Index> faces);
  /// A segment with its length beside it, and its ends; with `lower` the length is the upper end of a bracket. A length
  /// beyond the largest double is written as null.
  void add_length(const char* role, const Vec3& from, const Vec3& to, double length, std::optional<double> lower = {});

  [[nodiscard]] Json take() { return std::move(layers_); }

 private:
  [[nodiscard]] std::vector<float> shown(std::span<const Vec3> points) const;
  /// Whether it was written.
  bool add(const char* kind, const char* role, const std::vector<float>& numbers);
  Json& push(const char* kind, const char* role, Json array);

  const ViewMeshes& meshes_;
  ViewData& data_;
  std::optional<std::size_t> finding_;
  Json layers_ = Json::array();
};

}  // namespace toccata::io
