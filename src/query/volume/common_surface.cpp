#include "query/volume/common_surface.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <span>
#include <utility>

#include "math/vec3_measures.hpp"
#include "shapes/cut_loops.hpp"
#include "shapes/union_find.hpp"

namespace toccata {
namespace {

/// A directed edge of the surface that is being made, by its vertices.
using SurfaceEdge = std::array<Index, 2>;
/// An edge of a mesh, as its graph numbers the ends: the lesser first.
using MeshEdge = std::array<Index, 2>;
using CornerNumbers = std::array<Index, 3>;

/// The vertices of the surface, those of equal coordinates taken as one.
class SurfaceVertices {
 public:
  Index at(const Vec3& p) {
    const auto [found, is_new] = numbers_.try_emplace({p.x, p.y, p.z}, static_cast<Index>(positions_.size()));
    if (is_new) positions_.push_back(p);
    return found->second;
  }
  [[nodiscard]] const Vec3& position(Index vertex) const { return positions_[vertex]; }
  [[nodiscard]] const std::vector<Vec3>& positions() const { return positions_; }

 private:
  std::map<std::array<double, 3>, Index> numbers_;
  std::vector<Vec3> positions_;
};

/// Where a mesh edge enters or leaves the other solid.
struct EdgeCrossing {
  DoubleWord share;  ///< of the way from the lesser end
  Index vertex = 0;
  bool enters = false;
};

/// One of the two surfaces, and what of it bounds what both solids have in common.
struct CutSurface {
  VolumeSurface& surface;
  int own_winding = 0;
  int other_winding = 0;
  std::map<MeshEdge, std::vector<EdgeCrossing>> crossings{};
  std::map<MeshEdge, std::vector<SurfaceEdge>> inner_parts{};  ///< of edges, from the lesser end on
  std::map<Index, std::vector<SurfaceEdge>> borders{};         ///< of triangles, where the other's cross them
};

MeshEdge edge_of(const CornerNumbers& corners, std::size_t i) {
  const auto [low, high] = std::minmax(corners[i], corners[(i + 1) % 3]);
  return {low, high};
}

int axis_most_along(const Triangle& t) {
  const Vec3 normal = cross(t[1] - t[0], t[2] - t[0]);
  int axis = 2;
  for (const int other : {1, 0})
    if (std::abs(normal[other]) > std::abs(normal[axis])) axis = other;
  return axis;
}

/// Without those that lead back the way of others, and without those that lead nowhere.
std::vector<SurfaceEdge> uncancelled(const std::vector<SurfaceEdge>& edges) {
  std::map<SurfaceEdge, int> counts;
  for (const auto& [from, to] : edges)
    if (from != to) counts[{std::min(from, to), std::max(from, to)}] += from < to ? 1 : -1;
  std::vector<SurfaceEdge> left;
  for (const auto& [edge, count] : counts)
    for (int i = 0; i < std::abs(count); ++i) left.push_back(count > 0 ? edge : SurfaceEdge{edge[1], edge[0]});
  return left;
}

EnclosedVolume enclosed_by(std::span<const Vec3> vertices, std::span<const CornerNumbers> triangles) {
  EnclosedVolume enclosed;
  if (triangles.empty()) return enclosed;
  const Vec3 origin = vertices[triangles[0][0]];
  double area = 0, reach = 0, extent = 0;
  for (const CornerNumbers& t : triangles) {
    const Vec3 p = vertices[t[0]] - origin, q = vertices[t[1]] - origin, r = vertices[t[2]] - origin;
    enclosed.volume += dot(p, cross(q, r)) / 6;
    area += plain_length(cross(q - p, r - p)) / 2;
    for (const Index corner : t) {
      reach = std::max(reach, largest_magnitude(vertices[corner]));
      extent = std::max(extent, largest_magnitude(vertices[corner] - origin));
    }
  }
  constexpr double rounding = 0x1p-51;  // of a vertex, and of the sum, in which most is of both signs
  enclosed.error = rounding * area * (reach + extent);
  return enclosed;
}

class SurfaceMaker {
 public:
  SurfaceMaker(CrossedSurfaces& surfaces, int winding_of_first, int winding_of_second)
      : surfaces_(surfaces),
        sides_{CutSurface{surfaces.first, winding_of_first, winding_of_second},
               CutSurface{surfaces.second, winding_of_second, winding_of_first}} {}

