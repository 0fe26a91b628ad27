#pragma once

#include "toccata/narrow/convex_convex.hpp"
#include "toccata/query/model.hpp"
#include "toccata/query/pair_query.hpp"
#include "toccata/query/pairs.hpp"

namespace toccata {

/// How deep two solids overlap, and a short way to part them. Of two convex shapes, or one and a half-space, as in
/// convex_convex.hpp. Of closed meshes and compounds the bracket holds as well, and is wider: `lower` is proved by
/// convex bodies within the two, `upper · direction` by a distance that is not 0 after it, in the world doubles and in
/// exact arithmetic (docs/methods/penetration.md). Then `status` is `not_converged` where upper > 1.5 · lower; on_a and
/// on_b are where the two come apart last. When they do not overlap, both bounds are 0 and the points those of
/// `distance`.
///
/// Throws like `overlap`, and Error for what the table of pairs.hpp does not define: surfaces, flat hulls, two
/// half-spaces; also for an open mesh, which the message names, and for compounds that have half-spaces among others.
[[nodiscard]] Penetration penetration(const Model& a, const Model& b, const PairQuery& query = {});

/// The same, for a caller who asks often.
[[nodiscard]] Penetration penetration(const Model& a, const Model& b, const PairQuery& query, Workspace& workspace);

/// Shapes of types for which it is not defined are refused by the compiler.
template <PlainShape A, PlainShape B>
requires(!Answered<ShapeQuestion::penetration, A, B>) Penetration penetration(const A&, const B&, const PairQuery& = {})
= delete;

/// Make a Model of it, once: `Model(mesh)`.
template <class A, class B>
requires NeedAModel<A, B> Penetration penetration(const A&, const B&, const PairQuery& = {})
= delete;

}  // namespace toccata
