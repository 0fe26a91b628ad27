#include "toccata/shapes/close_mesh.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <numeric>
#include <utility>
#include <vector>

#include "shapes/union_find.hpp"
#include "shapes/welded_mesh.hpp"
#include "toccata/core/error.hpp"
#include "toccata/shapes/mesh_health.hpp"

namespace toccata {
namespace {

using TriangleList = std::vector<std::array<Index, 3>>;
using DirectedPair = std::array<Index, 2>;

constexpr Index no_vertex = std::numeric_limits<Index>::max();

/// The mesh with vertices of equal coordinates taken as one: of each the first of those.
struct WeldedPoints {
  std::vector<Vec3> points;
  TriangleList triangles;
  std::vector<Index> face_of_triangle;
  Index faces = 0;
};

WeldedPoints welded_points(const TriangleMesh& mesh) {
  const WeldedTriangles welded = weld(mesh);
  WeldedPoints result{std::vector<Vec3>(welded.distinct_vertices), welded.triangles, {}, mesh.face_count()};
  for (std::size_t t = 0; t < welded.triangles.size(); ++t) {
    for (std::size_t k = 0; k < 3; ++k) result.points[welded.triangles[t][k]] = mesh.vertices()[mesh.triangles()[t][k]];
    result.face_of_triangle.push_back(mesh.face_of(static_cast<Index>(t)));
  }
  return result;
}

bool has_equal_corners(const std::array<Index, 3>& t) { return t[0] == t[1] || t[1] == t[2] || t[2] == t[0]; }

/// What is missing for every edge to be used equally in both directions: each such use, once for each time.
std::vector<DirectedPair> missing_uses(const TriangleList& triangles) {
  std::vector<DirectedPair> uses;
  for (const auto& t : triangles)
    if (!has_equal_corners(t))
      for (std::size_t k = 0; k < 3; ++k) uses.push_back({t[k], t[(k + 1) % 3]});
  const auto key = [](const DirectedPair& use) {
    return std::array<Index, 3>{std::min(use[0], use[1]), std::max(use[0], use[1]),
                                use[0] > use[1] ? Index{1} : Index{0}};
  };
  std::sort(uses.begin(), uses.end(), [&](const DirectedPair& a, const DirectedPair& b) { return key(a) < key(b); });
  std::vector<DirectedPair> missing;
  for (std::size_t first = 0; first < uses.size();) {
    std::size_t end = first;
    std::ptrdiff_t upward = 0;
    for (; end < uses.size() && key(uses[end])[0] == key(uses[first])[0] && key(uses[end])[1] == key(uses[first])[1];
         ++end)
      upward += uses[end][0] < uses[end][1] ? 1 : -1;
    const Index low = key(uses[first])[0], high = key(uses[first])[1];
    for (; upward > 0; --upward) missing.push_back({high, low});
    for (; upward < 0; ++upward) missing.push_back({low, high});
    first = end;
  }
  return missing;
}

/// Points by the cells of a grid, each as wide as the distance that is asked about.
class PointGrid {
 public:
  PointGrid(const std::vector<Vec3>& points, double distance) : points_(points), distance_(distance) {}

  void add(Index point) { cells_[cell_of(points_[point])].push_back(point); }

  /// The nearest of those that were added within the distance, of several the first; else none.
  [[nodiscard]] Index nearest(const Vec3& place) const {
    const Cell middle = cell_of(place);
    Index best = no_vertex;
    double best_squared = distance_ * distance_;
    for (int dx = -1; dx <= 1; ++dx)
      for (int dy = -1; dy <= 1; ++dy)
        for (int dz = -1; dz <= 1; ++dz) {
          const auto found = cells_.find({middle[0] + dx, middle[1] + dy, middle[2] + dz});
          if (found == cells_.end()) continue;
          for (const Index point : found->second) {
            const Vec3 way = points_[point] - place;
            const double squared = dot(way, way);
            if (squared > best_squared || (squared == best_squared && point > best)) continue;
            best = point;
            best_squared = squared;
          }
        }
    return best;
  }

 private:
  using Cell = std::array<double, 3>;

