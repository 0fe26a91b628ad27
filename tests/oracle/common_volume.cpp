#include "oracle/common_volume.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace toccata::oracle {
namespace {

Rational six_volumes(const RationalPoint& p, const RationalPoint& q, const RationalPoint& r, const RationalPoint& s) {
  return dot(cross(q - p, r - p), s - p);
}

/// The polyhedron cut by a half-space: its cut faces, and a lid of the edges that the cut leaves open.
ConvexFaces cut(const ConvexFaces& faces, const HalfSpace& half_space) {
  ConvexFaces result;
  std::vector<RationalPoint> on_plane;
  for (const auto& face : faces) {
    std::vector<RationalPoint> inside = clipped(face, half_space);
    bool is_flat = true;
    for (const RationalPoint& p : inside) {
      if (height_above(half_space, p).is_zero())
        on_plane.push_back(p);
      else
        is_flat = false;
    }
    if (!is_flat && inside.size() >= 3) result.push_back(std::move(inside));
  }
  if (result.empty() || on_plane.size() < 3) return result;
  // The lid is convex: its corners are sorted around its middle.
  std::sort(on_plane.begin(), on_plane.end());
  on_plane.erase(std::unique(on_plane.begin(), on_plane.end()), on_plane.end());
  if (on_plane.size() < 3) return result;
  const RationalPoint middle = centroid(on_plane), first = on_plane[0] - middle;
  const auto angle_class = [&](const RationalPoint& p) {
    const Rational turn = dot(half_space.normal, cross(first, p - middle)), along = dot(first, p - middle);
    if (turn.is_zero()) return along.sign() >= 0 ? 0 : 2;
    return turn.sign() > 0 ? 1 : 3;
  };
  std::sort(on_plane.begin(), on_plane.end(), [&](const RationalPoint& p, const RationalPoint& q) {
    const int of_p = angle_class(p), of_q = angle_class(q);
    if (of_p != of_q) return of_p < of_q;
    return dot(half_space.normal, cross(p - middle, q - middle)).sign() > 0;
  });
  result.push_back(std::move(on_plane));
  return result;
}

Rational six_volumes(const ConvexFaces& faces) {
  Rational sum;
  if (faces.empty()) return sum;
  const RationalPoint& from = faces[0][0];
  for (const auto& face : faces)
    for (std::size_t i = 2; i < face.size(); ++i) sum += six_volumes(from, face[0], face[i - 1], face[i]);
  return sum;
}

struct Bounds {
  std::array<Rational, 3> lower, upper;
};

Bounds bounds_of(const std::vector<RationalPoint>& points) {
  Bounds bounds{{points[0].x, points[0].y, points[0].z}, {points[0].x, points[0].y, points[0].z}};
  for (const RationalPoint& p : points) {
    const std::array<Rational, 3> at{p.x, p.y, p.z};
    for (std::size_t i = 0; i < 3; ++i) {
      if (at[i] < bounds.lower[i]) bounds.lower[i] = at[i];
      if (bounds.upper[i] < at[i]) bounds.upper[i] = at[i];
    }
  }
  return bounds;
}

bool are_apart(const Bounds& a, const Bounds& b) {
  for (std::size_t i = 0; i < 3; ++i)
    if (a.upper[i] <= b.lower[i] || b.upper[i] <= a.lower[i]) return true;
  return false;
}

struct SignedTetrahedron {
  std::vector<RationalPoint> corners;
  Bounds bounds;
  int sign = 0;
};

std::vector<SignedTetrahedron> tetrahedra_over(const std::vector<Triangle>& triangles, const RationalPoint& from) {
  std::vector<SignedTetrahedron> all;
  for (const Triangle& t : triangles) {
    std::vector<RationalPoint> corners{from, exact(t[0]), exact(t[1]), exact(t[2])};
    const int sign = six_volumes(corners[0], corners[1], corners[2], corners[3]).sign();
    if (sign != 0) all.push_back({corners, bounds_of(corners), sign});
  }
  return all;
}

}  // namespace

ConvexFaces tetrahedron_faces(const RationalPoint& p, const RationalPoint& q, const RationalPoint& r,
                              const RationalPoint& s) {
  // Seen from s, a tetrahedron of positive volume has p, q, r the other way round.
  if (six_volumes(p, q, r, s).sign() > 0) return {{p, r, q}, {p, q, s}, {q, r, s}, {r, p, s}};
  return {{p, q, r}, {p, s, q}, {q, s, r}, {r, s, p}};
}

Rational six_common_volumes(const std::vector<RationalPoint>& a, const std::vector<RationalPoint>& b) {
  ConvexFaces faces = tetrahedron_faces(a[0], a[1], a[2], a[3]);
  for (const auto& face : tetrahedron_faces(b[0], b[1], b[2], b[3]))
    faces = cut(faces, half_space(face[0], cross(face[1] - face[0], face[2] - face[0])));
  return six_volumes(faces);
}

Rational common_volume(const std::vector<Triangle>& a, const std::vector<Triangle>& b) {
  const auto of_a = tetrahedra_over(a, exact(a[0][0])), of_b = tetrahedra_over(b, exact(b[0][0]));
  Rational sum;
  for (const SignedTetrahedron& s : of_a)
    for (const SignedTetrahedron& t : of_b)
      if (!are_apart(s.bounds, t.bounds)) sum += Rational(s.sign * t.sign) * six_common_volumes(s.corners, t.corners);
  return sum / Rational(6);
}

}  // namespace toccata::oracle
