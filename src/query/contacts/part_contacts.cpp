#include "query/contacts/part_contacts.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "query/ask.hpp"
#include "query/meshes/pair_search.hpp"
#include "query/meshes/triangles_shape.hpp"
#include "query/near_parts.hpp"
#include "toccata/narrow/quadrics.hpp"

namespace toccata {
namespace {

/// It was made of a Triangle; no hull is in the world.
bool is_triangle(const PosedPolytope& shape) {
  return shape.in_world() && shape.vertex_count() == 3 && shape.radius() == 0;
}

Triangle world_triangle_of(const PosedPolytope& shape) { return {{shape.vertex(0), shape.vertex(1), shape.vertex(2)}}; }

/// The contacts of one part of A and one of B; they lie in the scratch.
struct PartContacts {
  std::span<Contact> all;
};

PartContacts flipped(const PartContacts& contacts) {
  for (Contact& contact : contacts.all) contact = flipped(contact);
  return contacts;
}

struct AskContacts {
  static constexpr ShapeQuestion question = ShapeQuestion::contacts;

  PartContacts operator()(const PosedPolytope& a, const PosedPolytope& b) const {
    if (!is_triangle(a) || !is_triangle(b)) return one_if(overlap(a, b, &scratch.convex));
    const Intersection found = intersect(world_triangle_of(a), world_triangle_of(b));
    return one_if(found.kind != IntersectionKind::none, found);
  }
  PartContacts operator()(const PosedPolytope& a, const PosedHalfSpace& b) const { return one_if(overlap(a, b)); }
  PartContacts operator()(const PosedHalfSpace& a, const PosedHalfSpace& b) const { return one_if(overlap(a, b)); }
  PartContacts operator()(const PosedTriangles& a, const PosedQuadric& b) const {
    return each_of(a.mesh, triangles_intersecting(a.mesh, b, scratch));
  }
  template <PosedConvexSet Other>
  PartContacts operator()(const PosedQuadric& a, const Other& b) const {
    return one_if(overlap(a, b));
  }
  PartContacts operator()(const PosedTriangles& a, const PosedPolytope& b) const {
    const PartContacts contacts = each_of(a.mesh, triangles_intersecting(a.mesh, b, scratch));
    if (is_triangle(b))
      for (Contact& contact : contacts.all)
        contact.intersection = intersect(a.mesh.triangle(contact.element_a), world_triangle_of(b));
    return contacts;
  }
  PartContacts operator()(const PosedTriangles& a, const PosedHalfSpace& b) const {
    return each_of(a.mesh, triangles_intersecting(a.mesh, b, scratch));
  }
  PartContacts operator()(const PosedTriangles& a, const PosedTriangles& b) const {
    static_cast<void>(surface_contacts(a.mesh, b.mesh, scratch, threads));
    return {scratch.contacts};
  }

  [[nodiscard]] PartContacts one_if(bool met, const Intersection& found = {}) const {
    scratch.part_contacts.assign(met ? 1 : 0, {0, 0, 0, 0, found});
    return {scratch.part_contacts};
  }

  [[nodiscard]] PartContacts each_of(const PosedMesh& mesh, std::span<const Index> triangles) const {
    scratch.part_contacts.clear();
    for (const Index i : triangles) scratch.part_contacts.push_back({i, 0, mesh.model().mesh().face_of(i), 0, {}});
    return {scratch.part_contacts};
  }

  SearchScratch& scratch;
  int threads;
};

void append(std::vector<Contact>& to, const PartContacts& from, const PosedPart& a, const PosedPart& b) {
  for (Contact contact : from.all) {
    contact.element_a += a.first_element;
    contact.element_b += b.first_element;
    contact.face_a += a.first_face;
    contact.face_b += b.first_face;
    to.push_back(contact);
  }
}

}  // namespace

std::span<const Contact> contacts_of(const PosedModel& a, const PosedModel& b, SearchScratch& scratch, int threads) {
  std::vector<Contact>& all = scratch.all_contacts;
  all.clear();
  require_all_answered(ShapeQuestion::contacts, a, b);
  NearParts pairs(a, b, gap_of_parts, 0, scratch);
  while (const std::optional<ItemPair> next = pairs.next(0)) {
    const PosedPart &part_a = a.parts[next->first], &part_b = b.parts[next->second];
    append(all, ask(AskContacts{scratch, threads}, part_a, part_b), part_a, part_b);
  }
  std::sort(all.begin(), all.end(), [](const Contact& c, const Contact& d) {
    return c.element_a != d.element_a ? c.element_a < d.element_a : c.element_b < d.element_b;
  });
  return all;
}

PosedPart posed_element(const PosedModel& model, Index element) {
  for (auto part = model.parts.rbegin(); part != model.parts.rend(); ++part) {
    if (part->first_element > element) continue;
    const auto* triangles = std::get_if<PosedTriangles>(&part->shape);
    const Index number = element - part->first_element;
    if (number >= (triangles ? triangles->mesh.model().element_count() : 1)) break;
    if (!triangles) return *part;
    return {PosedShape(std::in_place_type<PosedPolytope>, triangles->mesh.triangle(number)), ShapeKind::triangle};
  }
  throw Error(fmt::format("there is no element {} in the model", element));
}

}  // namespace toccata
