#include "query/volume/volume_cells.hpp"

#include <cstddef>
#include <deque>

#include "query/inside/inside_winding.hpp"
#include "query/meshes/world_search.hpp"
#include "query/volume/winding_volume.hpp"
#include "toccata/bounds/volume.hpp"

namespace toccata {
namespace {

constexpr std::size_t most_volume_cells = 40'000;

/// Where a cell lies to a solid.
enum class SolidPlace { open, inside, outside };

struct VolumeCell {
  Aabb box;
  SolidPlace in_a = SolidPlace::open;
  SolidPlace in_b = SolidPlace::open;
};

bool is_crossed(const Aabb& box, const PosedMesh& mesh) {
  bool found = false;
  visit_triangles_near(mesh, box, [&](Index number) { return !(found = overlap(box, mesh.triangle(number))); });
  return found;
}

SolidPlace solid_place_of(const Aabb& box, const PosedMesh& mesh) {
  if (is_crossed(box, mesh)) return SolidPlace::open;
  return wind_along(mesh, ExactPoint(box.lower), 0).ahead != 0 ? SolidPlace::inside : SolidPlace::outside;
}

int axis_to_halve(const Aabb& box) {
  const Vec3 size = box.upper - box.lower;
  if (size.x >= size.y && size.x >= size.z) return 0;
  return size.y >= size.z ? 1 : 2;
}

}  // namespace

VolumeBracket volume_by_cells(const PosedMesh& a, const PosedMesh& b) {
  if (!overlap(a.box(), b.box())) return {};
  BoundedNumber certain, possible;
  std::deque<VolumeCell> waiting{{common_box(a.box(), b.box())}};
  for (std::size_t seen = 0; !waiting.empty() && seen < most_volume_cells; ++seen) {
    VolumeCell cell = waiting.front();
    waiting.pop_front();
    if (cell.in_a == SolidPlace::open) cell.in_a = solid_place_of(cell.box, a);
    if (cell.in_a == SolidPlace::outside) continue;
    if (cell.in_b == SolidPlace::open) cell.in_b = solid_place_of(cell.box, b);
    if (cell.in_b == SolidPlace::outside) continue;
    if (cell.in_a == SolidPlace::inside && cell.in_b == SolidPlace::inside) {
      certain = certain + bounded_volume(cell.box);
      continue;
    }
    const int axis = axis_to_halve(cell.box);
    const double half = 0.5 * cell.box.lower[axis] + 0.5 * cell.box.upper[axis];
    if (!(cell.box.lower[axis] < half && half < cell.box.upper[axis])) {  // no double between
      possible = possible + bounded_volume(cell.box);
      continue;
    }
    VolumeCell above = cell;
    cell.box.upper[axis] = half;
    above.box.lower[axis] = half;
    waiting.push_back(cell);
    waiting.push_back(above);
  }
  for (const VolumeCell& cell : waiting) possible = possible + bounded_volume(cell.box);
  return {volume_bracket_of(certain).lower, volume_bracket_of(certain + possible).upper};
}

}  // namespace toccata
