#include "methods/minkowski/general_overlay.hpp"

#include <algorithm>
#include <utility>

#include "math/constants.hpp"

// The arc of an edge of A leads from the region of B's map in which one of its faces' normals lies to that of the
// other. Regions are convex, so the arc leaves each through one border: where the normals of the faces beside it lie on
// both sides of the arc, and which is certain to be crossed within both arcs, outwards. So the regions are passed
// through in the exact order, and none is left out.
//
// The facets along an arc follow each other, and two that do share a half-edge's line: so the walk along A's arcs tells
// the twins along A's edges. Along an arc of B the facets are found out of order; but each vertex of A's map that it
// meets is met once, so the facet that begins where another one ends is found by that vertex.
namespace toccata {
namespace {

class GeneralOverlay {
 public:
  GeneralOverlay(const SumOperand& a, const SumOperand& b) : a_(a), b_(b) {}

  /// False where something is in doubt.
  [[nodiscard]] bool make() {
    if (!find_far(a_, b_, far_of_a_) || !find_far(b_, a_, far_of_b_)) return false;
    reserve();
    for (Index f = 0; f < a_.faces().size(); ++f) add_face_of_a(f);
    for (Index f = 0; f < b_.faces().size(); ++f) add_face_of_b(f);
    facets_.twins.resize(facets_.corners.size());
    crossings_.assign(b_.half_edges().size(), no_index);
    for (Index e = 0; e < a_.half_edges().size(); ++e)
      if (e < a_.half_edges()[e].twin && !follow(e)) return false;
    link_along_b();
    return true;
  }

  [[nodiscard]] SumFacets&& facets() { return std::move(facets_); }

 private:
  /// Finds, for each face, the vertex of the other operand that is farthest along its normal.
  [[nodiscard]] static bool find_far(const SumOperand& own, const SumOperand& other, std::vector<Index>& far) {
    far.resize(own.faces().size());
    Index vertex = 0;
    for (Index f = 0; f < far.size(); ++f) {
      const Index across = own.half_edges()[own.half_edges()[own.faces()[f].first].twin].face;
      const std::optional<Index> found = climb(own, f, other, across < f ? far[across] : vertex);
      if (!found) return false;
      far[f] = vertex = *found;
    }
    return true;
  }

  /// The steepest way up, until all others are certainly lower.
  [[nodiscard]] static std::optional<Index> climb(const SumOperand& own, Index face, const SumOperand& other,
                                                  Index vertex) {
    const double error = own.slope_error(face, other);
    while (true) {
      double steepest = -infinity;
      Index up = no_index;
      for (const Index h : other.leaving_all(vertex)) {
        const double slope = own.rounded_slope(face, other, h);
        up = slope > steepest ? h : up;
        steepest = slope > steepest ? slope : steepest;
      }
      if (steepest < -error) return vertex;
      if (!(steepest > error)) return {};
      vertex = other.half_edges()[up].target;
    }
  }

  void reserve() {
    const std::size_t own = a_.half_edges().size() + b_.half_edges().size();
    const std::size_t faces = a_.faces().size() + b_.faces().size();
    facets_.corners.reserve(3 * own);
    facets_.twins.reserve(3 * own);
    facets_.first.reserve(2 * faces + 1);
    facets_.kinds.reserve(2 * faces);
    facets_.planes.reserve(2 * faces);
    along_b_.reserve(faces);
  }

  void add_face_of_a(Index face) {
    const SumOperand::Face& f = a_.faces()[face];
    for (Index h = f.first; h < f.first + f.size; ++h)
      facets_.corners.push_back({a_.half_edges()[h].origin, far_of_a_[face]});
    facets_.close_face(a_, face, false, SumFaceKind::of_a);
  }

  void add_face_of_b(Index face) {
    const SumOperand::Face& f = b_.faces()[face];
    for (Index h = f.first; h < f.first + f.size; ++h)
      facets_.corners.push_back({far_of_b_[face], b_.half_edges()[h].origin});
    facets_.close_face(b_, face, true, SumFaceKind::of_b);
  }

  /// Along the arc of an edge of A, through the regions of B's map.
  [[nodiscard]] bool follow(Index e) {
    const Index begin = a_.half_edges()[e].face, end = a_.half_edges()[a_.half_edges()[e].twin].face;
    const Index last = far_of_a_[end];
    Index side = e;  // of the facet before, along e
    for (Index at = far_of_a_[begin], entry = b_.leaving(at); at != last;) {
      const Index f = exit_of(entry, e);
      if (f == no_index || !is_passed_outwards(f, begin, end)) return false;
      add_crossing(e, f, side);
      at = b_.half_edges()[f].target;
      entry = b_.half_edges()[f].twin;
    }
    link(side, a_.half_edges()[e].twin);
    return true;
  }

