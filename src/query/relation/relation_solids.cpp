#include "query/relation/relation_solids.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "query/index_set.hpp"
#include "query/meshes/world_search.hpp"
#include "query/relation/relation_locality.hpp"
#include "query/relation/relation_quadrants.hpp"
#include "query/relation/relation_samples.hpp"

namespace toccata {
namespace {

/// After so many pairs of crossing triangles whose neighbourhoods did not show all there is, look at everything.
constexpr int most_pair_samples = 16;

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
  RegionsSeen seen;
  ContactTriangles contacts;
};

/// Beside a pair of triangles that cross one usually sees all kinds of region at once.
FirstLook look_at_contacts(const SolidPair& pair, VisitContacts visit) {
  FirstLook look;
  IndexSet of_a(pair.a.model().mesh().triangle_count()), of_b(pair.b.model().mesh().triangle_count());
  int samples = 0;
  visit([&](const Contact& contact) {
    of_a.add(contact.element_a);
    of_b.add(contact.element_b);
    if (!contact.intersection.crossing || ++samples > most_pair_samples) return true;
    const Triangle a = pair.a.triangle(contact.element_a), b = pair.b.triangle(contact.element_b);
    look.seen = look.seen | sample_quadrants(pair, a, b, contact.intersection);
    if (!look.seen.all()) look.seen = look.seen | sample(pair, a, b);
    if (!look.seen.all()) look.seen = look.seen | sample(pair, b, a);
    return !look.seen.all();
  });
  look.contacts = {std::move(of_a).ascending(), std::move(of_b).ascending()};
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
  std::vector<Triangle> triangles;
  for (Index i = 0; i < mesh.model().mesh().triangle_count(); ++i) {
    Triangle t = mesh.triangle(i);
    std::rotate(t.vertex.begin(), std::min_element(t.vertex.begin(), t.vertex.end(), lexicographically_less),
                t.vertex.end());
    triangles.push_back(t);
  }
  std::sort(triangles.begin(), triangles.end(), [&](const Triangle& s, const Triangle& t) {
    return std::lexicographical_compare(s.vertex.begin(), s.vertex.end(), t.vertex.begin(), t.vertex.end(),
                                        lexicographically_less);
  });
  return triangles;
}

/// The same triangles, in any order and numbering: then winding numbers are the same everywhere.
bool have_same_triangles(const PosedMesh& a, const PosedMesh& b) {
  if (&a.model().mesh() == &b.model().mesh() && a.pose() == b.pose()) return true;
  return a.model().mesh().triangle_count() == b.model().mesh().triangle_count() && has_triangle(b, a.triangle(0)) &&
         oriented_triangles(a) == oriented_triangles(b);
}

Relation relation_of_equal_triangles(const SolidPair& pair) {
  RegionsSeen seen;
  const Index count = std::min<Index>(most_pair_samples, pair.a.model().mesh().triangle_count());
  for (Index i = 0; i < count && !seen.in_both; ++i) seen = seen | sample(pair, pair.a.triangle(i));
  if (!seen.in_both) seen = all_regions(pair, seen);
  return from_regions(true, seen);
}

/// The relation by what borders on the triangles that meet and on the parts that meet nothing, else by everything.
Relation relation_by_regions(const SolidPair& pair, const FirstLook& look) {
  RegionsKnown known = regions_at_contacts(pair, look.contacts);
  known.seen = known.seen | look.seen;
  known.possible = known.possible | regions_possible_at_other_parts(pair, look.contacts);
  const bool sets_meet = !look.contacts.of_a.empty() || known.possible.in_both;
  if (!known.seen.in_both && !known.possible.in_both) return from_regions(sets_meet, known.seen);
  if (!known.complete()) known.seen = known.seen | sample_other_parts(pair, look.contacts);
  return from_regions(sets_meet, known.complete() ? known.seen : all_regions(pair, known.seen));
}

}  // namespace

Relation relation_of_solids(const PosedMesh& a, const PosedMesh& b, VisitContacts visit) {
  const SolidPair pair{a, b};
  if (!overlap(a.box(), b.box())) return {};
  if (have_same_triangles(a, b)) return relation_of_equal_triangles(pair);
  const FirstLook look = look_at_contacts(pair, visit);
  return look.seen.all() ? from_regions(true, look.seen) : relation_by_regions(pair, look);
}

}  // namespace toccata
