#pragma once

#include <array>
#include <optional>

#include "narrow/quadrics/distance/quadric_proof.hpp"

namespace toccata {

/// How a search in numbers of 106 bits has ended.
struct FineEnd {
  /// Four points of A − B that seem to have the origin inside, with the weights that make it.
  std::optional<std::array<QuadricSearch::Corner, 4>> around;
  FineDirection direction{};  ///< else the last one, from B to A: across it they seem to be apart, if they are
};

/// The search of GJK with simplices and directions in numbers of 106 bits, for whether the bodies meet: where the gap
/// is so small, or one body so slim or so large, that doubles do not tell.
[[nodiscard]] FineEnd search_finely(const QuadricBody& a, const QuadricBody& b, const Vec3& first_direction);

}  // namespace toccata
