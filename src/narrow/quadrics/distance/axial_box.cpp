#include "narrow/quadrics/distance/axial_box.hpp"

#include <algorithm>
#include <cmath>

#include "math/constants.hpp"
#include "math/vec3_measures.hpp"
#include "narrow/pose_checks.hpp"
#include "narrow/quadrics/distance/axial_proof.hpp"
#include "narrow/quadrics/kinds/quadric_kind.hpp"

// The square of the distance of the round shape A from the point C + Σ s_j b_j of the box is convex in s, and half of
// it has the derivative b_j · (q − x), x the point of A nearest to the point q, which has a closed form. So the nearest
// point of the box is sought by an active set: coordinates at an end of their range which the derivative does not lead
// inwards rest there. Where all rest, the nearest points are found; where one is free, Newton's method has a closed
// second derivative; where two are, the nearest point of A is its farthest against the normal of that face.
namespace toccata {
namespace {

constexpr int most_axial_steps = 16;
/// What is left after a step that is smaller than this part of the shapes is about its square.
constexpr double small_step = 0x1p-24;
/// As far as the guess goes, both poses are rotations.
constexpr double largest_skew_of_rotations = 0x1p-42;

double clamped_around_zero(double x, double limit) { return std::min(std::max(x, -limit), limit); }

template <AxialKind Kind>
class AxialBox {
 public:
  AxialBox(const PosedQuadric& a, const PosedPolytope& b)
      : a_(a),
        b_(b),
        shape_(a.half()),
        axis_(a.pose().linear.column(2)),
        half_(b.as_box().half_extents),
        between_(b.as_box().centre - a.pose().offset) {
    for (int j = 0; j < 3; ++j) {
      side_[static_cast<std::size_t>(j)] = b.pose().linear.column(j);
      at_[j] = clamped_around_zero(-dot(side_[static_cast<std::size_t>(j)], between_), half_[j]);
    }
    small_ = small_step * std::min({a.half().x, a.half().z, half_.x, half_.y, half_.z});
  }

  /// Tells whether the conditions of the nearest points hold.
  bool search() {
    for (int i = 0; i < most_axial_steps; ++i) {
      if (!look_from_box()) return false;
      const Step taken = step();
      if (taken == Step::none) return true;
      if (taken == Step::failed) return false;
      if (taken == Step::small) return look_from_box();
    }
    return false;
  }

  [[nodiscard]] std::optional<FastDistance> proved() const;
  [[nodiscard]] bool is_surely_apart() const;
  /// Whether the plane across the line between the middles parts the two.
  [[nodiscard]] bool is_parted_between_middles() const;
  /// Where the search ended.
  [[nodiscard]] bool is_box_met_within() const;

 private:
  enum class Step { none, small, far, failed };
  /// What is proved of the distance in plain doubles, along a direction from a point of A in its own frame.
  struct Bounds {
    FastDistance distance;
    Vec3 on_a, direction;
  };

  [[nodiscard]] const Vec3& side(int j) const { return side_[static_cast<std::size_t>(j)]; }

  /// That of the box, from the middle of A.
  [[nodiscard]] Vec3 point_of_box() const {
    return between_ + ((at_.x * side_[0] + at_.y * side_[1]) + at_.z * side_[2]);
  }

  /// The nearest point of A to the point of the box, and what is between them.
  bool look_from_box() {
    const Vec3 point = point_of_box();
    const double up = dot(axis_, point);
    const Vec3 across = point - up * axis_;
    const double out = plain_length(across);
    radial_ = out > 0 ? (1 / out) * across : Vec3{};
    foot_ = shape_.foot(out, up);
    gap_ = point - (foot_.out * radial_ + foot_.up * axis_);
    return foot_.outside;
  }

  Step step() {
    Vec3 derivative;
    int free = 0, one_free = 0, one_resting = 0;
    for (int j = 0; j < 3; ++j) {
      derivative[j] = dot(side(j), gap_);
      const bool rests = (at_[j] == half_[j] && derivative[j] <= 0) || (at_[j] == -half_[j] && derivative[j] >= 0);
      free += rests ? 0 : 1;
      (rests ? one_resting : one_free) = j;
    }
    if (free == 0) return Step::none;
    if (free == 3) return Step::failed;
    if (free == 1) return step_along(one_free, derivative[one_free]);
    if (off_faces_ < 2) return step_on(one_resting);
    for (int j = 0; j < 3; ++j)
      if (j != one_resting && std::fabs(derivative[j]) > std::fabs(derivative[one_free])) one_free = j;
    return step_along(one_free, derivative[one_free]);
  }

