#pragma once

#include <span>
#include <vector>

#include "toccata/query/batch.hpp"
#include "toccata/query/inside.hpp"
#include "toccata/query/model.hpp"
#include "toccata/query/workspace.hpp"

namespace toccata {

/// What tells inside from outside.
enum class SignBy {
  automatic,                   ///< of a closed mesh the winding number, of an open one the generalised
  winding_number,              ///< exact: not 0 is inside, as `locate` has it. Not of open meshes
  generalized_winding_number,  ///< more than a half in magnitude is inside: a guess where holes are, and named so
};

/// How far a point is from the surface of a model, negative inside.
struct SignedDistance {
  /// The exact one lies in [lower, upper]; the width is at most 10⁻¹² of the magnitude. Both are 0 exactly on the
  /// surface. Where the side is undecided it is [−d, d], and the distance lies in [d · (1 − 10⁻¹²), d].
  double lower = 0;
  double upper = 0;
  Vec3 nearest{};     ///< of the surface; off by at most 10⁻¹² of the greatest coordinate
  Index element = 0;  ///< as in SurfacePoint: its triangle; of several the least
  Index face = 0;
  /// Where the status is undecided, inside stands for not being known: the safe side.
  Side side = Side::outside;
  SignBy sign_by = SignBy::winding_number;  ///< which of the two told the side
  /// undecided: the generalised winding number is a half up to what it is off by. not_converged: as in SurfacePoint.
  Status status = Status::exact;
  friend constexpr bool operator==(const SignedDistance&, const SignedDistance&) = default;
};

/// Of a world point from a posed model, whatever shape it is. The distance is that of `nearest_point`, certified. The
/// side of a closed mesh is exact, also when it is inside out or winds around the point several times; so is that of
/// boxes, balls and the like, whichever way is asked for (sign_by then is the winding number: of such it is 0 or 1);
/// in points, segments, triangles and flat hulls nothing is inside. A point is inside a compound when it is inside some
/// part, and then the distance is to the nearest surface of a part, which may lie within another. Throws Error when the
/// point is not finite, SignBy::winding_number is asked of an open mesh or a closed one has a singular pose, and for
/// poses as `overlap` does.
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

}  // namespace toccata
