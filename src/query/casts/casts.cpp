#include "toccata/query/casts.hpp"

#include <algorithm>
#include <optional>
#include <variant>

#include "math/constants.hpp"
#include "query/ask.hpp"
#include "query/casts/cast_until.hpp"
#include "query/casts/mesh_casts.hpp"
#include "query/near_parts.hpp"
#include "query/search_scratch.hpp"
#include "toccata/core/error.hpp"

namespace toccata {
namespace {

std::optional<ShapeHit> whole(const std::optional<Cast>& cast) {
  return cast ? std::optional(ShapeHit{*cast, 0, 0, 0, 0}) : std::nullopt;
}

struct AskCast {
  std::optional<ShapeHit> operator()(const PosedPolytope& a, const PosedPolytope& b) const {
    return whole(with_start_normal(cast_shape(a, motion, b, &scratch.convex), a, b));
  }
  std::optional<ShapeHit> operator()(const PosedHalfSpace&, const PosedHalfSpace&) const {
    return {};  // the table was asked before
  }
  template <PosedConvexSet A, PosedConvexSet B>
  std::optional<ShapeHit> operator()(const A& a, const B& b) const {
    return whole(cast_convex_until(a, motion, b, limit, scratch.convex));
  }
  template <class A, class B>
  std::optional<ShapeHit> operator()(const A& a, const B& b) const {
    return cast_until(a, motion, b, limit, scratch);
  }

  const Vec3& motion;
  double limit;
  SearchScratch& scratch;
};

/// Elements and faces counted from where those of the parts begin.
ShapeHit numbered(ShapeHit hit, const PosedPart& a, const PosedPart& b) {
  hit.element_a += a.first_element;
  hit.element_b += b.first_element;
  hit.face_a += a.first_face;
  hit.face_b += b.first_face;
  return hit;
}

}  // namespace

std::optional<ShapeHit> cast_until(const Model& a, const Vec3& motion, const Model& b, const PairQuery& query,
                                   double limit, Workspace& workspace) {
  if (!is_finite(motion)) throw Error("a cast: the motion has a coordinate that is not finite");
  const PosedModelPair models(a, b, query, workspace.scratch());
  require_all_answered(ShapeQuestion::cast_shape, models.a, models.b);
  std::optional<ShapeHit> first;
  const auto entry = [&](const Aabb& box_a, const Aabb& box_b) {
    return is_empty(box_a) ? infinity : box_entry(box_a, motion, box_b);
  };
  NearParts pairs(models.a, models.b, entry, limit, workspace.scratch());
  while (const std::optional<ItemPair> next = pairs.next(limit)) {
    const PosedPart &part_a = models.a.parts[next->first], &part_b = models.b.parts[next->second];
    const auto found = std::visit(AskCast{motion, limit, workspace.scratch()}, part_a.shape, part_b.shape);
    if (!found) continue;
    keep_first(first, numbered(*found, part_a, part_b));
    if (first->upper == 0) break;
    limit = std::min(limit, first->upper + widest_cast);
  }
  return first;
}

std::optional<ShapeHit> cast_shape(const Model& a, const Vec3& motion, const Model& b, const PairQuery& query) {
  Workspace workspace;
  return cast_shape(a, motion, b, query, workspace);
}

std::optional<ShapeHit> cast_shape(const Model& a, const Vec3& motion, const Model& b, const PairQuery& query,
                                   Workspace& workspace) {
  return cast_until(a, motion, b, query, 1, workspace);
}

}  // namespace toccata
