#include "oracle/quadrics.hpp"

#include <algorithm>

namespace toccata::oracle {
namespace {

FinePoint operator+(const FinePoint& a, const FinePoint& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
FinePoint operator-(const FinePoint& a, const FinePoint& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
FinePoint operator*(const Fine& s, const FinePoint& a) { return {s * a.x, s * a.y, s * a.z}; }
Fine dot(const FinePoint& a, const FinePoint& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
FinePoint cross(const FinePoint& a, const FinePoint& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
Fine length(const FinePoint& a) { return sqrt(dot(a, a)); }
FinePoint fine_point(const Vec3& v) { return {Fine(v.x), Fine(v.y), Fine(v.z)}; }

/// The farthest point of the disc that the first two axes span around the origin.
FinePoint farthest_of_disc(const FineSet& set, const FinePoint& d) {
  const Fine u = dot(d, set.axis[0]), v = dot(d, set.axis[1]), norm = sqrt(u * u + v * v);
  if (norm == 0) return {};
  return (u / norm) * set.axis[0] + (v / norm) * set.axis[1];
}

FinePoint farthest_of_hull(const FineSet& set, const FinePoint& d) {
  const FinePoint* best = &set.vertices[0];
  for (const FinePoint& v : set.vertices)
    if (dot(d, v) > dot(d, *best)) best = &v;
  return *best + (set.radius / length(d)) * d;
}

using FineSimplex = std::vector<FinePoint>;

/// Weights of the point nearest to the origin in the plane, line or point through all corners; empty when they are
/// not independent.
std::vector<Fine> affine_weights(const FineSimplex& s) {
  if (s.size() == 1) return {Fine(1)};
  const FinePoint u = s[1] - s[0], w = Fine(-1) * s[0];
  if (s.size() == 2) {
    const Fine uu = dot(u, u);
    if (uu == 0) return {};
    const Fine t = dot(w, u) / uu;
    return {1 - t, t};
  }
  const FinePoint v = s[2] - s[0];
  if (s.size() == 3) {
    const Fine uu = dot(u, u), uv = dot(u, v), vv = dot(v, v), det = uu * vv - uv * uv;
    if (det == 0) return {};
    const Fine t = (vv * dot(w, u) - uv * dot(w, v)) / det, r = (uu * dot(w, v) - uv * dot(w, u)) / det;
    return {1 - t - r, t, r};
  }
  const FinePoint t = s[3] - s[0];
  const Fine volume = dot(cross(u, v), t);
  if (volume == 0) return {};
  const Fine i = dot(cross(w, v), t) / volume, j = dot(cross(u, w), t) / volume, k = dot(cross(u, v), w) / volume;
  return {1 - i - j - k, i, j, k};
}

/// The part of the simplex, its last corner included, that has its point nearest to the origin inside.
struct NearestPart {
  FineSimplex corners;
  FinePoint point;
  Fine squared = -1;
};

NearestPart nearest_part(const FineSimplex& s) {
  NearestPart best;
  const std::size_t last = s.size() - 1;
  for (unsigned bits = 0; bits < 1U << last; ++bits) {
    FineSimplex part;
    for (std::size_t i = 0; i < last; ++i)
      if ((bits >> i & 1U) != 0) part.push_back(s[i]);
    part.push_back(s[last]);
    const std::vector<Fine> weight = affine_weights(part);
    if (weight.empty() || std::any_of(weight.begin(), weight.end(), [](const Fine& w) { return w < 0; })) continue;
    FinePoint point{};
    if (part.size() < 4)
      for (std::size_t i = 0; i < part.size(); ++i) point = point + weight[i] * part[i];
    const Fine squared = dot(point, point);
    if (best.squared < 0 || squared < best.squared) best = {part, point, squared};
  }
  return best;
}

/// How far the origin is from the faces of a tetrahedron around it, at least.
Fine depth_within(const FineSimplex& s) {
  Fine least = -1;
  for (std::size_t i = 0; i < 4; ++i) {
    const FinePoint &p = s[i], &q = s[(i + 1) % 4], &r = s[(i + 2) % 4];
    const FinePoint normal = cross(q - p, r - p);
    const Fine size = length(normal);
    if (size == 0) return 0;
    const Fine height = abs(dot(normal, p)) / size;
    if (least < 0 || height < least) least = height;
  }
  return least;
}

}  // namespace

FineSet quadric_set(FineKind kind, const Vec3& half, const Pose& pose) {
  FineSet set;
  set.kind = kind;
  for (int j = 0; j < 3; ++j) set.axis[static_cast<std::size_t>(j)] = Fine(half[j]) * fine_point(pose.linear.column(j));
  set.centre = fine_point(pose.offset);
  return set;
}

FineSet hull_set_of(const std::vector<Vec3>& world_vertices, double radius) {
  FineSet set;
  for (const Vec3& v : world_vertices) set.vertices.push_back(fine_point(v));
  set.radius = radius;
  return set;
}

FinePoint farthest(const FineSet& set, const FinePoint& d) {
  if (set.kind == FineKind::hull) return farthest_of_hull(set, d);
  const Fine along = dot(d, set.axis[2]);
  if (set.kind == FineKind::ellipsoid) {
    const Fine u = dot(d, set.axis[0]), v = dot(d, set.axis[1]), norm = sqrt(u * u + v * v + along * along);
    return set.centre + (u / norm) * set.axis[0] + (v / norm) * set.axis[1] + (along / norm) * set.axis[2];
  }
  const FinePoint rim = farthest_of_disc(set, d), top = set.centre + set.axis[2], bottom = set.centre - set.axis[2];
  if (set.kind == FineKind::cylinder) return rim + (along > 0 ? top : bottom);
  return dot(d, top) > dot(d, bottom + rim) ? top : bottom + rim;
}

FineNearness fine_nearness(const FineSet& a, const FineSet& b, double part, int most) {
  FineNearness found;
  found.upper = -1;
  NearestPart now;
  FinePoint direction = {Fine(1), Fine(0), Fine(0)};
  for (int step = 0; step < most; ++step) {
    const FinePoint point = farthest(a, Fine(-1) * direction) - farthest(b, direction);
    const Fine lower = dot(point, direction) / length(direction);
    if (step == 0 || lower > found.lower) {
      found.lower = lower;
      found.direction = direction;
    }
    if (found.upper >= 0 && found.upper - found.lower <= Fine(part) * found.upper) break;
    FineSimplex s = now.corners;
    s.push_back(point);
    const NearestPart next = nearest_part(s);
    if (now.squared >= 0 && !(next.squared < now.squared)) break;
    now = next;
    found.upper = sqrt(now.squared);
    if (now.corners.size() == 4) {
      found.meet = true;
      found.depth = depth_within(now.corners);
      found.upper = found.lower = 0;
      break;
    }
    if (now.squared == 0) break;
    direction = now.point;
  }
  if (found.lower < 0) found.lower = 0;
  return found;
}

}  // namespace toccata::oracle
