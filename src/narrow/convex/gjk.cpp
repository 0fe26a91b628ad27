#include "narrow/convex/gjk.hpp"

#include <algorithm>
#include <cmath>

#include "math/vec3_measures.hpp"
#include "narrow/convex/close_rise.hpp"
#include "narrow/convex/edge_walk.hpp"
#include "narrow/convex/vertices_of.hpp"

namespace toccata {
namespace {

/// More than any search that gets somewhere was seen to need.
constexpr int most_gjk_steps = 64;

bool has(const VertexPairs& pairs, Index a, Index b) {
  for (std::size_t i = 0; i < pairs.size; ++i)
    if (pairs.a[i] == a && pairs.b[i] == b) return true;
  return false;
}

/// Directions with momentum. Seen as the method of M. Frank and P. Wolfe for the least |x|² in the difference, a step
/// of GJK asks for the vertex s that is least along the gradient x; after Y. Nesterov the gradient is taken at a point
/// ahead, between x and the last s, and averaged with those before, of unit length each, as x may become ever shorter.
class Momentum {
 public:
  Vec3 next(const Vec3& nearest, const Vec3& last_vertex) {
    const double kept = (steps_ + 1) / (steps_ + 3);
    ++steps_;
    direction_ = kept * direction_ + (1 - kept) * unit(kept * nearest + (1 - kept) * last_vertex);
    direction_ = unit(direction_);
    return direction_;
  }

 private:
  static Vec3 unit(const Vec3& v) {
    const double squared = dot(v, v);
    return squared > 0 ? (1 / std::sqrt(squared)) * v : v;
  }

  Vec3 direction_;
  double steps_ = 0;
};

/// The search, a step at a time.
class GjkWalk {
 public:
  GjkWalk(const SupportSearch& a, const SupportSearch& b, const GjkGoal& goal) : a_(a), b_(b), goal_(goal) {}

  /// Adds the pair if it is nearer along the present direction, by more than rounding; tells whether it did.
  bool step_to(Index a, Index b) {
    const Vec3 point = a_.vertex(a) - b_.vertex(b);
    end_.size = std::max(end_.size, largest_magnitude(point));
    GjkSimplex& simplex = end_.simplex;
    if (simplex.pairs.size > 0) {
      const double gain = squared_ - dot(end_.nearest, point), rounding = 0x1p-46 * end_.size;
      // Less is rounding: of the vertices, and of the nearest point.
      if (!(gain > 0 && gain * gain > rounding * rounding * squared_) || has(simplex.pairs, a, b)) return false;
    }
    simplex.append(a, b, point);
    const NearestFace face = nearest_face(simplex);
    if (simplex.pairs.size > 1 && face.kept != 15 && !(face.squared < squared_)) {
      --simplex.pairs.size;
      return false;
    }
    simplex.keep(face.kept);
    end_.nearest = face.nearest;
    end_.inside = face.kept == 15;
    direction_ = face.direction;
    squared_ = face.squared;
    return true;
  }

  /// A step to the vertices that are the nearest along a direction, which is given by value because the step may change
  /// the present one; tells whether the search goes on.
  bool step_along(Vec3 direction) {
    ++end_.steps;
    end_.support_points += 2;
    const Index vertex_a = a_.least(direction), vertex_b = b_.least(-direction);
    return step_to(vertex_a, vertex_b) && !goal_reached(direction, vertex_a, vertex_b);
  }

  /// A step with momentum; tells whether it led on.
  bool step_ahead() {
    const GjkSimplex& simplex = end_.simplex;
    return step_along(momentum_.next(end_.nearest, simplex.point[simplex.pairs.size - 1]));
  }

  [[nodiscard]] const GjkEnd& end() const { return end_; }
  [[nodiscard]] const Vec3& direction() const { return direction_; }

 private:
  /// The last vertex that was stepped to is the least along the direction.
  [[nodiscard]] bool goal_reached(const Vec3& direction, Index a, Index b) {
    if (std::isnan(goal_.gap)) return false;
    const double height = dot(direction, a_.vertex(a) - b_.vertex(b));
    if (!(height > (goal_.gap + 0x1p-40 * end_.size) * std::sqrt(dot(direction, direction)))) return false;
    end_.separating = direction;
    return true;
  }