  [[nodiscard]] std::optional<ClosedSurface> made() {
    for (const CrossingPair& pair : surfaces_.pairs) add_crossing(pair);
    for (CutSurface& side : sides_) {
      add_whole(side);
      for (const Index number : side.surface.in_contact())
        if (!cut(side, number)) return {};
    }
    drop_cancelled();
    if (!is_closed()) return {};
    drop_flat_pieces();
    return compact();
  }

 private:
  /// The segment that two triangles have in common: a part of the border of what of each is inside the other.
  void add_crossing(const CrossingPair& pair) {
    const Triangle a = surfaces_.first.triangle(pair.of_first), b = surfaces_.second.triangle(pair.of_second);
    SurfaceEdge segment{};  // from its tail to its head, the inside of the second to its left on the first
    see_edges(sides_[0], pair.of_first, pair.of_second, b, pair.through.of_first,
              [&](Index vertex, int through) { segment[through > 0 ? 1 : 0] = vertex; });
    see_edges(sides_[1], pair.of_second, pair.of_first, a, pair.through.of_second,
              [&](Index vertex, int through) { segment[through > 0 ? 0 : 1] = vertex; });
    const SurfaceEdge back{segment[1], segment[0]};
    sides_[0].borders[pair.of_first].push_back(sides_[0].other_winding > 0 ? segment : back);
    sides_[1].borders[pair.of_second].push_back(sides_[1].other_winding > 0 ? back : segment);
  }

  template <class See>
  void see_edges(CutSurface& side, Index triangle, Index passed, const Triangle& plane,
                 const std::array<int, 3>& through, const See& see) {
    const CornerNumbers corners = side.surface.graph().corners(triangle);
    for (std::size_t i = 0; i < 3; ++i) {
      if (through[i] == 0) continue;
      const MeshEdge edge = edge_of(corners, i);
      const int upwards = edge[0] == corners[i] ? through[i] : -through[i];
      see(crossing_at({side.surface.side(), edge, passed}, plane, upwards * side.other_winding > 0, side), through[i]);
    }
  }

  [[nodiscard]] Index crossing_at(const EdgePass& pass, const Triangle& plane, bool enters, CutSurface& side) {
    const auto [found, is_new] = passes_.try_emplace(pass, 0);
    if (!is_new) return found->second;
    const VertexGraph& graph = side.surface.graph();
    const Vec3 &from = graph.position(pass.edge[0]), &to = graph.position(pass.edge[1]);
    const BoundedNumber share = share_at_plane(plane, from, to);
    const Vec3 position = high_parts(exactly(from) + share * bounded_difference(to, from));
    found->second = vertices_.at(position);
    side.crossings[pass.edge].push_back({share.value, found->second, enters});
    return found->second;
  }

  [[nodiscard]] Index vertex_of(CutSurface& side, Index corner) {
    return vertices_.at(side.surface.graph().position(corner));
  }

  void add_whole(CutSurface& side) {
    for (const auto& [number, winding] : side.surface.whole_triangles()) {
      CornerNumbers t = side.surface.graph().corners(number);
      for (Index& corner : t) corner = vertex_of(side, corner);
      add_triangle(side, t);
    }
  }

  void add_triangle(const CutSurface& side, const CornerNumbers& t) {
    if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0]) return;
    triangles_.push_back(side.own_winding > 0 ? t : CornerNumbers{t[0], t[2], t[1]});
  }

