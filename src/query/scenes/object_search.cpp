#include "query/scenes/object_search.hpp"

#include <algorithm>
#include <tuple>

#include "core/require_length.hpp"
#include "query/casts/cast_until.hpp"
#include "query/casts/mesh_casts.hpp"
#include "query/keep_least.hpp"
#include "query/posed_shape.hpp"
#include "query/search_scratch.hpp"
#include "toccata/core/error.hpp"
#include "toccata/query/distance.hpp"
#include "toccata/query/overlap.hpp"
#include "toccata/query/relation.hpp"

namespace toccata {
namespace {

template <class Found>
void keep_first(std::optional<Found>& first, const Found& found) {
  keep_least(first, found, [](const Found& answer) { return std::tie(answer.upper, answer.object); });
}

/// Whose interval begins later than that is of no interest: neither can it be the first, nor does it widen that.
double last_time(const std::optional<ObjectAnswer<RayHit>>& first) { return first ? first->upper + widest_cast : 1; }
double last_time(const std::optional<ObjectAnswer<ShapeHit>>& first) { return first ? first->upper + widest_cast : 1; }

/// Where something is met at the start nothing is earlier: only one of lesser number could take its place.
template <class Found>
bool is_settled(const std::optional<Found>& first, Index other) {
  return first && first->upper == 0 && first->object < other;
}

/// A shape that is asked about: where it is, and what is wrong with it, is found out once.
class AskedShape {
 public:
  AskedShape(const SceneInstance& shape, const SearchedObjects& objects, Workspace& workspace)
      : shape_(shape), objects_(objects), workspace_(workspace) {
    std::vector<PosedPart>& memory = workspace.scratch().posed[0];
    PosedModel posed = pose_model(shape.model, shape.pose, shape.solid, "the shape", std::move(memory));
    box_ = world_box(posed);
    posed.parts.clear();
    memory = std::move(posed.parts);
  }

  [[nodiscard]] const Aabb& box() const { return box_; }

  /// `ask(model a, model b, query, workspace)` of the shape and an object.
  template <class Ask>
  auto with(Index object, const Ask& ask) const {
    workspace_.scratch().convex = {};  // it was another pair's
    return ask_about(object, objects_, [&](const InstanceView& at) {
      const PairQuery query{shape_.pose, at.pose, shape_.solid, at.solid};
      return ask(shape_.model, at.model, query, workspace_);
    });
  }