  [[nodiscard]] Cell cell_of(const Vec3& p) const {
    return {std::floor(p.x / distance_), std::floor(p.y / distance_), std::floor(p.z / distance_)};
  }

  const std::vector<Vec3>& points_;
  double distance_;
  std::map<Cell, std::vector<Index>> cells_;
};

/// Moves vertices of the boundary onto others within the gap. Each goes to one that stays: so none moves farther.
void join_boundary(WeldedPoints& mesh, double gap, MeshRepair& repair) {
  std::vector<Index> boundary;
  for (const DirectedPair& use : missing_uses(mesh.triangles)) boundary.insert(boundary.end(), {use[0], use[1]});
  std::sort(boundary.begin(), boundary.end());
  boundary.erase(std::unique(boundary.begin(), boundary.end()), boundary.end());
  std::vector<Index> target(mesh.points.size());
  std::iota(target.begin(), target.end(), Index{0});
  PointGrid staying(mesh.points, gap);
  for (const Index vertex : boundary) {
    const Index near = staying.nearest(mesh.points[vertex]);
    if (near == no_vertex) {
      staying.add(vertex);
      continue;
    }
    target[vertex] = near;
    ++repair.moved_vertices;
  }
  WeldedPoints joined{std::move(mesh.points), {}, {}, mesh.faces};
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto& [a, b, c] = mesh.triangles[t];
    const std::array<Index, 3> moved{target[a], target[b], target[c]};
    // What had no area before is kept as it is.
    if (has_equal_corners(moved) && !has_equal_corners(mesh.triangles[t])) {
      ++repair.collapsed_triangles;
      continue;
    }
    joined.triangles.push_back(moved);
    joined.face_of_triangle.push_back(mesh.face_of_triangle[t]);
  }
  mesh = std::move(joined);
}

/// Simple loops of the missing uses: where several go on from a vertex, that which closes a loop first is cut off.
std::vector<std::vector<Index>> loops_of(const std::vector<DirectedPair>& missing, std::size_t& rest) {
  std::map<Index, std::vector<Index>> next;
  for (const DirectedPair& use : missing) next[use[0]].push_back(use[1]);
  for (auto& [from, targets] : next) std::sort(targets.rbegin(), targets.rend());
  std::vector<std::vector<Index>> loops;
  for (auto& [start, targets] : next)
    while (!targets.empty()) {
      std::vector<Index> path{start};
      std::map<Index, std::size_t> place{{start, 0}};
      for (Index at = start;;) {
        std::vector<Index>& onward = next[at];
        if (onward.empty()) {  // more uses come here than go on
          if (path.size() > 1) ++rest;
          break;
        }
        at = onward.back();
        onward.pop_back();
        const auto known = place.find(at);
        if (known == place.end()) {
          place[at] = path.size();
          path.push_back(at);
          continue;
        }
        loops.emplace_back(path.begin() + static_cast<std::ptrdiff_t>(known->second), path.end());
        for (std::size_t i = known->second + 1; i < path.size(); ++i) place.erase(path[i]);
        path.resize(known->second + 1);
        if (path.size() == 1) break;
      }
    }
  return loops;
}

/// The least height of a triangle: twice its area over its longest side.
double least_height(const Vec3& a, const Vec3& b, const Vec3& c) {
  const double longest = std::max({length(b - a), length(c - b), length(a - c)});
  return longest > 0 ? length(cross(b - a, c - a)) / longest : 0;
}

/// TriangleList that fill the loop, cut off by the shortest chord each time; none where one would be higher than the
/// gap everywhere.
TriangleList filling(std::vector<Index> loop, const std::vector<Vec3>& points, double gap) {
  TriangleList triangles;
  while (loop.size() > 2) {
    std::size_t best = 0;
    double shortest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const double chord = length(points[loop[(i + 2) % loop.size()]] - points[loop[i]]);
      if (chord < shortest) {
        shortest = chord;
        best = i;
      }
    }
    const std::size_t middle = (best + 1) % loop.size();
    const std::array<Index, 3> ear{loop[best], loop[middle], loop[(best + 2) % loop.size()]};
    if (least_height(points[ear[0]], points[ear[1]], points[ear[2]]) > gap) return {};
    triangles.push_back(ear);
    loop.erase(loop.begin() + static_cast<std::ptrdiff_t>(middle));
  }
  return triangles;
}

