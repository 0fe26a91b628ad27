#pragma once

#include <optional>

#include "query/manifolds/contact_element.hpp"
#include "query/search_scratch.hpp"

namespace toccata {

/// What is told of a contact of two elements.
struct LimitedManifold {
  Manifold manifold;       ///< empty where others tell this contact better
  Manifold alone{};        ///< then: a single point of it, if nobody does
  double depth_alone = 0;  ///< along its normal
};

/// The points of contact of two elements that meet, along the shortest way to part them that both allow. Neither is a
/// half-space.
[[nodiscard]] LimitedManifold limited_manifold(const ContactElement& a, const ContactElement& b,
                                               SearchScratch& scratch);

}  // namespace toccata
