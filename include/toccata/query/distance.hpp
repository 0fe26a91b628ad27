#pragma once

#include <optional>

#include "toccata/narrow/convex_convex.hpp"
#include "toccata/query/model.hpp"
#include "toccata/query/pair_query.hpp"

namespace toccata {

/// The distance of the two posed models, certified; 0 when they meet, also when one lies within a solid. For meshes it
/// is the least of their triangles, for a compound the least of its parts, by (upper, element of A, element of B); what
/// lies inside a mesh taken as a surface is at a distance from it. Where a mesh meets something, the elements named are
/// the first that are found to meet. For the same two trees and poses they are always the same; they are not the least
/// (`first_contact`), and others where A and B are exchanged. Where a model lies within a solid mesh, the element named
/// is one of the part that lies inside, and for the solid the first. Throws like `overlap`.
[[nodiscard]] Distance distance(const Model& a, const Model& b, const PairQuery& query = {});

/// The same, for a caller who asks often.
[[nodiscard]] Distance distance(const Model& a, const Model& b, const PairQuery& query, Workspace& workspace);

/// Make a Model of it, once: `Model(mesh)`.
template <class A, class B>
requires NeedAModel<A, B> Distance distance(const A&, const B&, const PairQuery& = {})
= delete;

/// Is the exact distance of the two posed models at most `max_distance` (in world units)? Decided exactly, as
/// everything about world doubles is; of cylinders, cones and ellipsoids a no is proved, and a number within the
/// interval of the distance counts as yes. Of 0 it is `overlap`. It ends at the first two elements that are so near,
/// and looks at nothing that is farther, so it costs less than the distance. Throws Error like `distance`, and when the
/// greatest distance is negative or no number; it may be infinite.
[[nodiscard]] bool within_distance(const Model& a, const Model& b, double max_distance, const PairQuery& query = {});

/// The same, for a caller who asks often: what was found near the last time is looked at first.
[[nodiscard]] bool within_distance(const Model& a, const Model& b, double max_distance, const PairQuery& query,
                                   Workspace& workspace);

/// Make a Model of it, once: `Model(mesh)`.
template <class A, class B>
requires NeedAModel<A, B>
bool within_distance(const A&, const B&, double, const PairQuery& = {}) = delete;

/// What `distance` answers, to the last bit, where `within_distance` says yes; nothing where it says no, which is found
/// out without the distance. Throws like it.
[[nodiscard]] std::optional<Distance> distance_within(const Model& a, const Model& b, double max_distance,
                                                      const PairQuery& query = {});

/// The same, for a caller who asks often.
[[nodiscard]] std::optional<Distance> distance_within(const Model& a, const Model& b, double max_distance,
                                                      const PairQuery& query, Workspace& workspace);

}  // namespace toccata
