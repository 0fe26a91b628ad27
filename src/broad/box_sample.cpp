#include "broad/box_sample.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>

#include "broad/float_boxes.hpp"
#include "math/constants.hpp"
#include "math/vec3_coordinates.hpp"

namespace toccata {
namespace {

BoxSample::Spread spread_of(std::vector<double>& values, double high) {
  if (values.empty()) return {};
  auto from = values.begin();
  // Ranks ascend, and what is before the last one asked for is not gone through again.
  const auto at = [&](double rank) {
    const auto place = values.begin() + static_cast<std::ptrdiff_t>(rank * static_cast<double>(values.size() - 1));
    std::nth_element(from, place, values.end());
    from = place;
    return *place;
  };
  const double low = at(0.01), median = at(0.5), upper = at(high);
  return {low, median, upper, *std::max_element(from, values.end())};
}

}  // namespace

BoxSample::BoxSample(std::span<const Aabb> boxes) {
  constexpr std::size_t wanted = 1024;
  constexpr double most = std::numeric_limits<double>::max();
  std::vector<Aabb> sample;
  visit_sample(boxes.size(), wanted, [&](std::size_t i) {
    if (!is_empty(boxes[i])) sample.push_back(boxes[i]);
  });
  bounds_ = finite_bounds(sample);
  size_ = sample.size();
  std::vector<double> places, sizes;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    places.clear();
    sizes.clear();
    for (const Aabb& box : sample) {
      const double lower = 0.25 * box.lower.*vec3_coordinates[axis], upper = 0.25 * box.upper.*vec3_coordinates[axis];
      if (std::fabs(lower) <= most) places.push_back(lower);
      if (upper - lower <= most) sizes.push_back(upper - lower);
    }
    places_[axis] = spread_of(places, 0.99);
    sizes_[axis] = spread_of(sizes, 0.95);
  }
}

namespace {

/// All numbers below `count`, or about `wanted` of them, ascending.
std::vector<std::size_t> numbers_by_chance(std::size_t count, std::size_t wanted) {
  std::vector<std::size_t> numbers(std::min(count, wanted));
  if (count <= wanted) {
    std::iota(numbers.begin(), numbers.end(), std::size_t{0});
    return numbers;
  }
  Random random(count);
  for (std::size_t& number : numbers) number = random.below(count);
  std::sort(numbers.begin(), numbers.end());
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
  return numbers;
}

/// So many that their pairs are about as many as there are boxes: then as many of them are near each other, however
/// many there are, and looking at them takes as long as a look at all boxes.
std::vector<Aabb> few_of(std::span<const Aabb> boxes) {
  const auto wanted =
      static_cast<std::size_t>(std::clamp(1.25 * std::sqrt(static_cast<double>(boxes.size())), 64.0, 1024.0));
  std::vector<Aabb> few;
  for (const std::size_t i : numbers_by_chance(boxes.size(), wanted))
    if (!is_empty(boxes[i])) few.push_back(boxes[i]);
  return few;
}

/// About the cells that the grid would have.
struct CellsAbout {
  CellsAbout(const BoxSample& sample, double count) {
    double all = 1;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      size[axis] = std::min(sample.sizes(axis).most, 1.5 * sample.sizes(axis).high);
      range[axis] = sample.places(axis).high - sample.places(axis).low;
      cells[axis] = std::clamp(range[axis] / std::max(size[axis], 1e-300), 1.0, 0x1p20);
      all *= cells[axis];
    }
    const double larger = all > 1.5 * count ? std::cbrt(all / (1.5 * count)) : 1;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      cells[axis] = std::max(cells[axis] / larger, 1.0);
      size[axis] = cells[axis] > 1 ? range[axis] / cells[axis] : infinity;
    }
  }
  std::array<double, 3> size{}, range{}, cells{};
};

/// How many of those behind box `i` meet it along an axis; and counts for each whether it begins within `reach`, four
/// times. Without branches: which do is not to be foreseen.
double meetings_behind(std::span<const Aabb> boxes, std::size_t i, double Vec3::*at, double reach,
                       std::span<std::uint32_t> near_along) {
  const double lower = boxes[i].lower.*at, upper = boxes[i].upper.*at, place = 0.25 * lower;
  std::uint32_t meet = 0;
  for (std::size_t j = i + 1; j < boxes.size(); ++j) {
    const double other = boxes[j].lower.*at;
    meet += static_cast<std::uint32_t>(lower <= boxes[j].upper.*at) & static_cast<std::uint32_t>(other <= upper);
    // Written so that what is not a number is near.
    near_along[j] += static_cast<std::uint32_t>(!(std::fabs(place - 0.25 * other) > reach));
  }
  return meet;
}

}  // namespace

BoxDensity::BoxDensity(const BoxSample& sample, std::span<const Aabb> boxes) {
  const std::vector<Aabb> few = few_of(boxes);
  if (few.size() < 2) return;
  const CellsAbout about(sample, static_cast<double>(boxes.size()));
  std::array<double, 3> meets{};
  double nears = 0;
  std::vector<std::uint32_t> near_along(few.size());
  for (std::size_t i = 0; i < few.size(); ++i) {
    std::fill(near_along.begin(), near_along.end(), 0U);
    for (std::size_t axis = 0; axis < 3; ++axis)
      meets[axis] += meetings_behind(few, i, vec3_coordinates[axis], 1.5 * about.size[axis], near_along);
    nears += static_cast<double>(std::count(near_along.begin(), near_along.end(), 3U));
  }
  const auto size = static_cast<double>(few.size());
  const double pairs = 0.5 * size * (size - 1);
  swept = 0.5 * *std::min_element(meets.begin(), meets.end()) / pairs;
  near = 0.5 * nears / pairs;
  double evenly = 1;
  for (std::size_t axis = 0; axis < 3; ++axis) evenly *= std::min(1.0, 3 / about.cells[axis]);
  heaped = nears > 16 && nears / pairs > 4 * evenly;
  // A box that reaches over many cells is compared row by row.
  double rows_of_large = 0;
  for (const Aabb& box : few) {
    double rows = 1, most = 1;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double reach = 0.25 * box.upper.*vec3_coordinates[axis] - 0.25 * box.lower.*vec3_coordinates[axis];
      const double over = std::min(reach / about.size[axis], about.cells[axis]);
      most = std::max(most, over);
      if (axis < 2) rows *= over + 2;
    }
    if (most > 2) rows_of_large += std::min(rows, static_cast<double>(boxes.size()) / 16);
  }
  near += 20 * rows_of_large / size / static_cast<double>(boxes.size());
}

double least_size(const BoxSample& sample) {
  double least = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const BoxSample::Spread& places = sample.places(axis);
    least = std::max({least, 0x1p-28 * (places.high - places.low), 0x1p-46 * std::fabs(places.low),
                      0x1p-46 * std::fabs(places.high)});
  }
  return std::min(least, 0x1p1000);
}

}  // namespace toccata
