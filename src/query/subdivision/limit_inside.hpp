#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "toccata/math/pose.hpp"
#include "toccata/query/subdivision.hpp"

namespace toccata {

/// A point that is known up to a radius.
struct RoughPoint {
  Vec3 at{};
  double radius = 0;
};

/// A point of every connected part of a posed model.
[[nodiscard]] std::vector<RoughPoint> points_of_parts(const Model& model, const Pose& pose);

/// A point of the limit surface of every connected part of a cage, within `radius` where rounding allows it.
[[nodiscard]] std::vector<RoughPoint> points_of_parts(const SubdivisionCage& cage, double radius);

/// Whether one of the points lies within the limit surface of a closed cage, which none of them is near: nothing where
/// more than `max_triangles` were needed to know it. The cage is refined only near the points.
[[nodiscard]] std::optional<bool> has_point_within(const SubdivisionCage& cage, std::span<const RoughPoint> points,
                                                   std::size_t max_triangles);

}  // namespace toccata
