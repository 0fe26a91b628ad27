#include "toccata/narrow/quadrics.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "math/vec3_measures.hpp"
#include "narrow/pose_checks.hpp"
#include "toccata/core/error.hpp"

namespace toccata {
namespace {

/// No coordinate of the shape in the world is larger.
double reach_of(const Vec3& half, const Pose& pose) {
  double largest = 0;
  for (int i = 0; i < 3; ++i) {
    const Vec3 r = magnitudes(pose.linear[i]);
    largest = std::max(largest, dot(r, half) + std::fabs(pose.offset[i]));
  }
  return largest;
}

}  // namespace

PosedQuadric::PosedQuadric(Kind kind, const Vec3& half, const Pose& pose, std::string_view name)
    : kind_(kind), half_(half), pose_(pose) {
  const auto who = [name] { return fmt::format("the {}", name); };
  if ((!is_surely_rigid(pose.linear) || !is_surely_finite(pose.offset)) &&
      (!is_finite(pose) || is_singular(pose.linear))) {
    require_finite(pose, who());
    require_regular(pose, who());
  }
  if (!std::isfinite(reach_of(half, pose)))
    throw Error(
        fmt::format("{}: it reaches beyond the finite numbers under the pose ({}); use smaller numbers or a "
                    "smaller scale",
                    who(), fmt::join(pose.numbers(), ", ")));
}

PosedQuadric PosedQuadric::moved(const Vec3& by) const {
  PosedQuadric result = *this;
  result.pose_.offset = pose_.offset + by;
  return result;
}

}  // namespace toccata
