#include "oracle/quadrics.hpp"

#include <algorithm>
#include <cmath>

namespace toccata::oracle {
namespace {

using std::abs, std::sqrt;
template <class N>
PointOf<N> operator+(const PointOf<N>& a, const PointOf<N>& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
template <class N>
PointOf<N> operator-(const PointOf<N>& a, const PointOf<N>& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
template <class N>
PointOf<N> operator*(const N& s, const PointOf<N>& a) {
  return {s * a.x, s * a.y, s * a.z};
}
template <class N>
N dot(const PointOf<N>& a, const PointOf<N>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
template <class N>
PointOf<N> cross(const PointOf<N>& a, const PointOf<N>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
template <class N>
N length(const PointOf<N>& a) {
  return sqrt(dot(a, a));
}
FinePoint fine_point(const Vec3& v) { return {Fine(v.x), Fine(v.y), Fine(v.z)}; }

/// The farthest point of the disc that the first two axes span around the origin.
template <class N>
PointOf<N> farthest_of_disc(const SetOf<N>& set, const PointOf<N>& d) {
  const N u = dot(d, set.axis[0]), v = dot(d, set.axis[1]), norm = sqrt(u * u + v * v);
  if (norm == 0) return {};
  return (u / norm) * set.axis[0] + (v / norm) * set.axis[1];
}

template <class N>
PointOf<N> farthest_of_hull(const SetOf<N>& set, const PointOf<N>& d) {
  const PointOf<N>* best = &set.vertices[0];
  for (const PointOf<N>& v : set.vertices)
    if (dot(d, v) > dot(d, *best)) best = &v;
  return *best + (set.radius / length(d)) * d;
}

template <class N>
using WeightsOf = boost::container::static_vector<N, 4>;

/// Weights of the point nearest to the origin in the plane, line or point through all corners; empty when they are
/// not independent.
template <class N>
WeightsOf<N> affine_weights(const SimplexOf<N>& s) {
  if (s.size() == 1) return {N(1)};
  const PointOf<N> u = s[1] - s[0], w = N(-1) * s[0];
  if (s.size() == 2) {
    const N uu = dot(u, u);
    if (uu == 0) return {};
    const N t = dot(w, u) / uu;
    return {1 - t, t};
  }
  const PointOf<N> v = s[2] - s[0];
  if (s.size() == 3) {
    const N uu = dot(u, u), uv = dot(u, v), vv = dot(v, v), det = uu * vv - uv * uv;
    if (det == 0) return {};
    const N t = (vv * dot(w, u) - uv * dot(w, v)) / det, r = (uu * dot(w, v) - uv * dot(w, u)) / det;
    return {1 - t - r, t, r};
  }
  const PointOf<N> t = s[3] - s[0];
  const N volume = dot(cross(u, v), t);
  if (volume == 0) return {};
  const N i = dot(cross(w, v), t) / volume, j = dot(cross(u, w), t) / volume, k = dot(cross(u, v), w) / volume;
  return {1 - i - j - k, i, j, k};
}

/// The part of the simplex, its last corner included, that has its point nearest to the origin inside.
template <class N>
struct NearestPart {
  SimplexOf<N> corners;
  PointOf<N> point;
  N squared = -1;
};

template <class N>
NearestPart<N> nearest_part(const SimplexOf<N>& s) {
  NearestPart<N> best;
  const std::size_t last = s.size() - 1;
  for (unsigned bits = 0; bits < 1U << last; ++bits) {
    SimplexOf<N> part;
    for (std::size_t i = 0; i < last; ++i)
      if ((bits >> i & 1U) != 0) part.push_back(s[i]);
    part.push_back(s[last]);
    const WeightsOf<N> weight = affine_weights(part);
    if (weight.empty() || std::any_of(weight.begin(), weight.end(), [](const N& w) { return w < 0; })) continue;
    PointOf<N> point{};
    if (part.size() < 4)
      for (std::size_t i = 0; i < part.size(); ++i) point = point + weight[i] * part[i];
    const N squared = dot(point, point);
    if (best.squared < 0 || squared < best.squared) best = {part, point, squared};
  }
  return best;
}

/// How far the origin is from the faces of a tetrahedron around it, at least.
template <class N>
N depth_within(const SimplexOf<N>& s) {
  N least = -1;
  for (std::size_t i = 0; i < 4; ++i) {
    const PointOf<N>&p = s[i], &q = s[(i + 1) % 4], &r = s[(i + 2) % 4];
    const PointOf<N> normal = cross(q - p, r - p);
    const N size = length(normal);
    if (size == 0) return 0;
    const N height = abs(dot(normal, p)) / size;
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

template <class N>
PointOf<N> farthest(const SetOf<N>& set, const PointOf<N>& d) {
  if (set.kind == FineKind::hull) return farthest_of_hull(set, d);
  const N along = dot(d, set.axis[2]);
  if (set.kind == FineKind::ellipsoid) {
    const N u = dot(d, set.axis[0]), v = dot(d, set.axis[1]), norm = sqrt(u * u + v * v + along * along);
    return set.centre + (u / norm) * set.axis[0] + (v / norm) * set.axis[1] + (along / norm) * set.axis[2];
  }
  const PointOf<N> rim = farthest_of_disc(set, d), top = set.centre + set.axis[2], bottom = set.centre - set.axis[2];
  if (set.kind == FineKind::cylinder) return rim + (along > 0 ? top : bottom);
  return dot(d, top) > dot(d, bottom + rim) ? top : bottom + rim;
}

template <class N>
NearnessOf<N> fine_nearness(const SetOf<N>& a, const SetOf<N>& b, double part, int most, PointOf<N> direction) {
  NearnessOf<N> found;
  found.upper = -1;
  NearestPart<N> now;
  for (int step = 0; step < most; ++step) {
    const PointOf<N> point = farthest(a, N(-1) * direction) - farthest(b, direction);
    const N lower = dot(point, direction) / length(direction);
    if (step == 0 || lower > found.lower) {
      found.lower = lower;
      found.direction = direction;
    }
    if (found.upper >= 0 && found.upper - found.lower <= N(part) * found.upper) break;
    SimplexOf<N> s = now.corners;
    s.push_back(point);
    const NearestPart<N> next = nearest_part(s);
    if (now.squared >= 0 && !(next.squared < now.squared)) break;
    now = next;
    found.upper = sqrt(now.squared);
    if (now.corners.size() == 4) {
      found.meet = true;
      found.depth = depth_within(now.corners);
      found.around = now.corners;
      found.upper = found.lower = 0;
      break;
    }
    if (now.squared == 0) break;
    direction = now.point;
  }
  if (found.lower < 0) found.lower = 0;
  return found;
}

template FinePoint farthest(const FineSet&, const FinePoint&);
template PointOf<long double> farthest(const SetOf<long double>&, const PointOf<long double>&);
template FineNearness fine_nearness(const FineSet&, const FineSet&, double, int, FinePoint);
template NearnessOf<long double> fine_nearness(const SetOf<long double>&, const SetOf<long double>&, double, int,
                                               PointOf<long double>);

}  // namespace toccata::oracle
