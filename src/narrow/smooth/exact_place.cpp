#include "narrow/smooth/exact_place.hpp"

#include <algorithm>

#include "toccata/narrow/smooth_boundary.hpp"

namespace toccata {
namespace {

/// Of a − √b, where b is not negative.
Sign sign_of_less_root(const WideInteger& a, const WideInteger& b) {
  return a < 0 ? Sign::negative : sign_of(a * a - b);
}

}  // namespace

ExactPlace exact_place(const PosedSmooth& shape, const Vec3& point) {
  const Mat3& linear = shape.pose().linear;
  const std::array<Vec3, 3> columns{linear.column(0), linear.column(1), linear.column(2)};
  const std::array<Vec3, 1> half{shape.half()};
  const std::array<Vec3, 2> places{point, shape.pose().offset};
  const int of_columns = common_exponent(columns), of_half = common_exponent(half), of_places = common_exponent(places);
  const int unit = std::min(of_columns + of_half, of_places);
  const WideInteger of_axes = WideInteger(1) << static_cast<unsigned>(of_columns + of_half - unit);
  ExactPlace place;
  for (std::size_t j = 0; j < 3; ++j)
    place.axis[j] =
        (of_axes * scaled_wide(half[0][static_cast<int>(j)], of_half)) * scaled_wide(columns[j], of_columns);
  place.point = scaled_wide(places[0], unit) - scaled_wide(places[1], unit);
  return place;
}

Sign exact_sign_of_height(const PosedSmooth& shape, const Vec3& point, const Vec3& normal) {
  const ExactPlace place = exact_place(shape, point);
  const std::array<Vec3, 1> along{normal};
  const IntegerVector n = scaled_wide(normal, common_exponent(along));
  const WideInteger middle = -dot(n, place.point), x = dot(n, place.axis[0]), y = dot(n, place.axis[1]),
                    z = dot(n, place.axis[2]);
  switch (shape.kind()) {
    case PosedSmooth::Kind::ellipsoid:
      return sign_of_less_root(middle, (x * x + y * y) + z * z);
    case PosedSmooth::Kind::cylinder:
      return sign_of_less_root(middle - abs(z), x * x + y * y);
    case PosedSmooth::Kind::cone:
      break;
  }
  return std::min(sign_of(middle + z), sign_of_less_root(middle - z, x * x + y * y));
}

bool is_middle_in(const PosedSmooth& shape, const PosedSmooth& other) {
  return side_of(shape.pose().offset, other) != Sign::positive;
}

bool is_middle_in(const PosedSmooth& shape, const PosedConvex& other) {
  return overlap(PosedConvex(Point(shape.pose().offset)), other);
}

}  // namespace toccata
