#pragma once

#include <optional>

#include "toccata/math/predicates.hpp"

// The later stages of the predicates, each alone, for the predicates themselves and for tests.
namespace toccata {

/// The signs by integers of one and two machine words: exact, or nothing where, along some axis, the coordinates are
/// not integers below 2^60 over a common power of two. Those of most meshes are, and all those on any coarse grid.
[[nodiscard]] std::optional<Sign> orient2d_by_machine_integers(const Vec2& a, const Vec2& b, const Vec2& c);
[[nodiscard]] std::optional<Sign> triple_product_sign_by_machine_integers(const Difference& u, const Difference& v,
                                                                          const Difference& w);

/// The signs by floating-point expansions: exact, or nothing where a difference or its rounding error is outside
/// [2^-300, 2^300] and not 0, so that products could under- or overflow.
[[nodiscard]] std::optional<Sign> orient2d_by_expansions(const Vec2& a, const Vec2& b, const Vec2& c);
[[nodiscard]] std::optional<Sign> triple_product_sign_by_expansions(const Difference& u, const Difference& v,
                                                                    const Difference& w);

/// The signs by integers of any length over a common power of two per axis: exact for all finite doubles, and slow.
[[nodiscard]] Sign orient2d_by_integers(const Vec2& a, const Vec2& b, const Vec2& c);
[[nodiscard]] Sign triple_product_sign_by_integers(const Difference& u, const Difference& v, const Difference& w);

}  // namespace toccata
