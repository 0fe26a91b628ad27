#include "query/inside/side_search.hpp"

#include <algorithm>
#include <variant>

#include "query/inside/inside_winding.hpp"
#include "query/semantics.hpp"
#include "toccata/core/error.hpp"
#include "toccata/narrow/quadrics.hpp"

namespace toccata {
namespace {

SignBy method_for(const PosedMesh& mesh, SignBy asked) {
  if (asked == SignBy::generalized_winding_number) return asked;
  if (!mesh.model().closed()) {
    if (asked == SignBy::automatic) return SignBy::generalized_winding_number;
    throw Error(
        "the mesh is open, and no winding number tells an inside of it: close it, or ask by the generalised winding "
        "number (SignBy::generalized_winding_number)");
  }
  static_cast<void>(taken_as_solid(mesh.model(), mesh.pose(), Solid::all, "the model"));  // throws for a singular pose
  return SignBy::winding_number;
}

/// Neither a mesh nor a surface.
bool holds(const PosedShape& shape, const PosedPolytope& point) {
  if (const auto* quadric = std::get_if<PosedQuadric>(&shape))
    return side_of(point.vertex(0), *quadric) != Sign::positive;
  if (const auto* convex = std::get_if<PosedPolytope>(&shape)) return convex->solid() && overlap(point, *convex);
  const auto* half_space = std::get_if<PosedHalfSpace>(&shape);
  return half_space != nullptr && overlap(point, *half_space);
}

/// More than a half, less, or neither is certain.
FoundSide side_by(const WindingNumber& found) {
  constexpr SignBy by = SignBy::generalized_winding_number;
  if (found.lower > 0.5 || found.upper < -0.5) return {Side::inside, by, Status::exact};
  if (found.lower > -0.5 && found.upper < 0.5) return {Side::outside, by, Status::exact};
  return {Side::inside, by, Status::undecided};
}

}  // namespace

SignedDistance with_side(const SurfacePoint& nearest, const FoundSide& found) {
  const bool inside = found.side == Side::inside;
  SignedDistance result;
  result.lower = inside ? -nearest.upper : nearest.lower;
  result.upper = !inside || found.status == Status::undecided ? nearest.upper : -nearest.lower;
  result.nearest = nearest.point;
  result.element = nearest.element;
  result.face = nearest.face;
  result.side = found.side;
  result.sign_by = found.sign_by;
  result.status = found.status == Status::exact ? nearest.status : found.status;
  return result;
}

SideSearch::SideSearch(const PosedModel& posed, SignBy asked) : posed_(posed) {
  for (const PosedPart& part : posed.parts)
    if (const auto* triangles = std::get_if<PosedTriangles>(&part.shape)) {
      if (method_for(triangles->mesh, asked) == SignBy::winding_number)
        closed_.push_back(&triangles->mesh);
      else
        others_.emplace_back(triangles->mesh);
    }
}

bool SideSearch::held_for_certain(const Vec3& point) const {
  const PosedPolytope convex(Point{point});
  if (std::any_of(posed_.parts.begin(), posed_.parts.end(),
                  [&](const PosedPart& part) { return holds(part.shape, convex); }))
    return true;
  if (closed_.empty()) return false;
  const ExactPoint exact(point);
  return std::any_of(closed_.begin(), closed_.end(),
                     [&](const PosedMesh* mesh) { return wind_along(*mesh, exact, 0).ahead != 0; });
}

FoundSide SideSearch::on_surface() const {
  return {Side::boundary, others_.empty() ? SignBy::winding_number : SignBy::generalized_winding_number, Status::exact};
}

FoundSide SideSearch::side_of(const Vec3& point, SearchScratch& scratch) const {
  if (held_for_certain(point)) return {Side::inside, SignBy::winding_number, Status::exact};
  FoundSide result;
  for (const WindingSearch& search : others_) {
    const FoundSide found = side_by(search.beside_a_half(point, scratch.winding));
    if (found.side == Side::inside && found.status == Status::exact) return found;
    if (result.status != Status::undecided) result = found;
  }
  return result;
}

}  // namespace toccata
