#pragma once

#include <vector>

#include "query/posed_shape.hpp"
#include "query/search_scratch.hpp"
#include "toccata/narrow/convex_convex.hpp"
#include "toccata/query/contacts.hpp"

namespace toccata {

/// The contacts of any two posed models, ascending. They lie in the scratch.
[[nodiscard]] std::span<const Contact> contacts_of(const PosedModel& a, const PosedModel& b, SearchScratch& scratch,
                                                   int threads);

/// What `manifold` and the like see of an element: a shape that needs no tree.
[[nodiscard]] PosedPart posed_element(const PosedModel& model, Index element);

/// The points of contact of two elements of posed models that meet. Throws Error where both are half-spaces.
[[nodiscard]] Manifold manifold_of(const PosedPart& a, const PosedPart& b, SearchScratch& scratch);

}  // namespace toccata