  const SupportSearch& a_;
  const SupportSearch& b_;
  const GjkGoal& goal_;
  GjkEnd end_;
  Momentum momentum_;
  Vec3 direction_;      // along end_.nearest
  double squared_ = 0;  // end_.nearest · end_.nearest
};

}  // namespace

namespace {

/// A walk along edges was measured to be faster than a scan from so many vertices on.
constexpr Index least_walked = 8000;

}  // namespace

bool in_certain_range(const Vec3& direction) {
  const double size = largest_magnitude(direction);
  return size >= 0x1p-300 && size <= 0x1p300;
}

SupportSearch::SupportSearch(const PosedPolytope& shape, const SupportKernels& kernels, GjkSupport support)
    : shape_(&shape),
      kernels_(&kernels),
      plain_{shape.along(0), shape.along(1), shape.along(2), shape.padded_count(), {}, {}, shape.vertex_count()},
      world_in_local_(shape.in_world() ? Mat3{} : transpose(shape.pose().linear)),
      stretch_{sum_of_magnitudes(world_in_local_[0]), sum_of_magnitudes(world_in_local_[1]),
               sum_of_magnitudes(world_in_local_[2])},
      offset_(shape.in_world() ? Vec3{} : shape.pose().offset),
      offset_magnitude_(sum_of_magnitudes(offset_)) {
  const Index least_count = support == GjkSupport::automatic ? least_walked : 2;
  trail_.walks = !shape.in_world() && support != GjkSupport::scan && shape.vertex_count() >= least_count;
}

/// What a walk tells; after one that tells nothing there are no others.
template <class Question>
auto SupportSearch::walked(const SupportScan& scan, Question question) const {
  EdgeWalk walk(*shape_, scan);
  const auto found = question(walk, trail_.last);
  trail_.last = walk.lowest();
  trail_.heights += walk.heights();
  trail_.walks = found.has_value();
  if (!found) trail_.heights += scan.count;
  return found;
}

// Walks are apart, so that the ways of small shapes stay short.

[[gnu::noinline]] Index SupportSearch::walked_least(const SupportScan& scan) const {
  const auto found = walked(scan, [](EdgeWalk& walk, Index start) { return walk.least(start); });
  return found ? *found : kernels_->least(scan);
}

[[gnu::noinline]] double SupportSearch::walked_least_depth(const SupportScan& scan) const {
  const auto found = walked(scan, [](EdgeWalk& walk, Index start) { return walk.least_depth(start); });
  return found ? *found : kernels_->least_depth(scan);
}

[[gnu::noinline]] Index SupportSearch::walked_close(const SupportScan& scan, double bound, std::span<const Index> own,
                                                    std::span<Index> found) const {
  if (!own.empty()) trail_.last = own[0];
  const auto count = walked(scan, [&](EdgeWalk& walk, Index start) { return walk.close(bound, own, found, start); });
  return count ? *count : kernels_->close(scan, bound, own, found);
}

Index SupportSearch::least(const Vec3& direction) const {
  SupportScan scan = plain_;
  scan.direction = world_in_local_ * direction;
  if (trail_.walks) return walked_least(scan);
  trail_.heights += scan.count;
  return kernels_->least(scan);
}

SupportScan SupportSearch::scan(const Vec3& direction, double spread) const {
  SupportScan scan = plain_;
  scan.direction = world_in_local_ * direction;
  scan.spread = spread * stretch_ + Vec3{lost_per_coordinate, lost_per_coordinate, lost_per_coordinate};
  return scan;
}

double SupportSearch::close_depth(const Vec3& direction, double spread, const Vec3& vertex) const {
  const double highest = dot(direction, vertex) + spread * sum_of_magnitudes(vertex);
  return (highest - dot(direction, offset_)) + 2 * (spread * offset_magnitude_ + lost_per_height);
}

Index SupportSearch::close(const Vec3& direction, double slack, const Vec3& vertex, std::span<const Index> own,
                           std::span<Index> found) const {
  const double spread = height_spread(direction, slack);
  const double bound = close_depth(direction, spread, vertex);
  const SupportScan along = scan(direction, spread);
  if (trail_.walks) return walked_close(along, bound, own, found);
  trail_.heights += along.count;
  return kernels_->close(along, bound, own, found);
}

double SupportSearch::lower_bound(const Vec3& direction) const {
  const double spread = height_spread(direction, 0);
  return (least_depth(scan(direction, spread)) + dot(direction, offset_)) -
         2 * (spread * offset_magnitude_ + lost_per_height);
}

double SupportSearch::least_depth(const SupportScan& scan) const {
  if (trail_.walks) return walked_least_depth(scan);
  trail_.heights += scan.count;
  return kernels_->least_depth(scan);
}

GjkEnd search_nearest(const SupportSearch& a, const SupportSearch& b, const VertexPairs& start, const GjkGoal& goal) {
  GjkWalk walk(a, b, goal);
  // False only when that is the goal.
  if (start.size == 0 && !walk.step_along(place_of(a.shape()) - place_of(b.shape()))) return walk.end();
  for (std::size_t i = 0; i < start.size && !walk.end().inside; ++i) walk.step_to(start.a[i], start.b[i]);
  int step = 0;
  // Where momentum leads no farther, the search goes on without: it has not ended before that says so.
  if (goal.acceleration == GjkAcceleration::nesterov)
    while (step < most_gjk_steps && !walk.end().inside && walk.step_ahead()) ++step;
  if (!(walk.end().separating == Vec3{})) return walk.end();
  for (; step < most_gjk_steps && !walk.end().inside; ++step)
    if (!walk.step_along(walk.direction())) break;
  return walk.end();
}

}  // namespace toccata
