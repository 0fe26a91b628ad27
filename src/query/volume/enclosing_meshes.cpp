#include "query/volume/enclosing_meshes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <numbers>
#include <utility>
#include <vector>

#include "math/plain_inverse.hpp"
#include "math/vec3_measures.hpp"
#include "narrow/quadrics/kinds/quadric_kind.hpp"
#include "query/relation/hull_mesh.hpp"
#include "toccata/generate/meshes.hpp"

namespace toccata {
namespace {

/// Vertices are moved by so much of the size, and more where rounding moves them: outwards around a solid, inwards
/// within it.
constexpr double least_margin = 0x1p-40;

/// A posed vertex is off by less than this share of the coordinates that were added up on the way to it.
constexpr double rounding_share = 0x1p-48;

/// A unit ball as a polyhedron with its vertices on it, and how far its faces are from the middle, a little less.
struct BallPoints {
  std::vector<Vec3> points;
  double within = 0;
};

BallPoints ball_points() {
  constexpr int subdivisions = 4;
  const TriangleMesh mesh = icosphere_mesh(1, subdivisions);
  BallPoints ball{{mesh.vertices().begin(), mesh.vertices().end()}, 1};
  for (const auto& [i, j, k] : mesh.triangles()) {
    const Vec3 &p = ball.points[i], &q = ball.points[j], &r = ball.points[k];
    const Vec3 normal = unit_or_zero(cross(q - p, r - p));
    ball.within = std::min(ball.within, (1 - least_margin) * std::abs(dot(normal, p)));
  }
  return ball;
}

const BallPoints& unit_ball() {
  static const BallPoints ball = ball_points();
  return ball;
}

std::optional<PosedMesh> mesh_of_hull(const PosedPolytope& shape) {
  const HullMesh hull = hull_mesh(shape);
  if (hull.dimension < 3) return std::nullopt;
  return PosedMesh(Model(hull.mesh), Pose{});
}

std::optional<PosedMesh> mesh_around(const std::vector<Vec3>& points) {
  const ConvexHull hull(points);
  return mesh_of_hull(PosedPolytope(hull));
}

/// Vertices grown by balls of that many radii.
std::optional<PosedMesh> mesh_of_rounded(const PosedPolytope& shape, double radius) {
  std::vector<Vec3> points;
  for (Index i = 0; i < shape.vertex_count(); ++i)
    for (const Vec3& p : unit_ball().points) points.push_back(shape.vertex(i) + radius * p);
  return mesh_around(points);
}

EnclosingMeshes meshes_of_polytope(const PosedPolytope& shape) {
  if (shape.radius() == 0) return {mesh_of_hull(shape), {}};
  double reach = shape.radius();
  for (Index i = 0; i < shape.vertex_count(); ++i) reach = std::max(reach, largest_magnitude(shape.vertex(i)));
  const double margin = least_margin + rounding_share * reach / shape.radius();
  return {mesh_of_rounded(shape, std::max(0.0, 1 - margin) * shape.radius()),
          mesh_of_rounded(shape, (1 + margin) / unit_ball().within * shape.radius())};
}

void add_polygon_rim(std::vector<Vec3>& points, double radius, double height) {
  constexpr int around = 256;
  for (int i = 0; i < around; ++i) {
    const double angle = 2 * std::numbers::pi * i / around;
    points.push_back({radius * std::cos(angle), radius * std::sin(angle), height});
  }
}

/// How much wider a regular polygon of that many corners has to be to contain the circle.
double rim_around() { return (1 + least_margin) / std::cos(std::numbers::pi / 256); }

/// Points for the shape whose half axes are 1: within it, up to the rounding of sines, or around it.
template <QuadricKind Kind>
std::vector<Vec3> unit_points(bool is_around) {
  std::vector<Vec3> points;
  if constexpr (AxialKind<Kind>) {
    const double radius = is_around ? rim_around() : 1;
    add_polygon_rim(points, radius, -1);
    if (Kind::has_tip)
      points.push_back({0, 0, 1});
    else
      add_polygon_rim(points, radius, 1);
    return points;
  }
  for (const Vec3& p : unit_ball().points) points.push_back((is_around ? 1 / unit_ball().within : 1) * p);
  return points;
}

/// The root of the sum of the squares of all elements of the inverse: no vector is shortened by more.
double most_shortened(const Mat3& linear) {
  const Mat3 inverse = plain_inverse_transpose(linear);
  double sum = 0;
  for (int row = 0; row < 3; ++row) sum += dot(inverse[row], inverse[row]);
  return std::sqrt(sum);
}

EnclosingMeshes meshes_of_quadric(const PosedQuadric& shape) {
  const Vec3 &half = shape.half(), &offset = shape.pose().offset;
  double reach = largest_magnitude(offset);
  for (int row = 0; row < 3; ++row) reach += largest_magnitude(shape.pose().linear[row]) * 3 * largest_magnitude(half);
  // A ball of half the least half axis around its middle is within the shape, and an image of it within its image.
  const double least_half = 0.5 * std::min({half.x, half.y, half.z});
  const double margin = least_margin + 4 * rounding_share * reach * most_shortened(shape.pose().linear) / least_half;
  const Vec3 middle{0, 0, with_kind(shape.kind(), [](auto kind) { return kind.inner_height; })};
  const auto mesh = [&](bool is_around) {
    std::vector<Vec3> points = with_kind(shape.kind(), [&]<class Kind>(Kind) { return unit_points<Kind>(is_around); });
    for (Vec3& p : points) {
      p = middle + (is_around ? 1 + margin : std::max(0.0, 1 - margin)) * (p - middle);
      p = transform(shape.pose(), {half.x * p.x, half.y * p.y, half.z * p.z});
    }
    return mesh_around(points);
  };
  return {mesh(false), mesh(true)};
}

/// A prism on the plane, as large as what is near: up to just below the plane, and to just above it.
EnclosingMeshes prisms_of(const PosedHalfSpace& shape, const Aabb& near) {
  const Vec3 normal = unit_or_zero(shape.normal);
  const Vec3 middle = 0.5 * near.lower + 0.5 * near.upper, size = near.upper - near.lower;
  const double height = dot(normal, middle - shape.point);
  const double reach = 4 * (std::abs(size.x) + std::abs(size.y) + std::abs(size.z) + std::abs(height));
  const double margin = rounding_share * (reach + largest_magnitude(middle) + largest_magnitude(shape.point)) * 0x1p4;
  const Vec3 foot = middle - height * normal;
  const Vec3 first = unit_or_zero(cross(normal, std::abs(normal.x) < 0.6 ? Vec3{1, 0, 0} : Vec3{0, 1, 0}));
  const Vec3 second = cross(normal, first);
  const auto prism = [&](double above) {
    std::vector<Vec3> points;
    for (const double up : {above, -reach})
      for (const double along : {-reach, reach})
        for (const double across : {-reach, reach})
          points.push_back(foot + along * first + across * second + up * normal);
    return mesh_around(points);
  };
  return {prism(-margin), prism(margin)};
}

}  // namespace

EnclosingMeshes enclosing_meshes(const PosedShape& shape, const Aabb& near) {
  if (const auto* triangles = std::get_if<PosedTriangles>(&shape)) return {triangles->mesh, {}};
  if (const auto* convex = std::get_if<PosedPolytope>(&shape)) return meshes_of_polytope(*convex);
  if (const auto* quadric = std::get_if<PosedQuadric>(&shape)) return meshes_of_quadric(*quadric);
  return prisms_of(std::get<PosedHalfSpace>(shape), near);
}

}  // namespace toccata
