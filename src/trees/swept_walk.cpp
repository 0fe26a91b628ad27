#include "trees/swept_walk.hpp"

#include <algorithm>
#include <cmath>

#include "math/constants.hpp"
#include "math/vec3_measures.hpp"

namespace toccata {
namespace {

constexpr double never = infinity;
/// A box is told from a single item by the item's own directions where it is no more than this part of it, along all
/// directions together.
constexpr double part_of_item = 0.5;
constexpr std::uint32_t lanes = WideBlock::width;

bool comes_later(const SweptFrontier::Entry& a, const SweptFrontier::Entry& b) {
  return a.time != b.time ? a.time > b.time : a.at > b.at;
}

Vec3 centre_of(const WideBlock& block, std::size_t lane) {
  return {block.centre[0][lane], block.centre[1][lane], block.centre[2][lane]};
}
Vec3 extent_of(const WideBlock& block, std::size_t lane) {
  return {block.extent[0][lane], block.extent[1][lane], block.extent[2][lane]};
}

/// From when on and until when eight boxes may be at one height with another one.
struct Passage {
  std::array<double, lanes> enter{};
  std::array<double, lanes> leave{};
};

/// What they are along one direction. A box that rises is one that stands while the other sinks: turned upside down it
/// is one that stands while the other rises.
void narrow(const WideBlock& block, Vec3 form, double offset, HeightRange other, const SweptDirection& d,
            Passage& passage) {
  const Vec3 size = magnitudes(form);
  for (std::size_t i = 0; i < lanes; ++i) {
    const double centre = ((form.x * block.centre[0][i] + form.y * block.centre[1][i]) +  //
                           form.z * block.centre[2][i]) +
                          offset;
    const double extent = (size.x * block.extent[0][i] + size.y * block.extent[1][i]) + size.z * block.extent[2][i];
    const double enter = (((centre - extent) - other.high) - d.pad) * d.per_speed;
    const double leave = (((centre + extent) - other.low) + d.pad) * d.per_speed;
    // What is not a number tells nothing.
    passage.enter[i] = enter > passage.enter[i] ? enter : passage.enter[i];
    passage.leave[i] = leave < passage.leave[i] ? leave : passage.leave[i];
  }
}

}  // namespace

bool SweptWalk::is_item(std::size_t side, std::uint32_t at) const {
  if (at == whole) return trees_[side] == nullptr;
  return trees_[side]->blocks[at / lanes].is_item(at % lanes);
}

Index SweptWalk::item(std::size_t side, std::uint32_t at) const {
  if (at == whole) return 0;
  return trees_[side]->items[trees_[side]->blocks[at / lanes].item_place(at % lanes)];
}

std::uint32_t SweptWalk::block_below(std::size_t side, std::uint32_t at) const {
  return at == whole ? 0 : static_cast<std::uint32_t>(trees_[side]->blocks[at / lanes].child[at % lanes]);
}

SweptWalk::Heights SweptWalk::heights(std::size_t side, std::uint32_t at) const {
  Heights heights;
  for (std::size_t i = 0; i < directions_.size(); ++i) {
    const SweptDirection& d = directions_[i];
    heights[i] = d.whole[side];
    if (at == whole) continue;
    const WideBlock& block = trees_[side]->blocks[at / lanes];
    const double centre = dot(d.form[side], centre_of(block, at % lanes)) + d.offset[side];
    const double extent = dot(magnitudes(d.form[side]), extent_of(block, at % lanes));
    heights[i] = {centre - extent, centre + extent};
  }
  return heights;
}

double SweptWalk::extent(const Heights& heights) const {
  double sum = 0;
  for (std::size_t i = 0; i < directions_.size(); ++i) sum += heights[i].high - heights[i].low;
  return sum;
}

/// The directions for the boxes of `side` and a single item that they are small beside; none for any others.
std::span<const SweptDirection> SweptWalk::directions_beside(const SweptFrontier::Entry& entry, std::size_t side,
                                                             const std::array<Heights, 2>& along) const {
  const std::size_t other = 1 - side;
  if (items_ == nullptr || !is_item(other, entry.at[other]) ||
      extent(along[side]) > part_of_item * extent(along[other]))
    return {};
  return items_->directions_beside(other, item(other, entry.at[other]));
}

SweptWalk::Times SweptWalk::times(std::size_t side, const WideBlock& block, const Heights& other,
                                  std::span<const SweptDirection> beside) const {
  Passage passage;
  passage.leave.fill(never);
  const auto look_along = [&](const SweptDirection& d, const HeightRange& range) {
    if (side == 1)
      narrow(block, d.form[1], d.offset[1], range, d, passage);
    else
      narrow(block, -d.form[0], -d.offset[0], {-range.high, -range.low}, d, passage);
  };
  for (std::size_t i = 0; i < directions_.size(); ++i) look_along(directions_[i], other[i]);
  for (const SweptDirection& d : beside) look_along(d, d.whole[1 - side]);
  Times times;
  for (std::size_t i = 0; i < lanes; ++i) {
    // Differences are rounded within the pad; the times themselves by less than this.
    const double enter = passage.enter[i] * (1 - 0x1p-50);
    times[i] = enter > passage.leave[i] * (1 + 0x1p-50) ? never : enter;
  }
  return times;
}

void SweptWalk::expand(const SweptFrontier::Entry& entry, double limit, SweptFrontier& frontier) const {
  const std::array<Heights, 2> along{heights(0, entry.at[0]), heights(1, entry.at[1])};
  const bool splits_first =
      is_item(1, entry.at[1]) || (!is_item(0, entry.at[0]) && extent(along[0]) > extent(along[1]));
  const std::size_t side = splits_first ? 0 : 1;
  const std::uint32_t number = block_below(side, entry.at[side]);
  const WideBlock& block = trees_[side]->blocks[number];
  const Times when = times(side, block, along[1 - side], directions_beside(entry, side, along));
  frontier.counts.volume_tests += block.count;
  for (std::uint32_t lane = 0; lane < block.count; ++lane) {
    if (when[lane] > limit) continue;
    SweptFrontier::Entry child{std::max(when[lane], entry.time), entry.at};
    child.at[side] = number * lanes + lane;
    frontier.waiting.push_back(child);
    std::push_heap(frontier.waiting.begin(), frontier.waiting.end(), comes_later);
  }
}

void SweptWalk::run(SweptFrontier& frontier, double limit, FunctionRef<double(ItemPair)> see) const {
  frontier.counts = {};
  frontier.waiting.assign(1, {0, {whole, whole}});
  while (!frontier.waiting.empty()) {
    std::pop_heap(frontier.waiting.begin(), frontier.waiting.end(), comes_later);
    const SweptFrontier::Entry next = frontier.waiting.back();
    frontier.waiting.pop_back();
    if (next.time > limit) return;
    if (!is_item(0, next.at[0]) || !is_item(1, next.at[1])) {
      expand(next, limit, frontier);
      continue;
    }
    ++frontier.counts.items;
    limit = std::min(limit, see({item(0, next.at[0]), item(1, next.at[1])}));
  }
}

}  // namespace toccata
