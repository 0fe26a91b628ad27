#include "query/contacts/region_depth.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <queue>
#include <tuple>

#include "math/constants.hpp"
#include "math/vec3_measures.hpp"
#include "query/contacts/depth_cell.hpp"
#include "query/meshes/world_search.hpp"
#include "query/posed_shape.hpp"
#include "query/relation/relation_locality.hpp"
#include "query/volume/winding_volume.hpp"

namespace toccata {
namespace {

/// Whether p is deeper; of equal ones, whether it is the first in space, so that the order of the solids does not show.
bool is_deeper(const DeepestPoint& p, const DeepestPoint& q) {
  if (p.depth != q.depth) return p.depth > q.depth;
  return lexicographically_less(p.point, q.point);
}

double largest_coordinate(const Aabb& box) {
  return std::max(largest_magnitude(box.lower), largest_magnitude(box.upper));
}

/// The two ways of a direction have one frame.
Vec3 without_sign(const Vec3& direction) {
  const double first = direction.x != 0 ? direction.x : direction.y != 0 ? direction.y : direction.z;
  return first < 0 ? -direction : direction;
}

Vec3 shortest_axis(const Aabb& box) {
  const Vec3 size = box.upper - box.lower;
  if (size.x <= size.y && size.x <= size.z) return {1, 0, 0};
  return size.y <= size.z ? Vec3{0, 1, 0} : Vec3{0, 0, 1};
}

Vec3 middle_of_box(const Aabb& box) { return 0.5 * box.lower + 0.5 * box.upper; }

bool box_holds(const Aabb& box, const Vec3& p) { return contains(box, Aabb{p, p}); }

double distance_to_segment(const Vec3& p, const Vec3& from, const Vec3& to) {
  const Vec3 along = to - from;
  const double length_squared = dot(along, along);
  const double share = length_squared > 0 ? std::clamp(dot(p - from, along) / length_squared, 0.0, 1.0) : 0;
  return plain_length(p - from - share * along);
}

/// All triangles as near to a point have it as a corner, and their opposite edges are farther.
bool is_cone_around(const Vec3& point, const PosedMesh& mesh, double near) {
  bool is_cone = true;
  visit_triangles_near(mesh, widened({point, point}, near), [&](Index number) {
    const Triangle t = mesh.triangle(number);
    const int corner = t[0] == point ? 0 : t[1] == point ? 1 : 2;
    is_cone = t[corner] == point && distance_to_segment(point, t[(corner + 1) % 3], t[(corner + 2) % 3]) > 2 * near;
    return is_cone;
  });
  return is_cone;
}

/// A box of the search, in its frame.
struct WaitingCell {
  double bound = 0;
  std::size_t number = 0;
  Vec3 lower;
  Vec3 upper;
  Vec3 change;  ///< how much the sum of the distances may change along each axis

  /// The order of a heap: the greatest bound first, then the one that came first.
  friend bool operator<(const WaitingCell& x, const WaitingCell& y) {
    return std::tie(x.bound, y.number) < std::tie(y.bound, x.number);
  }
};

class CommonDepthSearch {
 public:
  /// With a limit it ends as soon as a point is deeper, or no point may be.
  CommonDepthSearch(const DepthSide& a, const DepthSide& b, const Aabb& box, double size, std::optional<double> limit,
                    SearchScratch& scratch)
      : a_(a),
        b_(b),
        box_(box),
        slack_(depth_slack * size),
        floor_(least_width * size),
        limit_(limit),
        scratch_(scratch) {}

  /// Some of the vertices of either inside the other.
  void see_vertices(std::span<const Vec3> of_a, std::span<const Vec3> of_b) {
    constexpr std::size_t most = 16;
    const auto see_some = [&](std::span<const Vec3> vertices, const auto& see) {
      const std::size_t step = vertices.size() / most + 1;
      for (std::size_t i = 0; i < vertices.size(); i += step) see(vertices[i]);
    };
    see_some(of_a, [&](const Vec3& v) {
      const SurfacePoint found = b_.nearest(v, scratch_);
      see_vertex(a_, {found.lower, v, v, found.point});
    });
    see_some(of_b, [&](const Vec3& v) {
      const SurfacePoint found = a_.nearest(v, scratch_);
      see_vertex(b_, {found.lower, v, found.point, v});
    });
  }

  /// The point of the box that is nearest to it.
  void see_point(const Vec3& point) {
    if (const auto found = at(nearest_point_of(box_, point))) see(*found);
  }

