#include "oracle/hull_boundary.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace toccata::oracle {
namespace {

using Points = std::vector<RationalPoint>;
using Edge = std::pair<RationalPoint, RationalPoint>;

BoundaryTriangle triangle(const RationalPoint& p, const RationalPoint& q, const RationalPoint& r) {
  return {{p, q, r}, half_space(p, cross(q - p, r - p))};
}

bool is_above(const BoundaryTriangle& t, const RationalPoint& p) { return height_above(t.behind, p) > 0; }

Edge edge_of(const BoundaryTriangle& t, std::size_t i) { return {t.corner[i], t.corner[(i + 1) % 3]}; }

/// Directions, the same one or its opposite only once.
class Distinct {
 public:
  void add(const RationalPoint& direction) {
    Vec3 near = rounded(direction);
    near = (1 / std::hypot(near.x, near.y, near.z)) * near;
    for (std::size_t i = 0; i < kept_.size(); ++i) {
      const Vec3 n = toccata::cross(near, near_[i]);
      // NaN, where doubles do not reach, does not tell the two apart.
      if (std::hypot(n.x, n.y, n.z) > 1e-9) continue;
      if (is_zero(cross(direction, kept_[i]))) return;
    }
    kept_.push_back(direction);
    near_.push_back(near);
  }
  Points take() { return std::move(kept_); }

 private:
  Points kept_;
  std::vector<Vec3> near_;
};

Directions directions_of_flat(const Points& points, const Points& few) {
  Distinct edges;
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t j = i + 1; j < points.size(); ++j)
      if (!(points[i] == points[j])) edges.add(points[j] - points[i]);
  Directions result{edges.take(), {}};
  if (few.size() == 3) result.normals.push_back(cross(few[1] - few[0], few[2] - few[0]));
  return result;
}

}  // namespace

std::vector<RationalPoint> spanning(const std::vector<RationalPoint>& points) {
  Points few{points[0]};
  for (const RationalPoint& p : points) {
    if (few.size() == 1 && !(p == few[0])) few.push_back(p);
    if (few.size() == 2 && !is_zero(cross(few[1] - few[0], p - few[0]))) few.push_back(p);
    if (few.size() == 3 && !orientation(few[0], few[1], few[2], p).is_zero()) few.push_back(p);
    if (few.size() == 4) break;
  }
  return few;
}

// Begins with a tetrahedron, and each point takes the place of the triangles that it lies strictly above. Edges of
// triangles that remain are never in line with the point, or the triangle beyond them would not be strictly below it.
std::vector<BoundaryTriangle> boundary(const std::vector<RationalPoint>& points, std::vector<RationalPoint> four) {
  if (orientation(four[0], four[1], four[2], four[3]) > 0) std::swap(four[0], four[1]);
  std::vector<BoundaryTriangle> faces{triangle(four[0], four[1], four[2]), triangle(four[0], four[3], four[1]),
                                      triangle(four[1], four[3], four[2]), triangle(four[2], four[3], four[0])};
  for (const RationalPoint& p : points) {
    const auto hidden =
        std::partition(faces.begin(), faces.end(), [&](const auto& face) { return !is_above(face, p); });
    std::vector<Edge> open;
    for (auto face = hidden; face != faces.end(); ++face)
      for (std::size_t i = 0; i < 3; ++i) {
        const Edge edge = edge_of(*face, i);
        const auto twin = std::ranges::find(open, Edge{edge.second, edge.first});
        if (twin == open.end())
          open.push_back(edge);
        else
          open.erase(twin);
      }
    faces.erase(hidden, faces.end());
    for (const Edge& edge : open) faces.push_back(triangle(edge.first, edge.second, p));
  }
  return faces;
}

Directions directions_of(const std::vector<RationalPoint>& points) {
  const Points few = spanning(points);
  if (few.size() < 4) return directions_of_flat(points, few);
  Distinct edges, normals;
  const std::vector<BoundaryTriangle> faces = boundary(points, few);
  for (const BoundaryTriangle& face : faces) normals.add(face.behind.normal);
  for (const BoundaryTriangle& face : faces)
    for (std::size_t i = 0; i < 3; ++i) {
      const auto [from, to] = edge_of(face, i);
      if (!(from < to)) continue;  // each edge is seen from two faces, in opposite directions
      // What parts two triangles of one facet is no edge.
      const auto holds_twin = [&, &from = from, &to = to](const BoundaryTriangle& other) {
        for (std::size_t j = 0; j < 3; ++j)
          if (edge_of(other, j) == Edge{to, from}) return true;
        return false;
      };
      const auto other = std::ranges::find_if(faces, holds_twin);
      if (!is_zero(cross(face.behind.normal, other->behind.normal))) edges.add(to - from);
    }
  return {edges.take(), normals.take()};
}

}  // namespace toccata::oracle