  /// Newton's step, or to the middle of the part of the edge that is left where it would leave that.
  Step step_along(int j, double derivative) {
    if (j != edge_) {
      edge_ = j;
      most_ = half_[j];
      least_ = -most_;
    }
    (derivative > 0 ? most_ : least_) = at_[j];
    const double up = dot(side(j), axis_), out = dot(side(j), radial_);
    const double within = foot_.slope_out * out + foot_.slope_up * up;
    const double beside = std::max(0.0, 1 - (up * up + out * out));
    const double second = (up * up + out * out - within * within) + (1 - foot_.share) * beside;
    double next = clamped_around_zero(at_[j] - derivative / second, half_[j]);
    if (!(next >= least_ && next <= most_)) next = 0.5 * (least_ + most_);
    const double length = std::fabs(next - at_[j]);
    at_[j] = next;
    return length < small_ ? Step::small : Step::far;
  }

  /// The nearest points where the point of the box lies on the face j.
  Step step_on(int j) {
    edge_ = -1;
    const Vec3 inwards = at_[j] > 0 ? -side(j) : side(j);
    const double up = dot(axis_, inwards);
    const Vec3 across = inwards - up * axis_;
    const double out = plain_length(across);
    const AxialFoot foot = shape_.farthest(out, up);
    const Vec3 radial = out > 0 ? (1 / out) * across : Vec3{};
    const Vec3 from_box = (foot.out * radial + foot.up * axis_) - between_;
    bool on_face = true;
    for (int k = 0; k < 3; ++k) {
      if (k == j) continue;
      const double wanted = dot(side(k), from_box);
      at_[k] = clamped_around_zero(wanted, half_[k]);
      on_face = on_face && at_[k] == wanted;
    }
    off_faces_ += on_face ? 0 : 1;
    if (!on_face) return Step::far;
    radial_ = radial;
    foot_ = foot;
    return Step::none;
  }

  /// In the frame of A, and of A.
  [[nodiscard]] Vec3 local_point() const;
  /// From the box to A, across the flat parts on which the nearest points lie: there, what a direction is off by counts
  /// wholly.
  [[nodiscard]] Vec3 direction(const Vec3& z) const;
  [[nodiscard]] std::optional<Bounds> bounds() const;
  [[nodiscard]] std::optional<FastDistance> proved_longer(const Vec3& p, const Vec3& d) const;

