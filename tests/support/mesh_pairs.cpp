#include "support/mesh_pairs.hpp"

#include <algorithm>
#include <tuple>

#include "toccata/bounds/aabb.hpp"
#include "toccata/query/overlap.hpp"

namespace toccata::test {
namespace {

auto place(const Contact& contact) { return std::pair(contact.element_a, contact.element_b); }

std::vector<Triangle> world_triangles(const Model& model, const Pose& pose) {
  std::vector<Triangle> triangles;
  for (Index i = 0; i < model.mesh().triangle_count(); ++i) triangles.push_back(world_triangle(model, pose, i));
  return triangles;
}

std::vector<Aabb> boxes_of(const std::vector<Triangle>& triangles) {
  std::vector<Aabb> boxes;
  for (const Triangle& triangle : triangles) boxes.push_back(fit_aabb(triangle.vertex));
  return boxes;
}

/// With the models exchanged, and in the order of that question.
std::vector<Contact> exchanged(std::vector<Contact> contacts) {
  for (Contact& contact : contacts)
    contact = {contact.element_b, contact.element_a, contact.face_b, contact.face_a, flipped(contact.intersection)};
  std::sort(contacts.begin(), contacts.end(), [](const Contact& x, const Contact& y) { return place(x) < place(y); });
  return contacts;
}

bool is_first(const std::optional<Contact>& first, const std::vector<Contact>& all) {
  return all.empty() ? !first.has_value() : first == all.front();
}

/// What is wrong in one order of the models; empty if nothing is.
std::string fault_one_way(const Model& a, const Model& b, const PairQuery& query,
                          const std::vector<Contact>& expected) {
  if (!same(contacts(a, b, query), expected)) return "contacts";
  if (!is_first(first_contact(a, b, query), expected)) return "first_contact";
  if (overlap(a, b, query) != !expected.empty()) return "overlap";
  return "";
}

}  // namespace

PairQuery exchanged(const PairQuery& query) { return {query.pose_b, query.pose_a, query.solid_b, query.solid_a}; }

bool same(const std::vector<Contact>& x, const std::vector<Contact>& y) { return x == y; }

std::vector<Contact> contacts_by_brute_force(const Model& a, const Model& b, const PairQuery& query) {
  const auto triangles_a = world_triangles(a, query.pose_a), triangles_b = world_triangles(b, query.pose_b);
  const auto boxes_a = boxes_of(triangles_a), boxes_b = boxes_of(triangles_b);
  std::vector<Contact> found;
  for (Index i = 0; i < triangles_a.size(); ++i)
    for (Index j = 0; j < triangles_b.size(); ++j)
      if (overlap(boxes_a[i], boxes_b[j]) && overlap(triangles_a[i], triangles_b[j]))
        found.push_back({i, j, a.mesh().face_of(i), b.mesh().face_of(j), intersect(triangles_a[i], triangles_b[j])});
  return found;
}

std::string fault_of_surface_queries(const Model& a, const Model& b, const PairQuery& query) {
  const std::vector<Contact> expected = contacts_by_brute_force(a, b, query);
  std::string fault = fault_one_way(a, b, query, expected);
  if (!fault.empty()) return fault;
  const std::string swapped = fault_one_way(b, a, exchanged(query), exchanged(expected));
  return swapped.empty() ? "" : swapped + " with the models exchanged";
}

}  // namespace toccata::test
