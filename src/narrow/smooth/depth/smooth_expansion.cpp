#include "narrow/smooth/depth/smooth_expansion.hpp"

#include <algorithm>
#include <cmath>

#include "math/vec3_measures.hpp"

namespace toccata {
namespace {

/// Heights that differ by less are one, in a frame where the bodies are of size 1.
constexpr double rounding = 0x1p-49;
constexpr int most_steps = 8;
constexpr int most_starts = 4;
/// When a cap is looked for: the parts of the lowest height that the surface may miss there (one cap; those of edges
/// and faces), how much higher it may be, and what is little besides.
constexpr double missing_for_cap = 0.1;
constexpr double missing_for_edges = 0.02;
constexpr double height_for_cap = 1.2;
constexpr double little = 0.01;
/// Beyond so many corners caps are looked for everywhere, lest there be no end of corners.
constexpr std::size_t many_corners = 40;

}  // namespace

void SmoothExpansion::offer(SmoothCap& cap) {
  if (cap.atoms().size() == 1 && cap.height() < upper_ + rounding && cap.height() < 0x1p-8) cap.refine();
  if (!(cap.height() < upper_)) return;
  upper_ = cap.height();
  direction_ = cap.axis();
}

double SmoothExpansion::target() const { return upper_ * (1 - part_); }

void SmoothExpansion::append(const SmoothCap& cap) {
  Corner& corner = corner_[surface_.corner_count()];
  corner = {cap.on_a(), cap.on_b(), cap.axis(), {}, cap.atoms().size(), 0, 0};
  std::copy(cap.atoms().begin(), cap.atoms().end(), corner.atoms.begin());
}

bool SmoothExpansion::start() {
  const Vec3 between = unit_or_zero(plain(b_.middle_point()) - plain(a_.middle_point()));
  SmoothCap first(a_, b_, between == Vec3{} ? Vec3{1, 0, 0} : between), second(a_, b_, -first.axis());
  std::array<Vec3, 4> point{first.point(), second.point()};
  const auto place = [&](SmoothCap& cap, std::size_t i) {
    point[i] = cap.point();
    corner_[i] = {cap.on_a(), cap.on_b(), {}, {}, 0, 0, 0};
    offer(cap);
  };
  place(first, 0);
  place(second, 1);
  const Vec3 axis = unit_or_zero(point[1] - point[0]);
  SmoothCap third(a_, b_, some_across(axis));
  place(third, 2);
  const Vec3 normal = unit_or_zero(cross(axis, point[2] - point[0]));
  if (normal == Vec3{}) return false;
  SmoothCap up(a_, b_, normal), down(a_, b_, -normal);
  const double above = dot(normal, up.point() - point[0]), below = dot(normal, point[0] - down.point());
  place(above > below ? up : down, 3);
  return surface_.start(point);
}

// Corners that were raised when less was known to be low are wrong by so much: then all begins again.
bool SmoothExpansion::run(double part) {
  part_ = part;
  bool reached = false;
  for (int i = 0; i < most_starts; ++i) {
    highest_target_ = 0;
    reached = grow();
    if (!(highest_target_ > target() * (1 + 0x1p-45))) break;
  }
  return reached;
}

bool SmoothExpansion::grow() {
  if (!start()) return false;
  while (const std::optional<std::size_t> lowest = surface_.lowest()) {
    if (surface_.facet(*lowest).height >= target()) return true;
    if (surface_.full()) return false;
    if (!step(*lowest)) surface_.settle(*lowest);
  }
  return false;
}

// The lowest height near is looked for by Newton's method, so that its cap is as wide as can be.
bool SmoothExpansion::step(std::size_t facet) {
  SmoothCap here(a_, b_, surface_.facet(facet).normal);
  offer(here);
  const double gain = here.height() - surface_.facet(facet).height;
  if (is_promising(here, gain, missing_for_cap) && raise(lowest_near(here), gain)) return true;
  if (is_promising(here, gain, missing_for_edges) && raise_edge_or_face(facet, here, gain)) return true;
  if (!(gain > rounding)) return false;
  append(here);
  return surface_.add(here.point(), facet);
}

// Caps are dear: points alone grow the surface where it is far from what it stands for, or where that is high.
bool SmoothExpansion::is_promising(const SmoothCap& here, double gain, double missing) const {
  if (surface_.corner_count() > many_corners) return true;
  return gain < missing * upper_ + little && here.height() < height_for_cap * upper_ + little;
}

SmoothCap SmoothExpansion::lowest_near(const SmoothCap& from) {
  SmoothCap lowest = from;
  for (int i = 0; i < most_steps; ++i) {
    const std::optional<Vec3> axis = lowest.lower_axis();
    if (!axis) break;
    SmoothCap next(a_, b_, *axis);
    offer(next);
    if (!(next.height() < lowest.height())) break;
    lowest = next;
  }
  return lowest;
}

/// Of the facet's corners and the highest point above it.
bool SmoothExpansion::raise_edge_or_face(std::size_t facet, const SmoothCap& here, double gain) {
  std::array<AtomPair, 4> pair{here.atoms()[0]};
  std::size_t count = 1;
  for (const std::uint16_t i : surface_.facet(facet).corner) {
    const AtomPair next{corner_[i].a.atom, corner_[i].b.atom};
    if (std::find(pair.begin(), pair.begin() + count, next) == pair.begin() + count) pair[count++] = next;
  }
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t j = i + 1; j < count; ++j)
      if (raise_around(here.axis(), std::array{pair[i], pair[j]}, gain)) return true;
  for (std::size_t left = 0; left < count && count >= 3; ++left) {
    std::array<AtomPair, 3> three;
    for (std::size_t k = 0, to = 0; k < count && to < 3; ++k)
      if (k != left || count == 3) three[to++] = pair[k];
    if (raise_around(here.axis(), three, gain)) return true;
    if (count == 3) break;
  }
  return false;
}

