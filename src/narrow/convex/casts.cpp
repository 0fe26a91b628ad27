#include "toccata/narrow/casts.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "math/bounded_number.hpp"
#include "narrow/convex/gjk.hpp"
#include "narrow/convex/swept_meeting.hpp"
#include "narrow/exact/nearest_certificate.hpp"
#include "toccata/core/error.hpp"

namespace toccata {
namespace {

/// The interval's width, of the whole way.
constexpr double time_width = 0x1p-42;
constexpr int most_steps = 40;

/// A plane across `direction` that keeps the shapes apart until `time`; both proved.
struct Separation {
  double time = 0;
  bool for_ever = false;  ///< and after
};

double sum_of_magnitudes(const Vec3& v) { return (std::fabs(v.x) + std::fabs(v.y)) + std::fabs(v.z); }

/// A time by which the shapes have met, and where.
struct Meeting {
  double time = 0;
  Vec3 point;
};

/// One cast: A is moved, B stands.
class ShapeCast {
 public:
  ShapeCast(const PosedConvex& a, const Vec3& motion, const PosedConvex& b)
      : a_(a),
        b_(b),
        motion_(motion),
        kernels_(support_kernels()),
        reach_(std::nextafter(a.radius() + b.radius(), HUGE_VAL)) {}

  /// Are they apart all the way, with a plane across the direction between them?
  [[nodiscard]] bool is_kept_apart(const Vec3& direction) const {
    if (direction == Vec3{}) return false;
    const Separation found = separation(scaled_direction(direction));
    return found.for_ever || found.time > 1;
  }

  /// The direction that has kept them apart all the way.
  [[nodiscard]] const Vec3& parting() const { return parting_; }

  /// For shapes that are apart at the start.
  Cast answer() {
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
    for (int step = 0; step < most_steps; ++step) {
      const PosedConvex moved = a_.moved(free_until_ * motion_);
      const GjkEnd end = search_nearest({moved, kernels_}, {b_, kernels_}, last_, {std::nan("")});
      last_ = end.simplex.pairs;
      if (end.inside || end.nearest == Vec3{}) return false;
      const Vec3 direction = scaled_direction(-end.nearest);
      const Separation found = separation(direction);
      if (found.for_ever || found.time > 1) {
        parting_ = direction;
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

  /// A time by which the shapes have certainly met, soon enough after the one until which they are free.
  [[nodiscard]] std::optional<Meeting> certain_meeting() const {
    const auto met = a_.radius() + b_.radius() > 0 ? met_by_nearness() : met_by_triangles();
    return met && met->time <= 1 && met->time - free_until_ <= 2 * time_width ? met : std::nullopt;
  }

  /// The cores are nearer than the radii reach, a little later. Moved vertices are rounded twice, so they are off by
  /// less than 2^-52 of the coordinates that meet.
  [[nodiscard]] std::optional<Meeting> met_by_nearness() const {
    if (!a_.in_world()) return {};
    const double late = std::fmin(1, free_until_ + time_width);
    const PosedConvex moved = a_.moved(late * motion_);
    const auto nearest = certain_nearest({moved, kernels_}, {b_, kernels_}, last_);
    if (!nearest || !nearest->unique()) return {};
    double greatest = 0;
    for (Index i = 0; i < a_.vertex_count(); ++i) greatest = std::fmax(greatest, sum_of_magnitudes(a_.vertex(i)));
    const double error = 0x1p-50 * ((greatest + sum_of_magnitudes(motion_)) + reach_) + 0x1p-1000;
    const double distance = nearest->distance.value.high + 4 * nearest->distance.error;
    if (!(distance + error < (1 - 0x1p-50) * reach_)) return {};
    const Vec3 grown = (b_.radius() / distance) * high_parts(nearest->difference);
    return Meeting{late, high_parts(nearest->on_b) + grown};
  }

  /// The way passes through a triangle of the Minkowski difference: three exact signs. When, is enclosed.
  [[nodiscard]] std::optional<Meeting> met_by_triangles() const {
    for (std::size_t without = 0; without < 4 && last_.size >= 3; ++without) {
      VertexPairs triangle;
      for (std::size_t i = 0; i < last_.size; ++i)
        if (i != without && triangle.size < 3) triangle.append(last_.a[i], last_.b[i]);
      if (last_.size == 3 && without > 0) break;
      if (last_.size == 3) triangle = last_;
      if (const auto late = met_by_triangle(triangle)) return late;
    }
    return {};
  }

  [[nodiscard]] std::optional<Meeting> met_by_triangle(const VertexPairs& pairs) const {
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
    const double late = time.value.high + distance_from_high(time);
    if (!std::isfinite(late)) return {};
    return Meeting{std::nextafter(late, HUGE_VAL), point_of_b(pairs, c)};
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

  [[nodiscard]] bool reaches(double time) const { return swept_meets(a_, motion_, time, b_); }

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

  [[nodiscard]] Cast met(const Meeting& meeting) const {
    Cast cast;
    cast.hit = true;
    cast.lower = free_until_;
    cast.upper = meeting.time;
    cast.point = meeting.point;
    const Vec3 against = normal_ == Vec3{} ? scaled_direction(-motion_) : normal_;
    cast.normal = (1 / std::sqrt(dot(against, against))) * against;
    return cast;
  }

  const PosedConvex& a_;
  const PosedConvex& b_;
  Vec3 motion_;
  SupportKernels kernels_;
  double reach_;
  VertexPairs last_;
  double free_until_ = 0;
  Vec3 normal_{};
  Vec3 parting_{};
};

Cast met_at_start(const Vec3& point) {
  Cast cast;
  cast.hit = true;
  cast.point = point;
  return cast;
}

}  // namespace

Cast cast_shape(const PosedConvex& a, const Vec3& motion, const PosedConvex& b, ConvexWorkspace* workspace) {
  if (!is_finite(motion)) throw Error("a cast: the motion has a coordinate that is not finite");
  if (overlap(a, b, workspace)) return met_at_start(distance(a, b, workspace).on_b);
  if (motion == Vec3{}) return {};
  ShapeCast cast(a, motion, b);
  // What keeps the shapes apart all the way mostly does so the next time.
  if (workspace != nullptr && cast.is_kept_apart(workspace->direction)) return {};
  const Cast answer = cast.answer();
  if (workspace != nullptr && !(cast.parting() == Vec3{})) workspace->direction = cast.parting();
  return answer;
}

Cast cast_ray(const Vec3& origin, const Vec3& motion, const PosedConvex& target) {
  if (!is_finite(origin)) throw Error("a ray: its origin has a coordinate that is not finite");
  if (motion == Vec3{}) throw Error("a ray: its motion is zero; ask whether the point overlaps");
  return cast_shape(PosedConvex(Point(origin)), motion, target);
}

}  // namespace toccata
