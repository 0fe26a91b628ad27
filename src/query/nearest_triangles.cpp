#include "query/nearest_triangles.hpp"

#include <cmath>

#include "narrow/gap_direction.hpp"
#include "narrow/within.hpp"
#include "query/nearest_elements.hpp"

namespace toccata {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// What is kept of every pair is an interval around its distance, of at most this relative width or from one double to
/// the next, that depends on the pair alone. The least of the upper ends is the distance of the meshes up to that
/// width, and the first pair that has it the nearest one, in whichever order they were found.
constexpr double interval_width = 0.99e-12;

/// Not when the upper end is infinite: nothing is known then.
bool is_narrow(double lower, double upper) { return upper - lower < 0.9 * interval_width * upper; }

void put(TrianglePairBlock::Corners& corners, std::size_t lane, const Triangle& triangle) {
  for (std::size_t i = 0; i < 3; ++i)
    for (int axis = 0; axis < 3; ++axis) corners[i][static_cast<std::size_t>(axis)][lane] = triangle.vertex[i][axis];
}

/// The upper end of a pair's interval, and the pair.
struct Key {
  double upper;
  ItemPair pair;
  bool operator<(const Key& other) const { return std::tie(upper, pair) < std::tie(other.upper, other.pair); }
};

}  // namespace

double limit_from(double upper) { return std::nextafter(upper * (1 + 4e-12), infinity); }

void PairDistances::bound_block(std::span<const ItemPair> pairs) {
  for (std::size_t lane = 0; lane < pairs.size(); ++lane) {
    const Triangle a = a_[pairs[lane].first], b = b_[pairs[lane].second];
    swapped_[lane] = !lexicographically_less(a[0], b[0]);
    put(block_.a, lane, swapped_[lane] ? b : a);
    put(block_.b, lane, swapped_[lane] ? a : b);
  }
  bound_gaps(block_, gaps_);
}

/// The triangles of a pair that do not meet: so it is told which comes first, and what is computed of them is the same
/// either way round.
std::pair<Triangle, Triangle> PairDistances::in_order(const ItemPair& pair) const {
  const Triangle x = a_[pair.first], y = b_[pair.second];
  return lexicographically_less(x[0], y[0]) ? std::pair(x, y) : std::pair(y, x);
}

Distance PairDistances::exact(const ItemPair& pair, ConvexWorkspace* kept) const {
  return distance(PosedConvex(a_[pair.first]), PosedConvex(b_[pair.second]), kept);
}

FrontGap PairDistances::gap_in(std::size_t lane, const NearCandidate& candidate) const {
  const GapDirection found = gap_direction(triangle_a(block_, lane), triangle_b(block_, lane), candidate.points);
  const Mat3& linear = a_.pose().linear;
  const Vec3 seen{dot(linear.column(0), found.direction), dot(linear.column(1), found.direction),
                  dot(linear.column(2), found.direction)};
  return {((swapped_[lane] ? -1 : 1) / std::sqrt(dot(seen, seen))) * seen, found.gap};
}

double PairDistances::upper_of(const NearCandidate& candidate) const {
  if (is_narrow(candidate.lower, candidate.upper)) return candidate.upper;
  const auto [x, y] = in_order(candidate.pair);
  const GapInterval precise = precise_gap(x, y, candidate.points);
  return is_narrow(precise.lower, precise.upper) ? precise.upper : exact(candidate.pair).upper;
}

bool PairDistances::is_within(const NearCandidate& candidate, double tolerance) const {
  if (candidate.upper <= tolerance) return true;
  if (candidate.lower > tolerance) return false;
  if (candidate.upper < infinity) {
    const auto [x, y] = in_order(candidate.pair);
    const GapInterval precise = precise_gap(x, y, candidate.points);
    if (precise.upper <= tolerance) return true;
    if (precise.lower > tolerance) return false;
  }
  return toccata::is_within(PosedConvex(a_[candidate.pair.first]), PosedConvex(b_[candidate.pair.second]), tolerance);
}

/// False when two meet.
bool NearestTriangles::keep(NearCandidate candidate) {
  if (candidate.lower > limit_) return true;
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

Distance NearestTriangles::nearest(ConvexWorkspace* kept) {
  Key best{infinity, {}};
  std::sort(candidates_.begin(), candidates_.end(),
            [](const NearCandidate& x, const NearCandidate& y) { return x.lower < y.lower; });
  constexpr std::size_t corners_ahead = 4, numbers_ahead = 8;
  for (std::size_t i = 0; i < candidates_.size(); ++i) {
    const NearCandidate& candidate = candidates_[i];
    if (candidate.lower > limit_) break;
    if (i + numbers_ahead < candidates_.size()) pairs_.prefetch_numbers(candidates_[i + numbers_ahead].pair);
    if (i + corners_ahead < candidates_.size()) pairs_.prefetch_corners(candidates_[i + corners_ahead].pair);
    const Key key{pairs_.upper_of(candidate), candidate.pair};
    limit_ = std::min(limit_, limit_from(key.upper));
    if (key < best) best = key;
  }
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
