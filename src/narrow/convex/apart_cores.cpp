#include "narrow/convex/apart_cores.hpp"

#include <cmath>
#include <limits>
#include <span>

#include "math/constants.hpp"
#include "math/vec3_measures.hpp"
#include "narrow/convex/gjk.hpp"
#include "narrow/convex/likely_features.hpp"
#include "narrow/convex/rounded_depth.hpp"
#include "narrow/exact/nearest_certificate.hpp"

namespace toccata {
namespace {

ExactNearest exact_nearest_from(const PosedPolytope& a, const PosedPolytope& b, const CertainNearest& found) {
  if (found.unique()) return exact_nearest(a, b, found.pairs);
  return exact_nearest_of_faces(a, b, found.pairs, std::span(found.face_a.vertex).first(found.face_a.count),
                                std::span(found.face_b.vertex).first(found.face_b.count));
}

/// Two cores, and the directions and features that part them.
class ApartCores {
 public:
  ApartCores(const PosedPolytope& a, const PosedPolytope& b)
      : kernels_(support_kernels()),
        a_(a, kernels_),
        b_(b, kernels_),
        reach_(std::nextafter(a.radius() + b.radius(), infinity)) {}

  std::optional<ConvexSeparation> part() {
    if (const VertexPairs likely = likely_features(a(), b()); likely.size > 0)
      if (const auto found = certain_nearest(a_, b_, likely)) return parted_by(*found);
    GjkEnd end = search_nearest(a_, b_, {}, {reach_});
    if (!(end.separating == Vec3{})) {
      if (const auto parted = parted_along(end.separating)) return parted;
      end = search_nearest(a_, b_, {}, {std::numeric_limits<double>::quiet_NaN()});
    }
    if (end.inside) return {};
    if (const auto found = certain_nearest(a_, b_, end.simplex.pairs)) return parted_by(*found);
    if (const auto found = certain_nearest_along(a_, b_, end.nearest)) return parted_by(*found);
    return {};
  }

 private:
  [[nodiscard]] const PosedPolytope& a() const { return a_.shape(); }
  [[nodiscard]] const PosedPolytope& b() const { return b_.shape(); }

  /// Of shapes that are surely apart along a direction from B to A, which takes no nearest features.
  [[nodiscard]] std::optional<ConvexSeparation> parted_along(const Vec3& direction) const {
    if (!certainly_farther(a_, b_, direction, reach_)) return {};
    ConvexSeparation parted;
    parted.pairs.append(a_.least(direction), b_.least(-direction));
    const Vec3 across = (-1 / plain_length(direction)) * direction;
    parted.penetration.direction = across;
    parted.penetration.on_a = a_.vertex(parted.pairs.a[0]) + a().radius() * across;
    parted.penetration.on_b = b_.vertex(parted.pairs.b[0]) - b().radius() * across;
    return parted;
  }

  [[nodiscard]] ConvexSeparation parted_by(const CertainNearest& found) const {
    if (found.unique())
      if (const auto depth = rounded_depth(found, a().radius(), b().radius())) return {*depth, found.pairs};
    const ExactNearest nearest = exact_nearest_from(a(), b(), found);
    return {rounded_depth(nearest, a().radius(), b().radius(), {}), nearest.simplex};
  }

  SupportKernels kernels_;
  SupportSearch a_, b_;
  double reach_;  ///< at least the sum of the radii
};

}  // namespace

std::optional<ConvexSeparation> part_apart_cores(const PosedPolytope& a, const PosedPolytope& b) {
  return ApartCores(a, b).part();
}

}  // namespace toccata
