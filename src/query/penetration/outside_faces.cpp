#include "query/penetration/outside_faces.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "math/vec3_measures.hpp"

namespace toccata {
namespace {

/// The least along the normal.
double lowest(const Triangle& triangle, const Vec3& normal) {
  return std::min({dot(triangle[0], normal), dot(triangle[1], normal), dot(triangle[2], normal)});
}

double reach_of(const Triangle& triangle) {
  return std::max({largest_magnitude(triangle[0]), largest_magnitude(triangle[1]), largest_magnitude(triangle[2])});
}

}  // namespace

OutsideFaces::OutsideFaces(const ConvexHull& body) : body_(body) {
  for (Index i = 0; i < body.vertex_count(); ++i) reach_ = std::max(reach_, largest_magnitude(body.vertex(i)));
  const HullTopology topology = body.topology();
  for (Index face = 0; face < topology.face_count(); ++face) {
    const Index first = topology.face_start[face];
    const Vec3 a = body.vertex(topology.origin[first]), b = body.vertex(topology.origin[first + 1]),
               c = body.vertex(topology.origin[topology.face_start[face + 1] - 1]);
    const Vec3 normal = unit_or_zero(cross(b - a, c - a));
    faces_.push_back({normal, dot(a, normal)});
  }
}

bool OutsideFaces::tell_apart(const Triangle& triangle) {
  const double reach = std::max(reach_, reach_of(triangle));
  if (is_before(faces_[last_], triangle, reach)) return true;
  for (std::size_t i = 0; i < faces_.size(); ++i)
    if (i != last_ && is_before(faces_[i], triangle, reach)) {
      last_ = i;
      return true;
    }
  return false;
}

/// Any direction proves it, so that the normal may be rounded. A height is a sum of three products of numbers up
/// to 1.01 and `reach`: three roundings of 2^-53 make it wrong by less than 2^-49 · reach, and both of them by less
/// than 2^-48. A sum of two products that is more than doubles hold stays above the body whatever the third is: with
/// |x| + |y| > 1 of a unit normal |z| is less. Bodies of such coordinates have no normals.
bool OutsideFaces::is_before(Face& face, const Triangle& triangle, double reach) const {
  const double low = lowest(triangle, face.normal);
  if (!(low > face.height)) return false;
  if (!face.is_measured) {
    face.of_body = face.height;
    for (Index i = 0; i < body_.vertex_count(); ++i)
      face.of_body = std::max(face.of_body, dot(body_.vertex(i), face.normal));
    face.is_measured = true;
  }
  return low - face.of_body > 0x1p-47 * reach + 0x1p-1000;
}

}  // namespace toccata
