#pragma once

#include "toccata/narrow/convex_convex.hpp"
#include "toccata/query/model.hpp"
#include "toccata/query/pair_query.hpp"

namespace toccata {

/// Exact, also where every pair of triangles merely touches: two aligned boxes that share half their volume overlap.
/// For cylinders, cones and ellipsoids the status says when the relation is undecided; it is then called touching.
/// Throws like `overlap`.
[[nodiscard]] Relation relation(const Model& a, const Model& b, const PairQuery& query = {});

/// The same, for a caller who asks often. Where the surfaces of solids meet, what lies beside them is looked at in
/// rational numbers; these take memory of their own.
[[nodiscard]] Relation relation(const Model& a, const Model& b, const PairQuery& query, Workspace& workspace);

/// Make a Model of it, once: `Model(mesh)`.
template <class A, class B>
requires NeedAModel<A, B> Relation relation(const A&, const B&, const PairQuery& = {})
= delete;

}  // namespace toccata
