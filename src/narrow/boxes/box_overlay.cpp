// Compiled once for every SIMD level; Highway includes this file into itself.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "narrow/boxes/box_overlay.cpp"
#include <hwy/foreach_target.h>

#include <bit>
#include <cmath>

#include "narrow/boxes/box_overlay.hpp"
#include "narrow/convex/rows.hpp"

// The four sides of the parallelogram are clipped against the rectangle at once, one in each lane, by the shares of
// their length at which they cross its four lines (M. Cyrus, J. Beck, "Generalized two- and three-dimensional
// clipping", 1978); and the rectangle's four corners are located in the parallelogram. A corner on a border may be
// counted for two or three of the sixteen places; whatever comes near a border at all says that there may be doubles.
HWY_BEFORE_NAMESPACE();
namespace toccata {
namespace HWY_NAMESPACE {
namespace {

/// A gap of this part of the size of the contact still belongs to it, so that a resting box keeps its four points.
constexpr double gap_of_resting_boxes = 0x1p-10;

alignas(32) constexpr double sign_x[4] = {-1, 1, 1, -1};
alignas(32) constexpr double sign_y[4] = {-1, -1, 1, 1};
alignas(32) constexpr double way_x[4] = {2, 0, -2, 0};
alignas(32) constexpr double way_y[4] = {0, 2, 0, -2};

/// For the sides, along one axis: the shares of their length within which they are between its two lines.
struct SideShares {
  Row enter, leave;
  RowMask starts_within, goes_up;
};

HWY_INLINE SideShares shares_of(const Row& start, const Row& way, double limit, double parallel) {
  const Row lines = row_of(limit), length = magnitude(way), zero = row_of(0);
  const RowMask within = magnitude(start) <= lines, goes_up = zero < way, is_parallel = length <= row_of(parallel);
  const Row towards = select(goes_up, start, zero - start);
  SideShares shares;
  shares.enter = select(is_parallel, select(within, row_of(-1), row_of(3)), (zero - lines - towards) / length);
  shares.leave = select(is_parallel, row_of(2), (lines - towards) / length);
  shares.starts_within = within;
  shares.goes_up = goes_up;
  return shares;
}

HWY_INLINE RowMask is_within(const Row& value, double limit) { return magnitude(value) <= row_of(limit); }

/// Places of four of a kind.
HWY_INLINE void put(BoxOverlay& overlay, std::size_t first, const Row& x, const Row& y, const Row& gap,
                    const RowMask& taken) {
  store(x, overlay.x.data() + first);
  store(y, overlay.y.data() + first);
  store(gap, overlay.gap.data() + first);
  overlay.points |= bits_of(taken) << first;
}

/// The rectangle's corners in the parallelogram; whether one comes near its border.
HWY_INLINE bool put_corners(BoxOverlay& overlay, const SeenFace& face, double border) {
  const Vec3 &p = face.along_x, &q = face.along_y;
  const double area = p.x * q.y - p.y * q.x, inverse = 1 / area;
  const Row x = face.width * load(sign_x), y = face.height * load(sign_y);
  const Row from_x = x - row_of(face.centre.x), from_y = y - row_of(face.centre.y);
  const Row s = inverse * (q.y * from_x - q.x * from_y), t = inverse * (p.x * from_y - p.y * from_x);
  const Row gap = row_of(face.centre.z) + (p.z * s + q.z * t), one = row_of(1);
  put(overlay, BoxOverlay::first_corner, x, y, gap, is_within(s, 1) & is_within(t, 1));
  const double of_length = border * std::fabs(inverse);
  const RowMask near = is_within(magnitude(s) - one, of_length * (std::fabs(q.x) + std::fabs(q.y))) |
                       is_within(magnitude(t) - one, of_length * (std::fabs(p.x) + std::fabs(p.y)));
  return bits_of(near) != 0;
}

/// Four numbers at each of four places.
struct Sixteen {
  Row row[BoxOverlay::capacity / 4];
};

HWY_INLINE Sixteen sixteen(const std::array<double, BoxOverlay::capacity>& from) {
  return {{load(from.data()), load(from.data() + 4), load(from.data() + 8), load(from.data() + 12)}};
}

/// A number for each row, by its place.
template <class Function>
HWY_INLINE Sixteen each_row(const Function& function) {
  return {{function(0), function(1), function(2), function(3)}};
}

template <class Function>
HWY_INLINE unsigned each_bits(const Function& function) {
  return bits_of(function(0)) | bits_of(function(1)) << 4 | bits_of(function(2)) << 8 | bits_of(function(3)) << 12;
}

HWY_INLINE RowMask row_mask_of(unsigned bits) {
  return each_mask([&](std::size_t k) {
    const std::uint8_t few[8] = {static_cast<std::uint8_t>(bits >> (k * row_lanes) & ((1U << row_lanes) - 1))};
    return hn::LoadMaskBits(row_tag, few);
  });
}

/// The least of all, in every lane.
HWY_INLINE Row least_of(const Sixteen& values) {
  const Row least = lesser(lesser(values.row[0], values.row[1]), lesser(values.row[2], values.row[3]));
  hn::Vec<RowTag> here = least.part[0];
  for (std::size_t k = 1; k < row_parts; ++k) here = hn::Min(here, least.part[k]);
  here = hn::MinOfLanes(row_tag, here);
  return each([&](std::size_t) { return here; });
}

struct FoundPlace {
  unsigned place;
  double value;
};

/// The least value and its place, of equals the first.
HWY_INLINE FoundPlace found_least(const Sixteen& values) {
  const Row least = least_of(values);
  const unsigned bits = each_bits([&](std::size_t k) { return values.row[k] == least; });
  return {static_cast<unsigned>(std::countr_zero(bits | 1U << 15)), hn::GetLane(least.part[0])};
}

/// The greatest way between the first candidate and another is the size of a contact.
unsigned resting_candidates(const BoxOverlay& overlay) {
  const auto first = static_cast<std::size_t>(std::countr_zero(overlay.points));
  double span = 0;
  for (unsigned left = overlay.points & (overlay.points - 1); left != 0; left &= left - 1) {
    const auto i = static_cast<std::size_t>(std::countr_zero(left));
    const double x = overlay.x[i] - overlay.x[first], y = overlay.y[i] - overlay.y[first], squared = x * x + y * y;
    span = squared > span ? squared : span;
  }
  const Row limit = row_of(gap_of_resting_boxes * std::sqrt(span));
  return overlay.points & each_bits([&](std::size_t k) { return load(overlay.gap.data() + 4 * k) <= limit; });
}

/// The candidates, but only the first of those within the tolerance of each other.
unsigned without_doubles(const BoxOverlay& overlay, unsigned candidates) {
  const double tolerance = 0x1p-42 * overlay.size;
  unsigned kept = 0;
  for (unsigned left = candidates; left != 0; left &= left - 1) {
    const auto i = static_cast<std::size_t>(std::countr_zero(left));
    const auto is_same = [&](std::size_t k) {
      const Row x = load(overlay.x.data() + 4 * k) - row_of(overlay.x[i]);
      const Row y = load(overlay.y.data() + 4 * k) - row_of(overlay.y[i]);
      return is_within(x, tolerance) & is_within(y, tolerance);
    };
    if ((each_bits(is_same) & kept) == 0) kept |= 1U << i;
  }
  return kept;
}

/// Up to four, without a loop whose length would have to be guessed.
HWY_INLINE ChosenPlaces all_of(unsigned candidates) {
  const auto first_of = [](unsigned bits) { return static_cast<std::uint8_t>(std::countr_zero(bits | 1U << 15)); };
  const unsigned second = candidates & (candidates - 1), third = second & (second - 1), fourth = third & (third - 1);
  return {{first_of(candidates), first_of(second), first_of(third), first_of(fourth)},
          static_cast<std::size_t>(std::popcount(candidates))};
}

ChosenPlaces four_of(const BoxOverlay& overlay, unsigned candidates) {
  ChosenPlaces chosen{};
  const auto take = [&](unsigned place) { chosen.place[chosen.count++] = static_cast<std::uint8_t>(place); };
  const RowMask taken[4] = {row_mask_of(candidates), row_mask_of(candidates >> 4), row_mask_of(candidates >> 8),
                            row_mask_of(candidates >> 12)};
  const Sixteen x = sixteen(overlay.x), y = sixteen(overlay.y), gap = sixteen(overlay.gap);
  const unsigned deepest =
      found_least(each_row([&](std::size_t k) { return select(taken[k], gap.row[k], row_of(0x1p1000)); })).place;
  take(deepest);
  const Row deepest_x = row_of(overlay.x[deepest]), deepest_y = row_of(overlay.y[deepest]), zero = row_of(0);
  const Sixteen from_x = each_row([&](std::size_t k) { return x.row[k] - deepest_x; });
  const Sixteen from_y = each_row([&](std::size_t k) { return y.row[k] - deepest_y; });
  const unsigned farthest = found_least(each_row([&](std::size_t k) {
                              const Row squared = from_x.row[k] * from_x.row[k] + from_y.row[k] * from_y.row[k];
                              return select(taken[k], zero - squared, row_of(1));
                            })).place;
  take(farthest);
  const double far_x = overlay.x[farthest] - overlay.x[deepest], far_y = overlay.y[farthest] - overlay.y[deepest];
  const Sixteen aside =
      each_row([&](std::size_t k) { return select(taken[k], far_x * from_y.row[k] - far_y * from_x.row[k], zero); });
  const FoundPlace left = found_least(each_row([&](std::size_t k) { return zero - aside.row[k]; }));
  const FoundPlace right = found_least(aside);
  if (left.value < 0) take(left.place);
  if (right.value < 0) take(right.place);
  if (chosen.count != 3) return chosen;
  const unsigned third = chosen.place[2];
  const double turn = left.value < 0 ? -1 : 1;
  const FoundPlace fourth = found_least(each_row(
      [&](std::size_t k) { return select(row_mask_of((1U << third) >> (4 * k)), zero, turn * aside.row[k]); }));
  if (fourth.value < 0) take(fourth.place);
  return chosen;
}

}  // namespace

BoxOverlay overlay_at_level(const SeenFace& face) {
  const Vec3 &c = face.centre, &p = face.along_x, &q = face.along_y;
  BoxOverlay overlay;
  overlay.size = face.width + face.height;
  const double border = 0x1p-36 * overlay.size, parallel = 0x1p-60 * overlay.size;
  const Row to_x = load(sign_x), to_y = load(sign_y), along_x = load(way_x), along_y = load(way_y);
  const auto corners = [&](double middle, double half_x, double half_y) {
    return row_of(middle) + (half_x * to_x + half_y * to_y);
  };
  const Row x = corners(c.x, p.x, q.x), y = corners(c.y, p.y, q.y), gap = corners(c.z, p.z, q.z);
  const Row side_x = p.x * along_x + q.x * along_y, side_y = p.y * along_x + q.y * along_y;
  const SideShares in_x = shares_of(x, side_x, face.width, parallel),
                   in_y = shares_of(y, side_y, face.height, parallel);
  put(overlay, 0, x, y, gap, in_x.starts_within & in_y.starts_within);
  overlay.may_have_doubles = false;
  if (overlay.points == 0xF) {
    for (std::size_t k = 1; k < 4; ++k) store(gap, overlay.gap.data() + 4 * k);
    return overlay;
  }
  // The end of a side may lie beyond a line by rounding alone.
  const Row side_gap = p.z * along_x + q.z * along_y, zero = row_of(0), end = row_of(1 + 0x1p-50);
  const Row enter = greater(in_x.enter, in_y.enter), leave = lesser(in_x.leave, in_y.leave);
  const RowMask crosses = enter <= leave;
  put(overlay, BoxOverlay::first_entry, x + enter * side_x, y + enter * side_y, gap + enter * side_gap,
      crosses & (zero < enter) & (enter <= end));
  put(overlay, BoxOverlay::first_exit, x + leave * side_x, y + leave * side_y, gap + leave * side_gap,
      crosses & (zero < leave) & (leave <= end));
  overlay.enters_along_x = bits_of(in_y.enter <= in_x.enter);
  overlay.leaves_along_x = bits_of(in_x.leave <= in_y.leave);
  overlay.goes_up_x = bits_of(in_x.goes_up);
  overlay.goes_up_y = bits_of(in_y.goes_up);
  const bool has_corner_near = put_corners(overlay, face, border);
  const RowMask near =
      is_within(magnitude(x) - row_of(face.width), border) | is_within(magnitude(y) - row_of(face.height), border);
  overlay.may_have_doubles = has_corner_near || bits_of(near) != 0;
  return overlay;
}

ChosenPlaces chosen_at_level(const BoxOverlay& overlay) {
  if (overlay.points == 0) return {{}, 0};
  const Row zero = row_of(0), resting = row_of(2 * gap_of_resting_boxes * overlay.size);
  const auto gap = [&](std::size_t k) { return load(overlay.gap.data() + 4 * k); };
  unsigned candidates = overlay.points & each_bits([&](std::size_t k) { return gap(k) <= zero; });
  const unsigned at_most = overlay.points & each_bits([&](std::size_t k) { return gap(k) <= resting; });
  if (candidates != at_most) candidates = resting_candidates(overlay);
  if (overlay.may_have_doubles) candidates = without_doubles(overlay, candidates);
  return std::popcount(candidates) <= 4 ? all_of(candidates) : four_of(overlay, candidates);
}

}  // namespace HWY_NAMESPACE
}  // namespace toccata
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace toccata {

HWY_EXPORT(overlay_at_level);
HWY_EXPORT(chosen_at_level);

BoxOverlay overlay_of(const SeenFace& face) { return HWY_DYNAMIC_DISPATCH(overlay_at_level)(face); }
ChosenPlaces chosen_places(const BoxOverlay& overlay) { return HWY_DYNAMIC_DISPATCH(chosen_at_level)(overlay); }

}  // namespace toccata
#endif
