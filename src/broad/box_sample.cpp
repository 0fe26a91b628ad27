#include "broad/box_sample.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "broad/float_boxes.hpp"

namespace toccata {
namespace {

constexpr double Vec3::*coordinates[] = {&Vec3::x, &Vec3::y, &Vec3::z};

BoxSample::Spread spread_of(std::vector<double>& values, double high) {
  if (values.empty()) return {};
  std::sort(values.begin(), values.end());
  const auto at = [&](double rank) {
    return values[static_cast<std::size_t>(rank * static_cast<double>(values.size() - 1))];
  };
  return {at(0.01), at(0.5), at(high), values.back()};
}

}  // namespace

BoxSample::BoxSample(std::span<const Aabb> boxes) {
  constexpr std::size_t wanted = 1024;
  constexpr double most = std::numeric_limits<double>::max();
  const std::size_t step = std::max<std::size_t>(1, boxes.size() / wanted);
  std::vector<Aabb> sample;
  for (std::size_t i = 0; i < boxes.size(); i += step)
    if (!is_empty(boxes[i])) sample.push_back(boxes[i]);
  bounds_ = finite_bounds(sample);
  size_ = sample.size();
  std::vector<double> places, sizes;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    places.clear();
    sizes.clear();
    for (const Aabb& box : sample) {
      const double lower = 0.25 * box.lower.*coordinates[axis], upper = 0.25 * box.upper.*coordinates[axis];
      if (std::fabs(lower) <= most) places.push_back(lower);
      if (upper - lower <= most) sizes.push_back(upper - lower);
    }
    places_[axis] = spread_of(places, 0.99);
    sizes_[axis] = spread_of(sizes, 0.95);
  }
}

}  // namespace toccata
