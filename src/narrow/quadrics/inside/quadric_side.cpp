#include <algorithm>
#include <array>
#include <optional>

#include "narrow/quadrics/exact_place.hpp"
#include "narrow/quadrics/inside/unit_frame.hpp"
#include "toccata/narrow/quadrics.hpp"

namespace toccata {
namespace {

/// By what is greater than 0 outside, with twice the digits, where that tells.
std::optional<Sign> bounded_side(const PosedQuadric& shape, const Vec3& point) {
  const PairFrame frame = pair_frame(shape, shape);
  const UnitFrame unit{QuadricBody(shape, frame)};
  UnitGenerator at;
  at.centre = unit.placed(frame.place(point));
  const Within within = is_held(unit, at);
  if (within == Within::undecided) return {};
  return within == Within::yes ? Sign::negative : Sign::positive;
}

/// Of the numbers that are positive outside.
Sign greatest_sign(std::initializer_list<WideInteger> numbers) {
  Sign greatest = Sign::negative;
  for (const WideInteger& number : numbers) greatest = std::max(greatest, sign_of(number));
  return greatest;
}

Sign exact_side(const PosedQuadric& shape, const Vec3& point) {
  const UnitPlace place = unit_place(exact_place(shape, point));
  const auto& d = place.along;
  const WideInteger &volume = place.volume, across = d[0] * d[0] + d[1] * d[1], squared = volume * volume;
  switch (shape.kind()) {
    case PosedQuadric::Kind::ellipsoid:
      return greatest_sign({(across + d[2] * d[2]) - squared});
    case PosedQuadric::Kind::cylinder:
      return greatest_sign({across - squared, d[2] - volume, -d[2] - volume});
    case PosedQuadric::Kind::cone:
      break;
  }
  const WideInteger below_tip = volume - d[2];
  return greatest_sign({WideInteger(4 * across) - below_tip * below_tip, -below_tip, -d[2] - volume});
}

}  // namespace

Sign side_of(const Vec3& point, const PosedQuadric& shape) {
  if (const std::optional<Sign> side = bounded_side(shape, point)) return *side;
  return exact_side(shape, point);
}

}  // namespace toccata
