#include "query/volume/crossed_surfaces.hpp"

#include <algorithm>
#include <array>

#include "query/meshes/world_search.hpp"
#include "shapes/union_find.hpp"

namespace toccata {
namespace {

/// The triangles with area of that side, ascending, each once.
std::vector<Index> in_contact_of(const PosedMesh& mesh, std::span<const Contact> contacts, ContactSide side) {
  std::vector<Index> found;
  for (const Contact& contact : contacts) found.push_back(triangle_of(contact, side));
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  std::erase_if(found, [&](Index number) { return !has_area(mesh.triangle(number)); });
  return found;
}

}  // namespace

std::vector<Index> triangles_in_region(const PosedMesh& mesh, const Aabb& region) {
  std::vector<Index> found;
  visit_triangles_near(mesh, region, [&](Index number) {
    if (has_area(mesh.triangle(number))) found.push_back(number);
    return true;
  });
  std::sort(found.begin(), found.end());
  return found;
}

Aabb common_box(const Aabb& a, const Aabb& b) {
  return {{std::max(a.lower.x, b.lower.x), std::max(a.lower.y, b.lower.y), std::max(a.lower.z, b.lower.z)},
          {std::min(a.upper.x, b.upper.x), std::min(a.upper.y, b.upper.y), std::min(a.upper.z, b.upper.z)}};
}

BoundedNumber share_at_plane(const Triangle& plane, const Vec3& from, const Vec3& to) {
  const BoundedVector normal = cross(bounded_difference(plane[1], plane[0]), bounded_difference(plane[2], plane[0]));
  const BoundedNumber share =
      dot(normal, bounded_difference(from, plane[0])) / dot(normal, bounded_difference(from, to));
  if (share.error < 0.25) return share;
  return {{0.5, 0}, 0.25};  // between 0 and 1 in any case
}

VolumeSurface::VolumeSurface(const PosedMesh& mesh, const PosedMesh& other, VolumeSide side,
                             std::vector<Index> in_contact)
    : graph_(mesh), other_(other), side_(side), in_contact_(std::move(in_contact)) {}

int VolumeSurface::winding_at(Index vertex) {
  const auto [found, is_new] = windings_.try_emplace(vertex, 0);
  if (is_new) found->second = perturbed_winding(graph_.position(vertex), side_, other_);
  return found->second;
}

std::span<const std::pair<Index, int>> VolumeSurface::whole_triangles() {
  if (!has_whole_) whole_ = found_whole();
  has_whole_ = true;
  return whole_;
}

std::vector<std::pair<Index, int>> VolumeSurface::found_whole() {
  std::vector<Index> whole;
  for (const Index t : triangles_in_region(mesh(), common_box(mesh().box(), other_.box())))
    if (!std::binary_search(in_contact_.begin(), in_contact_.end(), t)) whole.push_back(t);
  std::vector<std::array<Index, 3>> corners;
  for (const Index t : whole) corners.push_back(graph_.corners(t));
  UnionFind joined(graph_.vertex_count());
  for (const auto& c : corners) {
    joined.unite(c[0], c[1]);
    joined.unite(c[0], c[2]);
  }
  std::vector<std::pair<Index, int>> found;
  for (std::size_t i = 0; i < whole.size(); ++i)
    if (const int winding = winding_at(joined.leader(corners[i][0])); winding != 0)
      found.emplace_back(whole[i], winding);
  for (const auto& c : corners)
    for (const Index vertex : c) windings_.try_emplace(vertex, winding_at(joined.leader(vertex)));
  return found;
}

CrossedSurfaces::CrossedSurfaces(const PosedMesh& first_mesh, const PosedMesh& second_mesh,
                                 std::span<const Contact> contacts)
    : first(first_mesh, second_mesh, VolumeSide::first, in_contact_of(first_mesh, contacts, ContactSide::a)),
      second(second_mesh, first_mesh, VolumeSide::second, in_contact_of(second_mesh, contacts, ContactSide::b)) {
  for (const Contact& contact : contacts) {
    const Triangle a = first.triangle(contact.element_a), b = second.triangle(contact.element_b);
    if (!has_area(a) || !has_area(b)) continue;
    const EdgesThrough through = perturbed_edges_through(a, b);
    if (through.any()) pairs.push_back({contact.element_a, contact.element_b, through});
  }
}

}  // namespace toccata
