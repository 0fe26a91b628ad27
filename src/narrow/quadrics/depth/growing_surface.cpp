#include "narrow/quadrics/depth/growing_surface.hpp"

#include <algorithm>
#include <utility>

#include "math/vec3_measures.hpp"

namespace toccata {
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
    const Vec3 product = across(i, j, k);
    if (product == Vec3{}) return false;
    measure(f, product);
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

Vec3 GrowingSurface::across(std::size_t i, std::size_t j, std::size_t k) const {
  if (is_fine()) return high_parts(outer(difference(fine_[i], fine_[k]), difference(fine_[j], fine_[k])));
  return cross(corner(i) - corner(k), corner(j) - corner(k));
}

FacetSlots::Corners GrowingSurface::nearest_first(std::size_t f) const {
  const auto [i, j, k] = slots_.corners(f);
  const double of_i = squared_[i], of_j = squared_[j], of_k = squared_[k];
  if (of_j < of_i && of_j <= of_k) return {j, k, i};
  if (of_k < of_i) return {k, i, j};
  return {i, j, k};
}

void GrowingSurface::measure(std::size_t f, const Vec3& product) {
  const double length = plain_length(product);
  const Vec3 normal = length > 0x1p-500 ? (1 / length) * product : unit_or_zero(product);
  normal_x_[f] = normal.x;
  normal_y_[f] = normal.y;
  normal_z_[f] = normal.z;
  // The height at the corner that is nearest to the origin, as that of a shallow place is, loses the least to rounding.
  pending_[f] = height_[f] = dot(normal, corner(nearest_first(f)[0]));
}

void GrowingSurface::vacate(std::size_t f) {
  normal_x_[f] = normal_y_[f] = normal_z_[f] = 0;
  height_[f] = pending_[f] = HUGE_VAL;
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

/// The facets that see the last corner by more than the margin, and whether all that come in their place have an area.
bool GrowingSurface::find_fan(std::size_t beyond, double margin) {
  const Vec3 apex = corner(corners_);
  const auto is_seen = [&](std::size_t f) { return dot(normal(f), apex) - height_[f] > margin; };
  if (!slots_.find_hole(beyond, is_seen)) return false;
  for (std::size_t k = 0; k < slots_.hole().size(); ++k) {
    const Vec3 product = across(slots_.hole()[k].from, slots_.hole()[k].to, corners_);
    if (product == Vec3{}) return false;
    fan_x_[k] = product.x;
    fan_y_[k] = product.y;
    fan_z_[k] = product.z;
  }
  return true;
}

bool GrowingSurface::add(const Corner& corner, std::size_t beyond) {
  if (full()) return false;
  set(corners_, corner);
  // Where rounding tears apart what is seen, less of it counts as seen; at last the facet alone.
  const std::array<double, 4> parts{0x1p-51, 0x1p-48, 0x1p-44, HUGE_VAL};
  if (std::none_of(parts.begin(), parts.end(), [&](double part) { return find_fan(beyond, part * extent_); }))
    return false;
  slots_.fill_hole(corners_++);
  for (std::size_t k = 0; k < slots_.hole().size(); ++k)
    measure(slots_.hole()[k].slot, {fan_x_[k], fan_y_[k], fan_z_[k]});
  for (const std::uint16_t f : slots_.left_over()) vacate(f);
  return true;
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
