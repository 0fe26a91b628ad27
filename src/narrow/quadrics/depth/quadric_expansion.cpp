#include "narrow/quadrics/depth/quadric_expansion.hpp"

#include <algorithm>
#include <cmath>

#include "math/vec3_measures.hpp"

namespace toccata {
namespace {

/// Heights that differ by less are one, in a frame where the bodies are of size 1.
constexpr double same_height = 0x1p-49;
/// What the first four corners count as no width.
constexpr double no_width = 0x1p-40;
constexpr int most_expansion_steps = 8;
constexpr int most_starts = 4;
/// When a cap is looked for: the parts of the lowest height that the surface may miss there (one cap; those of edges
/// and faces), how much higher it may be, and what is little besides.
constexpr double missing_for_cap = 0.1;
constexpr double missing_for_edges = 0.02;
constexpr double height_for_cap = 1.2;
constexpr double little = 0.01;
/// How far beside an edge or a face the axis may go, in parts of its size, for its cap to be looked for.
constexpr double most_beyond = 0.25;
/// Beyond so many corners caps are looked for everywhere, lest there be no end of corners.
constexpr std::size_t many_corners = 40;

}  // namespace

QuadricExpansion::Corner::Corner(const QuadricCap& cap, double s, double t)
    : a(cap.on_a()), b(cap.on_b()), axis(cap.axis()), generator_count(cap.generators().size()), times(s), tangent(t) {
  std::copy(cap.generators().begin(), cap.generators().end(), generators.begin());
}

QuadricExpansion::QuadricExpansion(const QuadricBody& a, const QuadricBody& b)
    : a_(a), b_(b), memory_(buffer_.data(), buffer_.size()), corner_(&memory_) {
  corner_.reserve(GrowingSurface::most_corners);
}

/// Gives the height as good as it is needed.
double QuadricExpansion::offer(const HighestPoint& highest) {
  double height = highest.height;
  if (height < upper_ + same_height && height < shallow_height)
    height = middle(height_of_pair<BoundedNumber>(a_, b_, highest.generators(), highest.axis));
  offer(height, highest.axis);
  return height;
}

void QuadricExpansion::offer(double height, const Vec3& axis) {
  if (!(height < upper_)) return;
  upper_ = height;
  direction_ = axis;
}

double QuadricExpansion::target() const { return upper_ * (1 - part_); }

GrowingSurface::Corner QuadricExpansion::placed(const Corner& corner, const Vec3& point) const {
  if (precision_ == Precision::plain) return {point, {}};
  return {point, vector_as<DoubleWord>(exact_corner<BoundedNumber>(corner))};
}

bool QuadricExpansion::add(const Corner& corner, const Vec3& point, std::size_t facet) {
  if (!surface_.add(placed(corner, point), facet)) return false;
  corner_.push_back(corner);
  return true;
}

bool QuadricExpansion::start() {
  has_surface_ = false;
  const Vec3 between = unit_or_zero(b_.middle() - a_.middle());
  const HighestPoint first(a_, b_, between == Vec3{} ? Vec3{1, 0, 0} : between), second(a_, b_, -first.axis);
  std::array<GrowingSurface::Corner, 4> corner;
  corner_.clear();
  const auto place = [&](const HighestPoint& highest) {
    offer(highest);
    corner_.push_back(Corner(highest));
    corner[corner_.size() - 1] = placed(corner_.back(), highest.point);
  };
  place(first);
  place(second);
  if (!(upper_ > 0)) return false;
  const Vec3 axis = unit_or_zero(second.point - first.point);
  const Vec3 across = some_across(axis);
  HighestPoint third(a_, b_, across);
  // The first two may lie on a flat end, beyond which there is nothing on this side.
  if (const double beside = dot(across, third.point - first.point); !(beside > no_width))
    if (const HighestPoint other(a_, b_, -across); dot(across, first.point - other.point) > beside) third = other;
  place(third);
  const Vec3 normal = unit_or_zero(cross(axis, third.point - first.point));
  if (normal == Vec3{}) return false;
  const HighestPoint up(a_, b_, normal), down(a_, b_, -normal);
  const double above = dot(normal, up.point - first.point), below = dot(normal, first.point - down.point);
  place(above > below ? up : down);
  return has_surface_ = surface_.start(precision_, corner);
}

// Corners that were raised when less was known to be low are wrong by so much: then all begins again.
bool QuadricExpansion::run(double part, Precision precision) {
  part_ = part;
  precision_ = precision;
  bool reached = false;
  for (int i = 0; i < most_starts; ++i) {
    highest_target_ = 0;
    reached = grow();
    if (!(highest_target_ > target() * (1 + 0x1p-45))) break;
  }
  return reached;
}

bool QuadricExpansion::grow() {
  if (!start()) return false;
  while (const std::optional<std::size_t> lowest = surface_.lowest()) {
    if (!(upper_ > 0)) return false;
    if (surface_.height(*lowest) >= target()) return true;
    if (surface_.full()) return false;
    if (!step(*lowest)) surface_.settle(*lowest);
  }
  return false;
}

// The lowest height near is looked for by Newton's method, so that its cap is as wide as can be.
bool QuadricExpansion::step(std::size_t facet) {
  const HighestPoint here(a_, b_, surface_.normal(facet));
  const double gain = offer(here) - surface_.height(facet);
  if (is_promising(here, gain, missing_for_cap))
    if (const std::optional<QuadricCap> cap = lowest_near(here); cap && raise(*cap, gain)) return true;
  if (is_promising(here, gain, missing_for_edges) && raise_edge_or_face(facet, here, gain)) return true;
  if (!(gain > same_height)) return false;
  return add(Corner(here), here.point, facet);
}

// Caps are dear: points alone grow the surface where it is far from what it stands for, or where that is high.
bool QuadricExpansion::is_promising(const HighestPoint& here, double gain, double missing) const {
  if (surface_.corner_count() > many_corners) return true;
  return gain < missing * upper_ + little && here.height < height_for_cap * upper_ + little;
}

/// Nothing where that is raised already.
std::optional<QuadricCap> QuadricExpansion::lowest_near(const HighestPoint& from) {
  QuadricCap lowest(a_, b_, from);
  for (int i = 0; i < most_expansion_steps; ++i) {
    const std::optional<Vec3> axis = lowest.lower_axis();
    if (!axis) break;
    if (is_raised(*axis)) return std::nullopt;
    const HighestPoint next(a_, b_, *axis);
    offer(next);
    if (!(next.height < lowest.height())) break;
    lowest = QuadricCap(a_, b_, next);
  }
  return lowest;
}

/// The axis lies in a cap, not near its rim.
bool QuadricExpansion::is_raised(const Vec3& axis) const {
  return std::any_of(corner_.begin(), corner_.end(), [&](const Corner& c) {
    const double along = dot(axis, c.axis);
    return c.tangent > 0 && along * along * (1 + 0.25 * c.tangent * c.tangent) > 1 && along > 0;
  });
}

/// The axis goes, but for a part of their size, between two points, or three.
bool QuadricExpansion::is_between(const Vec3& axis, std::span<const Vec3> points) const {
  const Vec3 &p = points[0], &q = points[1];
  if (points.size() == 2) {
    const Vec3 between = q - p, along = between - dot(between, axis) * axis;
    const double beyond = most_beyond * dot(along, along);
    return dot(p, along) <= beyond && dot(q, along) >= -beyond;
  }
  const Vec3& r = points[2];
  const std::array<double, 3> share{dot(axis, cross(q, r)), dot(axis, cross(r, p)), dot(axis, cross(p, q))};
  const double total = share[0] + share[1] + share[2];
  return std::all_of(share.begin(), share.end(), [&](double s) { return s * total >= -most_beyond * total * total; });
}

/// Raises an edge or a face of the facet's corners and the highest point above it.
bool QuadricExpansion::raise_edge_or_face(std::size_t facet, const HighestPoint& here, double gain) {
  std::array<GeneratorPair, 4> pair{here.generators()};
  std::array<Vec3, 4> point{here.point};
  std::size_t count = 1;
  for (const std::uint8_t i : surface_.corners_of(facet)) {
    const GeneratorPair next{corner_[i].a.generator, corner_[i].b.generator};
    if (std::find(pair.begin(), pair.begin() + count, next) != pair.begin() + count) continue;
    point[count] = corner_[i].a.point - corner_[i].b.point;
    pair[count++] = next;
  }
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t j = i + 1; j < count; ++j)
      for (std::size_t k = j + 1; k < count; ++k)
        if (is_between(here.axis, std::array{point[i], point[j], point[k]}) &&
            raise_around(here.axis, std::array{pair[i], pair[j], pair[k]}, gain))
          return true;
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t j = i + 1; j < count; ++j)
      if (is_between(here.axis, std::array{point[i], point[j]}) &&
          raise_around(here.axis, std::array{pair[i], pair[j]}, gain))
        return true;
  return false;
}

