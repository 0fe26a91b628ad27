#include "toccata/narrow/casts.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "math/bounded_double.hpp"
#include "math/vec3_measures.hpp"
#include "narrow/convex/cast_until.hpp"
#include "narrow/convex/gjk.hpp"
#include "narrow/convex/swept_overlap.hpp"
#include "narrow/convex/time_width.hpp"
#include "narrow/exact/nearest_certificate.hpp"
#include "toccata/core/error.hpp"

namespace toccata {
namespace {

/// The greatest width of the interval.
constexpr double greatest_width = 2 * time_width;
/// The same where coordinates are so large that less is lost in their last places: less than 10^-12.
constexpr double width_far_out = 4 * time_width;
constexpr int most_cast_steps = 40;

/// A plane across `direction` that keeps the shapes apart until `time`; both proved.
struct Separation {
  double time = 0;
  bool for_ever = false;  ///< and after
};

/// A time by which the shapes have met, and where.
struct CastContact {
  double time = 0;
  Vec3 point;
  Vec3 across{};  ///< a direction at right angles to both there
};

/// One cast: A is moved, B stands.
class ShapeCast {
 public:
  ShapeCast(const PosedPolytope& a, const Vec3& motion, const PosedPolytope& b)
      : a_(a),
        b_(b),
        motion_(motion),
        kernels_(support_kernels()),
        reach_(std::nextafter(a.radius() + b.radius(), HUGE_VAL)) {}

  /// Are they apart until a time, with a plane across the direction between them?
  [[nodiscard]] bool is_kept_apart(const Vec3& direction, double until) const {
    if (direction == Vec3{}) return false;
    const Separation found = separation(scaled_direction(direction));
    return found.for_ever || found.time > until;
  }

  /// The same by the plane between their nearest points at that time, if it is known to do so.
  [[nodiscard]] std::optional<Vec3> separation_until(double time) const {
    const PosedPolytope moved = a_.moved(time * motion_);
    const GjkEnd end = search_nearest({moved, kernels_}, {b_, kernels_}, {}, {std::nan("")});
    if (end.inside || end.nearest == Vec3{} || !is_finite(end.nearest)) return {};
    const Vec3 direction = scaled_direction(-end.nearest);
    return is_kept_apart(direction, time) ? std::optional(direction) : std::nullopt;
  }

  /// The answer took exact arithmetic.
  [[nodiscard]] bool was_exact() const { return was_exact_; }

  /// The direction that has kept them apart all the way.
  [[nodiscard]] const Vec3& separating_direction() const { return separating_; }

  /// For shapes that are apart at the start.
  std::optional<Cast> answer() {
    if (advance()) return {};
    if (const auto meeting = certain_meeting()) return met(*meeting);
    if (!reaches(1)) return {};
    const double late = narrow();
    return met({late, distance(a_.moved(free_until_ * motion_), b_).on_b});
  }

 private:
  /// Moves the time on, from separating plane to separating plane, as far as it certainly stays free. True when that is
  /// all the way: nothing is met. After the conservative advancement of B. Mirtich, "Impulse-based dynamic simulation
  /// of rigid body systems", 1996; each step ends where the plane of the last one no longer separates.
  bool advance() {
    for (int step = 0; step < most_cast_steps; ++step) {
      const PosedPolytope moved = a_.moved(free_until_ * motion_);
      const GjkEnd end = search_nearest({moved, kernels_}, {b_, kernels_}, last_, {std::nan("")});
      last_ = end.simplex.pairs;
      if (end.inside || end.nearest == Vec3{}) return false;
      const Vec3 direction = scaled_direction(-end.nearest);
      const Separation found = separation(direction);
      if (found.for_ever || found.time > 1) {
        separating_ = direction;
        return true;
      }
      if (!(found.time > free_until_)) return false;
      normal_ = -direction;
      const bool arrived = found.time - free_until_ < time_width / 8;
      free_until_ = found.time;
      if (arrived) return false;
    }
    return false;
  }

  /// The greatest coordinate becomes about 1/2, which the supports' bounds want.
  static Vec3 scaled_direction(const Vec3& d) {
    const double greatest = std::fmax(std::fmax(std::fabs(d.x), std::fabs(d.y)), std::fabs(d.z));
    const int exponent = std::ilogb(greatest) + 1;
    return {std::scalbn(d.x, -exponent), std::scalbn(d.y, -exponent), std::scalbn(d.z, -exponent)};
  }

