#pragma once

#include <cstddef>
#include <string_view>

#include "toccata/math/pose.hpp"

// What a pose has to be for a shape (docs/truth.md). `who` names the shape in messages: "the sphere".
namespace toccata {

/// The largest row sum of |RᵀR − I| is more than 2⁻⁴⁰, exactly: a ball would not stay a ball. Precondition: finite.
[[nodiscard]] bool deforms(const Mat3& linear);

/// Throws Error unless all twelve numbers are finite.
void require_finite(const Pose& pose, std::string_view who);

/// Throws Error, naming the ellipsoid as the shape to use, when the pose deforms. Precondition: finite.
void require_undeformed(const Pose& pose, std::string_view who);

/// Throws Error when the determinant is 0: the pose would flatten a solid. Precondition: finite.
void require_regular(const Pose& pose, std::string_view who);

/// Throws Error: the world vertex of vertex `number` at `local` is not finite.
[[noreturn]] void refuse_vertex(std::size_t number, const Vec3& local, const Pose& pose, std::string_view who);

}  // namespace toccata
