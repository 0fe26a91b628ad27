#include "query/penetration/separating_cover.hpp"

#include <algorithm>
#include <cmath>

#include "toccata/narrow/convex_convex.hpp"

namespace toccata {
namespace {

/// Boxes alone do not tell that some corner is outside of the pair's set.
bool may_cover(const InnerPair& pair, const Vec3& lower, const Vec3& upper) {
  const Vec3 least = pair.a->box.lower - pair.b->box.upper, greatest = pair.a->box.upper - pair.b->box.lower;
  bool may = true;
  for (int axis = 0; axis < 3; ++axis) may &= least[axis] < lower[axis] && upper[axis] < greatest[axis];
  return may;
}

Vec3 corner_of(const TranslationCell& cell, double half, int number) {
  const Vec3 away{(number & 1) != 0 ? half : -half, (number & 2) != 0 ? half : -half, (number & 4) != 0 ? half : -half};
  return cell.centre + away;
}

}  // namespace

double TranslationCell::nearest() const {
  Vec3 away;
  for (int axis = 0; axis < 3; ++axis) away[axis] = std::max(std::abs(centre[axis]) - half, 0.0);
  return std::sqrt(dot(away, away));
}

double TranslationCell::farthest() const {
  const Vec3 away{std::abs(centre.x) + half, std::abs(centre.y) + half, std::abs(centre.z) + half};
  return std::sqrt(dot(away, away));
}

bool SeparatingCover::covers(const TranslationCell& cell) const {
  return std::any_of(pairs_.begin(), pairs_.end(), [&](const InnerPair& pair) { return covers(pair, cell); });
}

bool SeparatingCover::covers(const InnerPair& pair, const TranslationCell& cell) const {
  // The corners of a cell that is larger by more than rounding can move a part: what they span holds the cell.
  const double half = cell.half + margin_;
  if (!may_cover(pair, corner_of(cell, half, 0), corner_of(cell, half, 7))) return false;
  SimplexCache workspace;
  for (int i = 0; i < 8; ++i)
    if (!overlap(pair.a->shape, pair.b->shape.moved(corner_of(cell, half, i)), &workspace)) return false;
  return true;
}

}  // namespace toccata