  /// Goes from the deepest point known to where it is deeper, away from the nearer surface.
  void climb() {
    constexpr int most_steps = 8;
    double step = best_.depth / 2;
    for (int i = 0; i < most_steps && step > 0; ++i) {
      const DeepestPoint from = best_;
      const Vec3 out_of_a = plain_unit_or_zero(from.on_a - from.point),
                 out_of_b = plain_unit_or_zero(from.on_b - from.point);
      for (const Vec3& way : {plain_unit_or_zero(-out_of_a - out_of_b), -out_of_a, -out_of_b})
        if (!(way == Vec3{})) see_point(from.point + step * way);
      step *= best_.depth > from.depth ? 1.5 : 0.25;
    }
  }

  enum class Until { some_point, inner_point, narrow };

  /// In a frame along the direction.
  void search(const Vec3& direction, Until until) {
    until_ = until;
    frame_ = frame_along(without_sign(direction), middle_of_box(box_));
    waiting_ = {};
    settled_ = 0;
    seen_ = 0;
    cost_ = 0;
    wait_for(looked_into(root()));
    while (!waiting_.empty() && waiting_.top().bound > narrow_enough() && cost_ < most_cost && !scratch_.is_stopped()) {
      if (limit_ && best_.depth > *limit_) break;
      if (until == Until::some_point && best_.depth > 0) return;
      if (until == Until::inner_point && inner_) return;
      const WaitingCell cell = waiting_.top();
      waiting_.pop();
      split(cell);
    }
    if (!waiting_.empty()) settled_ = std::max(settled_, waiting_.top().bound);
  }

  [[nodiscard]] FoundDepth found() const { return {{best_.depth, std::max(best_.depth, settled_)}, best_}; }
  [[nodiscard]] const DeepestPoint& best() const { return best_; }
  /// Off both surfaces.
  [[nodiscard]] const std::optional<Vec3>& inner() const { return inner_; }

 private:
  void see(const DeepestPoint& found) {
    if (found.depth > 0 && is_deeper(found, best_)) best_ = found;
  }

  /// A point inside both.
  void see_inner(const DeepestPoint& found) {
    if (!inner_) inner_ = found.point;
    see(found);
  }

  /// The point of a solid's own surface that is nearest to a middle.
  void see_on_surface(const DepthSide& own, Index triangle, const DeepestPoint& found) {
    if (!(found.depth > 0) || !is_deeper(found, best_)) return;
    if (has_inside_beside(own.mesh(), triangle, found.point, slacks_of_nearest * slack_ / 2)) see(found);
  }

  /// A vertex of a solid, inside the other.
  void see_vertex(const DepthSide& own, DeepestPoint found) {
    if (!(found.depth > 0) || !is_deeper(found, best_)) return;
    const double near = slacks_of_nearest * slack_;
    // Off such a corner all is as it is however near.
    if (!is_cone_around(found.point, own.mesh(), near)) found.depth -= near;
    see_on_surface(own, own.nearest(found.point, scratch_).element, found);
  }

  [[nodiscard]] double narrow_enough() const {
    if (until_ == Until::inner_point) return floor_;
    if (limit_) return std::max(*limit_, best_.depth + floor_);
    return std::max((1 + asked_precision) * best_.depth, floor_);
  }

  [[nodiscard]] static DeepestPoint of_both(const Vec3& point, const SurfacePoint& a, const SurfacePoint& b) {
    return {std::nextafter(a.lower + b.lower, 0.0), point, a.point, b.point};
  }

  [[nodiscard]] std::optional<DeepestPoint> at(const Vec3& point) const {
    const DepthSide::Place in_a = a_.at(point, scratch_);
    if (!in_a.inside) return {};
    const DepthSide::Place in_b = b_.at(point, scratch_);
    if (!in_b.inside) return {};
    return of_both(point, in_a.surface, in_b.surface);
  }

  [[nodiscard]] WaitingCell root() const {
    Aabb range;
    for (int i = 0; i < 8; ++i) {
      const Vec3 corner{(i & 1) != 0 ? box_.lower.x : box_.upper.x, (i & 2) != 0 ? box_.lower.y : box_.upper.y,
                        (i & 4) != 0 ? box_.lower.z : box_.upper.z};
      range = merge(range, frame_.inside(corner));
    }
    WaitingCell root;
    root.bound = infinity;
    root.lower = range.lower;
    root.upper = range.upper;
    return root;
  }

