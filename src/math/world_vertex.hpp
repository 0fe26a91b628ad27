#pragma once

#include "toccata/math/pose.hpp"

namespace toccata {

inline double row_times(const Vec3& row, const Vec3& v) { return (row.x * v.x + row.y * v.y) + row.z * v.z; }

/// The formula of `transform`, which defines the truth, for loops within the library: private, because everything that
/// includes it has to be compiled with -ffp-contract=off.
inline Vec3 world_vertex(const Pose& pose, const Vec3& v) {
  const Mat3& r = pose.linear;
  return {row_times(r[0], v) + pose.offset.x, row_times(r[1], v) + pose.offset.y, row_times(r[2], v) + pose.offset.z};
}

}  // namespace toccata
