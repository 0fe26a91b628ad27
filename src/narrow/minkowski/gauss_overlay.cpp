#include "narrow/minkowski/gauss_overlay.hpp"

#include <array>

#include "narrow/minkowski/facet_polygon.hpp"

namespace toccata {
namespace {

bool same(Sign p, Sign q) { return p == q && p != Sign::zero; }

/// Where the other operand is farthest along the normals of one operand's faces.
class FarSearch {
 public:
  FarSearch(const SumOperand& own, const SumOperand& other) : own_(own), other_(other) {
    vertex_.reserve(own.faces().size());
    for (Index f = 0; f < own.faces().size(); ++f) vertex_.push_back(climb(f, start(f)));
  }

  [[nodiscard]] Index vertex(Index face) const { return vertex_[face]; }

  [[nodiscard]] FarFeature feature(Index face) const {
    FarFeature far{vertex_[face], {}};
    const Index first = other_.leaving(far.vertex);
    if (first == no_index) return far;
    Index h = first;
    do {
      if (other_.dimension() > 1 && is_parallel_face(face, h)) {
        const SumOperand::Face& parallel = other_.faces()[other_.half_edges()[h].face];
        far.cycle.clear();
        for (Index i = 0; i < parallel.size; ++i) far.cycle.push_back(parallel.first + i);
        return far;
      }
      if (far.cycle.empty() && own_.slope(face, other_, h) == Sign::zero) far.cycle = {h, other_.half_edges()[h].twin};
      h = other_.next_leaving(h);
    } while (h != first);
    return far;
  }

 private:
  /// The one for a neighbour that has one, or else for the face before.
  [[nodiscard]] Index start(Index face) const {
    const auto edges = own_.half_edges();
    for (Index i = 0; i < own_.faces()[face].size; ++i) {
      const Index across = edges[edges[own_.faces()[face].first + i].twin].face;
      if (across < vertex_.size()) return vertex_[across];
    }
    return vertex_.empty() ? 0 : vertex_.back();
  }

  /// Every step is upwards, and what has no neighbour above it is farthest.
  [[nodiscard]] Index climb(Index face, Index vertex) const {
    for (bool higher = true; higher;) {
      const Index first = other_.leaving(vertex);
      if (first == no_index) return vertex;
      higher = false;
      Index h = first;
      do {
        if (own_.slope(face, other_, h) == Sign::positive) {
          vertex = other_.half_edges()[h].target;
          higher = true;
          break;
        }
        h = other_.next_leaving(h);
      } while (h != first);
    }
    return vertex;
  }

  /// The face of the half-edge, at the farthest vertex, has the same normal. Of a flat operand both its faces lie in
  /// the plane then, and one has it.
  [[nodiscard]] bool is_parallel_face(Index face, Index half_edge) const {
    const Index before = other_.half_edges()[half_edge].previous;
    if (own_.slope(face, other_, half_edge) != Sign::zero || own_.slope(face, other_, before) != Sign::zero)
      return false;
    return other_.dimension() == 3 || normals_agree(face, other_.half_edges()[half_edge].face);
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
  std::vector<Index> vertex_;
};

class Overlay {
 public:
  Overlay(const SumOperand& a, const SumOperand& b) : a_(a), b_(b), far_of_a_(a, b), far_of_b_(b, a) {}

  [[nodiscard]] SumFacets facets() {
    for (Index f = 0; f < a_.faces().size(); ++f) {
      const FarFeature far = far_of_a_.feature(f);
      const FacetPolygon polygon(a_, f, b_, far);
      for (const PolygonCorner& c : polygon.corners()) facets_.corners.push_back({c.on_first, c.on_second});
      close_face(false, f, far.cycle.size() > 2 ? SumFaceKind::of_both : SumFaceKind::of_a);
    }
    for (Index f = 0; f < b_.faces().size(); ++f) {
      const FarFeature far = far_of_b_.feature(f);
      if (far.cycle.size() > 2) continue;  // a face of A, which has made this one
      const FacetPolygon polygon(b_, f, a_, far);
      for (const PolygonCorner& c : polygon.corners()) facets_.corners.push_back({c.on_second, c.on_first});
      close_face(true, f, SumFaceKind::of_b);
    }
    seen_.assign(b_.points().size(), no_index);
    for (Index h = 0; h < a_.half_edges().size(); ++h)
      if (h < a_.half_edges()[h].twin) cross_with_edge(h);
    return std::move(facets_);
  }

 private:
  void close_face(bool of_b, Index face, SumFaceKind kind) {
    const auto& [p, q, r] = (of_b ? b_ : a_).faces()[face].corners;
    facets_.close(kind, {of_b, q, p}, {of_b, r, p});
  }

  /// Goes through the regions of B's map that the arc of A's edge meets, from the one in which the arc begins. All
  /// comparisons of regions are with closed arcs, so it does not matter whether the arc passes through ends of others.
  void cross_with_edge(Index e) {
    if (a_.dimension() == 1) {  // its arc is a whole circle
      for (Index f = 0; f < b_.half_edges().size(); ++f) cross(e, f);
      return;
    }
    waiting_.assign(1, far_of_a_.vertex(a_.half_edges()[e].face));
    seen_[waiting_.back()] = e;
    while (!waiting_.empty()) {
      const Index first = b_.leaving(waiting_.back());
      waiting_.pop_back();
      if (first == no_index) return;
      Index f = first;
      do {
        const Index target = b_.half_edges()[f].target;
        if (cross(e, f) && seen_[target] != e) {
          seen_[target] = e;
          waiting_.push_back(target);
        }
        f = b_.next_leaving(f);
      } while (f != first);
    }
  }

  /// The closed arcs may meet. Where they cross within both, the edges make a facet with the normal ±e × f, and it is
  /// made when f comes first of the two half-edges.
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
    if (f < on_b.twin) add_where_inside(e, f, {left, -right, -left_b, right_b});
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

  void add(Index e, Index f, Sign sense) {
    const SumOperand::HalfEdge &on_a = a_.half_edges()[e], &on_b = b_.half_edges()[f];
    const PlaneVector u{false, on_a.target, on_a.origin}, v{true, on_b.target, on_b.origin};
    const SumVertex first{on_a.origin, on_b.origin}, along_a{on_a.target, on_b.origin}, last{on_a.target, on_b.target},
        along_b{on_a.origin, on_b.target};
    if (sense == Sign::positive) {
      facets_.corners.insert(facets_.corners.end(), {first, along_a, last, along_b});
      facets_.close(SumFaceKind::of_edges, u, v);
    } else {
      facets_.corners.insert(facets_.corners.end(), {first, along_b, last, along_a});
      facets_.close(SumFaceKind::of_edges, v, u);
    }
  }

  const SumOperand& a_;
  const SumOperand& b_;
  FarSearch far_of_a_;
  FarSearch far_of_b_;
  SumFacets facets_;
  std::vector<Index> seen_;  ///< of each point of B, the last edge whose arc met its region
  std::vector<Index> waiting_;
};

}  // namespace

SumFacets overlay(const SumOperand& a, const SumOperand& b) { return Overlay(a, b).facets(); }

}  // namespace toccata
