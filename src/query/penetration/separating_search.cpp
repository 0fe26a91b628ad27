#include "query/penetration/separating_search.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <queue>
#include <utility>

namespace toccata {
namespace {

constexpr std::size_t first_seeds = 8, more_seeds = 3;
constexpr std::size_t most_cells = 6000;
constexpr double finest_share = 0.04;   // half-edge of a cell, of its way from no translation
constexpr double first_stretch = 1.06;  // beyond the way out of two bodies, where other bodies are in the way

/// Nearest first; of equally near ones the order does not depend on how they came about.
struct Farther {
  bool operator()(const TranslationCell& s, const TranslationCell& t) const {
    const double near_s = s.nearest(), near_t = t.nearest();
    return near_s != near_t ? near_s > near_t : lexicographically_less(t.centre, s.centre);
  }
};

using TranslationCells = std::priority_queue<TranslationCell, std::vector<TranslationCell>, Farther>;

void split(const TranslationCell& cell, TranslationCells& cells) {
  const double half = cell.half / 2;
  for (int i = 0; i < 8; ++i) {
    const Vec3 away{(i & 1) != 0 ? half : -half, (i & 2) != 0 ? half : -half, (i & 4) != 0 ? half : -half};
    cells.push({cell.centre + away, half});
  }
}

Index triangle_count(const SolidBody& body) {
  Index count = 0;
  for (const PosedPart& part : body.parts())
    if (const auto* triangles = std::get_if<PosedTriangles>(&part.shape))
      count += triangles->mesh.model().element_count();
  return count;
}

/// Rounds in which bodies are grown after the first: fewer where every body takes long.
std::size_t most_rounds(const SolidBody& a, const SolidBody& b) {
  constexpr std::size_t most = 16, fewest = 2, most_triangles = 1U << 18U;
  return std::clamp(most_triangles / (triangle_count(a) + triangle_count(b) + std::size_t{1}), fewest, most);
}

Vec3 unit_along(const Vec3& v) { return (1 / std::sqrt(dot(v, v))) * v; }

}  // namespace

SeparatingSearch::SeparatingSearch(SolidBody& a, SolidBody& b, const SeparatingQuestions& questions,
                                   const DepthLimit& limit)
    : a_(a),
      b_(b),
      questions_(questions),
      limit_(limit),
      extent_(a.extent() + b.extent()),
      tried_(questions, limit, extent_),
      cover_(extent_) {}

void SeparatingSearch::try_along(const Vec3& direction, double length) {
  // Beyond the surface by what `parted` wants to see between the two, were they at 5 degrees to the direction.
  if (tried_.attempt(direction, length + 16 * tried_.slack(length))) return;
  for (double stretch = first_stretch; length * stretch < best_.upper && !limit_.is_over(); stretch *= stretch)
    if (tried_.attempt(direction, length * stretch)) return tried_.shorten(4);
}

/// Looks for a shorter way in directions around the best one.
void SeparatingSearch::turn() {
  constexpr double least_gain = 0.99, widest = 0.5, narrowest = 0.02;
  for (double angle = widest; angle > narrowest && !is_done(); angle /= 2) {
    const Vec3 along = best_.direction;
    const Vec3 side = unit_along(cross(along, std::abs(along.x) < 0.5 ? Vec3{1, 0, 0} : Vec3{0, 1, 0}));
    const Vec3 other = cross(along, side);
    for (const auto& [x, y] : {std::pair{1, 0}, {-1, 0}, {0, 1}, {0, -1}, {1, 1}, {1, -1}, {-1, 1}, {-1, -1}}) {
      const Vec3 turned = unit_along(along + (angle * x) * side + (angle * y) * other);
      if (tried_.attempt(turned, least_gain * best_.upper)) break;
    }
  }
}

void SeparatingSearch::add(const InnerPair& pair) {
  if (pair.a == nullptr || pair.b == nullptr) return;
  cover_.add(pair);
  const Penetration depth = depth_between(*pair.a, *pair.b);
  if (depth.lower > of_pairs_) of_pairs_ = depth.lower;
  best_.lower = std::max(best_.lower, std::min(of_pairs_, best_.upper));
  if (depth.lower > 0 && depth.lower >= best_.lower / 2) try_along(depth.direction, depth.upper);
}

/// Adds pairs of bodies around points inside both when B is moved; returns how many.
std::size_t SeparatingSearch::add_parts(const Vec3& move, std::size_t most) {
  std::size_t added = 0;
  for (const SeparatingSeed& seed : find_seeds({a_, b_, move}, questions_.intersections(move), most))
    for (const CutBy cut : {CutBy::own_plane, CutBy::nearest_point}) {
      const InnerPair pair{a_.grow(seed.point, reach_, cut), b_.grow(seed.point - move, reach_, cut)};
      if (pair.a == nullptr || pair.b == nullptr) continue;
      ++added;
      add(pair);
      if (is_done()) return added;
    }
  return added;
}

/// A cell that is as small as it gets and not covered: is there a way out in it? Otherwise bodies are grown that tell
/// why not. Returns whether it is covered now.
bool SeparatingSearch::settle(const TranslationCell& cell) {
  const double length = std::sqrt(dot(cell.centre, cell.centre));
  if (length > 0 && tried_.attempt((1 / length) * cell.centre, length)) return false;
  return add_parts(cell.centre, more_seeds) > 0 && cover_.covers(cell);
}

void SeparatingSearch::cover() {
  TranslationCells cells;
  cells.push({{}, best_.upper});
  std::size_t rounds_left = most_rounds(a_, b_);
  for (std::size_t looked_at = 0; looked_at < most_cells && !is_done(); ++looked_at) {
    const TranslationCell cell = cells.top();
    const double near = cell.nearest();
    best_.lower = std::max(best_.lower, std::min(near, best_.upper));
    if (near >= best_.upper) return;
    cells.pop();
    if (cell.farthest() <= of_pairs_ || cover_.covers(cell)) continue;
    if (cell.half > finest_share * std::max(near, of_pairs_))
      split(cell, cells);
    else if (rounds_left-- == 0 || !settle(cell))
      return;
  }
}

Penetration SeparatingSearch::answer(const Penetration& known) {
  best_ = penetration(a_.outer(), b_.outer());
  // The hulls part after it, in exact arithmetic; for the world doubles a little more.
  for (double more = tried_.slack(best_.upper) + least_step; !tried_.parted(best_.upper * best_.direction); more *= 2)
    best_.upper += more;
  of_pairs_ = known.lower;
  best_.lower = std::min(known.lower, best_.upper);
  if (known.upper < best_.upper) {
    best_.upper = known.upper;
    best_.direction = known.direction;
  }
  if (!(extent_ > least_extent) || !(extent_ < greatest_extent)) return best_;
  reach_ = 2 * best_.upper;  // what is farther off hardly bounds a way out; with twice that brackets were the same
  const std::vector<const InnerPart*> parts_of_b = b_.convex_parts();
  for (const InnerPart* a : a_.convex_parts())
    for (const InnerPart* b : parts_of_b)
      if (!limit_.is_over()) add({a, b});
  if (!limit_.is_over()) add_parts({}, first_seeds);
  if (!is_done()) tried_.shorten(10);
  if (!is_done()) cover();
  if (!is_done()) turn();
  tried_.shorten(24);
  return best_;
}

}  // namespace toccata
