#include "query/relation_solids.hpp"

#include <algorithm>
#include <tuple>
#include <vector>

#include "query/pair_search.hpp"
#include "query/relation_parts.hpp"
#include "query/relation_samples.hpp"
#include "query/world_search.hpp"

namespace toccata {
namespace {

/// After so many pairs of crossing triangles whose neighbourhoods did not show all there is, look at everything.
constexpr int most_glances = 16;

Relation from_regions(bool sets_meet, const RegionsSeen& seen) {
  Relation result;
  result.kind = seen.in_both ? RelationKind::overlapping : sets_meet ? RelationKind::touching : RelationKind::apart;
  if (!seen.in_both) return result;
  if (!seen.only_in_a && !seen.only_in_b)
    result.containment = Containment::equal;
  else if (!seen.only_in_a)
    result.containment = Containment::a_in_b;
  else if (!seen.only_in_b)
    result.containment = Containment::b_in_a;
  return result;
}

struct FirstLook {
  bool surfaces_meet = false;
  RegionsSeen seen;
};

/// Beside a pair of triangles that cross one usually sees all kinds of region at once.
FirstLook look_at_contacts(const SolidPair& pair, const VisitContacts& visit) {
  FirstLook look;
  int glances = 0;
  visit([&](const Contact& contact) {
    look.surfaces_meet = true;
    if (!contact.meeting.crossing) return true;
    const Triangle a = pair.a.triangle(contact.triangle_a), b = pair.b.triangle(contact.triangle_b);
    look.seen = look.seen | glance(pair, a, b);
    if (!look.seen.all()) look.seen = look.seen | glance(pair, b, a);
    return !look.seen.all() && ++glances < most_glances;
  });
  return look;
}

/// Some triangle has the same box: a quick look that tells most different meshes apart.
bool has_triangle(const PosedMesh& mesh, const Triangle& t) {
  bool found = false;
  visit_triangles_near(mesh, box_of(t), [&](Index i) { return !(found = box_of(mesh.triangle(i)) == box_of(t)); });
  return found;
}

/// A triangle by its vertices, starting with the least: the orientation stays.
std::vector<Triangle> oriented_triangles(const PosedMesh& mesh) {
  const auto before = [](const Vec3& p, const Vec3& q) { return std::tie(p.x, p.y, p.z) < std::tie(q.x, q.y, q.z); };
  std::vector<Triangle> triangles;
  for (Index i = 0; i < mesh.model().mesh().triangle_count(); ++i) {
    Triangle t = mesh.triangle(i);
    std::rotate(t.vertex.begin(), std::min_element(t.vertex.begin(), t.vertex.end(), before), t.vertex.end());
    triangles.push_back(t);
  }
  std::sort(triangles.begin(), triangles.end(), [&](const Triangle& s, const Triangle& t) {
    return std::lexicographical_compare(s.vertex.begin(), s.vertex.end(), t.vertex.begin(), t.vertex.end(), before);
  });
  return triangles;
}

/// The same triangles, in any order and numbering: then winding numbers are the same everywhere.
bool have_same_triangles(const PosedMesh& a, const PosedMesh& b) {
  return a.model().mesh().triangle_count() == b.model().mesh().triangle_count() && has_triangle(b, a.triangle(0)) &&
         oriented_triangles(a) == oriented_triangles(b);
}

Relation relation_of_equal_triangles(const SolidPair& pair) {
  RegionsSeen seen;
  const Index count = std::min<Index>(most_glances, pair.a.model().mesh().triangle_count());
  for (Index i = 0; i < count && !seen.in_both; ++i) seen = seen | glance(pair, pair.a.triangle(i));
  if (!seen.in_both) seen = all_regions(pair, seen);
  return from_regions(true, seen);
}

/// What the surfaces of one solid show when they meet no face of the other. A part lies as a whole in one region of the
/// other solid, so only some kinds of region can border on it.
struct PartsLook {
  bool some_inside = false;
  RegionsSeen seen;
  RegionsSeen possible;
};

enum class Side { of_a, of_b };

PartsLook look_at_parts(const SolidPair& pair, Side side) {
  const PosedMesh& mesh = side == Side::of_a ? pair.a : pair.b;
  const PosedMesh& other = side == Side::of_a ? pair.b : pair.a;
  PartsLook look;
  for (const std::vector<Index>& part : connected_parts(mesh)) {
    const bool inside = is_interior(mesh.triangle(part.front())[0], other);
    look.some_inside |= inside;
    look.possible.in_both |= inside;
    (side == Side::of_a ? look.possible.only_in_b : look.possible.only_in_a) |= inside;
    (side == Side::of_a ? look.possible.only_in_a : look.possible.only_in_b) |= !inside;
    const auto with_area = std::find_if(part.begin(), part.end(), [&](Index t) { return has_area(mesh.triangle(t)); });
    if (with_area != part.end()) look.seen = look.seen | glance(pair, mesh.triangle(*with_area));
  }
  return look;
}

Relation relation_of_disjoint_surfaces(const SolidPair& pair) {
  const PartsLook a = look_at_parts(pair, Side::of_a), b = look_at_parts(pair, Side::of_b);
  if (!a.some_inside && !b.some_inside) return {};
  const RegionsSeen seen = a.seen | b.seen, possible = a.possible | b.possible;
  const bool all_seen = seen == (seen | possible);
  return from_regions(true, all_seen ? seen : all_regions(pair, seen));
}

}  // namespace

Relation relation_of_solids(const PosedMesh& a, const PosedMesh& b, const VisitContacts& visit) {
  const SolidPair pair{a, b};
  if (!overlap(a.box(), b.box())) return {};
  if (have_same_triangles(a, b)) return relation_of_equal_triangles(pair);
  const FirstLook look = look_at_contacts(pair, visit);
  if (!look.surfaces_meet) return relation_of_disjoint_surfaces(pair);
  return from_regions(true, look.seen.all() ? look.seen : all_regions(pair, look.seen));
}

}  // namespace toccata
