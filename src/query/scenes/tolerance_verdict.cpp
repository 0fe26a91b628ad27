#include "query/scenes/tolerance_verdict.hpp"

#include <optional>

#include "math/constants.hpp"
#include "query/contacts/local_depth_limit.hpp"
#include "query/penetration/solid_penetration.hpp"
#include "query/volume/solid_volume.hpp"

namespace toccata {
namespace {

using Tolerance = PairAnswer::Tolerance;

/// The translation is no shorter than how deep they are anywhere: within by it is within by both.
Tolerance by_translation(const PairAnswer& answer, double tolerance) {
  if (!answer.penetration) return Tolerance::undecided;
  if (answer.penetration->upper <= tolerance) return Tolerance::within;
  return answer.penetration->lower > tolerance ? Tolerance::beyond : Tolerance::undecided;
}

bool are_solid_meshes(const PairAnswer& answer, const OverlappingModels& models) {
  const Relation& relation = answer.relation;
  return models.a.has_mesh() && models.b.has_mesh() && relation.a_solid && relation.b_solid &&
         relation.kind == RelationKind::overlapping && relation.containment == Containment::none;
}

/// What the regions say, where they are known and one is deeper; else what is found.
ContactRegion::Depth local_depth(const PairAnswer& answer, double tolerance, const OverlappingModels& models,
                                 Workspace& workspace) {
  if (!answer.regions.empty())
    if (const auto& deepest = answer.regions[0].depth; deepest && deepest->lower > tolerance)
      return {deepest->lower, infinity};
  return local_depth_against(tolerance, models.a, models.b, models.query, workspace.scratch());
}

}  // namespace

void tell_depth(PairAnswer& answer, const OverlappingModels& models, Workspace& workspace) {
  workspace.scratch().convex = {};  // it was another pair's
  const auto depth = depth_where_defined(models.a, models.b, models.query, answer.relation, models.depth, workspace);
  if (!depth) return;
  const auto width = [](const Penetration& known) { return known.upper - known.lower; };
  if (answer.penetration && width(*answer.penetration) <= width(depth->penetration)) return;
  answer.penetration = depth->penetration;
  answer.depth_end = depth->end;
}

void tell_verdict(PairAnswer& answer, double tolerance, const OverlappingModels& models, Workspace& workspace) {
  if (are_surely_touching(answer.relation)) return;
  answer.tolerance = by_translation(answer, tolerance);
  if (answer.tolerance == Tolerance::within) return;
  if (are_solid_meshes(answer, models)) {
    const ContactRegion::Depth local = local_depth(answer, tolerance, models, workspace);
    if (local.lower > tolerance || local.upper <= tolerance) {
      answer.tolerance = local.lower > tolerance ? Tolerance::beyond : Tolerance::within;
      answer.local_depth = local;
      return;
    }
  }
  DepthOptions depth = models.depth;
  for (const double narrower : {1.0, 0x1p-3, 0x1p-7}) {
    if (answer.tolerance != Tolerance::undecided) return;
    depth.precision = narrower * models.depth.precision;
    if (!answer.penetration || narrower < 1) tell_depth(answer, {models.a, models.b, models.query, depth}, workspace);
    if (!answer.penetration) return;
    answer.tolerance = by_translation(answer, tolerance);
  }
}

}  // namespace toccata
