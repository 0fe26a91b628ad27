#include "toccata/query/faces_in_region.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "query/ask_each.hpp"
#include "query/meshes/world_search.hpp"
#include "query/posed_shape.hpp"
#include "toccata/core/error.hpp"
#include "toccata/narrow/quadrics.hpp"

namespace toccata {
namespace {

void require_region(const Aabb& box) {
  if (!is_finite(box.lower) || !is_finite(box.upper) || !(box.lower.x <= box.upper.x) ||
      !(box.lower.y <= box.upper.y) || !(box.lower.z <= box.upper.z))
    throw Error(
        fmt::format("the box from ({}, {}, {}) to ({}, {}, {}) is empty or not finite: give its least corner, "
                    "then its greatest",
                    box.lower.x, box.lower.y, box.lower.z, box.upper.x, box.upper.y, box.upper.z));
}

void require_region(const Ball& ball) {
  if (!is_finite(ball.centre) || !std::isfinite(ball.radius) || !(ball.radius >= 0))
    throw Error(
        fmt::format("the ball around ({}, {}, {}) of radius {} is empty or not finite: give a centre and a radius of 0 "
                    "or more",
                    ball.centre.x, ball.centre.y, ball.centre.z, ball.radius));
}

/// The box as a hull, because a centre and half sizes would be rounded.
ConvexHull hull_of(const Aabb& box) {
  std::array<Vec3, 8> corners;
  for (std::size_t i = 0; i < corners.size(); ++i)
    corners[i] = {(i & 1U) != 0 ? box.upper.x : box.lower.x, (i & 2U) != 0 ? box.upper.y : box.lower.y,
                  (i & 4U) != 0 ? box.upper.z : box.lower.z};
  return ConvexHull(corners);
}

PosedPolytope shape_of(const Ball& ball) {
  return ball.radius > 0 ? PosedPolytope(Sphere(ball.radius, ball.centre)) : PosedPolytope(Point(ball.centre));
}

/// A region at which shapes are compared.
class ExactRegion {
 public:
  explicit ExactRegion(const Aabb& box) : inner_(box), hull_(hull_of(box)), shape_(std::in_place, *hull_), box_(box) {}
  explicit ExactRegion(const Ball& ball) : inner_(box_within(ball)), shape_(shape_of(ball)), box_(world_box(*shape_)) {}
  // The shape refers to the hull.
  ExactRegion(const ExactRegion&) = delete;
  ExactRegion& operator=(const ExactRegion&) = delete;

  [[nodiscard]] const Aabb& box() const { return box_; }
  [[nodiscard]] const PosedPolytope& shape() const { return *shape_; }

  [[nodiscard]] bool meets(const Triangle& triangle) const {
    for (const Vec3& p : triangle.vertex)
      if (overlap(inner_, Aabb{p, p})) return true;
    return overlap(PosedPolytope(triangle), *shape_);
  }

 private:
  /// A little less than the greatest cube in it: what lies there is certainly inside.
  static Aabb box_within(const Ball& ball) {
    const double half = 0.577 * ball.radius;
    if (!(half > 0x1p-40 * std::max({std::abs(ball.centre.x), std::abs(ball.centre.y), std::abs(ball.centre.z)})))
      return {};
    const Vec3 reach{half, half, half};
    return {ball.centre - reach, ball.centre + reach};
  }

  Aabb inner_;  ///< of which every point is in the region; may be empty
  std::optional<ConvexHull> hull_;
  std::optional<PosedPolytope> shape_;
  Aabb box_;
};

/// Adds what meets the region of one part of a model.
struct FindInPart {
  void operator()(const PosedTriangles& triangles) const {
    const PosedMesh& mesh = triangles.mesh;
    const auto first = static_cast<std::ptrdiff_t>(found.size());
    visit_triangles_near(mesh, region.box(), [&](Index i) {
      if (region.meets(mesh.triangle(i))) add(i, mesh.model().mesh().face_of(i));
      return true;
    });
    std::sort(found.begin() + first, found.end(),
              [](const FoundElement& a, const FoundElement& b) { return a.element < b.element; });
  }
  void operator()(const PosedPolytope& shape) const {
    if (overlap(shape, region.shape())) add(0, 0);
  }
  void operator()(const PosedQuadric& shape) const {
    if (overlap(shape, region.shape())) add(0, 0);
  }
  void operator()(const PosedHalfSpace& shape) const {
    if (overlap(region.shape(), shape)) add(0, 0);
  }

  void add(Index element, Index face) const { found.push_back({part.first_element + element, part.first_face + face}); }

  const ExactRegion& region;
  const PosedPart& part;
  std::vector<FoundElement>& found;
};

}  // namespace

std::vector<FoundElement> faces_in_region(const Region& region, const Model& model, const Pose& pose) {
  Workspace workspace;
  static_cast<void>(faces_in_region(region, model, pose, workspace));
  return std::move(workspace.scratch().found_elements);
}

std::span<const FoundElement> faces_in_region(const Region& region, const Model& model, const Pose& pose,
                                              Workspace& workspace) {
  std::visit([](const auto& given) { require_region(given); }, region);
  std::vector<FoundElement>& found = workspace.scratch().found_elements;
  found.clear();
  const PosedModel posed = pose_model(model, pose, Solid::none, "the model");
  const auto search = [&](const auto& given) {
    const ExactRegion exact(given);
    for (const PosedPart& part : posed.parts) std::visit(FindInPart{exact, part, found}, part.shape);
  };
  std::visit(search, region);
  return found;
}

std::vector<Index> distinct_faces(std::span<const FoundElement> found) {
  std::vector<Index> faces;
  for (const FoundElement& one : found)
    if (faces.empty() || faces.back() != one.face) faces.push_back(one.face);
  return faces;
}

std::vector<std::vector<FoundElement>> faces_in_region_each(std::span<const RegionQuery> queries, const Model& model,
                                                            const BatchOptions& options) {
  return ask_each(queries, "query", options, [&](const RegionQuery& query, Workspace& workspace) {
    const auto found = faces_in_region(query.region, model, query.pose, workspace);
    return std::vector<FoundElement>(found.begin(), found.end());
  });
}

}  // namespace toccata
