#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

#include "toccata/core/status.hpp"
#include "toccata/math/pose.hpp"
#include "toccata/query/model.hpp"
#include "toccata/query/pair_query.hpp"

namespace toccata {

/// Where the surface is, and how far away is of interest.
struct NearestQuery {
  Pose pose{};
  /// In the world. What is within it is never left out; what is farther by less than 10⁻¹² of it may be found.
  double max_distance = std::numeric_limits<double>::infinity();
};

/// The point of a surface that is nearest to a given one, in the world.
struct SurfacePoint {
  /// The exact distance lies in [lower, upper], and upper − lower is at most 10⁻¹² · upper, or they are neighbouring
  /// doubles. Both are 0 only on the surface.
  double lower = 0;
  double upper = 0;
  /// Off from the exact one by at most 10⁻¹² times the greatest magnitude of a coordinate, of the given point or of the
  /// element.
  Vec3 point{};
  Index element = 0;              ///< as in Model: the triangle of a mesh
  Index face = 0;                 ///< the file's own face, counted from 0; of a shape that is one element 0
  Status status = Status::exact;  ///< not_converged: wider, by a quadric
  friend constexpr bool operator==(const SurfacePoint&, const SurfacePoint&) = default;
};

/// The nearest point of the surface of a model, none where all of it is farther than the greatest distance; also from
/// within: of a mesh or height field of its triangles, of a box,
/// ball, hull or any other solid of its boundary, which is one element. A point, segment or triangle is its own
/// surface. The surface of a compound is that of all its parts, also what lies within another part, as it is with the
/// shells of one mesh. Among elements that are equally near it is the first: the least by (upper, element). The same
/// bits at every SIMD level, whatever a workspace knows. Throws Error when a number is not finite or the greatest
/// distance is negative, and for poses as `overlap` does.
[[nodiscard]] std::optional<SurfacePoint> nearest_point(const Vec3& point, const Model& surface,
                                                        const NearestQuery& query = {});

/// The same, for a caller who asks often.
[[nodiscard]] std::optional<SurfacePoint> nearest_point(const Vec3& point, const Model& surface,
                                                        const NearestQuery& query, Workspace& workspace);

/// Make a Model of it, once: `Model(mesh)`.
template <ShapeOfAModel S>
std::optional<SurfacePoint> nearest_point(const Vec3&, const S&, const NearestQuery& = {}) = delete;

/// The nearest points of the k nearest elements, in the order of (upper, element); fewer where the surface has fewer
/// within the greatest distance. The first is that of `nearest_point`. Neighbours share what lies on their common edge,
/// so several may have one and the same nearest point. Throws like it.
[[nodiscard]] std::vector<SurfacePoint> nearest_points(const Vec3& point, std::size_t k, const Model& surface,
                                                       const NearestQuery& query = {});

/// The same, for a caller who asks often.
[[nodiscard]] std::vector<SurfacePoint> nearest_points(const Vec3& point, std::size_t k, const Model& surface,
                                                       const NearestQuery& query, Workspace& workspace);

}  // namespace toccata
