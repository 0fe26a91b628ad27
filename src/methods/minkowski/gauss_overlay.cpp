#include "methods/minkowski/gauss_overlay.hpp"

#include <algorithm>
#include <array>

#include "methods/minkowski/facet_polygon.hpp"

namespace toccata {
namespace {

bool same(Sign p, Sign q) { return p == q && p != Sign::zero; }

/// Where the other operand is farthest along the normals of one operand's faces.
class FarSearch {
 public:
  FarSearch(const SumOperand& own, const SumOperand& other) : own_(own), other_(other) {
    far_.reserve(own.faces().size());
    for (Index f = 0; f < own.faces().size(); ++f) {
      far_.push_back(climb(f, start(f)));
      if (far_.back().size > 0 && other.dimension() > 1) widen(f, far_.back());
    }
  }

  [[nodiscard]] const FarFeature& feature(Index face) const { return far_[face]; }

 private:
  /// The vertex for a neighbour that has one, or else for the face before.
  [[nodiscard]] Index start(Index face) const {
    const auto edges = own_.half_edges();
    for (Index i = 0; i < own_.faces()[face].size; ++i) {
      const Index across = edges[edges[own_.faces()[face].first + i].twin].face;
      if (across < far_.size()) return far_[across].vertex;
    }
    return far_.empty() ? 0 : far_.back().vertex;
  }

  /// Every step is upwards, and what has no neighbour above it is farthest: a vertex, or an edge if a neighbour is as
  /// high.
  [[nodiscard]] FarFeature climb(Index face, Index vertex) const {
    FarFeature far{.vertex = vertex};
    const Index first = other_.leaving(vertex);
    if (first == no_index) return far;
    for (Index h = first, last = first;;) {
      const Sign slope = own_.slope(face, other_, h);
      if (slope == Sign::positive) {
        far = {.vertex = other_.half_edges()[h].target};
        h = last = other_.leaving(far.vertex);
        continue;
      }
      if (slope == Sign::zero)
        far = {.vertex = far.vertex, .first = h, .second = other_.half_edges()[h].twin, .size = 2};
      h = other_.next_leaving(h);
      if (h == last) return far;
    }
  }

  /// Widens the feature from an edge that lies across the normal to the face that does, if one does.
  void widen(Index face, FarFeature& far) const {
    for (const Index h : {far.first, far.second}) {
      const SumOperand::HalfEdge& edge = other_.half_edges()[h];
      const SumOperand::Face& beside = other_.faces()[edge.face];
      if (own_.slope(face, other_, edge.next) != Sign::zero) continue;
      // Both faces of a flat operand lie in the plane then, and one has the normal.
      if (other_.dimension() == 2 && !normals_agree(face, edge.face)) continue;
      far = {.vertex = far.vertex, .first = beside.first, .size = beside.size};
      return;
    }
  }

  [[nodiscard]] bool normals_agree(Index face, Index of_other) const {
    const auto [u, v] = own_.plane_of(face);
    const auto [p, q] = other_.plane_of(of_other);
    for (int axis = 0; axis < 3; ++axis) {
      Difference unit{};
      unit.head[axis] = 1;
      const Sign own = triple_product_sign(u, v, unit);
      if (own != Sign::zero) return own == triple_product_sign(p, q, unit);
    }
    return false;
  }

  const SumOperand& own_;
  const SumOperand& other_;
  std::vector<FarFeature> far_;
};

class Overlay {
 public:
  Overlay(const SumOperand& a, const SumOperand& b) : a_(a), b_(b), far_of_a_(a, b), far_of_b_(b, a) {}

  [[nodiscard]] SumFacets facets() {
    for (Index f = 0; f < a_.faces().size(); ++f) {
      const FarFeature& far = far_of_a_.feature(f);
      add_polygon(a_, f, b_, far, [](Index on_a, Index on_b) { return SumVertex{on_a, on_b}; });
      facets_.close_face(a_, f, false, far.is_face() ? SumFaceKind::of_both : SumFaceKind::of_a);
    }
    for (Index f = 0; f < b_.faces().size(); ++f) {
      const FarFeature& far = far_of_b_.feature(f);
      if (far.is_face()) continue;  // of A, which has made this one
      add_polygon(b_, f, a_, far, [](Index on_b, Index on_a) { return SumVertex{on_a, on_b}; });
      facets_.close_face(b_, f, true, SumFaceKind::of_b);
    }
    seen_.assign(b_.points().size(), no_index);
    tried_.assign(b_.half_edges().size(), no_index);
    for (Index h = 0; h < a_.half_edges().size(); ++h)
      if (h < a_.half_edges()[h].twin) cross_with_edge(h);
    return std::move(facets_);
  }

 private:
  template <class Pair>
  void add_polygon(const SumOperand& own, Index face, const SumOperand& other, const FarFeature& far, Pair pair) {
    const SumOperand::Face& f = own.faces()[face];
    if (far.size == 0) {
      for (Index h = f.first; h < f.first + f.size; ++h)
        facets_.corners.push_back(pair(own.half_edges()[h].origin, far.vertex));
    } else {
      const FacetPolygon polygon(own, face, other, far);
      for (const SumCorner& c : polygon.corners()) facets_.corners.push_back(pair(c.on_first, c.on_second));
    }
  }

