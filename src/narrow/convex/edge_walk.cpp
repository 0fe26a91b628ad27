#include "narrow/convex/edge_walk.hpp"

#include <algorithm>
#include <cmath>

#include "math/constants.hpp"
#include "math/vec3_measures.hpp"
#include "shapes/hull_guide.hpp"

// Let E bound what any rounded height is off by: with u = 2^-53, three products and two sums are off by 3.01u
// Σ|d_i||x_i|, and by 2^-1073 where products underflow. If y is as low as x by rounded heights, then exactly both are
// no higher than the rounded height of x plus E; the vertices down there hang together; and their rounded heights are
// at most 2E above that of x. Sums below are rounded themselves, by less than u times the reach, and so take another E.
namespace toccata {
namespace {}  // namespace

EdgeWalk::EdgeWalk(const PosedPolytope& hull, const SupportScan& scan)
    : scan_(scan),
      topology_(hull.topology()),
      extent_(hull.stored_extent()),
      reach_(extent_ * sum_of_magnitudes(scan.direction)),
      error_(0x1p-51 * reach_ + 0x1p-1060),
      budget_(128 + scan.count / 8) {
  // Otherwise heights may be infinite, or none.
  if (!(reach_ < 0x1p1000) || topology_.origin.empty()) budget_ = 0;
}

double EdgeWalk::height(Index i) const {
  const Vec3& d = scan_.direction;
  return (d.x * scan_.x[i] + d.y * scan_.y[i]) + d.z * scan_.z[i];
}

double EdgeWalk::depth(Index i) const {
  const Vec3& s = scan_.spread;
  const double own = (s.x * std::fabs(scan_.x[i]) + s.y * std::fabs(scan_.y[i])) + s.z * std::fabs(scan_.z[i]);
  return height(i) - own;
}

bool EdgeWalk::is_low(Index i) const {
  const auto end = low_.begin() + static_cast<std::ptrdiff_t>(low_count_);
  return std::find(low_.begin(), end, i) != end;
}

template <class Visit>
void EdgeWalk::visit_neighbours(Index vertex, Visit visit) {
  const Index first = topology_.leaving[vertex];
  Index edge = first;
  do {
    const Index twin = topology_.twin[edge], neighbour = topology_.origin[twin];
    visit(neighbour, height(neighbour));
    ++heights_;
    edge = topology_.next(twin);
  } while (edge != first && !is_spent());
}

Index EdgeWalk::lower_start(Index start) {
  if (topology_.guide.empty()) return start;
  const Index guided = topology_.guide[guide_cell(-scan_.direction, topology_.guide.size())];
  heights_ += 2;
  return height(guided) < height(start) ? guided : start;
}

bool EdgeWalk::descend(Index start) {
  if (budget_ == 0) return false;
  lowest_ = lower_start(start);
  lowest_height_ = height(lowest_);
  while (!is_spent()) {
    Index next = lowest_;
    rim_ = infinity;
    visit_neighbours(lowest_, [&](Index neighbour, double its_height) {
      next = its_height < rim_ ? neighbour : next;
      rim_ = std::min(rim_, its_height);
    });
    if (!(rim_ < lowest_height_)) return !is_spent();
    lowest_ = next;
    lowest_height_ = rim_;
  }
  return false;
}

bool EdgeWalk::find_low(double level) {
  low_[0] = lowest_;
  low_count_ = 1;
  const double bound = std::max(level, lowest_height_ + error_) + 2 * error_;
  if (rim_ > bound) return true;
  bool fits = true;
  for (std::size_t i = 0; i < low_count_ && fits; ++i)
    visit_neighbours(low_[i], [&](Index neighbour, double its_height) {
      if (!(its_height <= bound) || is_low(neighbour)) return;
      fits = low_count_ < most_low;
      if (fits) low_[low_count_++] = neighbour;
    });
  return fits && !is_spent();
}

/// All vertices whose depth may be no more than the bound.
bool EdgeWalk::find_as_deep(double bound) {
  const double spread = (1 + 0x1p-50) * (extent_ * sum_of_magnitudes(scan_.spread));
  return find_low((bound + spread) + (0x1p-50 * (std::fabs(bound) + spread) + error_));
}

std::optional<Index> EdgeWalk::least(Index start) {
  if (!descend(start) || !find_low(lowest_height_)) return {};
  Index best = lowest_;
  double least = lowest_height_;
  for (std::size_t i = 1; i < low_count_; ++i) {
    const double other = height(low_[i]);
    if (other > least || (other == least && low_[i] > best)) continue;
    best = low_[i];
    least = other;
  }
  return best;
}

std::optional<double> EdgeWalk::least_depth(Index start) {
  if (!descend(start) || !find_as_deep(depth(lowest_))) return {};
  double least = infinity;
  for (std::size_t i = 0; i < low_count_; ++i) least = std::min(least, depth(low_[i]));
  return least;
}

std::optional<Index> EdgeWalk::close(double bound, std::span<const Index> own, std::span<Index> found, Index start) {
  if (!descend(start) || !find_as_deep(bound)) return {};
  const auto end = low_.begin() + static_cast<std::ptrdiff_t>(low_count_);
  const auto is_left_out = [&](Index i) { return depth(i) > bound || std::ranges::find(own, i) != own.end(); };
  const auto close_end = std::remove_if(low_.begin(), end, is_left_out);
  std::sort(low_.begin(), close_end);
  const std::size_t count = static_cast<std::size_t>(close_end - low_.begin());
  std::copy_n(low_.begin(), std::min(count, found.size()), found.begin());
  return static_cast<Index>(count);
}

}  // namespace toccata
