#include <algorithm>
#include <cmath>

#include "math/vec3_measures.hpp"
#include "narrow/convex/expanding_polytope.hpp"

// How an expanding polytope begins.
namespace toccata {
namespace {

/// A vector across v, of a length like its own.
Vec3 vector_across(const Vec3& v) {
  const double x = std::fabs(v.x), y = std::fabs(v.y), z = std::fabs(v.z);
  if (x <= y && x <= z) return {0, -v.z, v.y};
  return y <= z ? Vec3{v.z, 0, -v.x} : Vec3{-v.y, v.x, 0};
}

Vec3 unit_or(const Vec3& v, const Vec3& otherwise) {
  const double squared = dot(v, v);
  return squared > 0x1p-900 ? (1 / std::sqrt(squared)) * v : otherwise;
}

}  // namespace

Sign ExpandingPolytope::orientation(const std::array<DifferencePoint, 4>& p) const {
  const Vec3 u = p[1].value - p[0].value, v = p[2].value - p[0].value, w = p[3].value - p[0].value;
  const double volume = dot(cross(u, v), w);
  // Edges are off by 7uV, and none is longer than 3.5V: see expanding_polytope.cpp.
  const double error =
      0x1p-44 * body_.extent() * body_.extent() * std::max({plain_length(u), plain_length(v), plain_length(w)});
  if (std::fabs(volume) > error) return volume > 0 ? Sign::positive : Sign::negative;
  std::array<IntegerVector, 4> exact;
  for (std::size_t k = 0; k < 4; ++k) exact[k] = body_.exact_point(p[k].on_a, p[k].on_b);
  return sign_of(dot(cross(exact[1] - exact[0], exact[2] - exact[0]), exact[3] - exact[0]));
}

void ExpandingPolytope::make_tetrahedron(const std::array<DifferencePoint, 4>& points) {
  points_.assign(points.begin(), points.end());
  if (orientation(points) == Sign::positive) std::swap(points_[1], points_[2]);
  // Now corner 3 lies behind the face 0, 1, 2.
  add_facet(0, 1, 2);
  add_facet(0, 3, 1);
  add_facet(1, 3, 2);
  add_facet(2, 3, 0);
  facets_[0].neighbour = {1, 2, 3};
  facets_[1].neighbour = {3, 2, 0};
  facets_[2].neighbour = {1, 3, 0};
  facets_[3].neighbour = {2, 1, 0};
}

// Far points, first towards the origin's nearest side: most of what the search needs lies there.
bool ExpandingPolytope::start_roughly() {
  const Vec3 along = unit_or(body_.from_a_to_b(), {1, 0, 0});
  std::array<DifferencePoint, 4> p{body_.support(along), body_.support(-along), {}, {}};
  const Vec3 axis = p[1].value - p[0].value;
  const Vec3 aside = unit_or(vector_across(axis), {0, 1, 0});
  const double far = 0.01 * body_.extent();
  p[2] = body_.support(aside);
  if (plain_length(cross(axis, p[2].value - p[0].value)) < far * plain_length(axis)) p[2] = body_.support(-aside);
  Vec3 normal = unit_or(cross(axis, p[2].value - p[0].value), {0, 0, 1});
  if (dot(normal, p[0].value) > 0) normal = -normal;  // towards the origin
  p[3] = body_.support(normal);
  if (std::fabs(dot(normal, p[3].value - p[0].value)) < far) p[3] = body_.support(-normal);
  if (orientation(p) == Sign::zero) return false;
  make_tetrahedron(p);
  return true;
}

bool ExpandingPolytope::start_exactly() {
  // All of D lies in the plane, line or point through its first point in which these lie.
  std::vector<DifferencePoint> points;
  for (Index i = 0; i < body_.a().count(); ++i) points.push_back(body_.point(i, 0));
  for (Index i = 1; i < body_.b().count(); ++i) points.push_back(body_.point(0, i));
  const IntegerVector origin = body_.exact_point(0, 0);
  const auto relative = [&](const DifferencePoint& p) { return body_.exact_point(p.on_a, p.on_b) - origin; };
  std::array<DifferencePoint, 4> chosen{points[0], {}, {}, {}};
  std::size_t count = 1;
  IntegerVector line, normal;
  for (const DifferencePoint& p : points) {
    const IntegerVector to = relative(p);
    const IntegerVector turned = count >= 2 ? cross(line, to) : to;
    if (count == 3 && dot(normal, to) == 0) continue;
    if (count < 3 && is_zero(turned)) continue;
    if (count == 1) line = to;
    if (count == 2) normal = turned;
    chosen[count++] = p;
    if (count == 4) break;
  }
  if (count < 4) {
    const Vec3 along = count == 2 ? unit_vector(line) : Vec3{0, 0, 1};
    flat_direction_ = count == 3 ? unit_vector(normal) : unit_or(vector_across(along), {1, 0, 0});
    return false;
  }
  make_tetrahedron(chosen);
  return true;
}

bool ExpandingPolytope::start() { return start_roughly() || start_exactly(); }

}  // namespace toccata