  /// The parts of an edge that are inside the other solid. Crossings too near each other for their order to be known
  /// are taken in and out in turn. Nothing where that cannot be.
  [[nodiscard]] const std::vector<SurfaceEdge>* inner_parts(CutSurface& side, const MeshEdge& edge) {
    const auto [found, is_new] = side.inner_parts.try_emplace(edge);
    if (!is_new) return &found->second;
    std::vector<EdgeCrossing> crossings = side.crossings[edge];
    std::stable_sort(crossings.begin(), crossings.end(), [](const EdgeCrossing& a, const EdgeCrossing& b) {
      return std::pair(a.share.high, a.share.low) < std::pair(b.share.high, b.share.low);
    });
    bool is_inside = side.surface.winding_at(edge[0]) != 0;
    Index from = vertex_of(side, edge[0]);
    while (!crossings.empty()) {
      const auto next =
          std::find_if(crossings.begin(), crossings.end(), [&](const auto& c) { return c.enters != is_inside; });
      if (next == crossings.end()) return nullptr;
      if (is_inside) found->second.push_back({from, next->vertex});
      from = next->vertex;
      is_inside = !is_inside;
      crossings.erase(next);
    }
    if (is_inside != (side.surface.winding_at(edge[1]) != 0)) return nullptr;
    if (is_inside) found->second.push_back({from, vertex_of(side, edge[1])});
    return &found->second;
  }

  /// What of a triangle in contact is inside. False where it cannot be cut.
  [[nodiscard]] bool cut(CutSurface& side, Index number) {
    std::vector<SurfaceEdge> edges = side.borders[number];
    const CornerNumbers corners = side.surface.graph().corners(number);
    for (std::size_t i = 0; i < 3; ++i) {
      const MeshEdge edge = edge_of(corners, i);
      const std::vector<SurfaceEdge>* parts = inner_parts(side, edge);
      if (parts == nullptr) return false;
      for (const auto& [from, to] : *parts)
        edges.push_back(edge[0] == corners[i] ? SurfaceEdge{from, to} : SurfaceEdge{to, from});
    }
    edges = uncancelled(edges);
    return edges.empty() || cut_face(side, side.surface.triangle(number), edges);
  }

  [[nodiscard]] bool cut_face(const CutSurface& side, const Triangle& t, std::span<const SurfaceEdge> edges) {
    const int axis = axis_most_along(t);
    const bool is_mirrored =
        orient2d(drop_axis(t[0], axis), drop_axis(t[1], axis), drop_axis(t[2], axis)) == Sign::negative;
    std::map<Index, Index> local;  // which vertices the face has
    std::vector<Index> own;
    std::vector<Vec2> points;
    std::vector<SurfaceEdge> ways;
    for (SurfaceEdge edge : edges) {
      for (Index& end : edge) {
        const auto [found, is_new] = local.try_emplace(end, static_cast<Index>(points.size()));
        if (is_new) {
          const Vec2 p = drop_axis(vertices_.position(end), axis);
          points.push_back(is_mirrored ? Vec2{p.y, p.x} : p);
          own.push_back(end);
        }
        end = found->second;
      }
      ways.push_back(edge);
    }
    const auto add = [&](const CornerNumbers& c) { add_triangle(side, {own[c[0]], own[c[1]], own[c[2]]}); };
    std::vector<CornerLoop> loops = loops_of_edges(points, ways);
    if (loops.empty()) return false;
    std::erase_if(loops, [&](const CornerLoop& loop) {
      if (std::abs(loop_area(points, loop)) > negligible_area(points)) return false;
      for (std::size_t i = 1; i + 1 < loop.size(); ++i) add({loop[0], loop[i], loop[i + 1]});
      return true;
    });
    const auto triangles = cut_loops(points, loops, 0x1p6 * negligible_area(points));
    if (!triangles) return false;
    for (const CornerNumbers& c : *triangles) add(c);
    return true;
  }