 private:
  const SceneInstance& shape_;
  const SearchedObjects& objects_;
  Workspace& workspace_;
  Aabb box_;
};

void require_ray(const Ray& ray) {
  if (!is_finite(ray.origin)) throw Error("a ray: its origin has a coordinate that is not finite");
  if (!is_finite(ray.motion)) throw Error("a ray: its motion has a coordinate that is not finite");
  if (ray.motion == Vec3{}) throw Error("a ray: its motion is zero; ask whether the point overlaps");
}

std::optional<ObjectAnswer<RayHit>> hit_of(const SearchedObjects& objects, Index object, const Ray& ray) {
  const auto hit = ask_about(object, objects, [&](const InstanceView& at) {
    return cast_ray(ray.origin, ray.motion, at.model, at.pose, at.solid);
  });
  return hit ? std::optional(ObjectAnswer<RayHit>{*hit, object}) : std::nullopt;
}

}  // namespace

std::optional<ObjectAnswer<RayHit>> first_ray_hit(const SearchedObjects& objects, const Ray& ray) {
  require_ray(ray);
  std::optional<ObjectAnswer<RayHit>> first;
  objects.tree.visit_along({ray.origin, ray.origin}, ray.motion, 1, [&](Index object) {
    if (objects.accepts(object) && !is_settled(first, object))
      if (const auto found = hit_of(objects, object, ray)) keep_first(first, *found);
    return last_time(first);
  });
  return first;
}

std::vector<ObjectAnswer<RayHit>> all_ray_hits(const SearchedObjects& objects, const Ray& ray) {
  require_ray(ray);
  std::vector<ObjectAnswer<RayHit>> all;
  objects.tree.visit_along({ray.origin, ray.origin}, ray.motion, 1, [&](Index object) {
    if (objects.accepts(object))
      if (const auto found = hit_of(objects, object, ray)) all.push_back(*found);
    return 1.0;
  });
  std::sort(all.begin(), all.end(), [](const ObjectAnswer<RayHit>& a, const ObjectAnswer<RayHit>& b) {
    return std::tie(a.upper, a.object) < std::tie(b.upper, b.object);
  });
  return all;
}

std::optional<ObjectAnswer<ShapeHit>> first_cast(const SearchedObjects& objects, const MovingShape& moving,
                                                 Workspace& workspace) {
  const Vec3& motion = moving.motion;
  if (!is_finite(motion)) throw Error("a cast: the motion has a coordinate that is not finite");
  const AskedShape asked(moving.shape, objects, workspace);
  std::optional<ObjectAnswer<ShapeHit>> first;
  if (is_empty(asked.box())) return first;
  objects.tree.visit_along(asked.box(), motion, 1, [&](Index object) {
    if (!objects.accepts(object) || is_settled(first, object)) return last_time(first);
    const double limit = std::min(1.0, last_time(first));
    const auto found =
        asked.with(object, [&](const Model& a, const Model& b, const PairQuery& query, Workspace& memory) {
          return cast_until(a, motion, b, query, limit, memory);
        });
    if (found) keep_first(first, ObjectAnswer<ShapeHit>{*found, object});
    return last_time(first);
  });
  return first;
}

std::vector<Index> overlapping_objects(const SearchedObjects& objects, const SceneInstance& shape,
                                       Workspace& workspace) {
  const AskedShape asked(shape, objects, workspace);
  std::vector<Index> found;
  objects.tree.visit_overlapping(asked.box(), [&](Index object) {
    const auto meets = [](auto&... question) { return overlap(question...); };
    if (objects.accepts(object) && asked.with(object, meets)) found.push_back(object);
    return true;
  });
  std::sort(found.begin(), found.end());
  return found;
}

std::vector<ObjectAnswer<Relation>> related_objects(const SearchedObjects& objects, const SceneInstance& shape,
                                                    Workspace& workspace) {
  const AskedShape asked(shape, objects, workspace);
  std::vector<ObjectAnswer<Relation>> found;
  objects.tree.visit_overlapping(asked.box(), [&](Index object) {
    if (!objects.accepts(object)) return true;
    const Relation how = asked.with(object, [](auto&... question) { return relation(question...); });
    if (how.kind != RelationKind::apart) found.push_back({how, object});
    return true;
  });
  std::sort(found.begin(), found.end(),
            [](const ObjectAnswer<Relation>& a, const ObjectAnswer<Relation>& b) { return a.object < b.object; });
  return found;
}

std::optional<ObjectAnswer<Distance>> nearest_object(const SearchedObjects& objects, const SceneInstance& shape,
                                                     double max_distance, Workspace& workspace) {
  require_length(max_distance, "the greatest distance");
  const AskedShape asked(shape, objects, workspace);
  std::optional<ObjectAnswer<Distance>> nearest;
  if (is_empty(asked.box())) return nearest;
  objects.tree.visit_nearest(asked.box(), max_distance, [&](Index object) {
    const double limit = last_distance(nearest, max_distance);
    if (!objects.accepts(object) || is_settled(nearest, object)) return limit;
    const auto found =
        asked.with(object, [&](const Model& a, const Model& b, const PairQuery& query, Workspace& memory) {
          return distance_within(a, b, limit, query, memory);
        });
    if (found) keep_first(nearest, ObjectAnswer<Distance>{*found, object});
    return last_distance(nearest, max_distance);
  });
  return nearest;
}

std::vector<Index> objects_within(const SearchedObjects& objects, const SceneInstance& shape, double max_distance,
                                  Workspace& workspace) {
  require_length(max_distance, "the greatest distance");
  const AskedShape asked(shape, objects, workspace);
  std::vector<Index> found;
  if (is_empty(asked.box())) return found;
  objects.tree.visit_nearest(asked.box(), max_distance, [&](Index object) {
    const auto is_near = [&](const Model& a, const Model& b, const PairQuery& query, Workspace& memory) {
      return within_distance(a, b, max_distance, query, memory);
    };
    if (objects.accepts(object) && asked.with(object, is_near)) found.push_back(object);
    return max_distance;
  });
  std::sort(found.begin(), found.end());
  return found;
}

}  // namespace toccata
