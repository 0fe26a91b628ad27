#include "query/penetration/local_depth.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "math/constants.hpp"
#include "math/vec3_measures.hpp"
#include "query/inside/side_search.hpp"
#include "query/nearest/nearest_search.hpp"
#include "query/penetration/quadric_hull.hpp"
#include "query/penetration/solid_body.hpp"

namespace toccata {
namespace {

/// Two balls around a point inside both solids, each within one, and the ways to where they touch the surfaces. The
/// balls overlap after every translation that is shorter than their radii together, and so do the solids.
struct CommonBalls {
  Vec3 middle;
  double in_a = 0;
  double in_b = 0;
  Vec3 out_of_a{};
  Vec3 out_of_b{};

  [[nodiscard]] double depth() const { return std::nextafter(in_a + in_b, 0.0); }
};

class BallSearch {
 public:
  BallSearch(const Model& a, const Model& b, const PairQuery& query, SearchScratch& scratch)
      : near_a_(a, {.pose = query.pose_a}, about_points),
        near_b_(b, {.pose = query.pose_b}, about_points),
        sides_a_(near_a_.posed(), SignBy::automatic),
        sides_b_(near_b_.posed(), SignBy::automatic),
        scratch_(scratch) {}

  /// None where the point is not proved to be inside both, or would not be deeper than that.
  [[nodiscard]] std::optional<CommonBalls> at(const Vec3& point, double deeper_than) const {
    if (!is_finite(point)) return {};
    const SurfacePoint of_a = near_a_.nearest(point, scratch_), of_b = near_b_.nearest(point, scratch_);
    const CommonBalls balls{point, of_a.lower, of_b.lower, plain_unit_or_zero(of_a.point - point),
                            plain_unit_or_zero(of_b.point - point)};
    const bool is_deeper = balls.in_a > 0 && balls.in_b > 0 && balls.depth() > deeper_than;
    if (!is_deeper || !is_inside(sides_a_, point) || !is_inside(sides_b_, point)) return {};
    return balls;
  }

  /// From where the surfaces meet, inwards: as far as it is inside both.
  [[nodiscard]] std::optional<CommonBalls> below(const SurfaceIntersection& from, double farthest) const {
    constexpr int most_halvings = 10;
    for (const Vec3& towards : {-from.normal_a - from.normal_b, from.normal_a + from.normal_b,
                                from.normal_b - from.normal_a, from.normal_a - from.normal_b}) {
      const Vec3 along = plain_unit_or_zero(towards);
      if (along == Vec3{}) continue;
      double step = farthest;
      for (int i = 0; i < most_halvings; ++i, step /= 2)
        if (const auto found = at(from.point + step * along, 0)) return found;
    }
    return {};
  }

  /// Moved to where they are greatest, as far as steps away from the surfaces lead.
  [[nodiscard]] CommonBalls climbed(CommonBalls best) const {
    constexpr int most_steps = 24;
    constexpr double least_share = 0x1p-7;
    double step = best.depth();
    for (int i = 0; i < most_steps && step > least_share * best.depth(); ++i) {
      const std::optional<CommonBalls> higher = step_from(best, step);
      if (higher) best = *higher;
      step *= higher ? 1.5 : 0.5;
    }
    return best;
  }

 private:
  static constexpr std::size_t about_points = 100;

  [[nodiscard]] bool is_inside(const SideSearch& sides, const Vec3& point) const {
    const FoundSide found = sides.side_of(point, scratch_);
    return found.side == Side::inside && found.status == Status::exact;
  }

  [[nodiscard]] std::optional<CommonBalls> step_from(const CommonBalls& from, double step) const {
    constexpr double least_slope = 0.02, least_gain = 1 + 0x1p-10;
    const Vec3 away = -from.out_of_a - from.out_of_b;
    if (plain_length(away) < least_slope) return {};
    for (const Vec3& way : {plain_unit_or_zero(away), -from.out_of_a, -from.out_of_b})
      if (const auto found = at(from.middle + step * way, least_gain * from.depth())) return found;
    return {};
  }

  NearestSearch near_a_;
  NearestSearch near_b_;
  SideSearch sides_a_;
  SideSearch sides_b_;
  SearchScratch& scratch_;
};

/// A convex body within the solid that holds the point or lies around it.
bool body_around(const PosedModel& solid, const Vec3& point, double reach, CutBy cut, std::optional<InnerPart>& body) {
  for (const PosedPart& part : solid.parts) {
    if (const auto* triangles = std::get_if<PosedTriangles>(&part.shape)) {
      if (const auto grown = grow_within(triangles->mesh, point, reach, cut)) body.emplace(*grown);
    } else if (holds(part.shape, point)) {
      if (const auto* convex = std::get_if<PosedPolytope>(&part.shape)) body.emplace(*convex);
      if (const auto* quadric = std::get_if<PosedQuadric>(&part.shape))
        if (const auto hull = hull_within(*quadric)) body.emplace(*hull);
    }
    if (body) return true;
  }
  return false;
}

class LocalDepth {
 public:
  LocalDepth(const PosedModelPair& models, const SeparatingQuestions& questions, const DepthLimit& limit, double extent)
      : models_(models), limit_(limit), tried_(questions, limit, extent) {}