  /// Until when the cores lie more than the radii apart along the direction: gap − time · speed > reach · |direction|.
  [[nodiscard]] Separation separation(const Vec3& direction) const {
    if (!in_certain_range(direction)) return {};
    const double of_b = SupportSearch(b_, kernels_).lower_bound(direction);
    const double of_a = SupportSearch(a_, kernels_).lower_bound(-direction);
    const double grown = reach_ * std::sqrt(dot(direction, direction));
    const double x = direction.x * motion_.x, y = direction.y * motion_.y, z = direction.z * motion_.z;
    const double magnitude = (std::fabs(x) + std::fabs(y)) + std::fabs(z);
    // A handful of roundings of 2^-53 each; underflow is within the floor.
    const double gap = ((of_b + of_a) - grown) - (0x1p-50 * ((std::fabs(of_b) + std::fabs(of_a)) + grown) + 0x1p-1000);
    const double speed = ((x + y) + z) + (0x1p-50 * magnitude + 0x1p-1000);
    if (speed <= 0) return {0, gap + free_until_ * -speed * (1 - 0x1p-50) > 0x1p-1000};
    return {gap > 0 ? (1 - 0x1p-50) * (gap / speed) : 0, false};
  }

  /// The same in double words, for shapes so large that what doubles round takes a while to pass by: the time until
  /// which the direction certainly keeps them apart, or 0.
  [[nodiscard]] double sharp_time(const Vec3& direction) const {
    const auto of_a = sharp_height(a_, -direction), of_b = sharp_height(b_, direction);
    if (!of_a || !of_b) return 0;
    const BoundedNumber reach = exactly(a_.radius()) + exactly(b_.radius());
    const BoundedNumber speed = dot(exactly(direction), exactly(motion_));
    const BoundedNumber gap = (*of_a + *of_b) - reach * length(exactly(direction));
    if (!gap.is_positive() || !speed.is_positive()) return 0;
    const BoundedNumber time = gap / speed;
    return std::fmax(floor_of(time), 0);
  }

  /// The least height of a vertex along a direction; nothing where too many may be the lowest.
  [[nodiscard]] std::optional<BoundedNumber> sharp_height(const PosedPolytope& shape, const Vec3& direction) const {
    const SupportSearch support(shape, kernels_);
    std::array<Index, 16> lowest{};
    const Index first = support.least(direction);
    const Index count = support.close(direction, 0, support.vertex(first), {}, lowest);
    if (count > lowest.size()) return {};
    BoundedNumber least = dot(exactly(direction), exactly(support.vertex(first)));
    for (Index i = 0; i < count; ++i) {
      const BoundedNumber height = dot(exactly(direction), exactly(support.vertex(lowest[i])));
      if (!(height - least).is_positive()) least = lower_of(least, height);
    }
    return least;
  }

  /// A number that is not above either, and with either's error at least.
  static BoundedNumber lower_of(const BoundedNumber& a, const BoundedNumber& b) {
    const bool is_a = (a.value - b.value).high < 0;
    return {is_a ? a.value : b.value, std::fmax(a.error, b.error)};
  }

  /// Free until the plane across a direction, both ways of which are the same, no longer keeps them apart.
  void sharpen(const Vec3& across) {
    if (across == Vec3{} || !is_finite(across)) return;
    const Vec3 scaled = scaled_direction(across), direction = dot(scaled, motion_) < 0 ? -scaled : scaled;
    const double time = in_certain_range(direction) ? sharp_time(direction) : 0;
    if (!(time > free_until_) || time > 1) return;
    free_until_ = time;
    normal_ = -direction;
  }

  [[nodiscard]] bool is_soon(const std::optional<CastContact>& meeting, double width) const {
    return meeting && meeting->time <= 1 && meeting->time - free_until_ <= width;
  }

  /// A time by which the shapes have certainly met, soon enough after the one until which they are free.
  std::optional<CastContact> certain_meeting() {
    if (a_.radius() + b_.radius() == 0) return met_by_triangles();
    const auto met = met_by_nearness(time_width);
    if (is_soon(met, greatest_width)) return met;
    sharpen(across_at(free_until_));
    const auto later = met_by_nearness(width_far_out);
    return is_soon(later, width_far_out) ? later : std::nullopt;
  }

