#include "narrow/gjk_simplex.hpp"

namespace toccata {
namespace {

/// Which corners are kept, as bits, and the point that they are nearest with.
struct Reduced {
  Vec3 nearest;
  double squared = 0;
  unsigned kept = 0;
};

Reduced reduced(const Vec3& nearest, unsigned kept) { return {nearest, dot(nearest, nearest), kept}; }

/// Below, q is the newest corner, and is always kept.
struct Corner {
  Vec3 point;
  unsigned bit;
};

Reduced on_segment(const Corner& p, const Corner& q) {
  const Vec3 along = p.point - q.point;
  const double forth = -dot(q.point, along);
  if (!(forth > 0)) return reduced(q.point, q.bit);
  return reduced(q.point + (forth / dot(along, along)) * along, p.bit | q.bit);
}

const Reduced& nearer(const Reduced& first, const Reduced& second) {
  return second.squared < first.squared ? second : first;
}

Reduced on_triangle(const Corner& p, const Corner& r, const Corner& q) {
  const Vec3 to_p = p.point - q.point, to_r = r.point - q.point;
  const Vec3 normal = cross(to_p, to_r);
  const bool beyond_p = dot(cross(to_p, normal), q.point) < 0, beyond_r = dot(cross(normal, to_r), q.point) < 0;
  if (beyond_p && beyond_r) return nearer(on_segment(p, q), on_segment(r, q));
  if (beyond_p) return on_segment(p, q);
  if (beyond_r) return on_segment(r, q);
  const double squared = dot(normal, normal);
  if (!(squared > 0)) return nearer(on_segment(p, q), on_segment(r, q));
  return reduced((dot(normal, q.point) / squared) * normal, p.bit | r.bit | q.bit);
}

/// The origin is not on the inner side of the face, on which the fourth corner is.
bool beyond(const Corner& p, const Corner& r, const Corner& q, const Corner& inner) {
  const Vec3 normal = cross(p.point - q.point, r.point - q.point);
  const double side = dot(normal, inner.point - q.point), height = -dot(normal, q.point);
  return !(side > 0 ? height > 0 : side < 0 && height < 0);
}

Reduced on_tetrahedron(const Corner& p, const Corner& r, const Corner& s, const Corner& q) {
  Reduced best{{}, 0, 15};
  const auto try_face = [&best, &q](const Corner& u, const Corner& v, const Corner& inner) {
    if (!beyond(u, v, q, inner)) return;
    const Reduced face = on_triangle(u, v, q);
    if (best.kept == 15 || face.squared < best.squared) best = face;
  };
  try_face(p, r, s);
  try_face(r, s, p);
  try_face(s, p, r);
  return best;
}

}  // namespace

Vec3 reduce(GjkSimplex& simplex) {
  const auto corner = [&simplex](std::size_t i) { return Corner{simplex.point[i], 1U << i}; };
  Reduced result;
  switch (simplex.pairs.size) {
    case 1:
      return simplex.point[0];
    case 2:
      result = on_segment(corner(0), corner(1));
      break;
    case 3:
      result = on_triangle(corner(0), corner(1), corner(2));
      break;
    default:
      result = on_tetrahedron(corner(0), corner(1), corner(2), corner(3));
      break;
  }
  GjkSimplex kept;
  for (std::size_t i = 0; i < simplex.pairs.size; ++i)
    if ((result.kept >> i & 1U) != 0) kept.append(simplex.pairs.a[i], simplex.pairs.b[i], simplex.point[i]);
  simplex = kept;
  return result.nearest;
}

}  // namespace toccata
