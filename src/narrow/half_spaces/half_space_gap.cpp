#include "narrow/half_spaces/half_space_gap.hpp"

#include <algorithm>
#include <cmath>

#include "math/double_search.hpp"
#include "math/root_sign.hpp"

namespace toccata {

HalfSpaceGap::HalfSpaceGap(const Vec3& centre, double radius, const PosedHalfSpace& h)
    : centre_(centre), radius_(radius), h_(h), exact_(exact_height(h, centre)) {}

Sign HalfSpaceGap::compare(double x, double y) const {
  const std::initializer_list<double> parts = {radius_, radius_, x, y};
  const int unit = std::min(common_exponent(parts), exact_.length_exponent);
  WideInteger reach = 0;
  for (const double part : parts) reach += scaled_wide(part, unit);
  const WideInteger twice_height = exact_.height << static_cast<unsigned>(exact_.length_exponent - unit + 1);
  return root_sum_sign(twice_height, -reach, exact_.normal_squared);
}

double HalfSpaceGap::approximate() const { return dot(unit_normal(h_), centre_ - h_.point) - radius_; }

Sign HalfSpaceGap::compare_on_ball(int axis, double x, double y) const {
  const double centre = centre_[axis];
  const std::initializer_list<double> parts = {centre, radius_, x, y};
  const int unit = common_exponent(parts);
  const auto scaled_part = [unit](double value) { return scaled_wide(value, unit); };
  const WideInteger rest = 2 * scaled_part(centre) - scaled_part(x) - scaled_part(y);
  const WideInteger grown = -2 * scaled_part(radius_) * exact_.normal[static_cast<std::size_t>(axis)];
  return root_sum_sign(grown, rest, exact_.normal_squared);
}

Vec3 HalfSpaceGap::on_ball() const {
  if (radius_ == 0) return centre_;
  const Vec3 guess = centre_ - radius_ * unit_normal(h_);
  Vec3 result;
  for (int axis = 0; axis < 3; ++axis)
    result[axis] = nearest_double_by([&](double x, double y) { return compare_on_ball(axis, x, y); }, guess[axis]);
  return result;
}

Vec3 HalfSpaceGap::foot() const {
  Vec3 result;
  for (int axis = 0; axis < 3; ++axis) {
    const auto i = static_cast<std::size_t>(axis);
    const WideInteger numerator = exact_.point[i] * exact_.normal_squared - exact_.height * exact_.normal[i];
    result[axis] = nearest_double(numerator, exact_.normal_squared, exact_.length_exponent);
  }
  return result;
}

Vec3 unit_normal(const PosedHalfSpace& h) {
  const Vec3& n = h.normal;
  const double greatest = std::fmax(std::fmax(std::fabs(n.x), std::fabs(n.y)), std::fabs(n.z));
  const int exponent = std::ilogb(greatest);  // scaled, no square overflows and none that matters underflows
  const Vec3 scaled_normal{std::scalbn(n.x, -exponent), std::scalbn(n.y, -exponent), std::scalbn(n.z, -exponent)};
  const double length = std::sqrt(dot(scaled_normal, scaled_normal));
  return {scaled_normal.x / length, scaled_normal.y / length, scaled_normal.z / length};
}

}  // namespace toccata
