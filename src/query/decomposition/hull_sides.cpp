#include "query/decomposition/hull_sides.hpp"

#include <algorithm>

#include "toccata/math/predicates.hpp"

namespace toccata {

bool HullSides::Face::is_in_front(const Vec3& point) const {
  const Filtered product = filtered_triple_product(normal, point - corners[0]);
  if (product.is_positive()) return true;
  if (product.is_negative()) return false;
  return orient3d(corners[0], corners[1], corners[2], point) == Sign::positive;
}

HullSides::HullSides(const ConvexHull& hull) {
  const HullTopology topology = hull.topology();
  for (Index f = 0; f < topology.face_count(); ++f) {
    const auto corner = [&](Index i) { return hull.vertex(topology.origin[topology.face_start[f] + i]); };
    faces_.push_back({{corner(0), corner(1), corner(2)}, filtered_cross(corner(1) - corner(0), corner(2) - corner(0))});
    lists_.push_back(f);
  }
  all_ = {0, lists_.size()};
}

std::optional<FaceRange> HullSides::cutting(FaceRange faces, std::span<const Vec3> corners) {
  const std::size_t first = lists_.size();
  for (std::size_t i = faces.first; i < faces.first + faces.count; ++i) {
    const Face& face = faces_[lists_[i]];
    const auto in_front =
        static_cast<std::size_t>(std::ranges::count_if(corners, [&](const Vec3& c) { return face.is_in_front(c); }));
    if (in_front == corners.size()) {
      lists_.resize(first);
      return {};
    }
    if (in_front > 0) lists_.push_back(lists_[i]);
  }
  return FaceRange{first, lists_.size() - first};
}

bool HullSides::is_behind(FaceRange faces, const Vec3& point) const {
  const std::span<const Index> list = std::span(lists_).subspan(faces.first, faces.count);
  return std::ranges::none_of(list, [&](Index f) { return faces_[f].is_in_front(point); });
}

}  // namespace toccata
