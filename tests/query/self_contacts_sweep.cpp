// A mesh against itself: every two triangles in rational arithmetic, and both questions of the library.
#include <fmt/format.h>

#include "oracle/meshes.hpp"
#include "support/case_seeds.hpp"
#include "support/self_meshes.hpp"
#include "toccata/query/self_contacts.hpp"

namespace toccata::test {
namespace {

bool is_intersection_of(const Contact& contact, const Model& model, const Pose& pose) {
  return contact.intersection ==
         intersect(world_triangle(model, pose, contact.element_a), world_triangle(model, pose, contact.element_b));
}

std::string fault_of_self_contacts(const SelfMesh& made) {
  const Model model(made.mesh);
  const auto expected = oracle::self_intersecting_pairs(oracle::surface_set(made.mesh, made.pose));
  const std::vector<Contact> contacts = self_contacts(model, made.pose);
  std::vector<oracle::TrianglePair> found;
  for (const Contact& contact : contacts) {
    found.push_back({contact.element_a, contact.element_b});
    if (!is_intersection_of(contact, model, made.pose)) return "a meeting is not that of the triangles";
  }
  if (found != expected) return fmt::format("self_contacts finds {} of {}", found.size(), expected.size());
  return self_overlap(model, made.pose) == !expected.empty() ? "" : "self_overlap";
}

SweepResult run_self_contacts(const std::string& family, std::uint64_t seed, std::uint64_t cases) {
  return run_cases(family, seed, cases, [&](std::uint64_t case_seed) {
    Random random(case_seed);
    return fault_of_self_contacts(random_self_mesh(family, random));
  });
}

const bool self_contacts_known =
    register_sweep({"self-contacts", self_mesh_families(), 50'000, 100, run_self_contacts});

}  // namespace
}  // namespace toccata::test
