#include <algorithm>

#include "shapes/hull_faces.hpp"
#include "toccata/math/predicates.hpp"

namespace toccata {
namespace {

struct FlatPoint {
  Vec2 place;
  Index number = 0;
};

/// In ascending order, of equal places the first number alone.
std::vector<FlatPoint> sorted_places(std::span<const Vec3> points, int dropped_axis) {
  std::vector<FlatPoint> result;
  result.reserve(points.size());
  for (Index i = 0; i < points.size(); ++i) result.push_back({drop_axis(points[i], dropped_axis), i});
  std::ranges::sort(result, [](const FlatPoint& p, const FlatPoint& q) {
    if (p.place.x != q.place.x) return p.place.x < q.place.x;
    return p.place.y != q.place.y ? p.place.y < q.place.y : p.number < q.number;
  });
  const auto same = [](const FlatPoint& p, const FlatPoint& q) { return p.place == q.place; };
  result.erase(std::unique(result.begin(), result.end(), same), result.end());
  return result;
}

/// The lower side of the hull for ascending places, the upper for descending ones, without its last point.
template <class Places>
void append_side(const Places& places, std::vector<Index>& cycle) {
  std::vector<FlatPoint> side;
  for (const FlatPoint& p : places) {
    while (side.size() > 1 && orient2d(side[side.size() - 2].place, side.back().place, p.place) != Sign::positive)
      side.pop_back();
    side.push_back(p);
  }
  for (std::size_t i = 0; i + 1 < side.size(); ++i) cycle.push_back(side[i].number);
}

}  // namespace

// Dropping an axis along which the plane is not vertical is an affine bijection: it keeps what is extreme.
HullFaces flat_hull_faces(std::span<const Vec3> points, const std::array<Index, 3>& triangle) {
  const auto vertical = [&](int axis) {
    return orient2d(drop_axis(points[triangle[0]], axis), drop_axis(points[triangle[1]], axis),
                    drop_axis(points[triangle[2]], axis)) == Sign::zero;
  };
  const int axis = !vertical(0) ? 0 : !vertical(1) ? 1 : 2;
  const std::vector<FlatPoint> places = sorted_places(points, axis);
  HullFaces faces{2, {}, {0}};
  append_side(places, faces.corners);
  append_side(std::vector<FlatPoint>(places.rbegin(), places.rend()), faces.corners);
  faces.close_face();
  const std::size_t count = faces.corners.size();
  for (std::size_t i = count; i-- > 0;) faces.corners.push_back(faces.corners[i]);
  faces.close_face();
  return faces;
}

}  // namespace toccata
