#pragma once

#include "query/manifolds/contact_element.hpp"
#include "query/search_scratch.hpp"

namespace toccata {

/// The points of contact of two elements that meet, along the shortest way to part them that both allow; none where
/// others tell this contact better. Neither is a half-space.
[[nodiscard]] Manifold limited_manifold(const ContactElement& a, const ContactElement& b, SearchScratch& scratch);

/// A contact that nobody tells, as a single point, and how deep it is along its normal.
struct LoneContact {
  Manifold manifold;
  double depth = 0;
};

[[nodiscard]] LoneContact lone_contact(const ContactElement& a, const ContactElement& b, SearchScratch& scratch);

}  // namespace toccata
