#include "reports/view/layer_writer.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace toccata::io {

std::vector<float> LayerWriter::shown(std::span<const Vec3> points) const {
  std::vector<float> numbers;
  numbers.reserve(3 * points.size());
  for (const Vec3& point : points) {
    const std::array<float, 3> place = meshes_.frame().shown(point);
    numbers.insert(numbers.end(), place.begin(), place.end());
  }
  return numbers;
}

Json& LayerWriter::push(const char* kind, const char* role, Json array) {
  Json layer = {{"kind", kind}, {"role", role}};
  if (finding_) layer["finding"] = *finding_;
  layer["data"] = std::move(array);
  layers_.push_back(std::move(layer));
  return layers_.back();
}

bool LayerWriter::add(const char* kind, const char* role, const std::vector<float>& numbers) {
  const bool is_near = std::all_of(numbers.begin(), numbers.end(), [](float number) { return std::isfinite(number); });
  if (numbers.empty() || !is_near) return false;
  push(kind, role, data_.add(numbers));
  return true;
}

void LayerWriter::add_arrows(const char* role, std::span<const Arrow> arrows) {
  std::vector<float> numbers;
  for (const Arrow& arrow : arrows) {
    const std::array<float, 3> place = meshes_.frame().shown(arrow.point);
    numbers.insert(numbers.end(), place.begin(), place.end());
    for (int axis = 0; axis < 3; ++axis) numbers.push_back(static_cast<float>(arrow.direction[axis]));
  }
  add("arrows", role, numbers);
}

void LayerWriter::add_box(const char* role, const Vec3& lower, const Vec3& upper) {
  add("boxes", role, shown(std::array{lower, upper}));
}

void LayerWriter::add_faces(const char* role, Index object, std::span<const Index> faces) {
  const std::vector<Index> triangles = meshes_.triangles_of(object, faces);
  if (!triangles.empty()) push("faces", role, data_.add(std::span<const std::uint32_t>(triangles)))["object"] = object;
}

void LayerWriter::add_length(const char* role, const Vec3& from, const Vec3& to, double length,
                             std::optional<double> lower) {
  const std::vector<float> ends = shown(std::array{from, to});
  if (!add("segments", role, ends)) return;
  layers_.back()["length"] = length;
  if (lower) layers_.back()["lower_length"] = *lower;
  add("points", role, ends);
}

}  // namespace toccata::io