/// A loop that is longer would take time that grows with the square of its length.
constexpr std::size_t longest_loop = 5000;

void fill_holes(WeldedPoints& mesh, double gap, MeshRepair& repair) {
  const std::vector<std::vector<Index>> loops = loops_of(missing_uses(mesh.triangles), repair.open_holes);
  for (const std::vector<Index>& loop : loops) {
    if (loop.size() == 2) continue;  // there and back again is closed
    const TriangleList triangles = loop.size() > longest_loop ? TriangleList{} : filling(loop, mesh.points, gap);
    if (triangles.empty()) {
      ++repair.open_holes;
      continue;
    }
    ++repair.filled_holes;
    repair.added_triangles += triangles.size();
    for (const auto& triangle : triangles) {
      mesh.triangles.push_back(triangle);
      mesh.face_of_triangle.push_back(mesh.faces++);
    }
  }
}

/// With the vertices that triangles have.
TriangleMesh mesh_of(const WeldedPoints& welded) {
  std::vector<Index> number(welded.points.size(), no_vertex);
  std::vector<Vec3> vertices;
  TriangleList triangles = welded.triangles;
  for (auto& triangle : triangles)
    for (Index& corner : triangle) {
      if (number[corner] == no_vertex) {
        number[corner] = static_cast<Index>(vertices.size());
        vertices.push_back(welded.points[corner]);
      }
      corner = number[corner];
    }
  return {std::move(vertices), std::move(triangles), welded.face_of_triangle};
}

double diagonal_of(const TriangleMesh& mesh) {
  Vec3 lower = mesh.vertices()[mesh.triangles()[0][0]], upper = lower;
  for (const auto& triangle : mesh.triangles())
    for (const Index corner : triangle)
      for (int axis = 0; axis < 3; ++axis) {
        lower[axis] = std::min(lower[axis], mesh.vertices()[corner][axis]);
        upper[axis] = std::max(upper[axis], mesh.vertices()[corner][axis]);
      }
  return length(upper - lower);
}

}  // namespace

RepairedMesh close_mesh(const TriangleMesh& mesh, double gap) {
  if (!(gap > 0) || !std::isfinite(gap)) throw Error("a gap to close is a positive, finite length");
  if (is_closed(mesh)) return {mesh, {}, true};
  WeldedPoints welded = welded_points(mesh);
  MeshRepair repair;
  join_boundary(welded, gap, repair);
  if (welded.triangles.empty()) return {mesh, {}, false};  // all of it is narrower than the gap
  fill_holes(welded, gap, repair);
  TriangleMesh closed = mesh_of(welded);
  const bool is_now_closed = is_closed(closed);
  return {std::move(closed), repair, is_now_closed};
}

std::optional<double> closing_gap(const TriangleMesh& mesh) {
  if (is_closed(mesh)) return 0;
  const double diagonal = diagonal_of(mesh);
  if (!(diagonal > 0) || !std::isfinite(diagonal)) return std::nullopt;
  constexpr double least = 1e-9, greatest = 0.02;
  double part = least;
  while (part <= greatest) {
    if (close_mesh(mesh, part * diagonal).closed) return part * diagonal;
    part *= 2;
  }
  return std::nullopt;
}

std::size_t boundary_count(const TriangleMesh& mesh) {
  const WeldedPoints welded = welded_points(mesh);
  const std::vector<DirectedPair> missing = missing_uses(welded.triangles);
  UnionFind sets(welded.points.size());
  for (const DirectedPair& use : missing) sets.unite(use[0], use[1]);
  std::vector<Index> leaders;
  for (const DirectedPair& use : missing) leaders.push_back(sets.leader(use[0]));
  std::sort(leaders.begin(), leaders.end());
  return static_cast<std::size_t>(std::unique(leaders.begin(), leaders.end()) - leaders.begin());
}

}  // namespace toccata