  /// Less than rounding the points may have made of nothing.
  static double negligible_area(std::span<const Vec2> points) {
    double reach = 0, extent = 0;
    for (const Vec2& p : points) {
      reach = std::max({reach, std::abs(p.x), std::abs(p.y)});
      extent = std::max({extent, std::abs(p.x - points[0].x), std::abs(p.y - points[0].y)});
    }
    return 0x1p-50 * reach * extent;
  }

  /// Two triangles of the same corners, the one seen from behind, are nothing.
  void drop_cancelled() {
    std::map<CornerNumbers, int> counts;  // by the corners ascending
    const auto turned = [](const CornerNumbers& t) {
      CornerNumbers sorted = t;
      std::sort(sorted.begin(), sorted.end());
      const int rises = (t[0] < t[1] ? 1 : 0) + (t[1] < t[2] ? 1 : 0) + (t[2] < t[0] ? 1 : 0);
      return std::pair(sorted, rises == 2);
    };
    for (const CornerNumbers& t : triangles_) {
      const auto [corners, is_even] = turned(t);
      counts[corners] += is_even ? 1 : -1;
    }
    std::vector<CornerNumbers> left;
    for (const CornerNumbers& t : triangles_) {
      const auto [corners, is_even] = turned(t);
      int& count = counts[corners];
      if (count == 0 || (count > 0) != is_even) continue;
      count += is_even ? -1 : 1;
      left.push_back(t);
    }
    triangles_ = std::move(left);
  }

  [[nodiscard]] bool is_closed() const {
    std::vector<SurfaceEdge> edges;
    for (const CornerNumbers& t : triangles_)
      for (std::size_t i = 0; i < 3; ++i) edges.push_back({t[i], t[(i + 1) % 3]});
    std::sort(edges.begin(), edges.end());
    std::vector<SurfaceEdge> back;
    for (const auto& [from, to] : edges) back.push_back({to, from});
    std::sort(back.begin(), back.end());
    return edges == back;
  }

  void drop_flat_pieces() {
    UnionFind joined(vertices_.positions().size());
    for (const CornerNumbers& t : triangles_) {
      joined.unite(t[0], t[1]);
      joined.unite(t[0], t[2]);
    }
    std::map<Index, ClosedSurface> pieces;  // by a vertex
    for (const CornerNumbers& t : triangles_) pieces[joined.leader(t[0])].triangles.push_back(t);
    std::map<Index, bool> is_flat;
    for (auto& [leader, piece] : pieces) {
      const EnclosedVolume enclosed = enclosed_by(vertices_.positions(), piece.triangles);
      is_flat[leader] = !(enclosed.volume > enclosed.error);
    }
    std::erase_if(triangles_, [&](const CornerNumbers& t) { return is_flat[joined.leader(t[0])]; });
  }

  [[nodiscard]] ClosedSurface compact() const {
    ClosedSurface surface;
    std::map<Index, Index> numbers;
    for (CornerNumbers t : triangles_) {
      for (Index& corner : t) {
        const auto [found, is_new] = numbers.try_emplace(corner, static_cast<Index>(surface.vertices.size()));
        if (is_new) surface.vertices.push_back(vertices_.position(corner));
        corner = found->second;
      }
      surface.triangles.push_back(t);
    }
    return surface;
  }

  CrossedSurfaces& surfaces_;
  std::array<CutSurface, 2> sides_;
  SurfaceVertices vertices_;
  std::map<EdgePass, Index> passes_;
  std::vector<CornerNumbers> triangles_;
};

}  // namespace

std::optional<ClosedSurface> common_surface(CrossedSurfaces& surfaces, int winding_of_first, int winding_of_second) {
  return SurfaceMaker(surfaces, winding_of_first, winding_of_second).made();
}

EnclosedVolume enclosed_volume(const ClosedSurface& surface) {
  return enclosed_by(surface.vertices, surface.triangles);
}

}  // namespace toccata
