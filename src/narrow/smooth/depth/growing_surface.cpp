#include "narrow/smooth/depth/growing_surface.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include "math/vec3_measures.hpp"

namespace toccata {

bool GrowingSurface::start(const std::array<Vec3, 4>& corners) {
  std::copy(corners.begin(), corners.end(), point_.begin());
  extent_ = 0;
  for (const Vec3& p : corners) extent_ = std::fmax(extent_, sum_of_magnitudes(p));
  const Vec3 u = point_[1] - point_[0], v = point_[2] - point_[0], w = point_[3] - point_[0];
  const double volume = dot(cross(u, v), w);
  if (!(std::fabs(volume) > 0)) return false;
  corners_ = facets_ = 4;
  // Corner 3 lies behind the face 0, i, j.
  const std::size_t i = volume < 0 ? 1 : 2, j = 3 - i;
  if (!place(0, 0, i, j) || !place(1, 0, 3, i) || !place(2, i, 3, j) || !place(3, j, 3, 0)) return false;
  join(0, 6), join(1, 10), join(2, 14), join(4, 13), join(5, 8), join(9, 12);
  return true;
}

bool GrowingSurface::place(std::size_t f, std::size_t i, std::size_t j, std::size_t k) {
  const Vec3 normal = unit_or_zero(cross(point_[i] - point_[k], point_[j] - point_[k]));
  // Of the corner that is nearest to the origin, as that of a shallow place is, rounding takes the least.
  Vec3 p = point_[k];
  for (const std::size_t other : {i, j})
    if (dot(point_[other], point_[other]) < dot(p, p)) p = point_[other];
  facet_[f] = {{static_cast<std::uint16_t>(i), static_cast<std::uint16_t>(j), static_cast<std::uint16_t>(k)},
               normal,
               dot(normal, p),
               false};
  return !(normal == Vec3{});
}

bool GrowingSurface::has_area(std::size_t i, std::size_t j, const Vec3& apex) const {
  return !(cross(point_[i] - apex, point_[j] - apex) == Vec3{});
}

void GrowingSurface::join(std::size_t edge, std::size_t other) {
  twin_[edge] = static_cast<std::uint16_t>(other);
  twin_[other] = static_cast<std::uint16_t>(edge);
}

std::optional<std::size_t> GrowingSurface::lowest() const {
  std::optional<std::size_t> found;
  double least = HUGE_VAL;
  for (std::size_t f = 0; f < facets_; ++f) {
    if (facet_[f].settled || !(facet_[f].height < least)) continue;
    least = facet_[f].height;
    found = f;
  }
  return found;
}

std::size_t GrowingSurface::most_before(const Vec3& point) const {
  std::size_t found = 0;
  double most = -HUGE_VAL;
  for (std::size_t f = 0; f < facets_; ++f) {
    const double above = dot(facet_[f].normal, point) - facet_[f].height;
    if (!(above > most)) continue;
    most = above;
    found = f;
  }
  return found;
}

void GrowingSurface::find_disc(const Vec3& point, std::size_t first, double margin) {
  gone_count_ = around_ = 0;
  gone_[gone_count_++] = static_cast<std::uint16_t>(first);
  is_gone_[first] = true;
  for (std::size_t g = 0; g < gone_count_; ++g)
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t f = gone_[g], twin = twin_[4 * f + k], other = twin / 4;
      if (is_gone_[other]) continue;
      const Facet& beyond = facet_[other];
      if (dot(beyond.normal, point) - beyond.height > margin) {
        is_gone_[other] = true;
        gone_[gone_count_++] = static_cast<std::uint16_t>(other);
      }
    }
  for (std::size_t g = 0; g < gone_count_; ++g)
    for (std::size_t k = 0; k < 3; ++k) {
      const Facet& f = facet_[gone_[g]];
      const std::uint16_t twin = twin_[4 * gone_[g] + k];
      if (is_gone_[twin / 4]) continue;
      around_start_ = f.corner[k];
      leaving_[around_start_] = {twin, f.corner[(k + 1) % 3]};
      ++around_;
    }
  for (std::size_t g = 0; g < gone_count_; ++g) is_gone_[gone_[g]] = false;
}

/// One loop that passes no corner twice.
bool GrowingSurface::is_disc() const {
  std::size_t at = around_start_;
  for (std::size_t i = 0; i < around_; ++i) {
    at = leaving_[at].to;
    if (at == around_start_) return i + 1 == around_;
  }
  return false;
}

void GrowingSurface::make_fan(const Vec3& point) {
  const std::size_t apex = corners_++;
  point_[apex] = point;
  extent_ = std::fmax(extent_, sum_of_magnitudes(point));
  std::size_t from = around_start_, first = 0, previous = 0;
  // A disc has fewer triangles than edges around it, unless there are corners within it, which are gone.
  const std::size_t kept = std::min(around_, gone_count_);
  for (std::size_t i = 0; i < around_; ++i) {
    const Edge edge = leaving_[from];
    const std::size_t f = i < kept ? gone_[i] : facets_++;
    place(f, from, edge.to, apex);
    join(4 * f, edge.twin);
    if (i == 0)
      first = f;
    else
      join(4 * previous + 1, 4 * f + 2);
    previous = f;
    from = edge.to;
  }
  join(4 * previous + 1, 4 * first + 2);
  // From the last slot on, so that what moves into a slot that gets free stays.
  std::sort(gone_.begin() + kept, gone_.begin() + gone_count_, std::greater<>());
  for (std::size_t g = kept; g < gone_count_; ++g) remove(gone_[g]);
}

void GrowingSurface::remove(std::size_t f) {
  const std::size_t last = --facets_;
  if (f == last) return;
  facet_[f] = facet_[last];
  for (std::size_t k = 0; k < 3; ++k) join(4 * f + k, twin_[4 * last + k]);
}

bool GrowingSurface::add(const Vec3& point, std::size_t beyond) {
  if (full()) return false;
  // Where rounding tears apart what is seen, less of it counts as seen; at last the facet alone.
  for (const double part : {0x1p-51, 0x1p-48, 0x1p-44, HUGE_VAL}) {
    find_disc(point, beyond, part * extent_);
    if (!is_disc()) continue;
    bool all = true;
    for (std::size_t i = 0, from = around_start_; i < around_; ++i, from = leaving_[from].to)
      all = all && has_area(from, leaving_[from].to, point);
    if (!all) continue;
    make_fan(point);
    return true;
  }
  return false;
}

}  // namespace toccata