  /// The direction from core to core, at a time; zero where it is not certain.
  [[nodiscard]] Vec3 across_at(double time) const {
    const PosedPolytope moved = a_.moved(time * motion_);
    const auto nearest = certain_nearest({moved, kernels_}, {b_, kernels_}, last_);
    return nearest && nearest->unique() ? high_parts(nearest->difference) : Vec3{};
  }

  /// No vertex of A moved is farther than this from where it is exactly: roughly, as each is rounded twice.
  [[nodiscard]] double roughly_rounded_by() const {
    double greatest = 0;
    for (Index i = 0; i < a_.vertex_count(); ++i) greatest = std::fmax(greatest, sum_of_magnitudes(a_.vertex(i)));
    return 0x1p-50 * ((greatest + sum_of_magnitudes(motion_)) + reach_) + 0x1p-1000;
  }

  /// The same, by looking at each.
  [[nodiscard]] double rounded_by(double time, const PosedPolytope& moved) const {
    const BoundedVector way = exactly(time) * exactly(motion_);
    double greatest = 0;
    for (Index i = 0; i < a_.vertex_count(); ++i) {
      const BoundedVector off = (exactly(a_.vertex(i)) + way) - exactly(moved.vertex(i));
      double sum = 0x1p-1000;
      for (const BoundedNumber& along : off) sum += std::fabs(along.value.high) + distance_from_high(along);
      greatest = std::fmax(greatest, sum);
    }
    return greatest;
  }

  /// The cores are nearer than the radii reach, a little later.
  [[nodiscard]] std::optional<CastContact> met_by_nearness(double width) const {
    if (!a_.in_world()) return {};
    const double late = std::fmin(1, free_until_ + width);
    const PosedPolytope moved = a_.moved(late * motion_);
    const auto nearest = certain_nearest({moved, kernels_}, {b_, kernels_}, last_);
    if (!nearest || !nearest->unique()) return {};
    const double distance = nearest->distance.value.high + 4 * nearest->distance.error;
    const double least_reach = (1 - 0x1p-50) * reach_;
    if (!(distance + roughly_rounded_by() < least_reach) && !(distance + rounded_by(late, moved) < least_reach))
      return {};
    const Vec3 grown = (b_.radius() / distance) * high_parts(nearest->difference);
    return CastContact{late, high_parts(nearest->on_b) + grown};
  }

  /// The way passes through a triangle of the Minkowski difference: three exact signs. When, is enclosed; and its plane
  /// is the one that keeps the shapes apart until then, if it is a face of the difference.
  std::optional<CastContact> met_by_triangles() {
    for (std::size_t without = 0; without < 4 && last_.size >= 3; ++without) {
      VertexPairs triangle;
      for (std::size_t i = 0; i < last_.size; ++i)
        if (i != without && triangle.size < 3) triangle.append(last_.a[i], last_.b[i]);
      if (last_.size == 3 && without > 0) break;
      if (last_.size == 3) triangle = last_;
      const auto met = met_by_triangle(triangle);
      if (met && met->time <= 1 && !is_soon(met, greatest_width)) sharpen(met->across);
      if (is_soon(met, greatest_width)) return met;
    }
    return {};
  }

  [[nodiscard]] std::optional<CastContact> met_by_triangle(const VertexPairs& pairs) const {
    std::array<Difference, 3> corner;
    for (std::size_t i = 0; i < 3; ++i) corner[i] = {b_.vertex(pairs.b[i]), a_.vertex(pairs.a[i])};
    int left = 0, right = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const Sign turn = triple_product_sign(corner[i], corner[(i + 1) % 3], {motion_, {}});
      left += turn == Sign::positive ? 1 : 0;
      right += turn == Sign::negative ? 1 : 0;
    }
    if ((left > 0) == (right > 0)) return {};
    std::array<BoundedVector, 3> c;
    for (std::size_t i = 0; i < 3; ++i) c[i] = bounded_difference(corner[i].head, corner[i].tail);
    const BoundedVector normal = cross(c[1] - c[0], c[2] - c[0]);
    const BoundedNumber time = dot(normal, c[0]) / dot(normal, exactly(motion_));
    if (!time.is_positive()) return {};  // the triangle lies behind
    const double late = ceiling_of(time);
    if (!std::isfinite(late)) return {};
    return CastContact{late, point_of_b(pairs, c), high_parts(normal)};
  }

