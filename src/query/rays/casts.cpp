#include "toccata/query/casts.hpp"

#include <optional>
#include <variant>

#include "query/ask.hpp"
#include "query/keep_least.hpp"
#include "query/search_scratch.hpp"

namespace toccata {
namespace {

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

Cast cast_shape(const Model& a, const Vec3& motion, const Model& b, const PairQuery& query) {
  Workspace workspace;
  return cast_shape(a, motion, b, query, workspace);
}

Cast cast_shape(const Model& a, const Vec3& motion, const Model& b, const PairQuery& query, Workspace& workspace) {
  const PosedModels models(a, b, query, workspace.scratch());
  std::optional<Cast> earliest;  // of those that hit
  models.visit([&](const PosedPart& part_a, const PosedPart& part_b) {
    require_answered(ShapeQuestion::cast_shape, part_a.kind, part_b.kind);
    const Cast found = std::visit(AskCast{motion, workspace.scratch()}, part_a.shape, part_b.shape);
    if (found.hit) keep_least(earliest, found);
    return true;
  });
  return earliest.value_or(Cast{});
}

}  // namespace toccata
