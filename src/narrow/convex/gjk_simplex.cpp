#include "narrow/convex/gjk_simplex.hpp"

#include <bit>

namespace toccata {
namespace {

// Below, q is the newest corner, and is always kept.

struct SimplexCorner {
  const Vec3& point;
  unsigned bit;
};

NearestFace at(const Vec3& nearest, unsigned kept) { return {nearest, dot(nearest, nearest), nearest, kept}; }

NearestFace on_segment(const SimplexCorner& p, const SimplexCorner& q) {
  const Vec3 along = p.point - q.point;
  const double forth = -dot(q.point, along);
  if (!(forth > 0)) return at(q.point, q.bit);
  return at(q.point + (forth / dot(along, along)) * along, p.bit | q.bit);
}

NearestFace nearer(const NearestFace& first, const NearestFace& second) {
  return second.squared < first.squared ? second : first;
}

/// `normal` is (p − q) × (r − q).
NearestFace on_triangle(const SimplexCorner& p, const SimplexCorner& r, const SimplexCorner& q, const Vec3& normal) {
  const bool beyond_p = dot(cross(p.point - q.point, normal), q.point) < 0;
  const bool beyond_r = dot(cross(normal, r.point - q.point), q.point) < 0;
  if (beyond_p && beyond_r) return nearer(on_segment(p, q), on_segment(r, q));
  if (beyond_p) return on_segment(p, q);
  if (beyond_r) return on_segment(r, q);
  const double squared = dot(normal, normal), height = dot(normal, q.point);
  if (!(squared > 0)) return nearer(on_segment(p, q), on_segment(r, q));
  const Vec3 nearest = (height / squared) * normal;
  return {nearest, dot(nearest, nearest), height < 0 ? -normal : normal, p.bit | r.bit | q.bit};
}

/// Those of the three faces at q are looked at that do not have the origin on their inner side.
NearestFace on_tetrahedron(const std::array<SimplexCorner, 4>& corner) {
  const SimplexCorner& q = corner[3];
  const Vec3 to[3] = {corner[0].point - q.point, corner[1].point - q.point, corner[2].point - q.point};
  const Vec3 normal[3] = {cross(to[0], to[1]), cross(to[1], to[2]), cross(to[2], to[0])};
  const double volume = dot(normal[0], to[2]);
  unsigned beyond = 0;
  for (unsigned face = 0; face < 3; ++face) {
    const double height = dot(normal[face], q.point);
    const bool inner = ((volume > 0) & (height < 0)) | ((volume < 0) & (height > 0));
    beyond |= (inner ? 0U : 1U) << face;
  }
  NearestFace best{{}, 0, {}, 15};
  for (; beyond != 0; beyond &= beyond - 1) {
    const auto i = static_cast<std::size_t>(std::countr_zero(beyond));
    const NearestFace face = on_triangle(corner[i], corner[i == 2 ? 0 : i + 1], q, normal[i]);
    if (best.kept == 15 || face.squared < best.squared) best = face;
  }
  return best;
}

}  // namespace

void GjkSimplex::keep(unsigned bits) {
  std::size_t count = 0;
  // Moves each and counts those that stay, so that nothing depends on a branch.
  for (std::size_t i = 0; i < 4; ++i) {
    pairs.a[count] = pairs.a[i];
    pairs.b[count] = pairs.b[i];
    point[count] = point[i];
    count += bits >> i & 1U;
  }
  pairs.size = count;
}

NearestFace nearest_face(const GjkSimplex& simplex) {
  const auto corner = [&simplex](std::size_t i) { return SimplexCorner{simplex.point[i], 1U << i}; };
  const std::array<Vec3, 4>& point = simplex.point;
  switch (simplex.pairs.size) {
    case 1:
      return at(point[0], 1);
    case 2:
      return on_segment(corner(0), corner(1));
    case 3:
      return on_triangle(corner(0), corner(1), corner(2), cross(point[0] - point[2], point[1] - point[2]));
    default:
      return on_tetrahedron({corner(0), corner(1), corner(2), corner(3)});
  }
}

}  // namespace toccata