bool SmoothExpansion::raise_around(const Vec3& axis, std::span<const AtomPair> atoms, double gain) {
  SmoothCap cap(a_, b_, axis, atoms);
  for (int i = 0; i < most_steps; ++i) {
    const std::optional<Vec3> next = cap.lower_axis();
    if (!next) return false;
    const Vec3 way = *next - cap.axis();
    cap = SmoothCap(a_, b_, *next, atoms);
    if (dot(way, way) < 0x1p-100) break;
    // What comes to rest higher is of no use.
    if (i == 1 && !(cap.height() < 1.25 * upper_ + rounding)) return false;
  }
  SmoothCap all(a_, b_, cap.axis());
  offer(all);
  // Of a shallow place rounded heights tell nothing; the point between the pairs' is refined.
  if (!(cap.height() > all.height() - 8 * rounding)) return false;
  cap.refine();
  offer(cap);
  return raise(cap, gain);
}

bool SmoothExpansion::raise(const SmoothCap& cap, double gain) {
  const double least = target(), tangent = cap.widest_tangent(least);
  if (!(tangent > 0)) return false;
  // A little less than what the cap allows.
  const double times = least * std::sqrt(1 + tangent * tangent) * (1 - 0x1p-48);
  const Vec3 point = times * cap.axis();
  const std::size_t facet = surface_.most_before(point);
  const double above = dot(surface_.facet(facet).normal, point) - surface_.facet(facet).height;
  // What is as low as anything is raised at once, but where it is raised already.
  const bool is_lowest = cap.height() <= upper_ * (1 + 0x1p-20);
  const double raised = 0x1p-10 * least * tangent * tangent;
  if (!(above > std::fmax(is_lowest ? raised : gain, 0x1p-54))) return false;
  append(cap);
  Corner& corner = corner_[surface_.corner_count()];
  corner.times = times;
  highest_target_ = std::fmax(highest_target_, least);
  corner.tangent = tangent;
  return surface_.add(point, facet);
}

template <class Number>
VectorOf<Number> SmoothExpansion::exact_corner(std::size_t i) const {
  const Corner& c = corner_[i];
  if (c.tangent > 0) return multiple(number_as<Number>(c.times), vector_as<Number>(exactly(c.axis)));
  return difference(point_of<Number>(a_, body_point(c.a)), point_of<Number>(b_, body_point(c.b)));
}

template <class Number>
double SmoothExpansion::proved_height(const std::array<VectorOf<Number>, 3>& corner) {
  const auto& [p, q, r] = corner;
  const VectorOf<Number> normal = outer(difference(q, p), difference(r, p));
  const double height = floor_of(inner(normal, p) / root_of_squares(inner(normal, normal)));
  // Asked so that NaN is no proof.
  return height > 0 ? height : 0;
}

/// Of the facet's corners, the one that is nearest to the origin first: its height is the least rounded.
std::array<std::uint16_t, 3> SmoothExpansion::nearest_first(std::size_t facet) const {
  std::array<std::uint16_t, 3> corner = surface_.facet(facet).corner;
  const auto squared = [&](std::uint16_t i) { return dot(surface_.corner(i), surface_.corner(i)); };
  const auto nearest =
      std::min_element(corner.begin(), corner.end(), [&](auto i, auto j) { return squared(i) < squared(j); });
  std::rotate(corner.begin(), nearest, corner.end());
  return corner;
}

// Every facet turns its outer side away from the origin, so that the closed surface goes round the origin, and all
// its corners' hull holds the ball that reaches to the lowest facet.
double SmoothExpansion::proved_lowest(double enough) const {
  std::array<VectorOf<BoundedDouble>, GrowingSurface::most_corners> point;
  for (std::size_t i = 0; i < surface_.corner_count(); ++i) point[i] = exact_corner<BoundedDouble>(i);
  double least = enough;
  for (std::size_t f = 0; f < surface_.facet_count() && least > 0; ++f) {
    const auto [i, j, k] = nearest_first(f);
    if (proved_height<BoundedDouble>({point[i], point[j], point[k]}) >= least) continue;
    const double finely = proved_height<BoundedNumber>(
        {exact_corner<BoundedNumber>(i), exact_corner<BoundedNumber>(j), exact_corner<BoundedNumber>(k)});
    least = std::fmin(least, finely);
  }
  return least;
}

/// The caps that raised corners stand for are wider where less is to be proved. Those that do not hold come down.
bool SmoothExpansion::lower_caps(double least) {
  bool all_hold = true;
  for (std::size_t i = 0; i < surface_.corner_count(); ++i) {
    Corner& c = corner_[i];
    if (!(c.tangent > 0)) continue;
    const double ratio = c.times / least * (1 + 0x1p-48), tangent = std::sqrt(std::fmax(ratio * ratio - 1, 0));
    if (SmoothCap(a_, b_, c.axis, {c.atoms.data(), c.atom_count}).proved_height(tangent, least) >= least) continue;
    c.tangent = 0;
    all_hold = false;
  }
  return all_hold;
}

double SmoothExpansion::proved_depth() {
  double least = proved_lowest(target());
  while (least > 0 && !lower_caps(least)) least = proved_lowest(least);
  return least;
}

}  // namespace toccata