  /// Takes in what the balls themselves tell.
  void know(const CommonBalls& balls) {
    tried_.best.lower = std::max(tried_.best.lower, balls.depth());
    ways_.push_back({plain_unit_or_zero(balls.out_of_a - balls.out_of_b), balls.depth()});
  }

  /// Takes in what bodies around their middle tell.
  void grow_around(const CommonBalls& balls) {
    constexpr double times_the_depth = 4;
    for (const CutBy cut : {CutBy::own_plane, CutBy::nearest_point}) {
      std::optional<InnerPart> a, b;
      const double reach = times_the_depth * balls.depth();
      if (!body_around(models_.a, balls.middle, reach, cut, a) || !body_around(models_.b, balls.middle, reach, cut, b))
        continue;
      const Penetration depth = depth_between(*a, *b);
      if (!(depth.lower > 0)) continue;
      tried_.best.lower = std::max(tried_.best.lower, depth.lower);
      ways_.push_back({depth.direction, depth.upper});
    }
  }

  /// Those ways that are no longer than may be of use.
  void try_ways() {
    constexpr double greatest_ratio = 2;
    constexpr int steps = 3;  // make most of what is left
    const double lower = best().lower, most = std::min(limit_.ratio(), greatest_ratio) * lower;
    for (const Way& way : ways_) {
      const double least = std::max(way.length, lower) + 16 * tried_.slack(way.length);
      for (const double length : {least, std::sqrt(least) * std::sqrt(most), most})
        if (length <= most && tried_.attempt(way.direction, length)) break;
      if (limit_.is_over()) return;
    }
    tried_.shorten(steps);
  }

  [[nodiscard]] const Penetration& best() const { return tried_.best; }

 private:
  struct Way {
    Vec3 direction;
    double length;
  };

  const PosedModelPair& models_;
  const DepthLimit& limit_;
  TriedWays tried_;
  std::vector<Way> ways_;
};

/// The deepest come first.
std::vector<CommonBalls> first_balls(const BallSearch& search, const std::vector<SurfaceIntersection>& meeting,
                                     double size) {
  std::vector<CommonBalls> found;
  const auto keep = [&](const std::optional<CommonBalls>& balls) {
    if (balls) found.push_back(*balls);
  };
  Vec3 mean;
  for (const SurfaceIntersection& one : meeting) mean = mean + (1.0 / static_cast<double>(meeting.size())) * one.point;
  keep(search.at(mean, 0));
  for (const SurfaceIntersection& one : meeting) keep(search.below(one, size / 4));
  std::stable_sort(found.begin(), found.end(),
                   [](const CommonBalls& s, const CommonBalls& t) { return s.depth() > t.depth(); });
  return found;
}

double size_of_common_box(const PosedModelPair& models) {
  Aabb a, b;
  for (const PosedPart& part : models.a.parts) a = merge(a, world_box(part.shape));
  for (const PosedPart& part : models.b.parts) b = merge(b, world_box(part.shape));
  Vec3 size;
  for (int axis = 0; axis < 3; ++axis)
    size[axis] = std::max(std::min(a.upper[axis], b.upper[axis]) - std::max(a.lower[axis], b.lower[axis]), 0.0);
  return plain_length(size);
}

}  // namespace

Penetration local_depth(const Model& a, const Model& b, const PairQuery& query, const PosedModelPair& models,
                        const SeparatingQuestions& questions, const std::vector<SurfaceIntersection>& meeting,
                        const DepthLimit& limit, SearchScratch& scratch) {
  constexpr std::size_t most_climbs = 2;
  const double extent = extent_of(models.a) + extent_of(models.b);
  LocalDepth depth(models, questions, limit, extent);
  if (meeting.empty() || !(extent > least_extent) || !(extent < greatest_extent)) return depth.best();
  const BallSearch search(a, b, query, scratch);
  std::optional<CommonBalls> deepest;
  std::vector<CommonBalls> balls = first_balls(search, meeting, size_of_common_box(models));
  for (std::size_t i = 0; i < std::min(balls.size(), most_climbs) && !limit.is_over(); ++i) {
    const CommonBalls climbed = search.climbed(balls[i]);
    depth.know(climbed);
    if (!deepest || climbed.depth() > deepest->depth()) deepest = climbed;
  }
  depth.try_ways();
  if (deepest && !limit.is_narrow(depth.best()) && !limit.is_over()) {
    depth.grow_around(*deepest);
    depth.try_ways();
  }
  return depth.best();
}

}  // namespace toccata
