#pragma once

#include "toccata/narrow/convex_convex.hpp"
#include "toccata/query/model.hpp"
#include "toccata/query/pair_query.hpp"
#include "toccata/query/workspace.hpp"

namespace toccata {

/// The distance of the two posed models, certified; 0 when they meet, also when one lies within a solid. Of meshes it
/// is the least of their triangles, of a compound the least of its parts, by (upper, element of A, element of B); what
/// lies inside a mesh taken as a surface is at a distance from it. Of a model within a solid mesh the element named is
/// one of the part that lies inside, and of the solid the first. Throws like `overlap`.
[[nodiscard]] Distance distance(const Model& a, const Model& b, const PairQuery& query = {});

/// The same, for a caller who asks often.
[[nodiscard]] Distance distance(const Model& a, const Model& b, const PairQuery& query, Workspace& workspace);

/// Make a Model of it, once: `Model(mesh)`.
template <class A, class B>
requires NeedAModel<A, B> Distance distance(const A&, const B&, const PairQuery& = {})
= delete;

}  // namespace toccata