bool QuadricExpansion::raise_around(const Vec3& axis, std::span<const GeneratorPair> generators, double gain) {
  QuadricCap cap(a_, b_, axis, generators);
  for (int i = 0; i < most_expansion_steps; ++i) {
    const std::optional<Vec3> next = cap.lower_axis();
    if (!next) return false;
    const Vec3 way = *next - cap.axis();
    cap = QuadricCap(a_, b_, *next, generators);
    if (dot(way, way) < 0x1p-100) break;
    // What comes to rest higher is of no use.
    if (i == 1 && !(cap.height() < 1.25 * upper_ + same_height)) return false;
  }
  const double highest = offer(HighestPoint(a_, b_, cap.axis()));
  // Rounded heights tell nothing of a shallow place; the point between the pairs' is refined.
  if (!(cap.height() > highest - 8 * same_height)) return false;
  if (cap.height() < shallow_height) cap.refine();
  offer(cap.height(), cap.axis());
  return raise(cap, gain);
}

bool QuadricExpansion::raise(const QuadricCap& cap, double gain) {
  const double least = target(), tangent = cap.widest_tangent(least);
  if (!(tangent > 0)) return false;
  // A little less than what the cap allows.
  const double times = least * std::sqrt(1 + tangent * tangent) * (1 - 0x1p-48);
  const Vec3 point = times * cap.axis();
  const std::size_t facet = surface_.most_before(point);
  const double above = dot(surface_.normal(facet), point) - surface_.height(facet);
  // What is as low as anything is raised at once, but where it is raised already.
  const bool is_lowest = cap.height() <= upper_ * (1 + 0x1p-20);
  const double raised = 0x1p-10 * least * tangent * tangent;
  if (!(above > std::fmax(is_lowest ? raised : gain, 0x1p-54))) return false;
  highest_target_ = std::fmax(highest_target_, least);
  return add(Corner(cap, times, tangent), point, facet);
}

