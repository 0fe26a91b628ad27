#include "narrow/smooth/smooth_expansion.hpp"

#include <algorithm>
#include <cmath>

#include "math/vec3_measures.hpp"

namespace toccata {
namespace {

using Edge = std::array<std::size_t, 2>;

/// The edge joins the horizon, unless the facet beyond it is seen too.
void toggle(std::vector<Edge>& horizon, const Edge& edge) {
  const auto back = std::find(horizon.begin(), horizon.end(), Edge{edge[1], edge[0]});
  if (back == horizon.end())
    horizon.push_back(edge);
  else
    horizon.erase(back);
}

}  // namespace

SmoothExpansion::SmoothExpansion(const SmoothBody& a, const SmoothBody& b, std::span<const SmoothSearch::Corner> four)
    : a_(a), b_(b) {
  for (const SmoothSearch::Corner& c : four) corner_.push_back({c.a, c.b, c.a.point - c.b.point});
  const Vec3 u = corner_[1].point - corner_[0].point, v = corner_[2].point - corner_[0].point,
             w = corner_[3].point - corner_[0].point;
  if (dot(cross(u, v), w) < 0) std::swap(corner_[0], corner_[1]);
  add_facet(0, 2, 1);
  add_facet(0, 1, 3);
  add_facet(1, 2, 3);
  add_facet(2, 0, 3);
}

void SmoothExpansion::add_facet(std::size_t i, std::size_t j, std::size_t k) {
  const Vec3 p = corner_[i].point;
  const Vec3 normal = unit_or_zero(cross(corner_[j].point - p, corner_[k].point - p));
  facet_.push_back({{i, j, k}, normal, dot(normal, p)});
}

const SmoothExpansion::Facet& SmoothExpansion::nearest() const {
  return *std::min_element(facet_.begin(), facet_.end(),
                           [](const Facet& f, const Facet& g) { return f.height < g.height; });
}

bool SmoothExpansion::add_corner(const Corner& corner) {
  std::vector<Edge> horizon;
  std::vector<Facet> kept;
  for (const Facet& f : facet_) {
    if (dot(f.normal, corner.point) <= f.height) {
      kept.push_back(f);
      continue;
    }
    for (std::size_t i = 0; i < 3; ++i) toggle(horizon, {f.corner[i], f.corner[(i + 1) % 3]});
  }
  // More than a closed surface has: rounding tore what is seen to pieces, which from there on would only multiply.
  if (kept.size() + horizon.size() > 2 * (corner_.size() + 1) - 4) return false;
  facet_ = std::move(kept);
  corner_.push_back(corner);
  for (const Edge& edge : horizon) add_facet(edge[0], edge[1], corner_.size() - 1);
  return true;
}

void SmoothExpansion::grow(double part, std::size_t most_corners) {
  while (corner_.size() < most_corners) {
    const Facet facet = nearest();
    if (facet.normal == Vec3{}) return;
    const SmoothSupport of_a = a_.support(facet.normal), of_b = b_.support(-facet.normal);
    const Corner corner{of_a, of_b, of_a.point - of_b.point};
    if (!(dot(facet.normal, corner.point) > facet.height * (1 + part) + 0x1p-50)) return;
    if (!add_corner(corner)) return;
  }
}

// Every facet turns its outer side away from the origin, so that the closed surface goes round the origin; what it
// encloses is within A − B, and with it the ball that reaches to the nearest facet.
double SmoothExpansion::proved_depth() const {
  std::vector<VectorOf<BoundedDouble>> exact;
  exact.reserve(corner_.size());
  for (const Corner& c : corner_)
    exact.push_back(
        difference(point_of<BoundedDouble>(a_, body_point(c.a)), point_of<BoundedDouble>(b_, body_point(c.b))));
  double least = HUGE_VAL;
  for (const Facet& f : facet_) {
    const auto &p = exact[f.corner[0]], &q = exact[f.corner[1]], &r = exact[f.corner[2]];
    const VectorOf<BoundedDouble> normal = outer(difference(q, p), difference(r, p));
    const double height = floor_of(inner(normal, p) / root_of_squares(inner(normal, normal)));
    // Asked so that NaN is no proof.
    if (!(height > 0)) return 0;
    least = std::fmin(least, height);
  }
  return least;
}

}  // namespace toccata
