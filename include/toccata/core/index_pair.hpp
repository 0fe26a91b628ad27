#pragma once

#include <compare>

#include "toccata/core/index.hpp"

namespace toccata {

/// Two different objects, first < second.
struct IndexPair {
  Index first;
  Index second;
  friend constexpr auto operator<=>(const IndexPair&, const IndexPair&) = default;
};

}  // namespace toccata
