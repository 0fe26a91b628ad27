#include "toccata/query/signed_distance.hpp"

#include <fmt/format.h>

#include "query/ask_each.hpp"
#include "query/inside/winding_search.hpp"
#include "toccata/core/error.hpp"

namespace toccata {
namespace {

void require_finite(const Vec3& point) {
  if (!is_finite(point))
    throw Error(fmt::format("the point ({}, {}, {}) has a coordinate that is not finite", point.x, point.y, point.z));
}

void require_positive_tolerance(const WindingOptions& options) {
  if (!(options.tolerance > 0))
    throw Error(fmt::format("the tolerance of a winding number is positive, and here it is {}; 0.01 is usual",
                            options.tolerance));
}

}  // namespace

WindingNumber generalized_winding_number(const Vec3& point, const Model& model, const Pose& pose,
                                         const WindingOptions& options) {
  Workspace workspace;
  return generalized_winding_number(point, model, pose, options, workspace);
}

WindingNumber generalized_winding_number(const Vec3& point, const Model& model, const Pose& pose,
                                         const WindingOptions& options, Workspace& workspace) {
  require_finite(point);
  require_positive_tolerance(options);
  const PosedMesh mesh(model, pose);
  return WindingSearch(mesh).at(point, options.tolerance, workspace.scratch().winding);
}

std::vector<WindingNumber> generalized_winding_number_each(std::span<const Vec3> points, const Model& model,
                                                           const Pose& pose, const WindingOptions& options,
                                                           const BatchOptions& batch) {
  require_positive_tolerance(options);
  const PosedMesh mesh(model, pose);
  const WindingSearch search(mesh);
  return ask_each(points, "point", batch, [&](const Vec3& point, Workspace& workspace) {
    require_finite(point);
    return search.at(point, options.tolerance, workspace.scratch().winding);
  });
}

}  // namespace toccata