  /// Along the axis along which the sum of the distances may change most, and the longest where it hardly does.
  void split(const WaitingCell& cell) {
    constexpr double of_flat = 0.03;
    int axis = 0;
    double most = -1;
    for (int i = 0; i < 3; ++i) {
      const double weight = (cell.upper[i] - cell.lower[i]) * (cell.change[i] + of_flat);
      if (weight > most) std::tie(axis, most) = std::pair(i, weight);
    }
    WaitingCell below = cell, above = cell;
    below.upper[axis] = above.lower[axis] = cell.lower[axis] + (cell.upper[axis] - cell.lower[axis]) / 2;
    wait_for(looked_into(below));
    wait_for(looked_into(above));
  }

  [[nodiscard]] DepthCell posed(const WaitingCell& cell) const {
    const Vec3 half = 0.5 * (cell.upper - cell.lower);
    DepthCell result;
    result.middle = frame_.in_world(cell.lower + half);
    for (std::size_t i = 0; i < 8; ++i)
      result.corners[i] = ((i & 1) != 0 ? half.x : -half.x) * frame_.axes[0] +
                          ((i & 2) != 0 ? half.y : -half.y) * frame_.axes[1] +
                          ((i & 4) != 0 ? half.z : -half.z) * frame_.axes[2];
    result.radius = plain_length(half) + slack_;
    result.axes = frame_.axes;
    return result;
  }

  /// A turned cell may be beside the box though it is part of the root, which is a turned box around it.
  [[nodiscard]] bool meets_box(const DepthCell& cell) const {
    const Vec3 more{slack_, slack_, slack_};
    const Aabb around = fit_aabb(cell.corners);
    return overlap({cell.middle + around.lower - more, cell.middle + around.upper + more}, box_);
  }

  /// With its own bound, which is not more than the one it had: 0 where it has nothing in common with both.
  [[nodiscard]] WaitingCell looked_into(WaitingCell cell) {
    cell.number = ++seen_;
    cost_ += cost_of_cell;
    const double had = cell.bound;
    cell.bound = 0;
    const DepthCell world = posed(cell);
    if (!meets_box(world)) return cell;
    const DepthSide::Place in_a = a_.at(world.middle, scratch_);
    DistanceBounds of_a = bounds_by_distance(a_, in_a, world, slack_);
    if (of_a.count == 0) return cell;
    const DepthSide::Place in_b = b_.at(world.middle, scratch_);
    DistanceBounds of_b = bounds_by_distance(b_, in_b, world, slack_);
    if (of_b.count == 0) return cell;
    if (!box_holds(box_, world.middle))
      see_point(world.middle);
    else if (in_a.inside && in_b.inside)
      see_inner(of_both(world.middle, in_a.surface, in_b.surface));
    cell.bound = std::min(greatest_sum(of_a, of_b), had);
    // Where the nearest surface is another one on the way through the cell, that opposite to the other solid's may
    // tell.
    for (const bool own : {true, false}) {
      if (!(cell.bound > narrow_enough())) break;
      add_bound_by_height(a_, in_a, world, own ? of_a.outwards : -of_b.outwards, slack_, of_a);
      add_bound_by_height(b_, in_b, world, own ? of_b.outwards : -of_a.outwards, slack_, of_b);
      cell.bound = std::min(cell.bound, greatest_sum(of_a, of_b));
    }
    if (cell.bound > narrow_enough()) see_surface_points(in_a, in_b);
    cost_ += of_a.triangles + of_b.triangles;
    const Vec3 slope = of_a.outwards + of_b.outwards;
    for (int i = 0; i < 3; ++i)
      cell.change[i] = std::abs(dot(slope, world.axes[static_cast<std::size_t>(i)])) + of_a.bend[i] + of_b.bend[i];
    return cell;
  }

  /// The points of the surfaces that are nearest to a middle: no middle of a cell may ever be inside of a thin wedge
  /// whose edge is where the two are deepest.
  void see_surface_points(const DepthSide::Place& in_a, const DepthSide::Place& in_b) {
    const auto depth_in = [&](const DepthSide& other, const Vec3& point) {
      const SurfacePoint across = other.nearest(point, scratch_);
      return std::pair(across.lower - slacks_of_nearest * slack_, across.point);
    };
    const Vec3 &on_a = in_a.surface.point, &on_b = in_b.surface.point;
    if (!in_a.inside && box_holds(box_, on_a) && is_interior(on_a, b_.mesh())) {
      const auto [depth, across] = depth_in(b_, on_a);
      see_on_surface(a_, in_a.surface.element, {depth, on_a, on_a, across});
    }
    if (!in_b.inside && box_holds(box_, on_b) && is_interior(on_b, a_.mesh())) {
      const auto [depth, across] = depth_in(a_, on_b);
      see_on_surface(b_, in_b.surface.element, {depth, on_b, across, on_b});
    }
  }

