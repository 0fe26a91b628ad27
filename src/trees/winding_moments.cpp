#include "trees/winding_moments.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>

#include "math/constants.hpp"
#include "math/vec3_measures.hpp"

namespace toccata {
namespace {

constexpr std::array<std::array<std::size_t, 2>, 6> pairs{{{0, 0}, {1, 1}, {2, 2}, {0, 1}, {1, 2}, {2, 0}}};
constexpr std::array<std::array<std::size_t, 3>, 10> triples{
    {{0, 0, 0}, {1, 1, 1}, {2, 2, 2}, {0, 0, 1}, {0, 0, 2}, {1, 1, 0}, {1, 1, 2}, {2, 2, 0}, {2, 2, 1}, {0, 1, 2}}};
/// Where the pair (i, j) is.
constexpr std::array<std::array<std::size_t, 3>, 3> pair_at{{{0, 3, 5}, {3, 1, 4}, {5, 4, 2}}};

std::array<double, 3> components(const Vec3& v) { return {v.x, v.y, v.z}; }

// Upper bounds are rounded, too: a little is added to each.
constexpr double upward = 1 + 0x1p-44;
// Corners lie within 2 of the tree's origin, and to take that off them rounds a coordinate by 2⁻⁵³ of it at most.
constexpr double of_corners = 0x1p-50;

/// The moments of a triangle, around its middle.
WindingMoments moments_of_triangle(const std::array<Vec3, 3>& t) {
  WindingMoments m;
  const Vec3 u = t[1] - t[0], v = t[2] - t[0], w = t[2] - t[1];
  const Vec3 area = 0.5 * cross(u, v);
  m.centre = (1.0 / 3) * ((t[0] + t[1]) + t[2]);
  m.first = components(area);
  std::array<double, 6> covariance{};
  for (const Vec3& corner : t) {
    const Vec3 d = corner - m.centre;
    const auto at = components(d);
    for (std::size_t k = 0; k < pairs.size(); ++k) covariance[k] += at[pairs[k][0]] * at[pairs[k][1]] / 12;
    m.radius = std::max(m.radius, plain_length(d));
  }
  for (std::size_t k = 0; k < triples.size(); ++k) {
    const auto [a, b, c] = triples[k];
    m.third[k] = (m.first[a] * covariance[pair_at[b][c]] + m.first[b] * covariance[pair_at[a][c]] +
                  m.first[c] * covariance[pair_at[a][b]]) /
                 3;
  }
  m.radius = upward * m.radius + of_corners;
  m.size = upward * (plain_length(u) * plain_length(v));
  m.area = upward * (plain_length(area) + 0x1p-49 * m.size);
  m.spread = upward * m.area * ((covariance[0] + covariance[1]) + covariance[2]);
  m.perimeter = upward * ((plain_length(u) + plain_length(v)) + plain_length(w));
  m.triangles = m.levels = 1;
  return m;
}

/// Adds what another surface is, seen from the first one's centre.
void add(WindingMoments& to, const WindingMoments& from) {
  const Vec3 way = from.centre - to.centre;
  const auto h = components(way);
  for (std::size_t k = 0; k < 3; ++k) to.first[k] += from.first[k];
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    const auto [i, j] = pairs[k];
    to.second[k] += from.second[k] + 0.5 * (from.first[i] * h[j] + from.first[j] * h[i]);
  }
  for (std::size_t n = 0; n < triples.size(); ++n) {
    const auto [i, j, k] = triples[n];
    const double once =
        from.second[pair_at[i][j]] * h[k] + from.second[pair_at[j][k]] * h[i] + from.second[pair_at[k][i]] * h[j];
    const double twice = from.first[i] * (h[j] * h[k]) + from.first[j] * (h[i] * h[k]) + from.first[k] * (h[i] * h[j]);
    to.third[n] += from.third[n] + (2 * once + twice) / 3;
  }
  const double distance = plain_length(way);
  to.radius = std::max(to.radius, upward * (distance + from.radius) + of_corners);
  const double lean = plain_length(from.lean) + 0x1p-40 * from.size * from.radius;
  to.spread = upward * (to.spread + (from.spread + distance * (2 * lean + distance * from.area)));
  to.lean = to.lean + (from.lean + from.area * way);
  to.area = upward * (to.area + from.area);
  to.size = upward * (to.size + from.size);
  to.perimeter = upward * (to.perimeter + from.perimeter);
  to.triangles += from.triangles;
  to.levels = std::max(to.levels, from.levels + 1);
}

/// The middle of the surfaces, by area; of such without any, of their centres.
Vec3 common_centre(std::span<const WindingMoments> parts) {
  Vec3 sum, plain;
  double area = 0;
  for (const WindingMoments& part : parts) {
    sum = sum + part.area * part.centre;
    plain = plain + part.centre;
    area += part.area;
  }
  const Vec3 centre = (1 / area) * sum;
  return is_finite(centre) ? centre : (1.0 / static_cast<double>(parts.size())) * plain;
}

/// How far from the centre the boxes of the block reach.
double reach(const WideBlock& block, const Vec3& centre) {
  Vec3 farthest;
  for (std::size_t lane = 0; lane < block.count; ++lane)
    for (int axis = 0; axis < 3; ++axis) {
      const auto i = static_cast<std::size_t>(axis);
      const double off = std::abs(double{block.centre[i][lane]} - centre[axis]) + double{block.extent[i][lane]};
      farthest[axis] = std::max(farthest[axis], off);
    }
  return upward * plain_length(farthest) + of_corners;
}

/// The corners of the triangle, scaled first: a difference may be too large for doubles.
std::array<Vec3, 3> corners_of(const WideBvh& tree, const TriangleMesh& mesh, Index triangle) {
  const double inverse = 1 / tree.unit;
  const Vec3 origin = inverse * tree.origin;
  std::array<Vec3, 3> corners;
  for (std::size_t i = 0; i < 3; ++i) corners[i] = inverse * mesh.vertices()[mesh.triangles()[triangle][i]] - origin;
  return corners;
}

}  // namespace

