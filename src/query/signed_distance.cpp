#include "toccata/query/signed_distance.hpp"

#include <optional>

#include "query/ask_each.hpp"
#include "query/inside_winding.hpp"
#include "query/nearest_search.hpp"
#include "query/semantics.hpp"
#include "query/winding_search.hpp"
#include "toccata/core/error.hpp"

namespace toccata {
namespace {

SignBy method_for(const Model& model, const Pose& pose, SignBy asked) {
  if (asked == SignBy::generalized_winding_number) return asked;
  if (!model.closed()) {
    if (asked == SignBy::automatic) return SignBy::generalized_winding_number;
    throw Error(
        "the mesh is open, and no winding number tells an inside of it: close it, or ask by the generalised winding "
        "number (SignBy::generalized_winding_number)");
  }
  static_cast<void>(taken_as_solid(model, pose, Solid::all, "the model"));  // throws for a singular pose
  return SignBy::winding_number;
}

/// A posed mesh from which signed distances are asked, and what is the same for all points.
class SignSearch {
 public:
  SignSearch(const Model& model, const Pose& pose, SignBy asked, std::size_t points)
      : mesh_(model, pose), method_(method_for(model, pose, asked)), nearest_(model, {.pose = pose}, points) {
    if (method_ == SignBy::generalized_winding_number) winding_.emplace(mesh_);
  }
  // The search refers to the mesh.
  SignSearch(const SignSearch&) = delete;
  SignSearch& operator=(const SignSearch&) = delete;

  [[nodiscard]] SignedDistance from(const Vec3& point, SearchScratch& scratch) const {
    const SurfacePoint found = nearest_.nearest(point, scratch);
    SignedDistance result;
    result.nearest = found.point;
    result.element = found.element;
    result.face = found.face;
    result.sign_by = method_;
    result.side = found.upper == 0 ? Side::boundary : side_of(point, scratch, result.status);
    const bool inside = result.side == Side::inside;
    result.lower = inside ? -found.upper : found.lower;
    result.upper = !inside || result.status == Status::undecided ? found.upper : -found.lower;
    return result;
  }

 private:
  /// Of a point off the surface.
  [[nodiscard]] Side side_of(const Vec3& point, SearchScratch& scratch, Status& status) const {
    if (method_ == SignBy::winding_number)
      return wind_along(mesh_, ExactPoint(point), 0).ahead != 0 ? Side::inside : Side::outside;
    const WindingNumber found = winding_->beside_a_half(point, scratch.winding);
    if (found.lower > 0.5 || found.upper < -0.5) return Side::inside;
    if (found.lower > -0.5 && found.upper < 0.5) return Side::outside;
    status = Status::undecided;
    return Side::inside;
  }

  PosedMesh mesh_;
  SignBy method_;
  NearestSearch nearest_;
  std::optional<WindingSearch> winding_;
};

}  // namespace

SignedDistance signed_distance(const Vec3& point, const Model& model, const Pose& pose, SignBy sign_by) {
  Workspace workspace;
  return signed_distance(point, model, pose, sign_by, workspace);
}

SignedDistance signed_distance(const Vec3& point, const Model& model, const Pose& pose, SignBy sign_by,
                               Workspace& workspace) {
  return SignSearch(model, pose, sign_by, 1).from(point, workspace.scratch());
}

std::vector<SignedDistance> signed_distance_each(std::span<const Vec3> points, const Model& model, const Pose& pose,
                                                 SignBy sign_by, const BatchOptions& batch) {
  const SignSearch search(model, pose, sign_by, points.size());
  return ask_each<SignedDistance>(points, "point", batch, [&](const Vec3& point, Workspace& workspace) {
    return search.from(point, workspace.scratch());
  });
}

}  // namespace toccata
