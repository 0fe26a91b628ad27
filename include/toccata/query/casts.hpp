#pragma once

#include "toccata/narrow/casts.hpp"
#include "toccata/query/model.hpp"
#include "toccata/query/pair_query.hpp"
#include "toccata/query/pairs.hpp"
#include "toccata/query/workspace.hpp"

namespace toccata {

/// The first meeting of the ray from `origin` to `origin + motion` (world) with the posed model; the time is the
/// fraction of the way. Of a compound it is the earliest of its parts, by (upper, element). This version answers it for
/// convex shapes, half-spaces and compounds of them. Throws Error for other models, when a number is not finite or the
/// motion is zero, and for poses as `overlap` does.
[[nodiscard]] Cast cast_ray(const Vec3& origin, const Vec3& motion, const Model& target, const Pose& pose = {});

/// The first meeting of A, moved from its pose by `motion` (world) without turning, with B, which stands. Of compounds
/// the earliest of their parts, by (upper, element of A, element of B). Throws like `overlap`, Error when the motion is
/// not finite, and Error for what the table of pairs.hpp does not define.
[[nodiscard]] Cast cast_shape(const Model& a, const Vec3& motion, const Model& b, const PairQuery& query = {});

/// The same, for a caller who asks often.
[[nodiscard]] Cast cast_shape(const Model& a, const Vec3& motion, const Model& b, const PairQuery& query,
                              Workspace& workspace);

/// Shapes of types for which it is not defined are refused by the compiler.
template <PlainShape A, PlainShape B>
requires(!Answered<ShapeQuestion::cast_shape, A, B>) Cast
    cast_shape(const A&, const Vec3&, const B&, const PairQuery& = {})
= delete;

}  // namespace toccata
