#pragma once

#include <span>
#include <vector>

#include "toccata/core/status.hpp"
#include "toccata/query/batch.hpp"
#include "toccata/query/model.hpp"
#include "toccata/query/workspace.hpp"

namespace toccata {

/// How much of the sphere of directions around a point the triangles of a mesh cover, each counted positive where it is
/// seen from its back: the generalised winding number. Of a closed mesh it is the winding number of `locate`, but for
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

/// Of a world point and a posed mesh or height field, open or closed. Far triangles are summed by their moments with a
/// proved bound, near ones each (docs/methods/winding-numbers.md; A. Jacobson, L. Kavan, O. Sorkine-Hornung, "Robust
/// inside-outside segmentation using generalized winding numbers", 2013; G. Barill, N. G. Dickson, R. Schmidt,
/// D. I. W. Levin, A. Jacobson, "Fast winding numbers for soups and clouds", 2018). A pose that turns, scales or
/// mirrors keeps it fast; one that deforms costs every triangle. Which triangles are summed together depends on the
/// model's tree: after `Model::deform` the value may be another within the bounds. Throws Error when the point is not
/// finite, the tolerance not positive, the model no mesh, and for poses as `overlap` does.
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
