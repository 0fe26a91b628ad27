#include "query/nearest/nearest_triangles.hpp"

#include <cmath>

#include "math/constants.hpp"
#include "narrow/triangles/gap_direction.hpp"
#include "query/nearest/nearest_elements.hpp"

namespace toccata {
namespace {

/// What is kept of every pair is an interval around its distance, of at most this relative width or from one double to
/// the next, that depends on the pair alone. The least of the upper ends is the distance of the meshes up to that
/// width, and the first pair that has it the nearest one, in whichever order they were found.
constexpr double interval_width = 0.99e-12;

/// Not when the upper end is infinite: nothing is known then.
bool is_narrow(double lower, double upper) { return upper - lower < 0.9 * interval_width * upper; }

}  // namespace

/// Which triangle of a pair comes first is told by the two alone, and so is what is computed of them, unless they meet.
void PairDistances::put(std::size_t lane, const ItemPair& pair) {
  const Triangle &a = a_.kept(pair.first), &b = b_.kept(pair.second);
  swapped_[lane] = !lexicographically_less(a[0], b[0]);
  set_pair(block_, lane, swapped_[lane] ? b : a, swapped_[lane] ? a : b);
}

void PairDistances::bound_block(std::span<const ItemPair> pairs) {
  for (std::size_t lane = 0; lane < pairs.size(); ++lane) put(lane, pairs[lane]);
  bound_gaps(block_, gaps_);
}

Distance PairDistances::exact(const ItemPair& pair, SimplexCache* kept) const {
  return distance(PosedPolytope(a_[pair.first]), PosedPolytope(b_[pair.second]), kept);
}

FrontGap PairDistances::gap_in(std::size_t lane, const NearCandidate& candidate) const {
  const GapDirection found = gap_direction(triangle_a(block_, lane), triangle_b(block_, lane), candidate.points);
  const Mat3& linear = a_.pose().linear;
  const Vec3 seen{dot(linear.column(0), found.direction), dot(linear.column(1), found.direction),
                  dot(linear.column(2), found.direction)};
  return {((swapped_[lane] ? -1 : 1) / std::sqrt(dot(seen, seen))) * seen, found.gap};
}

/// Tries every feature on those of the first lanes of a refined block that are still too wide: which features are
/// nearest may hang on digits that doubles do not have, and another direction then tells more. Each lane is left alone
/// once it is narrow, so that none depends on its neighbours.
void PairDistances::try_all_features(std::size_t count) {
  constexpr int feature_count = 15;
  TriangleGaps best = gaps_;
  const auto is_wide = [&](std::size_t lane) { return !is_narrow(best.lower[lane], best.upper[lane]); };
  for (int features = 0; features < feature_count; ++features) {
    std::size_t wide = 0;
    for (std::size_t lane = 0; lane < count; ++lane) {
      wide += is_wide(lane) ? 1 : 0;
      gaps_.set_points(lane, {static_cast<double>(features), 1.0 / 3, 1.0 / 3});
    }
    if (wide == 0) break;
    refine_gaps(block_, gaps_);
    for (std::size_t lane = 0; lane < count; ++lane) {
      if (!is_wide(lane)) continue;
      best.lower[lane] = std::max(best.lower[lane], gaps_.lower[lane]);
      best.upper[lane] = std::min(best.upper[lane], gaps_.upper[lane]);
    }
  }
  gaps_ = best;
}

TriangleGaps::Lanes PairDistances::uppers_of(std::span<const NearCandidate> candidates, Effort effort) {
  TriangleGaps::Lanes uppers{};
  bool all_narrow = true;
  for (std::size_t lane = 0; lane < candidates.size(); ++lane) {
    uppers[lane] = candidates[lane].upper;
    all_narrow = all_narrow && is_narrow(candidates[lane].lower, candidates[lane].upper);
  }
  if (all_narrow) return uppers;
  for (const NearCandidate& candidate : candidates) prefetch_corners(candidate.pair);
  for (std::size_t lane = 0; lane < candidates.size(); ++lane) {
    put(lane, candidates[lane].pair);
    gaps_.set_points(lane, candidates[lane].points);
  }
  refine_gaps(block_, gaps_);
  if (effort == Effort::whole) try_all_features(candidates.size());
  for (std::size_t lane = 0; lane < candidates.size(); ++lane) {
    if (is_narrow(candidates[lane].lower, candidates[lane].upper)) continue;
    if (is_narrow(gaps_.lower[lane], gaps_.upper[lane]))
      uppers[lane] = gaps_.upper[lane];
    else
      uppers[lane] = effort == Effort::whole ? exact(candidates[lane].pair).upper : infinity;
  }
  return uppers;
}

PairDistances::Ends PairDistances::precise_ends(const NearCandidate& candidate) const {
  TrianglePairBlock block{};
  TriangleGaps gaps{};
  const Triangle x = a_[candidate.pair.first], y = b_[candidate.pair.second];
  const bool in_order = lexicographically_less(x[0], y[0]);
  set_pair(block, 0, in_order ? x : y, in_order ? y : x);
  gaps.set_points(0, candidate.points);
  refine_gaps(block, gaps);
  return {gaps.lower[0], gaps.upper[0]};
}

bool PairDistances::is_within(const NearCandidate& candidate, double tolerance) const {
  if (candidate.upper <= tolerance) return true;
  if (candidate.lower > tolerance) return false;
  if (candidate.upper < infinity) {
    const Ends precise = precise_ends(candidate);
    if (precise.upper <= tolerance) return true;
    if (precise.lower > tolerance) return false;
  }
  return nearby(PosedPolytope(a_[candidate.pair.first]), PosedPolytope(b_[candidate.pair.second]),
                WantedDistance::within(tolerance))
      .has_value();
}

/// False when nothing more is wanted.
bool NearestTriangles::keep(NearCandidate candidate) {
  if (candidate.lower > limit_) return true;
  if (wanted_.enough >= 0) {
    if (pairs_.is_within(candidate, wanted_.enough)) {
      near_enough_ = candidate.pair;
      limit_ = -1;
      return false;
    }
    if (wanted_.is_yes_or_no()) return true;
  }
  if (candidate.lower == 0 && pairs_.meet(candidate.pair)) {
    limit_ = -1;
    return false;
  }
  if (candidate.upper == infinity) {
    const Distance found = pairs_.exact(candidate.pair);
    candidate.lower = found.lower;
    candidate.upper = found.upper;
  }
  limit_ = std::min(limit_, limit_from(candidate.upper));
  if (!(candidate.lower > limit_)) candidates_.push_back(candidate);
  return true;
}

/// The least of some candidates, but for those that it adds to `untold`.
NearestTriangles::Key NearestTriangles::least_of(std::span<const NearCandidate> candidates,
                                                 PairDistances::Effort effort, std::vector<NearCandidate>& untold) {
  Key least;
  std::array<NearCandidate, TrianglePairBlock::lanes> block;
  std::size_t count = 0;
  const auto see_block = [&] {
    const TriangleGaps::Lanes uppers = pairs_.uppers_of(std::span(block).first(count), effort);
    for (std::size_t i = 0; i < count; ++i)
      if (uppers[i] == infinity)
        untold.push_back(block[i]);
      else
        least = std::min(least, Key{uppers[i], block[i].pair});
    limit_ = std::min(limit_, limit_from(least.upper));
    count = 0;
  };
  for (const NearCandidate& candidate : candidates) {
    if (candidate.lower > limit_) continue;
    pairs_.prefetch_numbers(candidate.pair);
    block[count++] = candidate;
    if (count == block.size()) see_block();
  }
  see_block();
  return least;
}

/// The least of all. Those that seem to be nearest come first, so that the limit soon leaves out what it can, and those
/// that take more come together.
NearestTriangles::Key NearestTriangles::least() {
  const auto first =
      candidates_.begin() + static_cast<std::ptrdiff_t>(std::min(TrianglePairBlock::lanes, candidates_.size()));
  std::nth_element(candidates_.begin(), first, candidates_.end(),
                   [](const NearCandidate& x, const NearCandidate& y) { return x.lower < y.lower; });
  std::vector<NearCandidate> untold, none;
  const Key least = least_of(candidates_, PairDistances::Effort::first, untold);
  return untold.empty() ? least : std::min(least, least_of(untold, PairDistances::Effort::whole, none));
}

Distance NearestTriangles::nearest(SimplexCache* kept) {
  if (near_enough_)
    return {.upper = wanted_.enough, .element_a = near_enough_->first, .element_b = near_enough_->second};
  const Key best = least();
  Distance result = pairs_.exact(best.pair, kept);
  result.upper = std::min(result.upper, best.upper);
  result.lower = lower_from(result.upper);
  result.element_a = best.pair.first;
  result.element_b = best.pair.second;
  return result;
}

bool NearestTriangles::any_within(double tolerance) const {
  return std::any_of(candidates_.begin(), candidates_.end(),
                     [&](const NearCandidate& candidate) { return pairs_.is_within(candidate, tolerance); });
}

}  // namespace toccata
