#pragma once

#include "toccata/query/model.hpp"
#include "toccata/query/pair_query.hpp"

namespace toccata {

/// Do the two posed models have a point in common? Touching counts; a model wholly inside a solid counts. Exact;
/// of cylinders, cones and ellipsoids a no is proved, and what is undecided (docs/truth.md) counts as yes. Shapes that
/// need no tree may be given as they are: overlap(bunny, Sphere{1}). Throws Error when a world vertex is not finite, a
/// model is asked about as a solid that is open, a surface or singularly posed, or the pose deforms a ball.
[[nodiscard]] bool overlap(const Model& a, const Model& b, const PairQuery& query = {});

/// The same, for a caller who asks often.
[[nodiscard]] bool overlap(const Model& a, const Model& b, const PairQuery& query, Workspace& workspace);

/// Make a Model of it, once: `Model(mesh)`.
template <class A, class B>
requires NeedAModel<A, B>
bool overlap(const A&, const B&, const PairQuery& = {}) = delete;

}  // namespace toccata
