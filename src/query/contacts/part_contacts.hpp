#pragma once

#include <optional>
#include <span>

#include "query/posed_shape.hpp"
#include "query/search_scratch.hpp"
#include "toccata/narrow/convex_convex.hpp"
#include "toccata/query/contacts.hpp"
#include "toccata/query/manifold.hpp"

namespace toccata {

/// The contacts of any two posed models, ascending. They lie in the scratch.
[[nodiscard]] std::span<const Contact> contacts_of(const PosedModel& a, const PosedModel& b, SearchScratch& scratch,
                                                   int threads);

/// What `manifold` and the like see of an element: a shape that needs no tree.
[[nodiscard]] PosedPart posed_element(const PosedModel& model, Index element);

/// The points of contact of two elements of posed models that meet. Throws Error where both are half-spaces.
[[nodiscard]] Manifold manifold_of(const PosedPart& a, const PosedPart& b, SearchScratch& scratch);

/// What `manifold` answers of two models in contact; nothing where the table of pairs.hpp does not define it.
[[nodiscard]] std::optional<Manifold> manifold_where_defined(const Model& a, const Model& b, const PairQuery& query,
                                                             Workspace& workspace);

}  // namespace toccata
