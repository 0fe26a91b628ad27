#pragma once

#include "toccata/math/pose.hpp"

namespace toccata {

/// `transform`, inline. Only for files of the library: they are compiled with -ffp-contract=off, so that nothing is
/// fused here either.
inline Vec3 transform_inline(const Pose& pose, const Vec3& v) {
  const Mat3& r = pose.linear;
  return {dot(r[0], v) + pose.offset.x, dot(r[1], v) + pose.offset.y, dot(r[2], v) + pose.offset.z};
}

}  // namespace toccata
