#include "narrow/quadrics/exact_place.hpp"

#include <algorithm>

#include "narrow/quadrics/kinds/quadric_kind.hpp"
#include "toccata/narrow/quadrics.hpp"

namespace toccata {
ExactPlace exact_place(const PosedQuadric& shape, const Vec3& point) {
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

UnitPlace unit_place(const ExactPlace& place) {
  const auto& axis = place.axis;
  UnitPlace unit;
  for (std::size_t i = 0; i < 3; ++i) unit.row[i] = cross(axis[(i + 1) % 3], axis[(i + 2) % 3]);
  unit.volume = dot(unit.row[0], axis[0]);
  if (unit.volume < 0) {
    unit.volume = -unit.volume;
    for (IntegerVector& row : unit.row) row = -row;
  }
  for (std::size_t i = 0; i < 3; ++i) unit.along[i] = dot(unit.row[i], place.point);
  return unit;
}

Sign exact_sign_of_height(const PosedQuadric& shape, const Vec3& point, const Vec3& normal) {
  const std::array<Vec3, 1> along{normal};
  return exact_sign_of_height(shape, point, scaled_wide(normal, common_exponent(along)));
}

Sign exact_sign_of_height(const PosedQuadric& shape, const Vec3& point, const IntegerVector& n) {
  const ExactPlace place = exact_place(shape, point);
  const WideInteger middle = -dot(n, place.point), x = dot(n, place.axis[0]), y = dot(n, place.axis[1]),
                    z = dot(n, place.axis[2]);
  return with_kind(shape.kind(), [&](auto kind) { return kind.sign_of_least_height(middle, x, y, z); });
}

Sign exact_sign_of_height(const PosedPolytope& shape, const Vec3& point, const IntegerVector& n) {
  const std::array<Vec3, 2> numbers{point, {shape.radius(), 0, 0}};
  int unit = common_exponent(numbers);
  for (Index i = 0; i < shape.vertex_count(); ++i) {
    const std::array<Vec3, 1> vertex{shape.vertex(i)};
    unit = std::min(unit, common_exponent(vertex));
  }
  const WideInteger level = dot(n, scaled_wide(point, unit)), radius = scaled_wide(shape.radius(), unit),
                    reach_squared = (radius * radius) * dot(n, n);
  Sign least = Sign::positive;
  for (Index i = 0; i < shape.vertex_count() && least != Sign::negative; ++i)
    least = std::min(least, sign_of_less_root(dot(n, scaled_wide(shape.vertex(i), unit)) - level, reach_squared));
  return least;
}

bool is_middle_in(const PosedQuadric& shape, const PosedQuadric& other) {
  return side_of(shape.pose().offset, other) != Sign::positive;
}

bool is_middle_in(const PosedQuadric& shape, const PosedPolytope& other) {
  return overlap(PosedPolytope(Point(shape.pose().offset)), other);
}

}  // namespace toccata
