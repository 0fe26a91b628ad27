#pragma once

#include <array>
#include <optional>

#include "narrow/smooth/distance/smooth_search.hpp"
#include "narrow/smooth/smooth_body.hpp"

namespace toccata {

/// Four points of A − B that seem to have the origin inside, by the search of GJK with simplices in numbers of 106
/// bits: where the bodies overlap so little, or are so slim, that doubles do not tell. With the weights that make
/// the origin. None where the search ends apart, or gains nothing more.
[[nodiscard]] std::optional<std::array<SmoothSearch::Corner, 4>> corners_around_origin(const SmoothBody& a,
                                                                                       const SmoothBody& b,
                                                                                       const Vec3& first_direction);

}  // namespace toccata
