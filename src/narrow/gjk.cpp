#include "narrow/gjk.hpp"

#include <algorithm>
#include <cmath>

namespace toccata {
namespace {

/// More than any search that gets somewhere was seen to need.
constexpr int most_steps = 64;

Vec3 times(const Mat3& m, const Vec3& v) { return {dot(m[0], v), dot(m[1], v), dot(m[2], v)}; }

Mat3 transposed(const Mat3& m) { return {{m.column(0), m.column(1), m.column(2)}}; }

Vec3 magnitudes(const Vec3& v) { return {std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)}; }

double sum(const Vec3& v) { return (v.x + v.y) + v.z; }

double largest(const Vec3& v) { return std::max(std::max(std::fabs(v.x), std::fabs(v.y)), std::fabs(v.z)); }

bool has(const VertexPairs& pairs, Index a, Index b) {
  for (std::size_t i = 0; i < pairs.size; ++i)
    if (pairs.a[i] == a && pairs.b[i] == b) return true;
  return false;
}

/// The search, a step at a time.
class Walk {
 public:
  Walk(const SupportSearch& a, const SupportSearch& b, const GjkGoal& goal) : a_(a), b_(b), goal_(goal) {}

  /// Adds the pair if it is nearer along the present direction, by more than rounding; tells whether it did.
  bool step_to(Index a, Index b) {
    const Vec3 point = a_.vertex(a) - b_.vertex(b);
    end_.size = std::max(end_.size, largest(point));
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
    end_.support_points += 2;
    const Index vertex_a = a_.least(direction), vertex_b = b_.least(-direction);
    return step_to(vertex_a, vertex_b) && !goal_reached(direction, vertex_a, vertex_b);
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
  Vec3 direction_;      // along end_.nearest
  double squared_ = 0;  // end_.nearest · end_.nearest
};

}  // namespace

// Bounds of heights. Let u = 2^-53. In its own frame a vertex x has the height h = fl(fl(Rᵀd) · x), off by less than
// 6.01u Σ |d_i||R_ij||x_j| from d · Rx, and the world vertex is off by less than 4.01u (Σ |R_ij||x_j| + |t_i|) from
// Rx + t; so h + d · t is within 10.1u Σ |d_i|(Σ |R_ij||x_j| + |t_i|) of the height of the world vertex. With 32u in
// place of 10.1u the few roundings of the bounds themselves and of their comparison are covered. For |d_i| its greatest
// is taken. A direction of which each coordinate is off by the slack s adds s times the same sum. Underflow: a product
// of Rᵀd loses at most 2^-1074, times |x_j|; each of those that make a height as much; and those that make a world
// vertex, times |d_i| ≤ 2^300.
namespace {

constexpr double rounding = 0x1p-48;
constexpr double lost_per_coordinate = 0x1p-1000;
constexpr double lost_per_height = 0x1p-700;

double spread_of(const Vec3& direction, double slack) { return rounding * largest(direction) + slack; }

}  // namespace

bool in_certain_range(const Vec3& direction) {
  const double size = largest(direction);
  return size >= 0x1p-300 && size <= 0x1p300;
}

SupportSearch::SupportSearch(const PosedConvex& shape, const SupportKernels& kernels)
    : shape_(&shape),
      kernels_(&kernels),
      plain_{shape.along(0), shape.along(1), shape.along(2), shape.padded_count(), {}, {}, shape.vertex_count()},
      world_in_local_(shape.in_world() ? Mat3{} : transposed(shape.pose().linear)),
      stretch_{sum(magnitudes(world_in_local_[0])), sum(magnitudes(world_in_local_[1])),
               sum(magnitudes(world_in_local_[2]))},
      offset_(shape.in_world() ? Vec3{} : shape.pose().offset),
      offset_magnitude_(sum(magnitudes(offset_))) {}

Index SupportSearch::least(const Vec3& direction) const {
  SupportScan scan = plain_;
  scan.direction = times(world_in_local_, direction);
  return kernels_->least(scan);
}

SupportScan SupportSearch::scan(const Vec3& direction, double spread) const {
  SupportScan scan = plain_;
  scan.direction = times(world_in_local_, direction);
  scan.spread = spread * stretch_ + Vec3{lost_per_coordinate, lost_per_coordinate, lost_per_coordinate};
  return scan;
}

Index SupportSearch::close(const Vec3& direction, double slack, const Vec3& vertex, std::span<const Index> own,
                           std::span<Index> found) const {
  const double spread = spread_of(direction, slack);
  const double highest = dot(direction, vertex) + spread * sum(magnitudes(vertex));
  const double bound = (highest - dot(direction, offset_)) + 2 * (spread * offset_magnitude_ + lost_per_height);
  return kernels_->close(scan(direction, spread), bound, own, found);
}

double SupportSearch::lower_bound(const Vec3& direction) const {
  const double spread = spread_of(direction, 0);
  return (kernels_->least_depth(scan(direction, spread)) + dot(direction, offset_)) -
         2 * (spread * offset_magnitude_ + lost_per_height);
}

GjkEnd search_nearest(const SupportSearch& a, const SupportSearch& b, const VertexPairs& start, const GjkGoal& goal) {
  Walk walk(a, b, goal);
  // False only when that is the goal.
  if (start.size == 0 && !walk.step_along(a.shape().pose().offset - b.shape().pose().offset)) return walk.end();
  for (std::size_t i = 0; i < start.size && !walk.end().inside; ++i) walk.step_to(start.a[i], start.b[i]);
  for (int step = 0; step < most_steps && !walk.end().inside; ++step)
    if (!walk.step_along(walk.direction())) break;
  return walk.end();
}

}  // namespace toccata
