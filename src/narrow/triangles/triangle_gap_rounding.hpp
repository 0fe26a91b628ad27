#pragma once

namespace toccata {

/// What the length of a difference of two triangles' points, and a bound of their distance from below by heights along
/// it, may be off by, as a part of the greatest coordinate of a vertex seen from one of the vertices: 64 roundings
/// (docs/methods/mesh-distance.md).
inline constexpr double triangle_gap_rounding = 0x1p-47;

}  // namespace toccata
