#include "toccata/query/convex_parts.hpp"

#include <cmath>

#include "toccata/query/distance.hpp"
#include "toccata/query/overlap.hpp"

namespace toccata {
namespace {

/// How far a rounded world point of the model may be from the exact one: three products and three sums a coordinate,
/// each off by 2^-53 of what is added up so far, with room to spare; the floor is for underflow.
double moved_by_rounding(const Model& model, const Pose& pose) {
  const Aabb& box = model.bounds();
  double most = 0;
  for (int row = 0; row < 3; ++row) {
    double sum = std::fabs(pose.offset[row]);
    for (int axis = 0; axis < 3; ++axis)
      sum += std::fabs(pose.linear[row][axis]) * std::fmax(std::fabs(box.lower[axis]), std::fabs(box.upper[axis]));
    most = std::fmax(most, sum);
  }
  return 0x1p-48 * most + 0x1p-1060;
}

/// None is moved where the parts are the model itself.
double slack_of(const ModelWithParts& one, const Pose& pose) {
  if (!std::holds_alternative<Compound>(one.parts().shape()) || !one.model().has_mesh()) return 0;
  // The mesh from where it is exactly, and the hulls from there.
  return 2 * moved_by_rounding(one.model(), pose);
}

/// What the model would refuse is left to it.
bool is_plain(const PairQuery& query) {
  return is_finite(query.pose_a) && is_finite(query.pose_b) && !is_singular(query.pose_a.linear) &&
         !is_singular(query.pose_b.linear) && query.solid_a == Solid::automatic && query.solid_b == Solid::automatic;
}

}  // namespace

bool parts_are_apart(const ModelWithParts& a, const ModelWithParts& b, const PairQuery& query) {
  if (!is_plain(query)) return false;
  const double slack = slack_of(a, query.pose_a) + slack_of(b, query.pose_b);
  return std::isfinite(slack) && !within_distance(a.parts(), b.parts(), slack, query);
}

bool overlap(const ModelWithParts& a, const ModelWithParts& b, const PairQuery& query) {
  return !parts_are_apart(a, b, query) && overlap(a.model(), b.model(), query);
}

}  // namespace toccata
