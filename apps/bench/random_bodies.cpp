#include "random_bodies.hpp"

#include <cmath>

#include "dop_bodies.hpp"
#include "toccata/math/pose.hpp"

namespace toccata::bench {

// Every number is drawn in a statement of its own: the order in which arguments are evaluated is not specified.

Vec3 unit_vector(Random& random) {
  while (true) {
    const double x = random.between(-1, 1);
    const double y = random.between(-1, 1);
    const double z = random.between(-1, 1);
    const Vec3 v{x, y, z};
    if (dot(v, v) > 0.01 && dot(v, v) <= 1) return (1 / std::sqrt(dot(v, v))) * v;
  }
}

Mat3 random_rotation(Random& random) {
  const Vec3 v = unit_vector(random);
  const double w = random.between(-1, 1);
  return rotation_of({v.x, v.y, v.z, w});
}

namespace {

double random_size(Random& random) { return random.between(0.3, 1); }

ConvexHull random_hull(std::size_t vertices, Random& random) {
  std::vector<Vec3> points;
  for (std::size_t i = 0; i < vertices; ++i) points.push_back(unit_vector(random));
  return ConvexHull(points);
}

Box random_box(Random& random) {
  const double x = random_size(random);
  const double y = random_size(random);
  const double z = random_size(random);
  return Box({x, y, z});
}

Capsule random_capsule(Random& random) {
  const double half_length = random_size(random);
  const double radius = 0.5 * random_size(random);
  return Capsule({0, 0, -half_length}, {0, 0, half_length}, radius);
}

ConvexBody random_round(const std::string& kind, Random& random) {
  const double radius = random_size(random);
  const double half_height = random_size(random);
  if (kind == "cone") return Cone(radius, half_height);
  return Cylinder(radius, half_height);
}

Triangle random_triangle(Random& random) {
  const Vec3 p = unit_vector(random);
  const Vec3 q = unit_vector(random);
  return {{p, q, unit_vector(random)}};
}

double reach_of(const PosedQuadric& shape) { return std::sqrt(dot(shape.half(), shape.half())); }

double reach_of(const PosedPolytope& shape) {
  double reach = 0;
  for (Index i = 0; i < shape.vertex_count(); ++i)
    reach = std::max(reach, std::sqrt(dot(shape.vertex(i), shape.vertex(i))));
  return reach + shape.radius();
}

}  // namespace

ConvexBody random_body(const std::string& kind, std::size_t vertices, Random& random) {
  if (kind == "sphere") return Sphere(random_size(random));
  if (kind == "box") return random_box(random);
  if (kind == "capsule") return random_capsule(random);
  if (kind == "triangle") return random_triangle(random);
  if (kind == "cylinder" || kind == "cone") return random_round(kind, random);
  if (kind == "ellipsoid") return Ellipsoid(random_box(random).half_extents());
  if (kind.ends_with("-dop")) return random_dop(kind, random);
  return random_hull(vertices, random);
}

double reach_of(const ConvexBody& body) {
  return std::visit([]<class Shape>(const Shape& shape) { return reach_of(PosedAs<Shape>(shape, Pose{})); }, body);
}

}  // namespace toccata::bench
