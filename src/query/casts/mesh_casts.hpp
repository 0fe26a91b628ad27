#pragma once

#include <optional>

#include "query/posed_shape.hpp"
#include "query/search_scratch.hpp"
#include "toccata/query/casts.hpp"

// Casts of which one side is a posed mesh or height field. Elements and faces are those of the meshes. What is met
// later than `limit` of the way (0 to 1) may be left out: so is what is not met.
namespace toccata {

[[nodiscard]] std::optional<ShapeHit> cast_until(const PosedTriangles& a, const Vec3& motion, const PosedTriangles& b,
                                                 double limit, SearchScratch& scratch);
[[nodiscard]] std::optional<ShapeHit> cast_until(const PosedTriangles& a, const Vec3& motion, const PosedConvex& b,
                                                 double limit, SearchScratch& scratch);
[[nodiscard]] std::optional<ShapeHit> cast_until(const PosedConvex& a, const Vec3& motion, const PosedTriangles& b,
                                                 double limit, SearchScratch& scratch);
[[nodiscard]] std::optional<ShapeHit> cast_until(const PosedTriangles& a, const Vec3& motion, const PosedSmooth& b,
                                                 double limit, SearchScratch& scratch);
[[nodiscard]] std::optional<ShapeHit> cast_until(const PosedSmooth& a, const Vec3& motion, const PosedTriangles& b,
                                                 double limit, SearchScratch& scratch);
[[nodiscard]] std::optional<ShapeHit> cast_until(const PosedTriangles& a, const Vec3& motion, const PosedHalfSpace& b,
                                                 double limit, SearchScratch& scratch);
[[nodiscard]] std::optional<ShapeHit> cast_until(const PosedHalfSpace& a, const Vec3& motion, const PosedTriangles& b,
                                                 double limit, SearchScratch& scratch);

/// A shape that stands while the other moves the opposite way: what meets, meets at the same time, farther on.
[[nodiscard]] Cast seen_from_target(const Cast& cast, const Vec3& motion);

/// Wider than the interval of any cast, as part of the way: what certainly begins so much later than the first one ends
/// is of no interest.
constexpr double widest_cast = 0x1p-38;

/// Keeps the first by (upper, element of A, element of B), and widens it so that the least of all exact times lies in
/// it.
void keep_first(std::optional<ShapeHit>& first, const ShapeHit& found);

}  // namespace toccata
