#include <optional>

#include "narrow/quadrics/exact_place.hpp"
#include "narrow/quadrics/inside/unit_frame.hpp"
#include "narrow/quadrics/kinds/quadric_kind.hpp"
#include "toccata/narrow/quadrics.hpp"

namespace toccata {
namespace {

/// The side by what is greater than 0 outside, with twice the digits, where that decides it.
std::optional<Sign> bounded_side(const PosedQuadric& shape, const Vec3& point) {
  const PairFrame frame = pair_frame(shape, shape);
  const UnitFrame unit{QuadricBody(shape, frame)};
  UnitGenerator at;
  at.centre = unit.placed(frame.place(point));
  const Within within = is_held(unit, at);
  if (within == Within::undecided) return {};
  return within == Within::yes ? Sign::negative : Sign::positive;
}

}  // namespace

Sign side_of(const Vec3& point, const PosedQuadric& shape) {
  if (const std::optional<Sign> side = bounded_side(shape, point)) return *side;
  const UnitPlace place = unit_place(exact_place(shape, point));
  return with_kind(shape.kind(), [&](auto kind) { return kind.side(place); });
}

}  // namespace toccata