template <class Number>
VectorOf<Number> QuadricExpansion::exact_corner(const Corner& c) const {
  if (c.tangent > 0) return multiple(number_as<Number>(c.times), vector_as<Number>(exactly(c.axis)));
  return difference(point_of<Number>(a_, body_point(c.a)), point_of<Number>(b_, body_point(c.b)));
}

template <class Number>
double QuadricExpansion::proved_height(const std::array<VectorOf<Number>, 3>& corner) {
  const auto& [p, q, r] = corner;
  const VectorOf<Number> normal = outer(difference(q, p), difference(r, p));
  const double height = floor_of(inner(normal, p) / root_of_squares(inner(normal, normal)));
  // Asked so that NaN is no proof.
  return height > 0 ? height : 0;
}

/// The facet's corner that is nearest to the origin comes first: its height is the least rounded.
template <class Number>
double QuadricExpansion::proved_height(std::size_t facet) const {
  const auto [i, j, k] = surface_.nearest_first(facet);
  return proved_height<Number>(
      {exact_corner<Number>(corner_[i]), exact_corner<Number>(corner_[j]), exact_corner<Number>(corner_[k])});
}

/// No corner of the surface is farther than this from the point that it stands for: centres and columns are rounded
/// once, round parts are of length 1 but for 2⁻⁵¹, and each sum is of a handful of numbers.
double QuadricExpansion::corner_error() const {
  double columns = 0, largest = 0;
  for (std::size_t j = 0; j < 3; ++j)
    columns += sum_of_magnitudes(a_.plain_column(j)) + sum_of_magnitudes(b_.plain_column(j));
  for (const Corner& c : corner_)
    largest = std::fmax(largest, sum_of_magnitudes(c.a.point) + sum_of_magnitudes(c.b.point) + 2 * c.times);
  return 0x1p-48 * (largest + 2 * columns);
}

/// The surface still has a corner of the facet where it was raised to.
bool QuadricExpansion::has_come_down(std::size_t facet) const {
  const FacetSlots::Corners corners = surface_.corners_of(facet);
  return std::any_of(corners.begin(), corners.end(),
                     [&](std::size_t i) { return corner_[i].times > 0 && !(corner_[i].tangent > 0); });
}

// Every facet turns its outer side away from the origin, so that the closed surface goes round the origin, and all
// its corners' hull holds the ball that reaches to the lowest facet.
double QuadricExpansion::proved_lowest(double enough) const {
  const double error = corner_error();
  double least = enough;
  for (std::size_t f = 0; f < surface_.facet_count() && least > 0; ++f) {
    if (surface_.is_vacant(f) || (!has_come_down(f) && surface_.is_surely_above(f, least, error))) continue;
    if (proved_height<BoundedDouble>(f) >= least) continue;
    least = std::fmin(least, proved_height<BoundedNumber>(f));
  }
  return least;
}

/// The caps that raised corners stand for are wider where less is to be proved. Those that do not hold come down.
bool QuadricExpansion::lower_caps(double least) {
  bool all_hold = true;
  for (Corner& c : corner_) {
    if (!(c.tangent > 0)) continue;
    QuadricCap cap(a_, b_, c.axis, {c.generators.data(), c.generator_count});
    if (cap.proved_height(tangent_of_raised(c.times, least), least) >= least) continue;
    c.tangent = 0;
    all_hold = false;
  }
  return all_hold;
}

double QuadricExpansion::proved_depth() {
  if (!has_surface_ || !(upper_ > 0)) return 0;
  double least = proved_lowest(target());
  while (least > 0 && !lower_caps(least)) least = proved_lowest(least);
  return least;
}

}  // namespace toccata
