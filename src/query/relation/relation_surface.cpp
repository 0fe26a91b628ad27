#include <algorithm>
#include <span>
#include <vector>

#include "math/exact.hpp"
#include "query/inside/inside_winding.hpp"
#include "query/relation/relation_cells.hpp"
#include "query/relation/relation_locality.hpp"
#include "query/relation/relation_solids.hpp"

namespace toccata {
namespace {

/// After so many crossing triangles beside which no interior was seen, look at everything.
constexpr int most_triangle_samples = 16;

/// Some point of the cells of a triangle with area, cut so, is interior. Where `cuts` are all that cut it, a miss is
/// proof.
bool cells_reach_interior(const PosedMesh& solid, const Triangle& t, std::span<const Triangle> cuts, bool proof) {
  const int axis = projection_axis(t);
  return !visit_cells(t, cuts, [&](const ExactPoint& p) {
    const LineWinding winding = wind_along(solid, p, axis, t);
    if (!winding.on_sheet && winding.ahead != 0) return CellVisit::stop;
    // Touched in this very point from outside its plane: the cell around it may be interior all the same.
    return proof && winding.on_another_plane ? CellVisit::another : CellVisit::next;
  });
}

/// Where the segment from → to, as a parameter in [0, 1], can begin or end to lie on a triangle; and more.
void add_cut_parameters(const RationalPoint& from, const RationalPoint& to, const Triangle& cut,
                        std::vector<Rational>& parameters) {
  const auto add = [&](const Rational& at_from, const Rational& at_to) {
    if (at_from != at_to) parameters.push_back(at_from / (at_from - at_to));
  };
  const std::array corner{to_rational(cut[0]), to_rational(cut[1]), to_rational(cut[2])};
  const RationalPoint normal = cross(corner[1] - corner[0], corner[2] - corner[0]);
  add(dot(normal, from - corner[0]), dot(normal, to - corner[0]));
  for (std::size_t i = 0; i < 3; ++i) {
    const RationalPoint edge = corner[(i + 1) % 3] - corner[i];
    const RationalPoint side_from = cross(edge, from - corner[i]), side_to = cross(edge, to - corner[i]);
    for (int axis = 0; axis < 3; ++axis) {
      add(side_from[axis], side_to[axis]);
      add(from[axis] - corner[i][axis], to[axis] - corner[i][axis]);
    }
  }
}

/// The longest edge of a triangle without area contains it: here, the ends least and greatest in lexicographic order.
struct SegmentEnds {
  Vec3 from;
  Vec3 to;
};

SegmentEnds ends_of(const Triangle& without_area) {
  const auto& v = without_area.vertex;
  const auto [least, greatest] = std::minmax_element(v.begin(), v.end(), lexicographically_less);
  return {*least, *greatest};
}

/// Some point of a triangle that is a segment or a point is interior.
bool segment_reaches_interior(const PosedMesh& solid, const Triangle& t, std::span<const Triangle> cuts) {
  const SegmentEnds ends = ends_of(t);
  if (ends.from == ends.to) return is_interior(ends.from, solid);
  const RationalPoint from = to_rational(ends.from), to = to_rational(ends.to);
  std::vector<Rational> parameters{0, 1};
  for (const Triangle& cut : cuts) add_cut_parameters(from, to, cut, parameters);
  std::erase_if(parameters, [](const Rational& s) { return s < 0 || s > 1; });
  std::sort(parameters.begin(), parameters.end());
  for (std::size_t i = 0; i + 1 < parameters.size(); ++i) {
    const Rational middle = (parameters[i] + parameters[i + 1]) / 2;
    const LineWinding winding = wind_along(solid, ExactPoint(from + middle * (to - from)), 0);
    if (!winding.on_face && winding.ahead != 0) return true;
  }
  return false;
}

/// The triangles of the surface by what of the solid they meet.
class SurfaceLook {
 public:
  SurfaceLook(const PosedMesh& solid, const PosedMesh& surface, VisitContacts visit)
      : solid_(solid), surface_(surface) {
    visit([&](const Contact& contact) {
      contacts_.push_back(contact);
      interior_seen_ = sample_at(contact);
      return !interior_seen_;
    });
    std::sort(contacts_.begin(), contacts_.end(),
              [](const Contact& c, const Contact& d) { return c.element_b < d.element_b; });
  }

  Relation relation() const {
    Relation result;
    if (interior_seen_ || contacts_reach_interior()) {
      result.kind = RelationKind::crossing;
      return result;
    }
    const PartsInside parts = parts_off_the_faces();
    if (parts.some) result.kind = RelationKind::crossing;
    if (parts.some && parts.all && contacts_.empty()) result.containment = Containment::b_in_a;
    if (!parts.some && !contacts_.empty()) result.kind = RelationKind::touching;
    return result;
  }

 private:
  struct PartsInside {
    bool some = false;
    bool all = true;
  };

  bool sample_at(const Contact& contact) {
    if (!contact.intersection.crossing || samples_ >= most_triangle_samples) return false;
    ++samples_;
    const Triangle t = surface_.triangle(contact.element_b), cut = solid_.triangle(contact.element_a);
    return has_area(t) && cells_reach_interior(solid_, t, std::span(&cut, 1), false);
  }

  bool contacts_reach_interior() const {
    for (std::size_t first = 0, last = 0; first < contacts_.size(); first = last) {
      while (last < contacts_.size() && contacts_[last].element_b == contacts_[first].element_b) ++last;
      if (reaches_interior(std::span(contacts_).subspan(first, last - first))) return true;
    }
    return false;
  }

  /// Whether one triangle of the surface reaches the solid's interior, by its contacts with all that it meets.
  bool reaches_interior(std::span<const Contact> contacts) const {
    const Triangle t = surface_.triangle(contacts.front().element_b);
    const bool area = has_area(t);
    std::vector<Triangle> cuts;
    for (const Contact& contact : contacts) {
      const bool cuts_face = contact.intersection.on_b.kind == FeatureKind::face &&
                             contact.intersection.kind != IntersectionKind::point &&
                             has_area(solid_.triangle(contact.element_a));
      if (!area || cuts_face) cuts.push_back(solid_.triangle(contact.element_a));
    }
    return area ? cells_reach_interior(solid_, t, cuts, true) : segment_reaches_interior(solid_, t, cuts);
  }

  /// The triangles of a part of which some meet the solid and none reaches its interior are outside.
  PartsInside parts_off_the_faces() const {
    std::vector<Index> with_contacts;
    for (const Contact& contact : contacts_) with_contacts.push_back(contact.element_b);
    PartsInside inside;
    for (const Index part : parts_without(surface_, with_contacts)) {
      const Index first = surface_.model().mesh_parts().first_triangle[part];
      const bool interior = is_interior(surface_.triangle(first)[0], solid_);
      inside.some |= interior;
      inside.all &= interior;
    }
    return inside;
  }

  const PosedMesh& solid_;
  const PosedMesh& surface_;
  std::vector<Contact> contacts_;
  int samples_ = 0;
  bool interior_seen_ = false;
};

}  // namespace

Relation relation_of_solid_and_surface(const PosedMesh& solid, const PosedMesh& surface, VisitContacts visit) {
  if (!overlap(solid.box(), surface.box())) return {};
  return SurfaceLook(solid, surface, visit).relation();
}

}  // namespace toccata
