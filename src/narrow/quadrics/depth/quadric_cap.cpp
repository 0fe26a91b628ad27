#include "narrow/quadrics/depth/quadric_cap.hpp"

#include <algorithm>
#include <cmath>

#include "math/vec3_measures.hpp"

namespace toccata {
namespace {

/// More than what the sums of products here are off by, as a part of the sum of the magnitudes.
constexpr double rounding_of_sums = 0x1p-49;
/// The most that is gone of the way from the point through which the axis goes to one of the pairs' points, where not
/// all of these have the round parts.
constexpr double most_part = 0.25;

double least_eigenvalue(const std::array<double, 3>& m) {
  const double half = 0.5 * (m[0] - m[2]);
  return 0.5 * (m[0] + m[2]) - std::sqrt(half * half + m[1] * m[1]);
}

double length(const std::array<double, 2>& v) { return std::sqrt(v[0] * v[0] + v[1] * v[1]); }

/// The farthest point of a generator.
QuadricSupport support_of(const QuadricBody& body, Index generator, const Vec3& outward) {
  QuadricSupport found{generator, {}, body.plain_centre(generator)};
  if (!body.grown(generator)) return found;
  const Vec3 along = body.along_columns(outward);
  const double growth = plain_length(along);
  if (!(growth > 0)) return found;
  found.round = (1 / growth) * along;
  found.point = found.point + body.map(found.round);
  return found;
}

}  // namespace

Vec3 some_across(const Vec3& d) {
  const Vec3 m = magnitudes(d);
  const Vec3 aside = m.x <= m.y && m.x <= m.z ? Vec3{0, -d.z, d.y}
                     : m.y <= m.z             ? Vec3{d.z, 0, -d.x}
                                              : Vec3{-d.y, d.x, 0};
  return unit_or_zero(aside);
}

QuadricCap::QuadricCap(const QuadricBody& a, const QuadricBody& b, const HighestPoint& highest)
    : axis_(highest.axis), count_(1) {
  side_[0].body = &a;
  side_[1].body = &b;
  on_a_[0] = highest.on_a;
  on_b_[0] = highest.on_b;
  generators_[0] = highest.generators();
  look();
}

QuadricCap::QuadricCap(const QuadricBody& a, const QuadricBody& b, const Vec3& axis,
                       std::span<const GeneratorPair> generators)
    : axis_(axis), count_(std::min(generators.size(), most_pairs)) {
  side_[0].body = &a;
  side_[1].body = &b;
  for (std::size_t i = 0; i < count_; ++i) {
    generators_[i] = generators[i];
    on_a_[i] = support_of(a, generators[i].a, axis);
    on_b_[i] = support_of(b, generators[i].b, -axis);
  }
  look();
}

void QuadricCap::look() {
  for (std::size_t i = 0; i < count_; ++i) {
    point_[i] = on_a_[i].point - on_b_[i].point;
    slope_unsure_ = std::fmax(slope_unsure_, sum_of_magnitudes(on_a_[i].point) + sum_of_magnitudes(on_b_[i].point));
  }
  slope_unsure_ *= rounding_of_sums;
  across_[0] = some_across(axis_);
  if (count_ == 2) {
    const Vec3 between = point_[1] - point_[0], along = unit_or_zero(between - dot(between, axis_) * axis_);
    if (!(along == Vec3{})) across_[0] = along;
  }
  across_[1] = cross(axis_, across_[0]);
  for (std::size_t i = 0; i < count_; ++i) slope_[i] = {dot(point_[i], across_[0]), dot(point_[i], across_[1])};
  weigh();
  look_at(side_[0], axis_);
  look_at(side_[1], -axis_);
  for (const Side& side : side_) slope_unsure_ += side.size * (side.unsure + rounding_of_sums);
}

// Weights that do not make the axis' own point are no proof, but none of them is negative, so that their point is one
// of A − B.
void QuadricCap::weigh() {
  if (count_ == 2) weight_ = {std::fmax(slope_[1][0], 0), std::fmax(-slope_[0][0], 0), 0};
  for (std::size_t i = 0; i < 3 && count_ == 3; ++i) {
    const auto &p = slope_[(i + 1) % 3], &q = slope_[(i + 2) % 3];
    weight_[i] = p[0] * q[1] - p[1] * q[0];
  }
  const double sign = weight_[0] + weight_[1] + weight_[2] < 0 ? -1 : 1;
  double total = 0;
  for (double& w : weight_) total += w = std::fmax(sign * w, 0);
  if (!(total > 0)) weight_ = {1, 0, 0}, total = 1;
  for (double& w : weight_) w /= total;
  height_ = 0;
  for (std::size_t i = 0; i < count_; ++i) height_ += weight_[i] * dot(axis_, point_[i]);
  for (std::size_t i = 0; i < count_; ++i) uneven_ = std::fmax(uneven_, height_ - dot(axis_, point_[i]));
}

void QuadricCap::look_at(Side& side, const Vec3& outward) const {
  const QuadricBody& body = *side.body;
  const auto& on = &side == side_.data() ? on_a_ : on_b_;
  bool all = true;
  double share = 0;
  for (std::size_t i = 0; i < count_; ++i) {
    all = all && body.grown(on[i].generator);
    if (body.grown(on[i].generator)) share += weight_[i];
  }
  if (body.column_count() == 0) return;
  std::array<std::array<double, 2>, 3> column{};
  double squared = 0;
  for (std::size_t j = 0; j < body.column_count(); ++j) {
    const Vec3& c = body.plain_column(j);
    column[j] = {dot(c, across_[0]), dot(c, across_[1])};
    squared += dot(c, c);
  }
  const Vec3 along = body.along_columns(outward);
  side.size = std::sqrt(squared);
  side.growth = plain_length(along);
  // Where the round part is flat along the axis, it counts as the point of it that was taken.
  side.is_flat = !(side.growth > 0x1p-30 * side.size);
  if (side.is_flat) return;
  side.unsure = rounding_of_sums * side.size / side.growth;
  side.is_round = share > 0;
  side.share = all ? 1 : share;
  std::array<double, 2> lean{};
  Symmetric whole{};
  for (std::size_t j = 0; j < body.column_count(); ++j) {
    const double u = along[static_cast<int>(j)] / side.growth;
    for (std::size_t k = 0; k < 2; ++k) lean[k] += u * column[j][k];
    whole[0] += column[j][0] * column[j][0];
    whole[1] += column[j][0] * column[j][1];
    whole[2] += column[j][1] * column[j][1];
  }
  side.lean = length(lean);
  side.curvature = {whole[0] - lean[0] * lean[0], whole[1] - lean[0] * lean[1], whole[2] - lean[1] * lean[1]};
}

QuadricCap::Symmetric QuadricCap::plain_excess() const {
  Symmetric q{-height_, 0, -height_};
  for (const Side& side : side_)
    for (std::size_t k = 0; k < 3 && side.is_round; ++k) q[k] += side.share * side.curvature[k] / side.growth;
  return q;
}

std::optional<Vec3> QuadricCap::lower_axis() const {
  const Symmetric q = plain_excess();
  double x = 0, y = 0;
  if (count_ == 1) {
    if (!(least_eigenvalue(q) > 0)) return std::nullopt;
    const double determinant = q[0] * q[2] - q[1] * q[1];
    x = (q[1] * slope_[0][1] - q[2] * slope_[0][0]) / determinant;
    y = (q[1] * slope_[0][0] - q[0] * slope_[0][1]) / determinant;
  } else if (count_ == 2) {
    if (!(q[2] > 0)) return std::nullopt;
    x = -dot(point_[1] - point_[0], axis_) / (slope_[1][0] - slope_[0][0]);
    y = -(0.5 * (slope_[0][1] + slope_[1][1]) + q[1] * x) / q[2];
  } else {
    const Vec3 u = point_[1] - point_[0], v = point_[2] - point_[0];
    const double ux = dot(u, across_[0]), uy = dot(u, across_[1]), vx = dot(v, across_[0]), vy = dot(v, across_[1]);
    const double determinant = ux * vy - uy * vx;
    x = (uy * dot(v, axis_) - vy * dot(u, axis_)) / determinant;
    y = (vx * dot(u, axis_) - ux * dot(v, axis_)) / determinant;
  }
  // Asked so that NaN is none.
  if (!(x * x + y * y < 1)) return std::nullopt;
  return unit_or_zero(axis_ + x * across_[0] + y * across_[1]);
}

std::optional<QuadricCap::Curvature> QuadricCap::curvature_within(double tangent) const {
  Curvature result;
  for (const Side& side : side_) {
    if (!side.is_round) continue;
    const double along = tangent * (side.lean + side.size * (side.unsure + rounding_of_sums));
    const double across =
        tangent * std::sqrt(side.curvature[0] + side.curvature[2] + rounding_of_sums * side.size * side.size);
    if (!(along < 0.9 * side.growth)) return std::nullopt;
    const double widest = (side.growth + along) + 0.25 * across * across / (side.growth - along);
    const double share = side.share == 1 ? 1 : (1 - most_part) * side.share;
    for (std::size_t k = 0; k < 3; ++k) result.radii[k] += share * side.curvature[k] / widest;
    result.unsure += (side.unsure + rounding_of_sums) * side.size * side.size / widest;
  }
  return result;
}

// |d + x| is at most 1 + |x|² / 2, so that the height h + p · x + ½ xᵀG x is to be compared with `least` (1 + |x|² /
// 2).
double QuadricCap::loss_within(double tangent, double least) const {
  const std::optional<Curvature> g = curvature_within(tangent);
  if (!g) return HUGE_VAL;
  const double less = least * (1 + rounding_of_sums) + 4 * g->unsure;
  const Symmetric excess{g->radii[0] - less, g->radii[1], g->radii[2] - less};
  if (count_ == 1) return loss_around_point(excess, tangent);
  return count_ == 2 ? loss_around_edge(excess, tangent) : loss_around_face(excess, tangent);
}

double QuadricCap::loss_around_point(const Symmetric& excess, double tangent) const {
  const double least = least_eigenvalue(excess), slope = length(slope_[0]) * (1 + rounding_of_sums) + slope_unsure_;
  if (slope < least * tangent) return 0.5 * slope * slope / least * (1 + rounding_of_sums);
  return (slope * tangent - 0.5 * least * tangent * tangent) * (1 + rounding_of_sums);
}

// The highest of the points is no lower than the point through which the axis goes, moved by a part of the way to any
// of them: by as small a part as what is needed of the reach.
double QuadricCap::loss_between(double needed, double reach) const {
  const bool is_whole = side_[0].share == 1 && side_[1].share == 1;
  if (!(reach > 0) || !(needed < reach * (is_whole ? 1 - rounding_of_sums : most_part))) return HUGE_VAL;
  return needed / reach * uneven_ * (1 + rounding_of_sums);
}

// Along the edge, at α, an end gains the reach to it times |α|; across it, at β, nothing is lost but by the slope. The
// least over β of −slope |β| + mixed α β + ½ second β² is −(slope + |mixed α|)² / (2 second).
double QuadricCap::loss_around_edge(const Symmetric& excess, double tangent) const {
  const double slope = std::fmax(std::fabs(slope_[0][1]), std::fabs(slope_[1][1])) + slope_unsure_;
  const double reach = std::fmin(-slope_[0][0], slope_[1][0]) - slope_unsure_;
  const double mixed = std::fabs(excess[1]), second = excess[2] * (1 - rounding_of_sums);
  if (!(second > 0)) return HUGE_VAL;
  const double bend = std::fmax(mixed * mixed / second - excess[0], 0);
  const double needed = 2 * slope_unsure_ + slope * mixed / second + 0.5 * bend * tangent;
  return loss_between(needed, reach) + 0.5 * slope * slope / second * (1 + rounding_of_sums);
}

// In every direction of the plane some corner reaches as far as the circle within the triangle around the axis.
double QuadricCap::loss_around_face(const Symmetric& excess, double tangent) const {
  double reach = HUGE_VAL, sign = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto &p = slope_[i], &q = slope_[(i + 1) % 3];
    const double side = p[0] * q[1] - p[1] * q[0];
    if (i == 0) sign = side < 0 ? -1 : 1;
    reach = std::fmin(reach, sign * side / length(std::array{q[0] - p[0], q[1] - p[1]}));
  }
  const double needed = 4 * slope_unsure_ + 0.5 * std::fmax(-least_eigenvalue(excess), 0) * tangent;
  return loss_between(needed, reach * (1 - rounding_of_sums) - 4 * slope_unsure_);
}

