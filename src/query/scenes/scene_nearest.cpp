#include "toccata/query/scene_index.hpp"

#include <algorithm>
#include <memory>
#include <tuple>
#include <utility>

#include "math/constants.hpp"
#include "query/ask_each.hpp"
#include "query/inside/side_search.hpp"
#include "query/nearest/nearest_search.hpp"
#include "query/scenes/posed_name.hpp"
#include "toccata/bounds/aabb.hpp"
#include "toccata/broad/box_bvh.hpp"
#include "toccata/core/error.hpp"

namespace toccata {
namespace {

/// What `make` makes of each model, at its place.
template <class Part, class Make>
std::vector<std::unique_ptr<const Part>> made_of_each(std::span<const SceneInstance> models, const Make& make) {
  std::vector<std::unique_ptr<const Part>> parts;
  parts.reserve(models.size());
  for (std::size_t i = 0; i < models.size(); ++i) try {
      parts.push_back(make(i));
    } catch (const Error& error) {
      throw Error(fmt::format("{}: {}", name_for_messages(models[i], i), error.what()));
    }
  return parts;
}

bool contains_point(const Aabb& box, const Vec3& point) { return contains(box, Aabb{point, point}); }

bool comes_before(const ScenePoint& a, const ScenePoint& b) {
  return std::tie(a.nearest.upper, a.object, a.nearest.element) <
         std::tie(b.nearest.upper, b.object, b.nearest.element);
}

/// Many models at their places, and how near points are to them.
class SceneSearch {
 public:
  SceneSearch(std::span<const SceneInstance> models, double max_distance, std::size_t points)
      : searches_(made_of_each<NearestSearch>(
            models,
            [&](std::size_t i) {
              return std::make_unique<const NearestSearch>(
                  models[i].model, NearestQuery{.pose = models[i].pose, .max_distance = max_distance}, points);
            })),
        max_distance_(max_distance) {
    std::vector<Aabb> boxes;
    boxes.reserve(searches_.size());
    for (const auto& search : searches_) boxes.push_back(world_box(search->posed()));
    boxes_.update(boxes);
  }

  [[nodiscard]] const NearestSearch& operator[](std::size_t object) const { return *searches_[object]; }
  [[nodiscard]] const Aabb& box(Index object) const { return boxes_.box(object); }

  [[nodiscard]] std::vector<ScenePoint> nearest(const Vec3& point, std::size_t k, SearchScratch& scratch) const {
    if (!is_finite(point)) throw Error("the point is not finite");
    std::vector<ScenePoint> best;
    if (k == 0) return best;
    boxes_.visit_nearest({point, point}, max_distance_, [&](Index object) {
      for (const SurfacePoint& one : searches_[object]->nearest(point, k, scratch)) best.push_back({one, object});
      std::sort(best.begin(), best.end(), comes_before);
      best.resize(std::min(best.size(), k));
      return best.size() == k ? best.back().nearest.upper : max_distance_;
    });
    return best;
  }

 private:
  std::vector<std::unique_ptr<const NearestSearch>> searches_;
  BoxBvh boxes_;
  double max_distance_;
};

/// The same, and on which side of them points are.
class SceneSides {
 public:
  SceneSides(std::span<const SceneInstance> models, SignBy sign_by, std::size_t points)
      : search_(models, infinity, points), sides_(made_of_each<SideSearch>(models, [&](std::size_t i) {
          return std::make_unique<const SideSearch>(search_[i].posed(), sign_by);
        })) {}

  [[nodiscard]] SceneSignedDistance from(const Vec3& point, SearchScratch& scratch) const {
    const ScenePoint found = search_.nearest(point, 1, scratch).front();
    SceneSignedDistance result{{}, found.object, {}};
    if (found.nearest.upper == 0) {
      result.distance = with_side(found.nearest, sides_[found.object]->on_surface());
      return result;
    }
    FoundSide best;
    for (Index i = 0; i < sides_.size(); ++i) {
      if (sides_[i]->is_certain() && !contains_point(search_.box(i), point)) continue;
      const FoundSide side = sides_[i]->side_of(point, scratch);
      if (weight_of(side) <= weight_of(best)) continue;
      best = side;
      if (side.side == Side::inside) result.inside_of = i;
    }
    result.distance = with_side(found.nearest, best);
    return result;
  }

 private:
  /// The side with the greatest weight counts among several models, as it does among the parts of a compound.
  static int weight_of(const FoundSide& found) {
    const bool exact = found.sign_by == SignBy::winding_number;
    if (found.side != Side::inside) return exact ? 0 : 1;
    return found.status == Status::undecided ? 2 : exact ? 4 : 3;
  }

  SceneSearch search_;
  std::vector<std::unique_ptr<const SideSearch>> sides_;
};

}  // namespace

std::vector<std::vector<ScenePoint>> nearest_points_each(std::span<const Vec3> points, std::size_t k,
                                                         std::span<const SceneInstance> models, double max_distance,
                                                         const BatchOptions& options) {
  const SceneSearch search(models, max_distance, points.size());
  return ask_each(points, "point", options, [&](const Vec3& point, Workspace& workspace) {
    return search.nearest(point, k, workspace.scratch());
  });
}

std::vector<SceneSignedDistance> signed_distance_each(std::span<const Vec3> points,
                                                      std::span<const SceneInstance> models, SignBy sign_by,
                                                      const BatchOptions& options) {
  if (models.empty()) throw Error("there is no model whose surface could be near");
  const SceneSides sides(models, sign_by, points.size());
  return ask_each(points, "point", options,
                  [&](const Vec3& point, Workspace& workspace) { return sides.from(point, workspace.scratch()); });
}

}  // namespace toccata
