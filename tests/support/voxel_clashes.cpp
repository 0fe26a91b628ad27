#include "support/voxel_clashes.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <iterator>
#include <map>
#include <set>
#include <vector>

namespace toccata::test {
namespace {

Voxel stepped(Voxel voxel, int axis, int by) {
  voxel[static_cast<std::size_t>(axis)] += by;
  return voxel;
}

/// Things that are put together.
template <class Thing>
class Groups {
 public:
  void add(const Thing& thing) { leader_.try_emplace(thing, thing); }
  void unite(const Thing& x, const Thing& y) {
    add(x);
    add(y);
    leader_.at(leader(x)) = leader(y);
  }
  [[nodiscard]] Thing leader(Thing thing) const {
    while (leader_.at(thing) != thing) thing = leader_.at(thing);
    return thing;
  }

 private:
  std::map<Thing, Thing> leader_;
};

/// The voxels that have a face with another one of them in common are together.
Groups<Voxel> connected_voxels(const VoxelSolid& solid) {
  Groups<Voxel> groups;
  for (const Voxel& voxel : solid) {
    groups.add(voxel);
    for (int axis = 0; axis < 3; ++axis)
      if (solid.contains(stepped(voxel, axis, 1))) groups.unite(voxel, stepped(voxel, axis, 1));
  }
  return groups;
}

bool is_connected(const VoxelSolid& solid) {
  const Groups<Voxel> groups = connected_voxels(solid);
  return std::ranges::all_of(solid,
                             [&](const Voxel& voxel) { return groups.leader(voxel) == groups.leader(*solid.begin()); });
}

/// The eight voxels around a point that are in the solid, and those that are not, hang together by faces.
bool is_manifold_at(const VoxelSolid& solid, const Voxel& point) {
  VoxelSolid within, without;
  for (int i = 0; i < 8; ++i) {
    const Voxel voxel{point[0] - (i & 1), point[1] - (i >> 1 & 1), point[2] - (i >> 2)};
    (solid.contains(voxel) ? within : without).insert(voxel);
  }
  return is_connected(within) && is_connected(without);
}

/// An edge of the grid from a point along an axis, which has four voxels around it.
struct GridEdge {
  Voxel from{};
  int axis = 0;
  friend auto operator<=>(const GridEdge&, const GridEdge&) = default;
};

/// In cyclic order.
std::array<Voxel, 4> voxels_around(const GridEdge& edge) {
  const int u = (edge.axis + 1) % 3, v = (edge.axis + 2) % 3;
  return {edge.from, stepped(edge.from, u, -1), stepped(stepped(edge.from, u, -1), v, -1), stepped(edge.from, v, -1)};
}

bool is_manifold_along(const VoxelSolid& solid, const GridEdge& edge) {
  std::array<bool, 4> has{};
  std::ranges::transform(voxels_around(edge), has.begin(), [&](const Voxel& voxel) { return solid.contains(voxel); });
  return !(has[0] == has[2] && has[1] == has[3] && has[0] != has[1]);
}

bool is_manifold(const VoxelSolid& solid) {
  for (const Voxel& voxel : solid)
    for (int i = 0; i < 8; ++i) {
      const Voxel point{voxel[0] + (i & 1), voxel[1] + (i >> 1 & 1), voxel[2] + (i >> 2)};
      if (!is_manifold_at(solid, point)) return false;
      for (int axis = 0; axis < 3; ++axis)
        for (const int by : {0, -1})
          if (!is_manifold_along(solid, {stepped(point, axis, by), axis})) return false;
    }
  return true;
}

std::array<GridEdge, 4> edges_of(const GridFace& face) {
  const int u = (face.axis + 1) % 3, v = (face.axis + 2) % 3;
  return {GridEdge{face.lower, u}, GridEdge{face.lower, v}, GridEdge{stepped(face.lower, v, 1), u},
          GridEdge{stepped(face.lower, u, 1), v}};
}

/// The squares of a solid's surface that lie within another solid; those that share an edge are one piece.
struct InnerSurface {
  InnerSurface(const VoxelSolid& solid, const VoxelSolid& other) {
    for (const Voxel& voxel : solid)
      for (int axis = 0; axis < 3; ++axis)
        for (const int side : {0, 1}) {
          const Voxel across = stepped(voxel, axis, side == 0 ? -1 : 1);
          if (solid.contains(across) || !other.contains(voxel) || !other.contains(across)) continue;
          const GridFace face{side == 0 ? voxel : across, axis};
          pieces.add(face);
          for (const GridEdge& edge : edges_of(face)) {
            const GridFace& first = at_edge.try_emplace(edge, face).first->second;
            if (first != face) pieces.unite(first, face);
          }
        }
  }
  /// The piece that ends at an edge of a curve.
  [[nodiscard]] GridFace piece_at(const GridEdge& edge) const { return pieces.leader(at_edge.at(edge)); }

