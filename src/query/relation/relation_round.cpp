#include <algorithm>
#include <optional>
#include <vector>

#include "query/inside/inside_winding.hpp"
#include "query/meshes/world_search.hpp"
#include "query/relation/quadric_signs.hpp"
#include "query/relation/relation_cells.hpp"
#include "query/relation/relation_convex.hpp"
#include "query/relation/relation_samples.hpp"
#include "toccata/narrow/triangle_triangle.hpp"

namespace toccata {
namespace {

/// What lies beside the cells of a triangle: the solid, and what is not.
struct Beside {
  bool some_solid = false;
  bool some_empty = false;
  bool all_solid = true;  ///< beside every cell there is some of it
  bool all_empty = true;
};

/// The triangles that cut the relative interior of `t`; those with the same vertices do not.
std::vector<Triangle> cuts_of(const PosedMesh& mesh, const Triangle& t) {
  std::vector<Triangle> cuts;
  visit_triangles_near(mesh, box_of(t), [&](Index number) {
    const Triangle other = mesh.triangle(number);
    if (!has_area(other) || std::is_permutation(t.vertex.begin(), t.vertex.end(), other.vertex.begin())) return true;
    const Intersection m = intersect(t, other);
    if (m.on_a.kind == FeatureKind::face &&
        (m.kind == IntersectionKind::segment || m.kind == IntersectionKind::polygon))
      cuts.push_back(other);
    return true;
  });
  return cuts;
}

/// Precondition: has_area(t).
Beside beside(const PosedMesh& mesh, const Triangle& t) {
  const int axis = projection_axis(t);
  Beside result;
  visit_cells(t, cuts_of(mesh, t), [&](const ExactPoint& p) {
    const LineWinding winding = wind_along(mesh, p, axis, t);
    if (winding.on_another_plane) return CellVisit::another;
    const bool solid = winding.ahead != 0 || winding.behind != 0, empty = winding.ahead == 0 || winding.behind == 0;
    result.some_solid |= solid;
    result.some_empty |= empty;
    result.all_solid &= solid;
    result.all_empty &= empty;
    return CellVisit::next;
  });
  return result;
}

/// A world point in the interior, where one is at hand.
std::optional<Vec3> inner_point(const PosedPolytope& shape) { return shape.vertex(0); }
std::optional<Vec3> inner_point(const PosedQuadric& shape) { return shape.pose().offset; }
std::optional<Vec3> inner_point(const PosedHalfSpace&) { return std::nullopt; }

/// Which regions there are of a solid mesh, A, and a convex shape with an interior, B. Every region within the shape
/// borders on a triangle that reaches into its interior, or is all of it; every region outside, on a triangle that
/// sticks out. So these are looked at, on both sides, until everything has been seen. Beside triangles of which it is
/// undecided whether they do, regions are undecided.
template <class Shape>
class RoundRelation {
 public:
  RoundRelation(const PosedMesh& solid, const Shape& shape, std::span<const Index> contacts)
      : solid_(solid), shape_(shape), contacts_(contacts) {}

  Relation relation() {
    look_at_inner_point();
    look_at_contacts();
    if (seen_.in_both || doubtful_.in_both) look_outside();
    Relation result;
    result.kind = seen_.in_both || doubtful_.in_both ? RelationKind::overlapping : RelationKind::touching;
    if (beyond_seen(undecided_)) result.status = Status::undecided;
    if (beyond_seen(doubtful_)) result.status = Status::not_converged;
    if (result.kind != RelationKind::overlapping) return result;
    const bool a_in_b = !(seen_ | doubtful_ | undecided_).only_in_a,
               b_in_a = !(seen_ | doubtful_ | undecided_).only_in_b;
    result.containment = a_in_b && b_in_a ? Containment::equal
                         : a_in_b         ? Containment::a_in_b
                         : b_in_a         ? Containment::b_in_a
                                          : Containment::none;
    return result;
  }

 private:
  /// Some of these regions are not among those seen.
  [[nodiscard]] bool beyond_seen(const RegionsSeen& regions) const { return !((seen_ | regions) == seen_); }

  void look_at_inner_point() {
    const std::optional<Vec3> p = inner_point(shape_);
    // A mesh has an end and a half-space has none.
    if (!p) seen_.only_in_b = true;
    if (!p) return;
    const LineWinding winding = wind_along(solid_, ExactPoint(*p), 0);
    for (const int number : {winding.ahead, winding.behind}) (number != 0 ? seen_.in_both : seen_.only_in_b) = true;
  }

  void look_at_contacts() {
    for (const Index number : contacts_) {
      if (seen_.in_both && seen_.only_in_b) return;
      const Triangle t = solid_.triangle(number);
      const Known inside = has_area(t) ? reaches_into(PosedPolytope(t), shape_) : Known::no;
      if (inside == Known::no) continue;
      const Beside found = beside(solid_, t);
      if (inside == Known::undecided) {
        undecided_.in_both = true;
        undecided_.only_in_b |= found.some_empty;
        continue;
      }
      note(found.some_solid, found.all_solid, seen_.in_both, doubtful_.in_both);
      note(found.some_empty, found.all_empty, seen_.only_in_b, doubtful_.only_in_b);
    }
  }

  void look_outside() {
    const Index count = solid_.model().mesh().triangle_count();
    for (Index number = 0; number < count && !seen_.only_in_a; ++number) {
      const Triangle t = solid_.triangle(number);
      const bool meets = std::binary_search(contacts_.begin(), contacts_.end(), number);
      const Known outside = !has_area(t) ? Known::no : meets ? sticks_out(t) : Known::yes;
      if (outside == Known::no) continue;
      const Beside found = beside(solid_, t);
      if (outside == Known::undecided) {
        undecided_.only_in_a |= found.some_solid;
        continue;
      }
      // All cells of a triangle that does not meet the shape are outside it.
      note(found.some_solid, found.all_solid || !meets, seen_.only_in_a, doubtful_.only_in_a);
    }
  }

  [[nodiscard]] Known sticks_out(const Triangle& t) const {
    Known all_in = Known::yes;
    for (const Vec3& v : t.vertex) all_in = both(all_in, holds_point(shape_, v));
    if (all_in == Known::undecided) return all_in;
    return known(all_in == Known::no);
  }

  /// Some cell of those looked at counts, it is not known which.
  static void note(bool some, bool all, bool& seen, bool& doubtful) {
    seen |= some && all;
    doubtful |= some;
  }

  const PosedMesh& solid_;
  const Shape& shape_;
  std::span<const Index> contacts_;
  RegionsSeen seen_;
  RegionsSeen doubtful_;   ///< those that some cell may show
  RegionsSeen undecided_;  ///< those beside triangles that may reach into a quadric, or stick out
};

}  // namespace

Relation relation_of_solid_and_round(const PosedMesh& solid, const PosedPolytope& shape,
                                     std::span<const Index> contacts) {
  return RoundRelation(solid, shape, contacts).relation();
}

Relation relation_of_solid_and_round(const PosedMesh& solid, const PosedQuadric& shape,
                                     std::span<const Index> contacts) {
  return RoundRelation(solid, shape, contacts).relation();
}

Relation relation_of_solid_and_round(const PosedMesh& solid, const PosedHalfSpace& shape,
                                     std::span<const Index> contacts) {
  return RoundRelation(solid, shape, contacts).relation();
}

}  // namespace toccata
