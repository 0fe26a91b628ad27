#include "query/relation/relation_locality.hpp"

#include <optional>
#include <utility>

#include "query/index_set.hpp"
#include "query/inside/inside_winding.hpp"
#include "query/meshes/world_search.hpp"
#include "query/relation/relation_arrangement.hpp"

namespace toccata {
namespace {

std::vector<Triangle> world_triangles(const PosedMesh& mesh, std::span<const Index> numbers) {
  std::vector<Triangle> triangles;
  triangles.reserve(numbers.size());
  for (const Index number : numbers) triangles.push_back(mesh.triangle(number));
  return triangles;
}

void append(std::vector<Triangle>& to, const std::vector<Triangle>& from) {
  to.insert(to.end(), from.begin(), from.end());
}

/// The triangles of the mesh whose boxes meet that of one of these, and maybe others.
std::vector<Triangle> triangles_near(const PosedMesh& mesh, std::span<const Triangle> triangles) {
  // To look near so many takes longer than to look at all.
  if (triangles.size() >= mesh.model().mesh().triangle_count()) return mesh.triangles();
  IndexSet found(mesh.model().mesh().triangle_count());
  for (const Triangle& t : triangles)
    visit_triangles_near(mesh, box_of(t), [&](Index number) {
      found.add(number);
      return true;
    });
  return world_triangles(mesh, std::move(found).ascending());
}

/// What can border on what hangs on the vertices of triangles without area, which have no sides to look at.
RegionsSeen possible_beyond_flat(const SolidPair& pair, const ContactTriangles& contacts) {
  RegionsSeen possible;
  for (const Triangle& t : world_triangles(pair.a, contacts.of_a))
    for (int i = 0; i < 3 && !has_area(t); ++i)
      possible = possible | possible_at_surface_of_a(is_interior(t[i], pair.b));
  for (const Triangle& t : world_triangles(pair.b, contacts.of_b))
    for (int i = 0; i < 3 && !has_area(t); ++i)
      possible = possible | possible_at_surface_of_b(is_interior(t[i], pair.a));
  return possible;
}

Vec3 vertex_of_part(const PosedMesh& mesh, Index part) {
  return mesh.triangle(mesh.model().mesh_parts().first_triangle[part])[0];
}

std::optional<Triangle> triangle_with_area(const PosedMesh& mesh, Index part) {
  const MeshParts& parts = mesh.model().mesh_parts();
  for (std::size_t i = parts.first_triangle[part]; i < parts.part_of_triangle.size(); ++i) {
    if (parts.part_of_triangle[i] != part) continue;
    const Triangle t = mesh.triangle(static_cast<Index>(i));
    if (has_area(t)) return t;
  }
  return std::nullopt;
}

}  // namespace

RegionsKnown regions_at_contacts(const SolidPair& pair, const ContactTriangles& contacts) {
  RegionsKnown known;
  if (contacts.of_a.empty()) return known;
  std::vector<Triangle> of_interest = world_triangles(pair.a, contacts.of_a);
  append(of_interest, world_triangles(pair.b, contacts.of_b));
  std::vector<Triangle> beside = triangles_near(pair.a, of_interest);
  append(beside, triangles_near(pair.b, of_interest));

  known.possible = possible_beyond_flat(pair, contacts);
  const Arrangement arrangement(std::move(of_interest), std::move(beside));
  arrangement.visit_patches([&](const ExactPoint& p, const Triangle& sheet) {
    const SidesOfPoint sides = sides_of(pair, p, sheet);
    if (sides.on_another_plane) return CellVisit::another;
    known.seen = known.seen | sides.seen;
    known.possible = known.possible | sides.possible_beyond;
    return known.seen.all() ? CellVisit::stop : CellVisit::next;
  });
  return known;
}

RegionsSeen regions_possible_at_other_parts(const SolidPair& pair, const ContactTriangles& contacts) {
  RegionsSeen possible;
  for (const Index part : parts_without(pair.a, contacts.of_a))
    possible = possible | possible_at_surface_of_a(is_interior(vertex_of_part(pair.a, part), pair.b));
  for (const Index part : parts_without(pair.b, contacts.of_b))
    possible = possible | possible_at_surface_of_b(is_interior(vertex_of_part(pair.b, part), pair.a));
  return possible;
}

RegionsSeen sample_other_parts(const SolidPair& pair, const ContactTriangles& contacts) {
  RegionsSeen seen;
  const auto sample_at = [&](const PosedMesh& mesh, std::span<const Index> with_contacts) {
    for (const Index part : parts_without(mesh, with_contacts))
      if (const std::optional<Triangle> t = triangle_with_area(mesh, part)) seen = seen | sample(pair, *t);
  };
  sample_at(pair.a, contacts.of_a);
  sample_at(pair.b, contacts.of_b);
  return seen;
}

std::vector<Index> parts_without(const PosedMesh& mesh, std::span<const Index> triangles) {
  const MeshParts& parts = mesh.model().mesh_parts();
  std::vector<bool> has_one(parts.first_triangle.size());
  for (const Index t : triangles) has_one[parts.part_of_triangle[t]] = true;
  std::vector<Index> without;
  for (std::size_t part = 0; part < has_one.size(); ++part)
    if (!has_one[part]) without.push_back(static_cast<Index>(part));
  return without;
}

bool is_interior(const Vec3& point, const PosedMesh& closed) {
  if (!contains(closed.box(), {point, point})) return false;
  const LineWinding winding = wind_along(closed, ExactPoint(point), 0);
  return !winding.on_face && winding.ahead != 0;
}

}  // namespace toccata
