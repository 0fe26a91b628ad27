#include "toccata/query/signed_distance.hpp"

#include <vector>

#include "query/ask_each.hpp"
#include "query/inside/side_search.hpp"
#include "query/nearest/nearest_search.hpp"

namespace toccata {
namespace {

/// A posed model from which signed distances are asked, and what is the same for all points.
class SignSearch {
 public:
  SignSearch(const Model& model, const Pose& pose, SignBy asked, std::size_t points)
      : nearest_(model, {.pose = pose}, points), sides_(nearest_.posed(), asked) {}
  // The search for sides refers to the other.
  SignSearch(const SignSearch&) = delete;
  SignSearch& operator=(const SignSearch&) = delete;

  [[nodiscard]] SignedDistance from(const Vec3& point, SearchScratch& scratch) const {
    return signed_of(point, nearest_.nearest(point, scratch), scratch);
  }

  void from(std::span<const Vec3> points, std::span<SignedDistance> found, SearchScratch& scratch) const {
    std::vector<std::optional<SurfacePoint>> nearest(points.size());
    nearest_.nearest(points, nearest, scratch);
    for (std::size_t i = 0; i < points.size(); ++i) found[i] = signed_of(points[i], *nearest[i], scratch);
  }

 private:
  [[nodiscard]] SignedDistance signed_of(const Vec3& point, const SurfacePoint& found, SearchScratch& scratch) const {
    return with_side(found, found.upper == 0 ? sides_.on_surface() : sides_.side_of(point, scratch));
  }

  NearestSearch nearest_;
  SideSearch sides_;
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
  return ask_in_rows<SignedDistance>(
      points, batch, [&](std::span<const Vec3> row, std::span<SignedDistance> found, Workspace& workspace) {
        search.from(row, found, workspace.scratch());
      });
}

}  // namespace toccata
