#include "toccata/query/casts.hpp"

#include <optional>
#include <variant>

#include "query/ask.hpp"
#include "query/search_scratch.hpp"

namespace toccata {
namespace {

/// Keeps the earlier of two; the first among those of one upper end.
void keep_earlier(std::optional<Cast>& earliest, const Cast& found) {
  if (!earliest || (found.hit && (!earliest->hit || found.upper < earliest->upper))) earliest = found;
}

struct AskRay {
  Cast operator()(const PosedConvex& target) const { return cast_ray(origin, motion, target); }
  Cast operator()(const PosedHalfSpace& target) const { return cast_ray(origin, motion, target); }
  Cast operator()(const PosedTriangles&) const { return {}; }  // the table was asked before

  const Vec3& origin;
  const Vec3& motion;
};

/// A shape that stands while the other moves the opposite way: what meets, meets at the same time, farther on.
Cast seen_from_target(const Cast& cast, const Vec3& motion) {
  Cast result = cast;
  result.normal = -cast.normal;
  if (cast.hit) result.point = cast.point + cast.upper * motion;
  return result;
}

struct AskCast {
  Cast operator()(const PosedConvex& a, const PosedConvex& b) const {
    return cast_shape(a, motion, b, &scratch.convex);
  }
  Cast operator()(const PosedConvex& a, const PosedHalfSpace& b) const { return cast_shape(a, motion, b); }
  Cast operator()(const PosedHalfSpace& a, const PosedConvex& b) const {
    return seen_from_target(cast_shape(b, -motion, a), motion);
  }
  template <class A, class B>
  Cast operator()(const A&, const B&) const {
    return {};  // the table was asked before
  }

  const Vec3& motion;
  SearchScratch& scratch;
};

}  // namespace

Cast cast_ray(const Vec3& origin, const Vec3& motion, const Model& target, const Pose& pose) {
  const PosedModel posed = pose_model(target, pose, Solid::automatic, "the target");
  std::optional<Cast> earliest;
  for (const PosedPart& part : posed.parts) {
    const PairCell cell = pair_cell(ShapeQuestion::cast_ray, ShapeKind::point, part.kind);
    if (cell.state != PairState::defined)
      throw Error(fmt::format("cast-ray at a {} is not answered: {}", name_of(part.kind), cell.text));
    keep_earlier(earliest, std::visit(AskRay{origin, motion}, part.shape));
  }
  return *earliest;
}

Cast cast_shape(const Model& a, const Vec3& motion, const Model& b, const PairQuery& query) {
  Workspace workspace;
  return cast_shape(a, motion, b, query, workspace);
}

Cast cast_shape(const Model& a, const Vec3& motion, const Model& b, const PairQuery& query, Workspace& workspace) {
  const PosedModels models(a, b, query, workspace.scratch());
  std::optional<Cast> earliest;
  models.visit([&](const PosedPart& part_a, const PosedPart& part_b) {
    require_answered(ShapeQuestion::cast_shape, part_a.kind, part_b.kind);
    keep_earlier(earliest, std::visit(AskCast{motion, workspace.scratch()}, part_a.shape, part_b.shape));
    return true;
  });
  return *earliest;
}

}  // namespace toccata
