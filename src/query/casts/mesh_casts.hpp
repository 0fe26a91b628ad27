#pragma once

#include <concepts>
#include <optional>

#include "narrow/convex/cast_until.hpp"
#include "narrow/half_spaces/half_space_casts.hpp"
#include "narrow/quadrics/casts/quadric_cast_until.hpp"
#include "query/casts/start_normal.hpp"
#include "query/posed_shape.hpp"
#include "query/search_scratch.hpp"
#include "toccata/query/casts.hpp"

// Casts of which one side is a posed mesh or height field. Elements and faces are those of the meshes. What is met
// later than `limit` of the way (0 to 1) may be left out: so is what is not met.
namespace toccata {

template <class A, class B>
requires std::same_as<A, PosedTriangles> || std::same_as<B, PosedTriangles>
[[nodiscard]] std::optional<ShapeHit> cast_until(const A& a, const Vec3& motion, const B& b, double limit,
                                                 SearchScratch& scratch);

/// The same of two convex sets, without the normal of a contact at the start; two half-spaces meet wherever they are.
template <PosedConvexSet A, PosedConvexSet B>
[[nodiscard]] std::optional<Cast> plain_cast_until(const A& a, const Vec3& motion, const B& b, double limit,
                                                   SimplexCache& kept) {
  if constexpr (std::same_as<A, PosedHalfSpace> || std::same_as<B, PosedHalfSpace>)
    return cast_shape(a, motion, b);
  else if constexpr (std::same_as<A, PosedQuadric> || std::same_as<B, PosedQuadric>)
    return cast_shape_until(a, motion, b, limit);
  else
    return cast_shape_until(a, motion, b, limit, kept);
}

/// And with it.
template <PosedConvexSet A, PosedConvexSet B>
[[nodiscard]] std::optional<Cast> cast_convex_until(const A& a, const Vec3& motion, const B& b, double limit,
                                                    SimplexCache& kept) {
  return with_start_normal(plain_cast_until(a, motion, b, limit, kept), a, b);
}

/// Wider than the interval of any cast, as part of the way: what certainly begins so much later than the first one ends
/// is of no interest.
constexpr double widest_cast = 0x1p-38;

/// keep_least by (upper, element of A, element of B).
void keep_first(std::optional<ShapeHit>& first, const ShapeHit& found);

}  // namespace toccata