  /// Goes through the regions of B's map that the arc of A's edge meets, from the one in which the arc begins. All
  /// comparisons of regions are with closed arcs, so it does not matter whether the arc passes through ends of others.
  void cross_with_edge(Index e) {
    if (a_.dimension() == 1) {  // its arc is a whole circle
      for (Index f = 0; f < b_.half_edges().size(); ++f)
        if (f < b_.half_edges()[f].twin) cross(e, f);
      return;
    }
    waiting_.assign(1, far_of_a_.feature(a_.half_edges()[e].face).vertex);
    seen_[waiting_.back()] = e;
    while (!waiting_.empty()) {
      const Index first = b_.leaving(waiting_.back());
      waiting_.pop_back();
      if (first == no_index) return;
      Index f = first;
      do {
        const SumOperand::HalfEdge& on_b = b_.half_edges()[f];
        const Index edge = std::min(f, on_b.twin);
        if (tried_[edge] != e) {  // not from its other end
          tried_[edge] = e;
          if (cross(e, edge) && seen_[on_b.target] != e) {
            seen_[on_b.target] = e;
            waiting_.push_back(on_b.target);
          }
        }
        f = b_.half_edges()[on_b.twin].next;
      } while (f != first);
    }
  }

  /// The closed arcs may meet. Where they cross within both, the edges make a facet with the normal ±e × f.
  bool cross(Index e, Index f) {
    const SumOperand::HalfEdge &on_a = a_.half_edges()[e], &on_b = b_.half_edges()[f];
    Sign left = Sign::zero, right = Sign::zero;
    if (a_.dimension() > 1) {
      left = a_.slope(on_a.face, b_, f);
      right = a_.slope(a_.half_edges()[on_a.twin].face, b_, f);
      if (same(left, right)) return false;
    }
    Sign left_b = Sign::zero, right_b = Sign::zero;
    if (b_.dimension() > 1) {
      left_b = b_.slope(on_b.face, a_, e);
      right_b = b_.slope(b_.half_edges()[on_b.twin].face, a_, e);
      if (same(left_b, right_b) || same(left, left_b) || same(right, right_b)) return false;
    }
    add_where_inside(e, f, {left, -right, -left_b, right_b});
    return true;
  }

  /// The four conditions on the normal e × f, as signs: all positive, or all negative for its opposite. An operand that
  /// is a segment sets none.
  void add_where_inside(Index e, Index f, const std::array<Sign, 4>& signs) {
    const bool free_a = a_.dimension() == 1, free_b = b_.dimension() == 1;
    const auto all = [&](Sign sense) {
      return (free_a || (signs[0] == sense && signs[1] == sense)) &&
             (free_b || (signs[2] == sense && signs[3] == sense));
    };
    if (free_a && free_b) {
      if (!are_parallel(e, f)) {
        add(e, f, Sign::positive);
        add(e, f, Sign::negative);
      }
    } else if (all(Sign::positive)) {
      add(e, f, Sign::positive);
    } else if (all(Sign::negative)) {
      add(e, f, Sign::negative);
    }
  }

  [[nodiscard]] bool are_parallel(Index e, Index f) const {
    for (int axis = 0; axis < 3; ++axis) {
      Difference unit{};
      unit.head[axis] = 1;
      if (triple_product_sign(a_.along(e), b_.along(f), unit) != Sign::zero) return false;
    }
    return true;
  }

  void add(Index e, Index f, Sign sense) { facets_.add_parallelogram(a_, e, b_, f, sense); }

  const SumOperand& a_;
  const SumOperand& b_;
  FarSearch far_of_a_;
  FarSearch far_of_b_;
  SumFacets facets_;
  std::vector<Index> seen_;   ///< of each point of B, the last edge whose arc met its region
  std::vector<Index> tried_;  ///< of each edge of B, the last edge whose arc it was compared with
  std::vector<Index> waiting_;
};

}  // namespace

void SumFacets::add_parallelogram(const SumOperand& a, Index e, const SumOperand& b, Index f, Sign sense) {
  const SumOperand::HalfEdge &on_a = a.half_edges()[e], &on_b = b.half_edges()[f];
  const PlaneVector u{false, on_a.target, on_a.origin}, v{true, on_b.target, on_b.origin};
  const SumVertex origin{on_a.origin, on_b.origin}, along_a{on_a.target, on_b.origin}, last{on_a.target, on_b.target},
      along_b{on_a.origin, on_b.target};
  const bool is_forward = sense == Sign::positive;
  for (const SumVertex& corner : {origin, is_forward ? along_a : along_b, last, is_forward ? along_b : along_a})
    corners.push_back(corner);
  close(SumFaceKind::of_edges, is_forward ? u : v, is_forward ? v : u);
}

SumFacets overlay(const SumOperand& a, const SumOperand& b) { return Overlay(a, b).facets(); }

}  // namespace toccata
