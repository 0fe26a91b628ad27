#include "narrow/smooth/depth/growing_surface.hpp"

#include <algorithm>
#include <utility>

#include "math/vec3_measures.hpp"

namespace toccata {
namespace {

Vec3 rounded(const GrowingSurface::FinePoint& p) { return {p[0].high, p[1].high, p[2].high}; }

}  // namespace

bool GrowingSurface::start(Precision precision, const std::array<Corner, 4>& corners) {
  precision_ = precision;
  extent_ = 0;
  corners_ = 4;
  if (is_fine()) fine_.resize(most_corners);
  for (std::size_t i = 0; i < 4; ++i) set(i, corners[i]);
  const Vec3 u = corner(1) - corner(0), v = corner(2) - corner(0), w = corner(3) - corner(0);
  const double volume = dot(cross(u, v), w);
  if (!(std::fabs(volume) > 0)) return false;
  slots_.start_tetrahedron(volume > 0);
  for (std::size_t f = 0; f < 4; ++f) {
    const auto [i, j, k] = slots_.corners(f);
    if (normal_of(i, j, k) == Vec3{}) return false;
    measure(f);
  }
  return true;
}

void GrowingSurface::set(std::size_t i, const Corner& corner) {
  const Vec3& p = corner.point;
  x_[i] = p.x;
  y_[i] = p.y;
  z_[i] = p.z;
  squared_[i] = dot(p, p);
  extent_ = std::fmax(extent_, sum_of_magnitudes(p));
  if (is_fine()) fine_[i] = corner.fine;
}

Vec3 GrowingSurface::normal_of(std::size_t i, std::size_t j, std::size_t k) const {
  if (is_fine()) return rounded(outer(difference(fine_[i], fine_[k]), difference(fine_[j], fine_[k])));
  return cross(corner(i) - corner(k), corner(j) - corner(k));
}

FacetSlots::Corners GrowingSurface::nearest_first(std::size_t f) const {
  FacetSlots::Corners c = slots_.corners(f);
  const auto nearest = std::min_element(c.begin(), c.end(), [&](auto i, auto j) { return squared_[i] < squared_[j]; });
  std::rotate(c.begin(), nearest, c.end());
  return c;
}

void GrowingSurface::measure(std::size_t f) {
  // Of the corner that is nearest to the origin, as that of a shallow place is, rounding takes the least.
  const auto [i, j, k] = nearest_first(f);
  Vec3 normal = normal_of(j, k, i);
  const double length = plain_length(normal);
  normal = length > 0x1p-500 ? (1 / length) * normal : unit_or_zero(normal);
  normal_x_[f] = normal.x;
  normal_y_[f] = normal.y;
  normal_z_[f] = normal.z;
  pending_[f] = height_[f] = dot(normal, corner(i));
}

std::optional<std::size_t> GrowingSurface::lowest() const {
  const auto end = pending_.begin() + static_cast<std::ptrdiff_t>(facet_count());
  const auto found = std::min_element(pending_.begin(), end);
  if (!(*found < HUGE_VAL)) return std::nullopt;
  return static_cast<std::size_t>(found - pending_.begin());
}

std::size_t GrowingSurface::most_before(const Vec3& point) const {
  std::size_t found = 0;
  double most = -HUGE_VAL;
  for (std::size_t f = 0; f < facet_count(); ++f) {
    const double above = dot(normal(f), point) - height_[f];
    if (!(above > most)) continue;
    most = above;
    found = f;
  }
  return found;
}

void GrowingSurface::find_seen(const Vec3& point, double margin) {
  seen_ = {};
  for (std::size_t f = 0; f < facet_count(); ++f) {
    const bool is_seen = dot(normal(f), point) - height_[f] > margin;
    seen_[f / 64] |= std::uint64_t{is_seen} << (f % 64);
  }
}

bool GrowingSurface::add(const Corner& corner, std::size_t beyond) {
  if (full()) return false;
  set(corners_, corner);
  // Where rounding tears apart what is seen, less of it counts as seen; at last the facet alone.
  for (const double part : {0x1p-51, 0x1p-48, 0x1p-44, HUGE_VAL}) {
    find_seen(corner.point, part * extent_);
    if (!slots_.find_hole(beyond, seen_)) continue;
    const auto has_area = [&](const auto& edge) { return !(normal_of(edge.from, edge.to, corners_) == Vec3{}); };
    if (!std::all_of(slots_.hole().begin(), slots_.hole().end(), has_area)) continue;
    slots_.fill_hole(corners_++);
    for (const FacetSlots::HoleEdge& edge : slots_.hole()) measure(edge.slot);
    for (const std::uint16_t f : slots_.left_over()) {
      normal_x_[f] = normal_y_[f] = normal_z_[f] = 0;
      height_[f] = pending_[f] = HUGE_VAL;
    }
    return true;
  }
  return false;
}

// With n the product of the edges e and f, and p the corner: what corners and edges are off by, and rounding, turns n
// by less than 4 error (|e| + |f|), its direction by less than twice that part of |n|, and moves p by `error`; so the
// height changes by less than 8 error (|e| + |f|) |p| / |n| + 2 error. A facet that is not much larger than `error`
// does not come near to passing.
bool GrowingSurface::is_surely_above(std::size_t f, double height, double error) const {
  const auto [i, j, k] = nearest_first(f);
  const Vec3 p = corner(i), u = corner(j) - p, v = corner(k) - p, normal = cross(u, v);
  const double unsure = 8 * error * (sum_of_magnitudes(u) + sum_of_magnitudes(v)) * sum_of_magnitudes(p);
  // Asked so that NaN is not certain.
  return dot(normal, p) - unsure > (height + 3 * error) * plain_length(normal) * (1 + 0x1p-50);
}

}  // namespace toccata