  /// The side of the arc's great circle on which the normal of a face of B lies; zero where it is in doubt.
  [[nodiscard]] Sign side_of_face(Index face, Index e) const {
    const double slope = b_.rounded_slope(face, a_, e), error = b_.slope_error(face, a_);
    return slope > error ? Sign::positive : slope < -error ? Sign::negative : Sign::zero;
  }

  /// The border through which the great circle of e's arc leaves a vertex's region, as it passes between the normals
  /// of the two faces beside; looked for from one of the vertex's half-edges on, the one through which it came in
  /// unless this is the first. None where a sign is in doubt.
  [[nodiscard]] Index exit_of(Index first, Index e) const {
    Sign left = side_of_face(b_.half_edges()[first].face, e);
    for (Index f = first;;) {
      const SumOperand::HalfEdge& twin = b_.half_edges()[b_.half_edges()[f].twin];
      const Sign right = side_of_face(twin.face, e);
      if (left == Sign::zero || right == Sign::zero) return no_index;
      if (left == Sign::positive && right == Sign::negative) return f;
      left = right;
      f = twin.next;
      if (f == first) return no_index;
    }
  }

  /// Within the arc from one normal to another, which is certain; or false.
  [[nodiscard]] bool is_passed_outwards(Index f, Index begin, Index end) const {
    return a_.rounded_slope(begin, b_, f) < -a_.slope_error(begin, b_) &&
           a_.rounded_slope(end, b_, f) > a_.slope_error(end, b_);
  }

  void link(Index side, Index twin) {
    facets_.twins[side] = twin;
    facets_.twins[twin] = side;
  }

  /// The facet of two edges, f being passed outwards. `side` is a half-edge along e of the facet before on e's arc, and
  /// becomes that of this one.
  void add_crossing(Index e, Index f, Index& side) {
    const SumOperand::HalfEdge &on_a = a_.half_edges()[e], &on_b = b_.half_edges()[f];
    const Index first = static_cast<Index>(facets_.corners.size());
    facets_.twins.resize(first + 4);
    // The order of corners, and so of sides, is that of `add_parallelogram`.
    if (f < on_b.twin) {
      facets_.add_parallelogram(a_, e, b_, f, Sign::negative);
      link(side, first + 3);
      side = first + 1;
      along_b_.push_back({first, first + 2, on_a.origin, on_a.target, std::exchange(crossings_[f], next_crossing())});
    } else {
      facets_.add_parallelogram(a_, e, b_, on_b.twin, Sign::positive);
      link(side, first + 2);
      side = first;
      along_b_.push_back(
          {first + 1, first + 3, on_a.target, on_a.origin, std::exchange(crossings_[on_b.twin], next_crossing())});
    }
  }

  [[nodiscard]] Index next_crossing() const { return static_cast<Index>(along_b_.size()); }

  void link_along_b() {
    const auto own = static_cast<Index>(a_.half_edges().size());
    std::vector<Index> starting_at(a_.points().size());
    for (Index f = 0; f < b_.half_edges().size(); ++f) {
      const SumOperand::HalfEdge& edge = b_.half_edges()[f];
      if (f > edge.twin) continue;
      for (Index c = crossings_[f]; c != no_index; c = along_b_[c].next) starting_at[along_b_[c].back_at] = c;
      const Index last = far_of_b_[b_.half_edges()[edge.twin].face];
      Index side = own + f;
      for (Index at = far_of_b_[edge.face]; at != last;) {
        const Crossing& crossing = along_b_[starting_at[at]];
        link(side, crossing.back);
        side = crossing.along;
        at = crossing.along_at;
      }
      link(side, own + edge.twin);
    }
  }

  /// What a parallelogram has along an edge of B: half-edges in its direction and back, and the vertices of A at which
  /// they are.
  struct Crossing {
    Index along = 0;
    Index back = 0;
    Index along_at = 0;
    Index back_at = 0;
    Index next = no_index;  ///< of the same edge
  };

  const SumOperand& a_;
  const SumOperand& b_;
  std::vector<Index> far_of_a_;
  std::vector<Index> far_of_b_;
  SumFacets facets_;
  std::vector<Crossing> along_b_;
  std::vector<Index> crossings_;  ///< of each edge of B the last
};

}  // namespace

std::optional<SumFacets> general_overlay(const SumOperand& a, const SumOperand& b) {
  if (a.dimension() < 3 || b.dimension() < 3) return {};
  GeneralOverlay overlay(a, b);
  if (!overlay.make()) return {};
  return overlay.facets();
}

}  // namespace toccata
