#include <fmt/format.h>

#include <span>
#include <vector>

#include "methods/bsp/bsp_parts.hpp"
#include "toccata/core/error.hpp"
#include "toccata/query/self_contacts.hpp"
#include "toccata/shapes/mesh_health.hpp"

namespace toccata {
namespace {

constexpr std::string_view purpose = "a BSP tree is made of a closed mesh that does not intersect itself";

void require_closed(const Model& solid) {
  if (solid.closed()) return;
  for (const MeshFault& fault : mesh_faults(solid.mesh()))
    if (!fault.edges.empty())
      throw Error(
          fmt::format("{}, and this one is open: {} edges are used unequally often in the two directions; "
                      "look at that from vertex {} to vertex {}",
                      purpose, inspect(solid.mesh()).unbalanced_edges, fault.edges[0][0], fault.edges[0][1]));
  throw Error(fmt::format("{}, and this one is open", purpose));
}

void require_area(const BspPlanes& planes) {
  for (Index t = 0; t < planes.triangle_count(); ++t)
    if (!has_area(planes.triangle(t)))
      throw Error(fmt::format("triangle {} has no area, so there is no plane of it to make a BSP tree with", t));
}

void require_no_self_contact(const Model& solid) {
  const std::vector<Contact> contacts = self_contacts(solid);
  if (contacts.empty()) return;
  throw Error(fmt::format("{}, and this one does: {} pairs of triangles, first triangles {} and {}", purpose,
                          contacts.size(), contacts[0].element_a, contacts[0].element_b));
}

}  // namespace

void require_possible(const BspOptions& options) {
  if (options.candidates == 0 || !(options.split_weight >= 0) || !(options.max_growth >= 1))
    throw Error(
        fmt::format("a BSP tree needs at least one candidate, a split weight of 0 or more, and a max_growth of "
                    "1 or more; here they are {}, {} and {}",
                    options.candidates, options.split_weight, options.max_growth));
}

/// So that ten planes of each triangle, and eight times the numbers of children, can be counted, a tree has fewer than
/// 2^28 fragments.
void require_growth_allowed(double fragments, Index triangles, const BspOptions& options) {
  if (fragments <= options.max_growth * triangles && fragments < 0x1p28) return;
  throw Error(fmt::format(
      "the BSP tree of {} triangles has come to {} fragments, more than {} times as many: allow a greater max_growth",
      triangles, fragments, options.max_growth));
}

void require_finite_point(const Vec3& p) {
  if (!is_finite(p))
    throw Error(fmt::format("the point ({}, {}, {}) has a coordinate that is not finite", p.x, p.y, p.z));
}

void require_solid_for_bsp(const Model& solid) {
  if (!solid.has_mesh()) throw Error(fmt::format("{}, and the model is no mesh", purpose));
  require_closed(solid);
  require_area(BspPlanes(solid.mesh(), BspFrame(solid.bounds())));
  require_no_self_contact(solid);
}

}  // namespace toccata
