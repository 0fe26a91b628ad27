#include "query/part_contacts.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "query/ask.hpp"
#include "query/pair_search.hpp"
#include "query/triangles_shape.hpp"

namespace toccata {
namespace {

using Contacts = std::vector<Contact>;

/// It was made of a Triangle; no hull is in the world.
bool is_triangle(const PosedConvex& shape) {
  return shape.in_world() && shape.vertex_count() == 3 && shape.radius() == 0;
}

Triangle triangle_of(const PosedConvex& shape) { return {{shape.vertex(0), shape.vertex(1), shape.vertex(2)}}; }

struct AskContacts {
  static constexpr ShapeQuestion question = ShapeQuestion::contacts;

  Contacts operator()(const PosedConvex& a, const PosedConvex& b) const {
    if (!is_triangle(a) || !is_triangle(b)) return one_if(overlap(a, b, &scratch.convex));
    const Meeting found = meeting(triangle_of(a), triangle_of(b));
    if (found.kind == MeetingKind::none) return {};
    return {{0, 0, 0, 0, found}};
  }
  Contacts operator()(const PosedConvex& a, const PosedHalfSpace& b) const { return one_if(overlap(a, b)); }
  Contacts operator()(const PosedHalfSpace& a, const PosedHalfSpace& b) const { return one_if(overlap(a, b)); }
  Contacts operator()(const PosedTriangles& a, const PosedConvex& b) const {
    Contacts contacts = each_of(a.mesh, triangles_meeting(a.mesh, b));
    if (is_triangle(b))
      for (Contact& contact : contacts) contact.meeting = meeting(a.mesh.triangle(contact.triangle_a), triangle_of(b));
    return contacts;
  }
  Contacts operator()(const PosedTriangles& a, const PosedHalfSpace& b) const {
    return each_of(a.mesh, triangles_meeting(a.mesh, b));
  }
  Contacts operator()(const PosedTriangles& a, const PosedTriangles& b) const {
    const auto found = surface_contacts(a.mesh, b.mesh, scratch, threads);
    return {found.begin(), found.end()};
  }

  static Contacts one_if(bool met) { return met ? Contacts{Contact{}} : Contacts{}; }

  static Contacts each_of(const PosedMesh& mesh, const std::vector<Index>& triangles) {
    Contacts contacts;
    contacts.reserve(triangles.size());
    for (const Index i : triangles) contacts.push_back({i, 0, mesh.model().mesh().face_of(i), 0, {}});
    return contacts;
  }

  SearchScratch& scratch;
  int threads;
};

void append(Contacts& to, const Contacts& from, const PosedPart& a, const PosedPart& b) {
  for (Contact contact : from) {
    contact.triangle_a += a.first_element;
    contact.triangle_b += b.first_element;
    contact.face_a += a.first_face;
    contact.face_b += b.first_face;
    to.push_back(contact);
  }
}

}  // namespace

std::span<const Contact> contacts_of(const PosedModel& a, const PosedModel& b, SearchScratch& scratch, int threads) {
  Contacts all;
  for (const PosedPart& part_a : a.parts)
    for (const PosedPart& part_b : b.parts)
      append(all, ask(AskContacts{scratch, threads}, part_a, part_b), part_a, part_b);
  std::sort(all.begin(), all.end(), [](const Contact& c, const Contact& d) {
    return c.triangle_a != d.triangle_a ? c.triangle_a < d.triangle_a : c.triangle_b < d.triangle_b;
  });
  scratch.contacts = std::move(all);
  return scratch.contacts;
}

PosedPart posed_element(const PosedModel& model, Index element) {
  for (auto part = model.parts.rbegin(); part != model.parts.rend(); ++part) {
    if (part->first_element > element) continue;
    const auto* triangles = std::get_if<PosedTriangles>(&part->shape);
    const Index number = element - part->first_element;
    if (number >= (triangles ? triangles->mesh.model().element_count() : 1)) break;
    if (!triangles) return *part;
    return {PosedShape(std::in_place_type<PosedConvex>, triangles->mesh.triangle(number)), ShapeKind::triangle};
  }
  throw Error(fmt::format("there is no element {} in the model", element));
}

}  // namespace toccata
