#include "narrow/gjk_simplex.hpp"

namespace toccata {
namespace {

// Below, q is the newest corner, and is always kept.

struct Corner {
  const Vec3& point;
  unsigned bit;
};

NearestFace at(const Vec3& nearest, unsigned kept) { return {nearest, dot(nearest, nearest), nearest, kept}; }

NearestFace on_segment(const Corner& p, const Corner& q) {
  const Vec3 along = p.point - q.point;
  const double forth = -dot(q.point, along);
  if (!(forth > 0)) return at(q.point, q.bit);
  return at(q.point + (forth / dot(along, along)) * along, p.bit | q.bit);
}

NearestFace nearer(const NearestFace& first, const NearestFace& second) {
  return second.squared < first.squared ? second : first;
}

/// `normal` is (p − q) × (r − q).
NearestFace on_triangle(const Corner& p, const Corner& r, const Corner& q, const Vec3& normal) {
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

/// Of the three faces at q, those that do not have the origin on their inner side are looked at.
NearestFace on_tetrahedron(const Corner& p, const Corner& r, const Corner& s, const Corner& q) {
  const Vec3 to_p = p.point - q.point, to_r = r.point - q.point, to_s = s.point - q.point;
  const Vec3 normal_s = cross(to_p, to_r), normal_p = cross(to_r, to_s), normal_r = cross(to_s, to_p);
  const double volume = dot(normal_s, to_s), side = volume > 0 ? 1.0 : volume < 0 ? -1.0 : 0.0;
  NearestFace best{{}, 0, {}, 15};
  const auto try_face = [&](const Corner& v, const Corner& w, const Vec3& normal) {
    if (-side * dot(normal, q.point) > 0) return;
    const NearestFace face = on_triangle(v, w, q, normal);
    if (best.kept == 15 || face.squared < best.squared) best = face;
  };
  try_face(p, r, normal_s);
  try_face(r, s, normal_p);
  try_face(s, p, normal_r);
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
  const auto corner = [&simplex](std::size_t i) { return Corner{simplex.point[i], 1U << i}; };
  const std::array<Vec3, 4>& point = simplex.point;
  switch (simplex.pairs.size) {
    case 1:
      return at(point[0], 1);
    case 2:
      return on_segment(corner(0), corner(1));
    case 3:
      return on_triangle(corner(0), corner(1), corner(2), cross(point[0] - point[2], point[1] - point[2]));
    default:
      return on_tetrahedron(corner(0), corner(1), corner(2), corner(3));
  }
}

}  // namespace toccata
