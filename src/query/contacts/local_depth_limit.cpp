#include "query/contacts/local_depth_limit.hpp"

#include "math/constants.hpp"
#include "query/contacts/outward_turn.hpp"
#include "query/contacts/region_depth.hpp"
#include "query/posed_mesh_pair.hpp"
#include "query/posed_shape.hpp"
#include "query/volume/crossed_surfaces.hpp"
#include "query/volume/winding_volume.hpp"

namespace toccata {
namespace {

/// Every triangle in the region has the outside on one of its sides.
bool bounds_its_solid(const PosedMesh& mesh, const Aabb& region, SearchScratch& scratch) {
  return only_winding_in(mesh, region, scratch).has_value();
}

}  // namespace

std::optional<Vec3> inner_common_point(const Model& a, const Model& b, const PairQuery& query, SearchScratch& scratch) {
  const PosedMeshPair pair(a, b, query);
  const CommonDepth depth(a, b, query, pair, outward_turn(pair.a, 0), outward_turn(pair.b, 0), scratch);
  return depth.inner_point(common_box(pair.a.box(), pair.b.box()));
}

ContactRegion::Depth local_depth_against(double limit, const Model& a, const Model& b, const PairQuery& query,
                                         SearchScratch& scratch) {
  const PosedMeshPair pair(a, b, query);
  const Aabb common = common_box(pair.a.box(), pair.b.box());
  const CommonDepth depth(a, b, query, pair, outward_turn(pair.a, 0), outward_turn(pair.b, 0), scratch);
  ContactRegion::Depth found = depth.against(limit, common);
  if (found.lower > limit) return {found.lower, infinity};
  if (found.upper > limit) return found;
  // Where no point seems deeper than the limit, the surfaces that it was measured to are no farther than that.
  const Aabb region = widened(common, limit);
  if (!bounds_its_solid(pair.a, region, scratch) || !bounds_its_solid(pair.b, region, scratch)) found.upper = infinity;
  return found;
}

}  // namespace toccata