double QuadricCap::widest_tangent(double least) const {
  constexpr double narrowest = 0x1p-12;
  const double loss = 0.5 * (height_ - least);
  if (!(loss_within(narrowest, least) <= loss)) return 0;
  double tangent = 1;
  while (tangent > narrowest && !(loss_within(tangent, least) <= loss)) tangent *= 0.75;
  return std::fmax(tangent, narrowest);
}

template <class Number>
Number QuadricCap::weighed_height(const std::array<Number, most_pairs>& height) const {
  if (count_ == 1) return height[0];
  Number weighed = number_as<Number>(weight_[0]) * height[0], total = number_as<Number>(weight_[0]);
  for (std::size_t i = 1; i < count_; ++i) {
    weighed = weighed + number_as<Number>(weight_[i]) * height[i];
    total = total + number_as<Number>(weight_[i]);
  }
  return weighed / total;
}

template <class Number>
Number QuadricCap::height_of_side(const Side& side, const QuadricSupport& on, const FineVector& outward) const {
  if (!side.is_flat) return generator_height<Number>(*side.body, on.generator, outward);
  return inner(vector_as<Number>(outward), point_of<Number>(*side.body, body_point(on)));
}

/// Gives what the height is certainly no less than.
template <class Number>
double QuadricCap::refined() {
  std::array<Number, most_pairs> height;
  for (std::size_t i = 0; i < count_; ++i)
    height[i] = height_of_side<Number>(side_[0], on_a_[i], fine(axis_)) +
                height_of_side<Number>(side_[1], on_b_[i], fine(-axis_));
  const Number weighed = weighed_height(height);
  height_ = middle(weighed);
  uneven_ = 0;
  for (std::size_t i = 0; i < count_; ++i) uneven_ = std::fmax(uneven_, ceiling_of(weighed - height[i]));
  return floor_of(weighed);
}

void QuadricCap::refine() { refined_lower_ = refined<BoundedNumber>(); }

double QuadricCap::proved_height(double tangent, double least) {
  double lower = 0;
  const auto prove = [&](double height) {
    // The axis is of length 1 but for rounding, and x lies across it but for that.
    lower = height * (1 - rounding_of_sums) - loss_within(tangent * (1 + rounding_of_sums), least);
    return lower * (1 - 0x1p-50) >= least;
  };
  const bool is_proved = refined_lower_ ? prove(*refined_lower_) : prove(refined<BoundedDouble>());
  if (!is_proved && !refined_lower_) {
    refine();
    prove(*refined_lower_);
  }
  // Asked so that NaN is no proof.
  return lower > 0 ? lower * (1 - 0x1p-50) : 0;
}

}  // namespace toccata