  /// The way's point in a triangle of differences, as the point of B with the same weights, rounded.
  [[nodiscard]] Vec3 point_of_b(const VertexPairs& pairs, const std::array<BoundedVector, 3>& corner) const {
    std::array<double, 3> weight;
    for (std::size_t i = 0; i < 3; ++i)  // of one sign, but for rounding
      weight[i] = std::fabs(dot(cross(corner[(i + 1) % 3], corner[(i + 2) % 3]), exactly(motion_)).value.high);
    const double total = (weight[0] + weight[1]) + weight[2];
    Vec3 point;
    for (std::size_t i = 0; i < 3; ++i) point = point + (weight[i] / total) * b_.vertex(pairs.b[i]);
    return point;
  }

  [[nodiscard]] bool reaches(double time) {
    was_exact_ = true;
    return swept_meets(a_, motion_, time, b_);
  }

  /// The first meeting lies between the time that is known to be free and one that is known to be late enough: makes
  /// the first of them later until they are near each other, and returns the second.
  double narrow() {
    double late = 1;
    for (double width = time_width; free_until_ + width < late; width *= 64)
      (reaches(free_until_ + width) ? late : free_until_) = free_until_ + width;
    while (late - free_until_ > time_width) {
      const double middle = free_until_ + (late - free_until_) / 2;
      (reaches(middle) ? late : free_until_) = middle;
    }
    return late;
  }

  [[nodiscard]] Cast met(const CastContact& meeting) const {
    Cast cast;
    cast.lower = free_until_;
    cast.upper = meeting.time;
    cast.point = meeting.point;
    const Vec3 against = normal_ == Vec3{} ? scaled_direction(-motion_) : normal_;
    cast.normal = (1 / std::sqrt(dot(against, against))) * against;
    return cast;
  }

  const PosedPolytope& a_;
  const PosedPolytope& b_;
  Vec3 motion_;
  SupportKernels kernels_;
  double reach_;
  VertexPairs last_;
  double free_until_ = 0;
  bool was_exact_ = false;
  Vec3 normal_{};
  Vec3 separating_{};
};

Cast met_at_start(const Vec3& point) {
  Cast cast;
  cast.point = point;
  return cast;
}

}  // namespace

std::optional<Cast> cast_shape(const PosedPolytope& a, const Vec3& motion, const PosedPolytope& b,
                               SimplexCache* workspace) {
  if (!is_finite(motion)) throw Error("a cast: the motion has a coordinate that is not finite");
  if (overlap(a, b, workspace)) return met_at_start(distance(a, b, workspace).on_b);
  if (motion == Vec3{}) return {};
  ShapeCast cast(a, motion, b);
  // What keeps the shapes apart all the way mostly does so the next time.
  if (workspace != nullptr && cast.is_kept_apart(workspace->direction, 1)) return {};
  const std::optional<Cast> answer = cast.answer();
  if (workspace != nullptr) workspace->counts.exact += cast.was_exact() ? 1 : 0;
  if (workspace != nullptr && !(cast.separating_direction() == Vec3{}))
    workspace->direction = cast.separating_direction();
  return answer;
}

std::optional<Cast> cast_shape_until(const PosedPolytope& a, const Vec3& motion, const PosedPolytope& b, double limit,
                                     SimplexCache& workspace) {
  const ShapeCast cast(a, motion, b);
  if (cast.is_kept_apart(workspace.direction, limit)) return {};
  if (const auto direction = cast.separation_until(limit)) {
    workspace.direction = *direction;
    return {};
  }
  return cast_shape(a, motion, b, &workspace);
}

std::optional<Cast> cast_ray(const Vec3& origin, const Vec3& motion, const PosedPolytope& target) {
  if (!is_finite(origin)) throw Error("a ray: its origin has a coordinate that is not finite");
  if (motion == Vec3{}) throw Error("a ray: its motion is zero; ask whether the point overlaps");
  return cast_shape(PosedPolytope(Point(origin)), motion, target);
}

}  // namespace toccata
