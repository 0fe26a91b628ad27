#include "trees/oriented_boxes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <utility>

#include "math/constants.hpp"
#include "math/floats.hpp"

namespace toccata {
namespace {

using TriangleCorners = std::array<Vec3, 3>;
using Axes = std::array<Vec3, 3>;

/// The area of a surface, and its first and second moments.
struct SurfaceMoments {
  double area = 0;
  Vec3 first;
  std::array<double, 6> second{};  ///< xx, yy, zz, xy, yz, zx

  SurfaceMoments& operator+=(const SurfaceMoments& other) {
    area += other.area;
    first = first + other.first;
    for (std::size_t i = 0; i < 6; ++i) second[i] += other.second[i];
    return *this;
  }
};

std::array<double, 6> products(const Vec3& v) {
  return {v.x * v.x, v.y * v.y, v.z * v.z, v.x * v.y, v.y * v.z, v.z * v.x};
}

SurfaceMoments moments_of(const TriangleCorners& t) {
  // Triangles without area count a little, so that a mesh of such has principal axes too.
  constexpr double of_a_point = 1e-30;
  const Vec3 normal = cross(t[1] - t[0], t[2] - t[0]);
  const double area = 0.5 * std::sqrt(dot(normal, normal)) + of_a_point;
  const Vec3 middle = (1.0 / 3) * ((t[0] + t[1]) + t[2]);
  SurfaceMoments m{area, area * middle};
  const auto of_middle = products(middle), p = products(t[0]), q = products(t[1]), r = products(t[2]);
  for (std::size_t i = 0; i < 6; ++i) m.second[i] = area / 12 * (9 * of_middle[i] + ((p[i] + q[i]) + r[i]));
  return m;
}

struct SymmetricMatrix {
  std::array<std::array<double, 3>, 3> value;
};

SymmetricMatrix covariance(const SurfaceMoments& m) {
  const Vec3 mean = (1 / m.area) * m.first;
  const auto of_mean = products(mean);
  std::array<double, 6> c;
  for (std::size_t i = 0; i < 6; ++i) c[i] = m.second[i] / m.area - of_mean[i];
  return {{{{c[0], c[3], c[5]}, {c[3], c[1], c[4]}, {c[5], c[4], c[2]}}}};
}

/// Makes the element (p, q) zero by turning these two axes.
void turn(SymmetricMatrix& m, Axes& axes, std::size_t p, std::size_t q) {
  auto& a = m.value;
  if (a[p][q] == 0) return;
  const double theta = (a[q][q] - a[p][p]) / (2 * a[p][q]);
  const double t = (theta >= 0 ? 1 : -1) / (std::fabs(theta) + std::sqrt(theta * theta + 1));
  const double c = 1 / std::sqrt(t * t + 1), s = t * c;
  const std::size_t r = 3 - p - q;
  a[p][p] -= t * a[p][q];
  a[q][q] += t * a[p][q];
  a[p][q] = a[q][p] = 0;
  const double rp = a[r][p], rq = a[r][q];
  a[r][p] = a[p][r] = c * rp - s * rq;
  a[r][q] = a[q][r] = s * rp + c * rq;
  const Vec3 axis_p = axes[p], axis_q = axes[q];
  axes[p] = c * axis_p - s * axis_q;
  axes[q] = s * axis_p + c * axis_q;
}

/// The eigenvectors, that of the greatest eigenvalue first (C. Jacobi, "Über ein leichtes Verfahren …", 1846).
Axes jacobi_axes(SymmetricMatrix m) {
  Axes axes{Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}};
  constexpr int sweeps = 6;
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    turn(m, axes, 0, 1);
    turn(m, axes, 1, 2);
    turn(m, axes, 0, 2);
  }
  std::array<std::size_t, 3> order{0, 1, 2};
  std::sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) { return m.value[i][i] > m.value[j][j]; });
  return {axes[order[0]], axes[order[1]], axes[order[2]]};
}

/// The vector scaled to length 1, or something at right angles to `other` where there is no direction.
Vec3 unit_or_across(const Vec3& v, const Vec3& other) {
  const double length = std::sqrt(dot(v, v));
  if (length > 0 && std::isfinite(length)) return (1 / length) * v;
  const Vec3 least = std::fabs(other.x) < 0.6 ? Vec3{1, 0, 0} : Vec3{0, 1, 0};
  const Vec3 across = cross(other, least);
  const double size = std::sqrt(dot(across, across));
  return size > 0 ? (1 / size) * across : Vec3{1, 0, 0};
}