  void wait_for(const WaitingCell& cell) {
    if (cell.bound > narrow_enough())
      waiting_.push(cell);
    else
      settled_ = std::max(settled_, cell.bound);
  }

  static constexpr double asked_precision = 0.1;
  /// What is narrower than that share of the coordinates is not looked into.
  static constexpr double least_width = 0x1p-40;
  /// What is looked at, in triangles, before the search ends: some tenths of a second. A press fit all around a shaft
  /// takes about two thousand cells, what lies across two faces one or a few.
  static constexpr std::size_t most_cost = 5'000'000, cost_of_cell = 500;

  const DepthSide& a_;
  const DepthSide& b_;
  const Aabb& box_;
  double slack_;
  double floor_;
  std::optional<double> limit_;
  SearchScratch& scratch_;
  Until until_ = Until::narrow;
  DeepestPoint best_;
  std::optional<Vec3> inner_;
  CellFrame frame_{};
  std::priority_queue<WaitingCell> waiting_;
  double settled_ = 0;  ///< the greatest bound of the cells that were left
  std::size_t seen_ = 0;
  std::size_t cost_ = 0;
};

}  // namespace

Vec3 nearest_point_of(const Aabb& box, const Vec3& p) {
  return {std::clamp(p.x, box.lower.x, box.upper.x), std::clamp(p.y, box.lower.y, box.upper.y),
          std::clamp(p.z, box.lower.z, box.upper.z)};
}

Vec3 normal_of_any_size(const Triangle& t) {
  return unit_or_zero(cross(unit_or_zero(t[1] - t[0]), unit_or_zero(t[2] - t[0])));
}

DepthSide::DepthSide(const Model& model, const Pose& pose, const PosedMesh& mesh, double turn)
    : search_(model, {.pose = pose}, 100), mesh_(mesh), turn_(turn) {}

DepthSide::Place DepthSide::at(const Vec3& point, SearchScratch& scratch) const {
  return {search_.nearest(point, scratch), is_interior(point, mesh_)};
}

Vec3 DepthSide::outward_normal(Index triangle) const { return turn_ * normal_of_any_size(mesh_.triangle(triangle)); }

CommonDepth::CommonDepth(const Model& a, const Model& b, const PairQuery& query, const PosedMeshPair& pair,
                         double turn_a, double turn_b, SearchScratch& scratch)
    : a_(a, query.pose_a, pair.a, turn_a),
      b_(b, query.pose_b, pair.b, turn_b),
      size_(std::max(largest_coordinate(pair.a.box()), largest_coordinate(pair.b.box()))),
      scratch_(scratch) {}

FoundDepth CommonDepth::within(const Aabb& box, std::span<const Vec3> of_a, std::span<const Vec3> of_b) const {
  using Until = CommonDepthSearch::Until;
  CommonDepthSearch search(a_, b_, box, size_, {}, scratch_);
  search.see_vertices(of_a, of_b);
  search.see_point(middle_of_box(box));
  if (search.best().depth == 0) search.search(shortest_axis(box), Until::some_point);
  search.climb();
  const Vec3 across = plain_unit_or_zero(search.best().on_a - search.best().on_b);
  search.search(across == Vec3{} ? shortest_axis(box) : across, Until::narrow);
  return search.found();
}

ContactRegion::Depth CommonDepth::against(double limit, const Aabb& box) const {
  using Until = CommonDepthSearch::Until;
  CommonDepthSearch search(a_, b_, box, size_, limit, scratch_);
  search.see_point(middle_of_box(box));
  if (search.best().depth == 0) search.search(shortest_axis(box), Until::some_point);
  if (search.best().depth == 0) return search.found().bracket;
  search.climb();
  if (search.best().depth > limit) return {search.best().depth, infinity};
  const Vec3 across = plain_unit_or_zero(search.best().on_a - search.best().on_b);
  search.search(across == Vec3{} ? shortest_axis(box) : across, Until::narrow);
  return search.found().bracket;
}

std::optional<Vec3> CommonDepth::inner_point(const Aabb& box) const {
  CommonDepthSearch search(a_, b_, box, size_, {}, scratch_);
  search.search(shortest_axis(box), CommonDepthSearch::Until::inner_point);
  return search.inner();
}

}  // namespace toccata
