#pragma once

#include <span>
#include <vector>

#include "toccata/core/status.hpp"
#include "toccata/math/pose.hpp"
#include "toccata/query/batch.hpp"
#include "toccata/query/model.hpp"
#include "toccata/query/pair_query.hpp"

namespace toccata {

enum class Side { outside, boundary, inside };

struct PointLocation {
  Side side = Side::outside;
  /// How often the surface winds around the point; 0 is outside. On the boundary it is not defined and 0 here.
  int winding_number = 0;
};

/// Where a world point lies relative to the posed solid: on one of its faces, or inside (winding number not 0), or
/// outside. Exact. Throws Error when the mesh is open, the pose is singular, or the point or a vertex is not finite.
[[nodiscard]] PointLocation locate(const Vec3& point, const Model& solid, const Pose& pose = {});

/// What decides between inside and outside.
enum class SignBy {
  automatic,                   ///< for a closed mesh the winding number, for an open one the generalised
  winding_number,              ///< exact: not 0 is inside, as `locate` has it. Not of open meshes
  generalized_winding_number,  ///< more than a half in magnitude is inside: a guess where holes are, and named so
};

/// How far a point is from the surface of a model, negative inside.
struct SignedDistance {
  /// The exact one lies in [lower, upper]; the width is at most 10⁻¹² of the magnitude. Both are 0 exactly on the
  /// surface. Where the side is undecided it is [−d, d], and the distance lies in [d · (1 − 10⁻¹²), d].
  double lower = 0;
  double upper = 0;
  Vec3 nearest{};     ///< the nearest point of the surface; off by at most 10⁻¹² of the greatest coordinate
  Index element = 0;  ///< as in SurfacePoint: its triangle; the least of several
  Index face = 0;
  /// Where the status is undecided, inside stands for not being known: the safe side.
  Side side = Side::outside;
  SignBy sign_by = SignBy::winding_number;  ///< which of the two decided the side
  /// undecided: the generalised winding number is a half up to what it is off by. not_converged: as in SurfacePoint.
  Status status = Status::exact;
  friend constexpr bool operator==(const SignedDistance&, const SignedDistance&) = default;
};

/// The signed distance of a world point from a posed model, whatever shape it is. The distance is that of
/// `nearest_point`, certified. The side of a closed mesh is exact, also when it is inside out or winds around the point
/// several times; so is that of boxes, balls and the like, whichever way is asked for (sign_by then is the winding
/// number: of such it is 0 or 1); in points, segments, triangles and flat hulls nothing is inside. A point is inside a
/// compound when it is inside some part, and then the distance is to the nearest surface of a part, which may lie
/// within another. Throws Error when the point is not finite, SignBy::winding_number is asked of an open mesh or a
/// closed one has a singular pose, and for poses as `overlap` does.
[[nodiscard]] SignedDistance signed_distance(const Vec3& point, const Model& model, const Pose& pose = {},
                                             SignBy sign_by = SignBy::automatic);

/// The same, for a caller who asks often.
[[nodiscard]] SignedDistance signed_distance(const Vec3& point, const Model& model, const Pose& pose, SignBy sign_by,
                                             Workspace& workspace);

/// The same of many points, as in batch.hpp ("point i: "); the model is placed once.
[[nodiscard]] std::vector<SignedDistance> signed_distance_each(std::span<const Vec3> points, const Model& model,
                                                               const Pose& pose = {},
                                                               SignBy sign_by = SignBy::automatic,
                                                               const BatchOptions& batch = {});

/// How much of the sphere of directions around a point the triangles of a mesh cover, each counted positive where it is
/// seen from its back: the generalised winding number. For a closed mesh it is the winding number of `locate`, but for
/// rounding. A triangle in whose plane the point lies counts 0; so on a face it is the mean of both sides.
struct WindingNumber {
  double value = 0;
  double lower = 0;  ///< the exact one lies in [lower, upper]
  double upper = 0;
  /// not_converged: the interval is wider than was asked for, because the point is too near an edge for doubles.
  Status status = Status::exact;
  friend constexpr bool operator==(const WindingNumber&, const WindingNumber&) = default;
};

struct WindingOptions {
  /// The interval reaches no farther than this from the value. Positive. The smaller, the slower: of 70,000 triangles
  /// some 10 µs for 0.2, ten times that for 0.01, fifty times for 0.001.
  double tolerance = 1e-2;
};

/// How often a posed mesh or height field, open or closed, winds around a world point. Far triangles are summed by
/// their moments with a proved bound, near ones each (docs/methods/winding-numbers.md; A. Jacobson, L. Kavan, O.
/// Sorkine-Hornung, "Robust inside-outside segmentation using generalized winding numbers", 2013; G. Barill, N. G.
/// Dickson, R. Schmidt, D. I. W. Levin, A. Jacobson, "Fast winding numbers for soups and clouds", 2018). A pose that
/// turns, scales or mirrors keeps it fast; one that deforms costs every triangle. Which triangles are summed together
/// depends on the model's tree: after `Model::deform` the value may be another within the bounds. Throws Error when the
/// point is not finite, the tolerance not positive, the model no mesh, and for poses as `overlap` does.
[[nodiscard]] WindingNumber generalized_winding_number(const Vec3& point, const Model& model, const Pose& pose = {},
                                                       const WindingOptions& options = {});

/// The same, for a caller who asks often.
[[nodiscard]] WindingNumber generalized_winding_number(const Vec3& point, const Model& model, const Pose& pose,
                                                       const WindingOptions& options, Workspace& workspace);

/// The same of many points, as in batch.hpp ("point i: "); the mesh is placed once.
[[nodiscard]] std::vector<WindingNumber> generalized_winding_number_each(std::span<const Vec3> points,
                                                                         const Model& model, const Pose& pose = {},
                                                                         const WindingOptions& options = {},
                                                                         const BatchOptions& batch = {});

}  // namespace toccata