/// The box along two directions, orthonormal up to rounding of doubles, around the corners of some triangles.
OrientedBox fit(const Vec3& first, const Vec3& second, std::span<const TriangleCorners> triangles) {
  OrientedBox box;
  box.axis = {as_floats(first), as_floats(second)};
  const Axes axes{as_doubles(box.axis[0]), as_doubles(box.axis[1]),
                  cross(as_doubles(box.axis[0]), as_doubles(box.axis[1]))};
  std::array<double, 3> low{infinity, infinity, infinity}, high{-infinity, -infinity, -infinity};
  for (const TriangleCorners& corners : triangles)
    for (const Vec3& corner : corners)
      for (std::size_t k = 0; k < 3; ++k) {
        const double at = dot(axes[k], corner);
        low[k] = std::min(low[k], at);
        high[k] = std::max(high[k], at);
      }
  Vec3 centre;
  for (std::size_t k = 0; k < 3; ++k) centre = centre + (0.5 * (low[k] + high[k])) * axes[k];
  box.centre = as_floats(centre);
  centre = as_doubles(box.centre);
  double largest = 0;
  std::array<double, 3> reach{};
  for (std::size_t k = 0; k < 3; ++k) {
    const double at = dot(axes[k], centre);
    reach[k] = std::max(high[k] - at, at - low[k]);
    largest = std::max(largest, reach[k]);
  }
  // That the axes are not quite orthonormal: docs/methods/mesh-distance.md. Coordinates are at most 2, so what doubles
  // round is far below the last term.
  for (std::size_t k = 0; k < 3; ++k) box.extent[k] = up_to_float(reach[k] + 0x1p-19 * largest + 0x1p-48);
  return box;
}

OrientedBox fit(const SurfaceMoments& moments, std::span<const TriangleCorners> triangles) {
  const Axes axes = jacobi_axes(covariance(moments));
  const Vec3 first = unit_or_across(axes[0], {0, 0, 1});
  return fit(first, unit_or_across(axes[1] - dot(axes[1], first) * first, first), triangles);
}

/// Along the longest edge, and across it in the triangle's plane.
OrientedBox fit(const TriangleCorners& t) {
  const std::array<Vec3, 3> edges{t[1] - t[0], t[2] - t[1], t[0] - t[2]};
  const Vec3 longest =
      *std::max_element(edges.begin(), edges.end(), [](const Vec3& u, const Vec3& v) { return dot(u, u) < dot(v, v); });
  const Vec3 first = unit_or_across(longest, {0, 0, 1});
  const Vec3 normal = unit_or_across(cross(edges[0], edges[1]), first);
  return fit(first, unit_or_across(cross(normal, first), first), {&t, 1});
}

/// The places that a block's items have; they lie side by side.
struct Run {
  std::size_t first = std::numeric_limits<std::size_t>::max();
  std::size_t end = 0;
  SurfaceMoments moments;

  void add(const Run& other) {
    first = std::min(first, other.first);
    end = std::max(end, other.end);
    moments += other.moments;
  }
};

std::vector<TriangleCorners> corners_in_order(const WideBvh& tree, const TriangleMesh& mesh) {
  std::vector<TriangleCorners> corners;
  corners.reserve(tree.items.size());
  const double inverse = 1 / tree.unit;
  const Vec3 origin = inverse * tree.origin;
  // Scaled first: a difference may be too large for doubles.
  const auto in_units = [&](Index vertex) { return inverse * mesh.vertices()[vertex] - origin; };
  for (const Index item : tree.items) {
    const auto& triangle = mesh.triangles()[item];
    corners.push_back({in_units(triangle[0]), in_units(triangle[1]), in_units(triangle[2])});
  }
  return corners;
}

class Maker {
 public:
  Maker(const WideBvh& tree, const TriangleMesh& mesh)
      : tree_(tree), corners_(corners_in_order(tree, mesh)), runs_(tree.blocks.size()), boxes_(tree.blocks.size()) {}

  std::vector<OrientedBlock> boxes() {
    // Children come after their parents.
    for (std::size_t block = tree_.blocks.size(); block-- > 0;) make(block);
    return std::move(boxes_);
  }

 private:
  void make(std::size_t number) {
    const WideBlock& block = tree_.blocks[number];
    OrientedBlock& boxes = boxes_[number];
    boxes.child = block.child;
    boxes.count = block.count;
    for (std::size_t lane = 0; lane < block.count; ++lane) {
      const Run run = run_of(block, lane);
      const auto triangles = std::span(corners_).subspan(run.first, run.end - run.first);
      set_lane(boxes, lane, block.is_item(lane) ? fit(triangles[0]) : fit(run.moments, triangles));
      runs_[number].add(run);
    }
    for (std::size_t lane = block.count; lane < OrientedBlock::width; ++lane) set_lane(boxes, lane, {});
  }

  Run run_of(const WideBlock& block, std::size_t lane) const {
    if (!block.is_item(lane)) return runs_[static_cast<std::size_t>(block.child[lane])];
    const auto place = block.item_place(lane);
    return {place, place + 1, moments_of(corners_[place])};
  }

  const WideBvh& tree_;
  std::vector<TriangleCorners> corners_;
  std::vector<Run> runs_;
  std::vector<OrientedBlock> boxes_;
};

}  // namespace

void set_lane(OrientedBlock& block, std::size_t lane, const OrientedBox& box) {
  for (std::size_t i = 0; i < 3; ++i) {
    block.centre[i][lane] = box.centre[i];
    block.axis[0][i][lane] = box.axis[0][i];
    block.axis[1][i][lane] = box.axis[1][i];
    block.extent[i][lane] = box.extent[i];
  }
}

std::vector<OrientedBlock> oriented_boxes(const WideBvh& tree, const TriangleMesh& mesh) {
  return Maker(tree, mesh).boxes();
}

}  // namespace toccata
