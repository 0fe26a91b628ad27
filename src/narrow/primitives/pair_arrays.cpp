#include "toccata/narrow/pair_arrays.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "narrow/boxes/box_corners.hpp"
#include "narrow/primitives/pair_distances.hpp"
#include "narrow/primitives/pair_kernels.hpp"
#include "toccata/core/error.hpp"

namespace toccata {
namespace {

/// The first of 24 in a BoxArray.
constexpr std::ptrdiff_t corner_columns = 17;

template <std::size_t Width>
std::array<const double*, Width> columns_of(const Columns<Width>& array) {
  std::array<const double*, Width> result;
  for (std::size_t i = 0; i < Width; ++i) result[i] = array.column(i);
  return result;
}

template <std::size_t WidthA, std::size_t WidthB>
void require_pairs(const Columns<WidthA>& a, const Columns<WidthB>& b) {
  if (a.size() == b.size()) return;
  throw Error(fmt::format("pairs need two arrays of one length; these have {} and {} shapes", a.size(), b.size()));
}

/// The kernel's answers; what it leaves open or did not reach is asked one by one.
template <std::size_t WidthA, std::size_t WidthB, class OneByOne>
std::vector<std::uint8_t> answers(PairKernel kernel, const Columns<WidthA>& a, const Columns<WidthB>& b,
                                  const OneByOne& one_by_one) {
  require_pairs(a, b);
  std::vector<std::uint8_t> result(a.size(), pair_unknown);
  const auto columns_a = columns_of(a);
  const auto columns_b = columns_of(b);
  kernel({columns_a.data(), columns_b.data(), a.size()}, result.data());
  const auto end = result.end();
  for (auto open = std::find(result.begin(), end, pair_unknown); open != end; open = std::find(open, end, pair_unknown))
    *open = one_by_one(static_cast<std::size_t>(open - result.begin())) ? pair_meets : pair_apart;
  return result;
}

/// The same for distances. Box corners are the last columns.
template <class ArrayA, class ArrayB>
std::vector<Distance> distances(DistanceKernel kernel, const ArrayA& a, const ArrayB& b,
                                std::ptrdiff_t first_of_b = 0) {
  require_pairs(a, b);
  std::vector<Distance> result(a.size());
  const auto columns_a = columns_of(a);
  const auto columns_b = columns_of(b);
  const std::size_t done = kernel({columns_a.data(), columns_b.data() + first_of_b, a.size()}, result.data());
  for (std::size_t i = 0; i < result.size(); ++i)
    if (i >= done || !is_known(result[i])) result[i] = distance(a[i], b[i]);
  return result;
}

}  // namespace

void BoxArray::append(const PosedBox& box) {
  const auto& [x, y, z] = box.half_axis;
  const BoxCorners corners = world_corners(box.shape, box.pose);
  std::array<double, 41> row{box.centre.x,
                             box.centre.y,
                             box.centre.z,
                             x.x,
                             x.y,
                             x.z,
                             y.x,
                             y.y,
                             y.z,
                             z.x,
                             z.y,
                             z.z,
                             box.inverse_squared.x,
                             box.inverse_squared.y,
                             box.inverse_squared.z,
                             box.size,
                             box.corner_slack};
  for (std::size_t axis = 0; axis < 3; ++axis)
    std::copy_n(corners.along()[axis], 8, row.begin() + corner_columns + 8 * static_cast<std::ptrdiff_t>(axis));
  append_row(row);
  box_.push_back(box);
}

std::vector<std::uint8_t> overlap_each(const SphereArray& a, const SphereArray& b) {
  return answers(pair_kernels().sphere_sphere, a, b, [&](std::size_t i) { return overlap(a[i], b[i]); });
}

std::vector<std::uint8_t> overlap_each(const SphereArray& a, const TriangleArray& b) {
  return answers(pair_kernels().sphere_triangle, a, b, [&](std::size_t i) { return overlap(a[i], b[i]); });
}

std::vector<std::uint8_t> overlap_each(const SphereArray& a, const BoxArray& b) {
  return answers(pair_kernels().sphere_box, a, b, [&](std::size_t i) { return overlap(a[i], b[i]); });
}

std::vector<std::uint8_t> overlap_each(const CapsuleArray& a, const CapsuleArray& b) {
  return answers(pair_kernels().capsule_capsule, a, b, [&](std::size_t i) { return overlap(a[i], b[i]); });
}

std::vector<std::uint8_t> overlap_each(const AlignedBoxArray& a, const AlignedBoxArray& b) {
  return answers(pair_kernels().box_box, a, b, [&](std::size_t i) {
    for (std::size_t axis = 0; axis < 3; ++axis)
      if (a.column(axis)[i] > b.column(axis + 3)[i] || b.column(axis)[i] > a.column(axis + 3)[i]) return false;
    return true;
  });
}

std::vector<Distance> distance_each(const SphereArray& a, const SphereArray& b) {
  return distances(distance_kernels().sphere_sphere, a, b);
}

std::vector<Distance> distance_each(const SphereArray& a, const TriangleArray& b) {
  return distances(distance_kernels().sphere_triangle, a, b);
}

std::vector<Distance> distance_each(const SphereArray& a, const BoxArray& b) {
  return distances(distance_kernels().sphere_box, a, b, corner_columns);
}

std::vector<Distance> distance_each(const CapsuleArray& a, const CapsuleArray& b) {
  return distances(distance_kernels().capsule_capsule, a, b);
}

}  // namespace toccata