  const PosedQuadric& a_;
  const PosedPolytope& b_;
  typename Kind::Section shape_;
  Vec3 axis_;
  Vec3 half_;     // of the box
  Vec3 between_;  // from the middle of A to that of the box
  std::array<Vec3, 3> side_{};
  double small_ = 0;
  Vec3 at_;        // s
  int edge_ = -1;  // along which the last step went, and the part of it where the nearest point is
  int off_faces_ = 0;
  double least_ = 0;
  double most_ = 0;
  Vec3 radial_;  // from the axis of A towards the point of the box
  Vec3 gap_;     // q − x
  AxialFoot foot_;
};

template <AxialKind Kind>
Vec3 AxialBox<Kind>::local_point() const {
  const Mat3& m = a_.pose().linear;
  return drawn_in_foot<Kind>(a_.half(), foot_, dot(m.column(0), radial_), dot(m.column(1), radial_));
}

template <AxialKind Kind>
Vec3 AxialBox<Kind>::direction(const Vec3& z) const {
  if (foot_.slope_out == 1) return dot(z, axis_) > 0 ? axis_ : -axis_;
  std::array<Vec3, 2> flat;
  std::size_t size = 0;
  for (int j = 0; j < 3; ++j)
    if (std::fabs(at_[j]) < half_[j] && size < 2) flat[size++] = side(j);
  if (size < 2 && foot_.slope_up > 0) flat[size++] = foot_.slope_out * radial_ + foot_.slope_up * axis_;
  if (size == 0) return z;
  if (size == 1) return z - dot(flat[0], z) * flat[0];
  const Vec3 normal = cross(flat[0], flat[1]);
  return dot(z, normal) > 0 ? normal : -normal;
}

/// A point of the box: a corner, and steps along up to two edges from there to others. No longer than half the edge, so
/// that it is a mean of corners as they are, rounded.
struct BoxPoint {
  Vec3 corner;
  Vec3 steps;
  bool is_corner = true;
};

/// The nearest corner, numbered as PosedPolytope numbers corners.
Index nearest_corner(const Vec3& at) { return (at.x > 0 ? 1U : 0U) + (at.y > 0 ? 2U : 0U) + (at.z > 0 ? 4U : 0U); }

BoxPoint box_point(const PosedPolytope& box, const Vec3& at) {
  const Vec3& half = box.as_box().half_extents;
  const Index nearest = nearest_corner(at);
  BoxPoint point{box.vertex(nearest), {}};
  for (int j = 0; j < 3; ++j) {
    const double inwards = half[j] - std::fabs(at[j]);
    if (inwards == 0) continue;
    point.is_corner = false;
    point.steps = point.steps + (inwards / (2 * half[j])) * (box.vertex(nearest ^ (1U << j)) - point.corner);
  }
  return point;
}

/// What a box reaches beyond one of its corners along a direction.
double beyond_corner(const PosedPolytope& box, const Vec3& corner, const Vec3& d) {
  const double *const x = box.along(0), *const y = box.along(1), *const z = box.along(2);
  std::array<double, 8> height;
  for (std::size_t k = 0; k < 8; ++k)
    height[k] = (d.x * (x[k] - corner.x) + d.y * (y[k] - corner.y)) + d.z * (z[k] - corner.z);
  const auto higher = [&](std::size_t i, std::size_t j) { return height[i] > height[j] ? height[i] : height[j]; };
  return std::max({higher(0, 1), higher(2, 3), higher(4, 5), higher(6, 7)});
}

// With r and h the radius and half height, e the length of the box's half extents, d = z, the difference of the points
// as computed, and L its length: an operation rounds by at most u = 2⁻⁵³ of its result, a product of three terms by 3 u
// times that of the magnitudes, a length by 2.5 u; and rotations, but for 2⁻⁴², change no length.
//
// z: the point p turned, |p| ≤ P = √(r² + h²), 3 √3 u P; its sum with what is between, which is at most L + P + 2.1 e,
// twice u; the steps, 3 u e each for their differences, products and sum, at most e; u L at the end. In all
// u (8.2 P + 6.2 e + 3 L), P ≤ r + h being of no use.
// What both reach beyond these points is off by `rounding_beyond`.
template <AxialKind Kind>
auto AxialBox<Kind>::bounds() const -> std::optional<Bounds> {
  const Vec3 p = local_point();
  const Mat3& m = a_.pose().linear;
  const Vec3 turned{dot(m[0], p), dot(m[1], p), dot(m[2], p)};
  const BoxPoint on_b = box_point(b_, at_);
  const Vec3 z = ((a_.pose().offset - on_b.corner) + turned) - on_b.steps;
  const Vec3 d = direction(z);
  const double length = plain_length(z), length_of_d = plain_length(d);
  if (!is_moderate(length) || !is_moderate(length_of_d)) return {};
  const Vec3 n{dot(m.column(0), d), dot(m.column(1), d), dot(m.column(2), d)};
  const double of_box = beyond_corner(b_, on_b.corner, d) - dot(d, on_b.steps);
  const double along = (dot(z, d) - (beyond_axial<Kind>(a_.half(), p, n) + of_box)) / length_of_d;

  const double r = a_.half().x, h = a_.half().z, e = plain_length(half_) + b_.as_box().slack;
  const double off = unit_roundoff * (9.3 * std::sqrt(r * r + h * h) + 7 * e + 3.5 * length);
  const double off_beyond = rounding_beyond(r, h, e, on_b.is_corner);
  FastDistance found;
  // 2.5 u of the length, 2 u of the operations.
  found.upper = (length + off) * (1 + 6 * unit_roundoff);
  // 3 u of the product, u of the difference, 3.5 u of the quotient, 2 u of the operations.
  found.lower = (along - (off + off_beyond)) - 12 * unit_roundoff * length;
  found.on_a = turned + a_.pose().offset;
  found.on_b = on_b.corner + on_b.steps;
  return Bounds{found, p, d};
}

template <AxialKind Kind>
std::optional<FastDistance> AxialBox<Kind>::proved() const {
  const std::optional<Bounds> found = bounds();
  if (!found) return {};
  if (is_narrow(found->distance)) return found->distance;
  return is_nearly_narrow(found->distance) ? proved_longer(found->on_a, found->direction) : std::nullopt;
}

/// No distance has to be told: a bound above 0 is enough, however wide the interval is.
template <AxialKind Kind>
bool AxialBox<Kind>::is_surely_apart() const {
  const std::optional<Bounds> found = bounds();
  return found && found->distance.lower > 0;
}

/// Tiny gaps, with twice the digits.
template <AxialKind Kind>
std::optional<FastDistance> AxialBox<Kind>::proved_longer(const Vec3& p, const Vec3& d) const {
  FastSide on_a, on_b;
  const double upper = 0.5 * (1 + p.z / a_.half().z), reach = Kind::width_at(upper);
  on_a.generator[1] = 1;
  on_a.weight = {1 - upper, upper, 0};
  on_a.size = 2;
  if (reach > 0) on_a.round = (1 / (reach * a_.half().x)) * Vec3{p.x, p.y, 0};
  on_b.generator[0] = nearest_corner(at_);
  on_b.size = 1;
  for (int j = 0; j < 3; ++j) {
    if (std::fabs(at_[j]) == half_[j]) continue;
    if (on_b.size == on_b.generator.size()) return {};
    on_b.generator[on_b.size] = on_b.generator[0] ^ (1U << j);
    on_b.weight[on_b.size++] = (half_[j] - std::fabs(at_[j])) / (2 * half_[j]);
  }
  return if_narrow(proved_interval(a_, b_, on_a, on_b, d));
}

// With d what is between the middles and L its length, (d · x)² + (d · y)² of the columns of A's pose is no more than
// L² (1 + 2⁻⁴²) − (d · axis)², and rounds by 12 u L². The other heights and their sum round by less than 20 u L (L + r
// + h + e), with e the sum of the box's half extents.
template <AxialKind Kind>
bool AxialBox<Kind>::is_parted_between_middles() const {
  const Vec3& d = between_;
  const double squared = dot(d, d), length = std::sqrt(squared), up = dot(axis_, d);
  if (!is_moderate(length)) return false;
  const double radius = a_.half().x, h = a_.half().z;
  const double rim = radius * std::sqrt(std::max(0.0, squared * (1 + 0x1p-40) - up * up));
  const double of_a = Kind::reach(rim, h * up).up;
  double of_box = b_.as_box().slack * length;
  for (int j = 0; j < 3; ++j) of_box += half_[j] * std::fabs(dot(side(j), d));
  const double sizes = length + ((radius + h) + ((half_.x + half_.y) + half_.z));
  return squared - (of_a + of_box) > 0x1p-46 * (length * sizes);
}

// With P = √(r² + h²), no less than the distance of the point from the middle of A, and e the length of the half
// extents, the point is off by u (2 P + 6.3 e) and by the box's slack. What it is up and out rounds by 12 u P, and the
// depth by 30 u P; a rotation is not farther from A's pose than 2⁻⁴³, which turns both by less than 2⁻⁴² · 1.6 P.
template <AxialKind Kind>
bool AxialBox<Kind>::is_box_met_within() const {
  const Vec3 point = point_of_box();
  const double up = dot(axis_, point), out = plain_length(point - up * axis_);
  const double r = a_.half().x, h = a_.half().z;
  const double off =
      0x1p-40 * std::sqrt(r * r + h * h) + 8 * unit_roundoff * plain_length(half_) + 2 * b_.as_box().slack;
  return shape_.depth_of(out, up) > off;
}

bool is_round_beside_box(const PosedQuadric& a, const PosedPolytope& b) {
  const RigidBox& box = b.as_box();
  if (!(box.skew < largest_skew_of_rotations) || b.radius() > 0) return false;
  if (!(box.slack < 0x1p290) || !is_surely_rigid(a.pose().linear)) return false;
  const Vec3& e = box.half_extents;
  return is_moderate(a.half().x) && is_moderate(a.half().z) && is_moderate(e.x) && is_moderate(e.y) && is_moderate(e.z);
}

template <AxialKind Kind>
std::optional<FastDistance> distance_to_box(const PosedQuadric& a, const PosedPolytope& b) {
  AxialBox<Kind> pair(a, b);
  if (!pair.search()) return {};
  return pair.proved();
}

template <AxialKind Kind>
std::optional<QuadricContact> contact_with_box(const PosedQuadric& a, const PosedPolytope& b) {
  AxialBox<Kind> pair(a, b);
  if (pair.is_parted_between_middles()) return QuadricContact::apart;
  if (pair.search() && pair.is_surely_apart()) return QuadricContact::apart;
  if (pair.is_box_met_within()) return QuadricContact::contact;
  return {};
}

}  // namespace

std::optional<FastDistance> axial_box_distance(const PosedQuadric& a, const PosedPolytope& b) {
  return with_kind(a.kind(), [&]<class Kind>(Kind) -> std::optional<FastDistance> {
    if constexpr (AxialKind<Kind>)
      if (is_round_beside_box(a, b)) return distance_to_box<Kind>(a, b);
    return {};
  });
}

std::optional<QuadricContact> axial_box_contact(const PosedQuadric& a, const PosedPolytope& b) {
  return with_kind(a.kind(), [&]<class Kind>(Kind) -> std::optional<QuadricContact> {
    if constexpr (AxialKind<Kind>)
      if (is_round_beside_box(a, b)) return contact_with_box<Kind>(a, b);
    return {};
  });
}

}  // namespace toccata
