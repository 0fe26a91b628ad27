#pragma once

#include "toccata/narrow/convex_convex.hpp"
#include "toccata/query/model.hpp"
#include "toccata/query/pair_query.hpp"
#include "toccata/query/pairs.hpp"
#include "toccata/query/workspace.hpp"

namespace toccata {

/// How deep two convex solids overlap, and the shortest way to part them. Throws like `overlap`, and Error for what the
/// table of pairs.hpp does not define: surfaces, flat hulls, two half-spaces, and in this version meshes and compounds.
[[nodiscard]] Penetration penetration(const Model& a, const Model& b, const PairQuery& query = {});

/// The same, for a caller who asks often.
[[nodiscard]] Penetration penetration(const Model& a, const Model& b, const PairQuery& query, Workspace& workspace);

/// Shapes of types for which it is not defined are refused by the compiler.
template <PlainShape A, PlainShape B>
requires(!Answered<ShapeQuestion::penetration, A, B>) Penetration penetration(const A&, const B&, const PairQuery& = {})
= delete;

}  // namespace toccata
