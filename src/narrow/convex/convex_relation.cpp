#include "narrow/convex/cached_simplex.hpp"
#include "narrow/convex/convex_containment.hpp"
#include "narrow/convex/core_distance.hpp"
#include "narrow/exact/exact_interior.hpp"
#include "narrow/primitives/closed_forms.hpp"
#include "toccata/narrow/convex_convex.hpp"

namespace toccata {
namespace {

/// One question about two shapes.
class RelationQuestion {
 public:
  RelationQuestion(const PosedPolytope& a, const PosedPolytope& b, SimplexCache& workspace)
      : a_(a), b_(b), workspace_(workspace) {}

  /// The question counts once, whatever it is made of.
  Relation answer() {
    const ConvexCounts before = workspace_.counts;
    Relation relation = kind();
    relation.a_solid = a_.solid();
    relation.b_solid = b_.solid();
    ConvexCounts& counts = workspace_.counts;
    if (by_exact_ || counts.exact > before.exact) {
      counts.exact = before.exact + 1;
      counts.certificates = before.certificates;
      counts.closed_forms = before.closed_forms;
    }
    return relation;
  }

 private:
  Relation kind() {
    if (!overlap(a_, b_, &workspace_)) return {};
    if (meet_deeply()) return relation_when_deep();
    return {RelationKind::touching, Containment::none, !a_.solid() && !b_.solid()};
  }

  /// Whether the interiors of two solids meet; for a solid and a surface, whether the surface meets the interior; for
  /// two surfaces, whether the relative interiors meet and the two do not lie in one plane. With radii that is: the
  /// cores are nearer than their sum.
  bool meet_deeply() {
    if (is_flattened(a_) || is_flattened(b_)) return false;
    const bool is_grown = a_.radius() > 0 || b_.radius() > 0;
    // A formula proves an intersection by more than any rounding: solids meet inside then, and cores are nearer than
    // the sum of the radii.
    if ((is_grown || (a_.solid() && b_.solid())) && nearness_by_formula(a_, b_) == Nearness::meet) return true;
    const VertexPairs simplex = cached_simplex(workspace_, a_, b_);
    if (is_grown) {
      const CoreDistanceOrder order = compare_core_distance_at(a_, b_, a_.radius(), b_.radius(), simplex);
      by_exact_ = by_exact_ || order.by_exact;
      return order.sign == Sign::negative;
    }
    if (simplex.size == 4 && origin_within_tetrahedron(a_, b_, simplex)) return true;
    by_exact_ = true;
    return interiors_meet(a_, b_, simplex);
  }

  Relation relation_when_deep() {
    if (a_.solid() && b_.solid()) return {RelationKind::overlapping, noted(containment_of_solids(a_, b_))};
    if (a_.solid()) return {RelationKind::crossing, flipped(noted(containment_in_interior(b_, a_)))};
    if (b_.solid()) return {RelationKind::crossing, noted(containment_in_interior(a_, b_))};
    return {RelationKind::crossing};
  }

  Containment noted(const ContainmentAnswer& answer) {
    by_exact_ = by_exact_ || answer.by_exact;
    return answer.containment;
  }

  const PosedPolytope& a_;
  const PosedPolytope& b_;
  SimplexCache& workspace_;
  bool by_exact_ = false;
};

}  // namespace

Relation relation(const PosedPolytope& a, const PosedPolytope& b, SimplexCache* workspace) {
  SimplexCache alone;
  return RelationQuestion(a, b, workspace != nullptr ? *workspace : alone).answer();
}

}  // namespace toccata
