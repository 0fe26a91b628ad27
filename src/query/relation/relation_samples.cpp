#include "query/relation/relation_samples.hpp"

#include <utility>
#include <vector>

#include "query/inside/inside_winding.hpp"
#include "query/relation/relation_arrangement.hpp"

namespace toccata {
namespace {

RegionsSeen region_of(int winding_a, int winding_b) {
  const bool in_a = winding_a != 0, in_b = winding_b != 0;
  return {in_a && in_b, in_a && !in_b, in_b && !in_a};
}

RegionsSeen sample_cells(const SolidPair& pair, const Triangle& t, std::span<const Triangle> cuts) {
  RegionsSeen seen;
  if (!has_area(t)) return seen;
  visit_cells(t, cuts, [&](const ExactPoint& p) {
    seen = seen | sides_of(pair, p, t).seen;
    return seen.all() ? CellVisit::stop : CellVisit::next;
  });
  return seen;
}

}  // namespace

RegionsSeen operator|(const RegionsSeen& x, const RegionsSeen& y) {
  return {x.in_both || y.in_both, x.only_in_a || y.only_in_a, x.only_in_b || y.only_in_b};
}

RegionsSeen possible_at_surface_of_a(bool in_b) { return {in_b, !in_b, in_b}; }

RegionsSeen possible_at_surface_of_b(bool in_a) { return {in_a, in_a, !in_a}; }

SidesOfPoint sides_of(const SolidPair& pair, const ExactPoint& p, const Triangle& t) {
  const int axis = projection_axis(t);
  const LineWinding a = wind_along(pair.a, p, axis, t), b = wind_along(pair.b, p, axis, t);
  SidesOfPoint sides{region_of(a.ahead, b.ahead) | region_of(a.behind, b.behind), {}, false};
  sides.on_another_plane = a.on_another_plane || b.on_another_plane;
  // A surface on one side of which the other solid is lies on the surface of that solid.
  const bool in_a = a.ahead != 0, in_b = b.ahead != 0;
  if (in_b == (b.behind != 0)) sides.possible_beyond = sides.possible_beyond | possible_at_surface_of_a(in_b);
  if (in_a == (a.behind != 0)) sides.possible_beyond = sides.possible_beyond | possible_at_surface_of_b(in_a);
  return sides;
}

RegionsSeen sample(const SolidPair& pair, const Triangle& t) { return sample_cells(pair, t, {}); }

RegionsSeen sample(const SolidPair& pair, const Triangle& t, const Triangle& cut) {
  return sample_cells(pair, t, std::span(&cut, 1));
}

RegionsSeen all_regions(const SolidPair& pair, const RegionsSeen& seen) {
  RegionsSeen result = seen;
  std::vector<Triangle> triangles = pair.a.triangles();
  const std::vector<Triangle> of_b = pair.b.triangles();
  triangles.insert(triangles.end(), of_b.begin(), of_b.end());
  const Arrangement arrangement(std::move(triangles));
  arrangement.visit_patches([&](const ExactPoint& p, const Triangle& sheet) {
    const SidesOfPoint sides = sides_of(pair, p, sheet);
    if (sides.on_another_plane) return CellVisit::another;
    result = result | sides.seen;
    return result.all() ? CellVisit::stop : CellVisit::next;
  });
  return result;
}

}  // namespace toccata