  Groups<GridFace> pieces;
  std::map<GridEdge, GridFace> at_edge;
};

/// The edges along which the two surfaces cross: one of the four voxels around is of both, one of neither.
std::vector<GridEdge> crossing_edges(const VoxelSolid& a, const VoxelSolid& b) {
  std::vector<GridEdge> edges;
  for (const Voxel& voxel : a) {
    if (!b.contains(voxel)) continue;
    for (int axis = 0; axis < 3; ++axis)
      for (int i = 0; i < 4; ++i) {
        const GridEdge edge{stepped(stepped(voxel, (axis + 1) % 3, i & 1), (axis + 2) % 3, i >> 1), axis};
        const auto around = voxels_around(edge);
        const auto count_in = [&](const VoxelSolid& solid) {
          return std::ranges::count_if(around, [&](const Voxel& one) { return solid.contains(one); });
        };
        const auto common =
            std::ranges::count_if(around, [&](const Voxel& one) { return a.contains(one) && b.contains(one); });
        if (common == 1 && count_in(a) == 2 && count_in(b) == 2) edges.push_back(edge);
      }
  }
  return edges;
}

/// Around one common part: the curves, and those at which each piece of either surface ends.
struct CommonPart {
  std::set<Voxel> curves;
  std::map<GridFace, std::set<Voxel>> ends_of_a, ends_of_b;
};

std::map<Voxel, CommonPart> common_parts(const VoxelSolid& a, const VoxelSolid& b) {
  VoxelSolid common;
  std::ranges::set_intersection(a, b, std::inserter(common, common.end()));
  const Groups<Voxel> part_of = connected_voxels(common);
  const InnerSurface a_in_b(a, b), b_in_a(b, a);
  const std::vector<GridEdge> edges = crossing_edges(a, b);
  Groups<Voxel> curves;  // by their points
  for (const GridEdge& edge : edges) curves.unite(edge.from, stepped(edge.from, edge.axis, 1));
  std::map<Voxel, CommonPart> parts;
  for (const GridEdge& edge : edges) {
    const auto around = voxels_around(edge);
    const auto inner = std::ranges::find_if(around, [&](const Voxel& voxel) { return common.contains(voxel); });
    const Voxel curve = curves.leader(edge.from);
    CommonPart& part = parts[part_of.leader(*inner)];
    part.curves.insert(curve);
    part.ends_of_a[a_in_b.piece_at(edge)].insert(curve);
    part.ends_of_b[b_in_a.piece_at(edge)].insert(curve);
  }
  return parts;
}

/// The points of two curves are more than two squares, of two steps each, apart.
bool are_curves_apart(const VoxelSolid& a, const VoxelSolid& b) {
  constexpr int two_squares = 4;
  Groups<Voxel> curves;
  std::set<Voxel> points;
  for (const GridEdge& edge : crossing_edges(a, b)) {
    const Voxel to = stepped(edge.from, edge.axis, 1);
    curves.unite(edge.from, to);
    points.insert({edge.from, to});
  }
  const auto are_near = [](const Voxel& p, const Voxel& q) {
    return std::abs(p[0] - q[0]) <= two_squares && std::abs(p[1] - q[1]) <= two_squares &&
           std::abs(p[2] - q[2]) <= two_squares;
  };
  return std::ranges::none_of(points, [&](const Voxel& p) {
    return std::ranges::any_of(points,
                               [&](const Voxel& q) { return are_near(p, q) && curves.leader(p) != curves.leader(q); });
  });
}

/// A piece leads from one curve to another.
bool leads_through(const std::map<GridFace, std::set<Voxel>>& ends) {
  return std::ranges::any_of(ends, [](const auto& piece) { return piece.second.size() > 1; });
}

}  // namespace

VoxelSolid random_manifold_voxels(Random& random, int size) {
  const auto some_box = [&](VoxelSolid& solid) {
    std::array<std::array<int, 2>, 3> range;
    for (auto& [from, to] : range) {
      from = static_cast<int>(random.below(static_cast<std::uint64_t>(size)));
      to = from + static_cast<int>(random.below(static_cast<std::uint64_t>(size - from)));
    }
    for (int x = range[0][0]; x <= range[0][1]; ++x)
      for (int y = range[1][0]; y <= range[1][1]; ++y)
        for (int z = range[2][0]; z <= range[2][1]; ++z) solid.insert({x, y, z});
  };
  for (;;) {
    VoxelSolid solid;
    for (std::uint64_t count = 1 + random.below(3); count > 0; --count) some_box(solid);
    if (is_manifold(solid)) return solid;
  }
}

VoxelSolid on_half_grid(const VoxelSolid& solid, const Voxel& steps) {
  VoxelSolid result;
  for (const Voxel& voxel : solid)
    for (int i = 0; i < 8; ++i)
      result.insert({2 * voxel[0] + steps[0] + (i & 1), 2 * voxel[1] + steps[1] + (i >> 1 & 1),
                     2 * voxel[2] + steps[2] + (i >> 2)});
  return result;
}

VoxelClash true_clash(const VoxelSolid& a, const VoxelSolid& b) {
  using Piercing = PairAnswer::Piercing;
  int by_a = 0, by_b = 0, others = 0;
  const std::map<Voxel, CommonPart> parts = common_parts(a, b);
  for (const auto& [where, part] : parts) {
    if (part.curves.size() < 2) continue;
    const bool a_leads = leads_through(part.ends_of_a), b_leads = leads_through(part.ends_of_b);
    ++(a_leads == b_leads ? others : a_leads ? by_a : by_b);
  }
  VoxelClash clash;
  clash.has_curves = !parts.empty();
  clash.has_curves_apart = are_curves_apart(a, b);
  clash.pierces = by_a + by_b + others > 0;
  if (clash.pierces && others == 0)
    clash.piercing = by_b == 0 ? Piercing::a_through_b : by_a == 0 ? Piercing::b_through_a : Piercing::unknown;
  return clash;
}

}  // namespace toccata::test
