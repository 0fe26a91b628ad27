#include "query/decomposition/cut_cells.hpp"

#include <algorithm>
#include <utility>

#include "query/decomposition/cell_corners.hpp"
#include "query/decomposition/exact_polygon.hpp"
#include "query/decomposition/outermost_corners.hpp"

// Let S be the solid, C a cell and K the closure of S within the open C. An extreme point v of the hull of K is among
// the points that are gathered: S is a cone near v. If no triangle through v reaches into the open C there, S near v is
// all of C, which has v as an extreme point only where v is a corner of C, and corners are gathered where S is all of C
// near them. Else v is in what is left of that triangle, which lies in K, and so is one of its corners. The union of
// all K is the closure of the interior of S, for the cells' borders have no interior. What else S has are triangles
// with the outside on both sides. If they reach into an open cell, their corners are gathered; if they lie in a plane
// between cells, it is seen to by `cover_flat_pieces`.
namespace toccata {
namespace {

/// A piece of surface that lies in the plane of a node.
struct FlatPiece {
  ExactPolygon polygon;
  Index node = 0;
};

class CellDivider {
 public:
  CellDivider(const Model& solid, const CutTree& tree) : solid_(solid), tree_(tree), contents_(tree.nodes.size()) {}

  std::vector<CellContent> divide() {
    const TriangleMesh& mesh = solid_.mesh();
    std::vector<Index> all(mesh.triangle_count());
    for (Index t = 0; t < all.size(); ++t) all[t] = t;
    descend(0, all, {}, {});
    cover_flat_pieces();
    return std::move(contents_);
  }

 private:
  [[nodiscard]] ExactPolygon polygon_of(Index triangle) const {
    ExactPolygon polygon{triangle, {}};
    for (const Index v : solid_.mesh().triangles()[triangle])
      polygon.corners.push_back({to_rational(solid_.mesh().vertices()[v]), {}});
    return polygon;
  }

  void descend(Index node, const std::vector<Index>& whole, std::vector<ExactPolygon> cut,
               const std::vector<CellSide>& cell) {
    const CutNode& at = tree_.nodes[node];
    if (!at.plane) return fill(node, whole, cut, cell);
    const CutPlane& plane = tree_.planes[*at.plane];
    std::array<std::vector<Index>, 2> whole_of;
    std::array<std::vector<ExactPolygon>, 2> cut_of;
    const auto share = [&](ExactPolygon polygon) {
      const PolygonBeside beside(polygon, plane, *at.plane);
      const bool front = beside.is_in_front(), back = beside.is_behind();
      if (front) cut_of[0].push_back(back ? beside.clipped(1) : polygon);
      if (back) cut_of[1].push_back(front ? beside.clipped(-1) : polygon);
      if (!front && !back) flat_.push_back({std::move(polygon), node});
    };
    for (const Index t : whole) {
      const auto [least, greatest] = signs_of(t, plane);
      if (greatest <= 0 && least < 0)
        whole_of[1].push_back(t);
      else if (least >= 0 && greatest > 0)
        whole_of[0].push_back(t);
      else
        share(polygon_of(t));
    }
    for (ExactPolygon& polygon : cut) share(std::move(polygon));
    for (const std::size_t side : {std::size_t{0}, std::size_t{1}}) {
      std::vector<CellSide> smaller = cell;
      smaller.push_back({*at.plane, side == 0 ? 1 : -1});
      descend(at.child[side], whole_of[side], std::move(cut_of[side]), smaller);
    }
  }

  [[nodiscard]] std::pair<int, int> signs_of(Index triangle, const CutPlane& plane) const {
    int least = 1, greatest = -1;
    for (const Index v : solid_.mesh().triangles()[triangle]) {
      const int sign = static_cast<int>(plane.side(solid_.mesh().vertices()[v]));
      least = std::min(least, sign);
      greatest = std::max(greatest, sign);
    }
    return {least, greatest};
  }

  void fill(Index node, const std::vector<Index>& whole, const std::vector<ExactPolygon>& cut,
            const std::vector<CellSide>& cell) {
    CellContent& content = contents_[node];
    content.triangles = whole;
    std::vector<Index> used;
    for (const Index t : whole)
      used.insert(used.end(), solid_.mesh().triangles()[t].begin(), solid_.mesh().triangles()[t].end());
    std::ranges::sort(used);
    used.erase(std::unique(used.begin(), used.end()), used.end());
    for (const Index v : used) content.points.push_back(solid_.mesh().vertices()[v]);
    for (const ExactPolygon& polygon : cut) content.triangles.push_back(polygon.triangle);
    for (const RationalPoint& corner : outermost_corners(cut, tree_.planes))
      append_doubles_around(corner, content.points);
    for (const RationalPoint& corner : solid_corners(solid_, tree_.planes, cell))
      append_doubles_around(corner, content.points);
    std::ranges::sort(content.triangles);
  }

  /// What a flat piece becomes in the cells below a node.
  void spread(const ExactPolygon& polygon, Index node, std::vector<std::pair<Index, ExactPolygon>>& pieces) const {
    const CutNode& at = tree_.nodes[node];
    if (!at.plane) return pieces.emplace_back(node, polygon), void();
    const CutPlane& plane = tree_.planes[*at.plane];
    const PolygonBeside beside(polygon, plane, *at.plane);
    const bool lies_in_it = !beside.is_in_front() && !beside.is_behind();
    if (beside.is_in_front() || lies_in_it) spread(beside.clipped(1), at.child[0], pieces);
    if (beside.is_behind() || lies_in_it) spread(beside.clipped(-1), at.child[1], pieces);
  }

  /// Next to a piece of surface in a plane the solid is on one side, and there the hulls contain it. If on neither side
  /// they do, it is a sheet of its own: its corners are added in front of it.
  void cover_flat_pieces() {
    std::vector<std::optional<ConvexHull>> hulls(contents_.size());
    const auto covered = [&](const std::pair<Index, ExactPolygon>& piece) {
      const CellContent& content = contents_[piece.first];
      if (content.points.empty()) return false;
      auto& hull = hulls[piece.first];
      if (!hull) hull.emplace(content.points);
      return std::ranges::all_of(piece.second.corners, [&](const ExactCorner& c) { return contains(*hull, c.point); });
    };
    std::vector<std::pair<Index, ExactPolygon>> uncovered;
    for (const FlatPiece& flat : flat_) {
      std::array<std::vector<std::pair<Index, ExactPolygon>>, 2> pieces;
      for (const std::size_t side : {std::size_t{0}, std::size_t{1}})
        spread(flat.polygon, tree_.nodes[flat.node].child[side], pieces[side]);
      if (std::ranges::all_of(pieces[0], covered) || std::ranges::all_of(pieces[1], covered)) continue;
      uncovered.insert(uncovered.end(), pieces[0].begin(), pieces[0].end());
    }
    for (const auto& [node, polygon] : uncovered) {
      contents_[node].triangles.push_back(polygon.triangle);
      for (const ExactCorner& corner : polygon.corners) append_doubles_around(corner.point, contents_[node].points);
    }
  }

  const Model& solid_;
  const CutTree& tree_;
  std::vector<CellContent> contents_;
  std::vector<FlatPiece> flat_;
};

}  // namespace

std::vector<CellContent> cell_contents(const Model& solid, const CutTree& tree) {
  return CellDivider(solid, tree).divide();
}

}  // namespace toccata
