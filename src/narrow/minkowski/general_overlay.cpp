#include "narrow/minkowski/general_overlay.hpp"

#include <algorithm>
#include <limits>

// The arc of an edge of A leads from the region of B's map in which one of its faces' normals lies to that of the
// other. Regions are convex, so the arc leaves each through one border, and a border that is certain to be crossed
// within both arcs, outwards, is that one: whichever was guessed first, the regions are passed through in the exact
// order, and none is left out.
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
    for (Index e = 0; e < a_.half_edges().size(); ++e)
      if (e < a_.half_edges()[e].twin && !follow(e)) return false;
    return true;
  }

  [[nodiscard]] SumFacets&& facets() { return std::move(facets_); }

 private:
  /// Of each face the vertex of the other operand that is farthest along its normal.
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
      double steepest = -std::numeric_limits<double>::infinity();
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
    facets_.first.reserve(2 * faces + 1);
    facets_.kinds.reserve(2 * faces);
    facets_.planes.reserve(2 * faces);
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
    for (Index at = far_of_a_[begin]; at != last;) {
      const Index f = exit_of(at, begin, end);
      if (f == no_index || !cross(e, f)) return false;
      at = b_.half_edges()[f].target;
    }
    return true;
  }

  /// The border of a vertex's region that the arc from one normal to another seems to leave through: of those that the
  /// end lies behind, the one that is passed first.
  [[nodiscard]] Index exit_of(Index vertex, Index begin, Index end) const {
    double earliest = std::numeric_limits<double>::infinity();
    Index exit = no_index;
    for (const Index f : b_.leaving_all(vertex)) {
      const double at_begin = a_.rounded_slope(begin, b_, f), at_end = a_.rounded_slope(end, b_, f);
      const double when = at_begin / (at_begin - at_end);
      const bool is_earlier = (at_begin < 0) & (at_end > 0) & (when < earliest);
      exit = is_earlier ? f : exit;
      earliest = is_earlier ? when : earliest;
    }
    return exit;
  }

  /// The arcs cross within both, f being passed outwards, which is certain; or false.
  [[nodiscard]] bool cross(Index e, Index f) {
    const SumOperand::HalfEdge &on_a = a_.half_edges()[e], &on_b = b_.half_edges()[f];
    const Index right = a_.half_edges()[on_a.twin].face, right_b = b_.half_edges()[on_b.twin].face;
    const bool is_crossed = a_.rounded_slope(on_a.face, b_, f) < -a_.slope_error(on_a.face, b_) &&
                            a_.rounded_slope(right, b_, f) > a_.slope_error(right, b_) &&
                            b_.rounded_slope(on_b.face, a_, e) > b_.slope_error(on_b.face, a_) &&
                            b_.rounded_slope(right_b, a_, e) < -b_.slope_error(right_b, a_);
    if (!is_crossed) return false;
    if (f < on_b.twin)
      facets_.add_parallelogram(a_, e, b_, f, Sign::negative);
    else
      facets_.add_parallelogram(a_, e, b_, on_b.twin, Sign::positive);
    return true;
  }

  const SumOperand& a_;
  const SumOperand& b_;
  std::vector<Index> far_of_a_;
  std::vector<Index> far_of_b_;
  SumFacets facets_;
};

}  // namespace

std::optional<SumFacets> general_overlay(const SumOperand& a, const SumOperand& b) {
  if (a.dimension() < 3 || b.dimension() < 3) return {};
  GeneralOverlay overlay(a, b);
  if (!overlay.make()) return {};
  return overlay.facets();
}

}  // namespace toccata