std::vector<WindingMoments> winding_moments(const WideBvh& tree, const TriangleMesh& mesh) {
  std::vector<WindingMoments> all(tree.blocks.size());
  // Children come after their parents.
  for (std::size_t number = all.size(); number-- > 0;) {
    const WideBlock& block = tree.blocks[number];
    std::array<WindingMoments, WideBlock::width> lanes;
    for (std::size_t lane = 0; lane < block.count; ++lane)
      lanes[lane] = block.is_item(lane)
                        ? moments_of_triangle(corners_of(tree, mesh, tree.items[block.item_place(lane)]))
                        : all[static_cast<std::size_t>(block.child[lane])];
    const std::span<const WindingMoments> parts(lanes.data(), block.count);
    all[number].centre = common_centre(parts);
    for (const WindingMoments& part : parts) add(all[number], part);
    all[number].radius = std::min(all[number].radius, reach(block, all[number].centre));
  }
  return all;
}

WindingPart winding_part(const WindingMoments& m, const Vec3& point, double off) {
  constexpr double quarter_of_pi_inverse = 0x1.45f306dc9c883p-4;  // 1 / (4π)
  const Vec3 r = m.centre - point;
  const double squared = dot(r, r), distance = std::sqrt(squared);
  // The radius of the sphere around the centre, with all that may be off.
  const double radius = upward * m.radius + 2 * off, gap = distance * (1 - 0x1p-44) - radius;
  if (!(gap > 4 * off) || !(gap > 0x1p-10 * distance)) return {0, infinity};

  const double inverse = 1 / distance, x = r.x * inverse, y = r.y * inverse, z = r.z * inverse;
  const auto& [xx, yy, zz, xy, yz, zx] = m.second;
  const auto& s = m.third;
  const double none = (m.first[0] * x + m.first[1] * y) + m.first[2] * z;
  const double along = ((xx * x * x + yy * y * y) + zz * z * z) + 2 * ((xy * x * y + yz * y * z) + zx * z * x);
  const double one = ((xx + yy) + zz) - 3 * along;
  const double traced = ((s[0] + s[5] + s[7]) * x + (s[1] + s[3] + s[8]) * y) + (s[2] + s[4] + s[6]) * z;
  const double cubic =
      ((s[0] * x * x * x + s[1] * y * y * y) + s[2] * z * z * z) +
      3 * (((s[3] * y + s[4] * z) * x * x + (s[5] * x + s[6] * z) * y * y) + (s[7] * x + s[8] * y) * z * z) +
      6 * s[9] * x * y * z;
  const double two = 7.5 * cubic - 4.5 * traced;
  const double scale = quarter_of_pi_inverse * inverse * inverse;
  const double value = scale * (none + inverse * (one + inverse * two));

  // The rest of the series; what was rounded; and what moves when points do.
  const double ratio = radius * inverse, left = gap * inverse, of_left = 1 / (left * left);
  const double rest = m.spread * inverse * inverse * ratio * (4 - 3 * ratio) * of_left;
  const double rounded = 0x1p-44 * (m.levels + 4) * m.size * of_left;
  const double moved = off * (m.perimeter + 6 * off * m.triangles) * of_left;
  return {value, upward * scale * ((rest + rounded) + moved)};
}

}  // namespace toccata
