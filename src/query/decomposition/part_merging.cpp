#include "query/decomposition/part_merging.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "math/constants.hpp"
#include "math/cube_directions.hpp"
#include "query/decomposition/solid_piece.hpp"
#include "toccata/bounds/aabb.hpp"
#include "toccata/core/parallel.hpp"

namespace toccata {
namespace {

constexpr double never_merged = infinity;

ConvexHull joined_hull(const ConvexHull& a, const ConvexHull& b) {
  std::vector<Vec3> points;
  for (const ConvexHull* hull : {&a, &b})
    for (Index v = 0; v < hull->vertex_count(); ++v) points.push_back(hull->vertex(v));
  return ConvexHull(points);
}

bool are_apart(const Aabb& a, const Aabb& b) {
  for (int axis = 0; axis < 3; ++axis)
    if (a.lower[axis] > b.upper[axis] + 1e-6 || b.lower[axis] > a.upper[axis] + 1e-6) return true;
  return false;
}

std::vector<Vec3> joined_corners(std::vector<Vec3> a, const std::vector<Vec3>& b) {
  a.insert(a.end(), b.begin(), b.end());
  return snapped(std::move(a));
}

/// Those of the corners that are farthest along some directions: their hull is most of the part's, and quickly made.
std::vector<Vec3> outline_of(const std::vector<Vec3>& corners) {
  std::vector<Vec3> outline;
  for (const Vec3& along : cube_directions) {
    const auto height = [&](const Vec3& p) { return dot(along, p); };
    outline.push_back(*std::ranges::max_element(corners, {}, height));
  }
  return snapped(std::move(outline));
}

/// How much larger the hull of two parts is than both, or at least is.
struct Growth {
  double least = never_merged;
  bool is_exact = true;
};

class PartMerging {
 public:
  PartMerging(std::vector<GrowingPart> parts, int threads)
      : parts_(std::move(parts)), threads_(threads), growth_(parts_.size()) {
    for (std::size_t i = 0; i < parts_.size(); ++i) {
      growth_[i].resize(i);
      boxes_.push_back(fit_aabb(parts_[i].corners));
      outlines_.push_back(outline_of(parts_[i].corners));
      alive_.push_back(i);
    }
    for (std::size_t i = 0; i < parts_.size(); ++i) measure(i);
  }

  [[nodiscard]] std::size_t count() const { return alive_.size(); }

  /// The pair whose hull grows least; of several the first. Measured are only pairs that may be it.
  [[nodiscard]] std::pair<std::size_t, std::size_t> best() {
    while (true) {
      const auto pair = least();
      if (pair.first == pair.second) return pair;
      Growth& growth = growth_[pair.first][pair.second];
      if (growth.is_exact) return pair;
      const auto& [i, j] = pair;
      growth = {hull_volume(joined_corners(parts_[i].corners, parts_[j].corners)) - volume_of(i, j), true};
    }
  }

  [[nodiscard]] GrowingPart joined(const std::pair<std::size_t, std::size_t>& pair) const {
    const GrowingPart &a = parts_[pair.first], &b = parts_[pair.second];
    GrowingPart part{joined_hull(a.hull, b.hull), joined_corners(a.corners, b.corners), 0,
                     a.solid_volume + b.solid_volume, a.faces};
    part.volume = hull_volume(part.corners);
    part.faces.insert(part.faces.end(), b.faces.begin(), b.faces.end());
    std::ranges::sort(part.faces);
    part.faces.erase(std::unique(part.faces.begin(), part.faces.end()), part.faces.end());
    return part;
  }

  void merge(const std::pair<std::size_t, std::size_t>& pair, GrowingPart part) {
    parts_[pair.second] = std::move(part);
    boxes_[pair.second] = toccata::merge(boxes_[pair.first], boxes_[pair.second]);
    outlines_[pair.second] = outline_of(parts_[pair.second].corners);
    std::erase(alive_, pair.first);
    measure(pair.second);
    for (const std::size_t i : alive_)
      if (i > pair.second) growth_[i][pair.second] = at_least(i, pair.second);
  }

  /// Those whose boxes are apart are measured only when no others are left.
  void measure_apart() {
    measures_apart_ = true;
    for (const std::size_t i : alive_) measure(i);
  }

  void forbid(const std::pair<std::size_t, std::size_t>& pair) { growth_[pair.first][pair.second] = {}; }

  [[nodiscard]] std::vector<GrowingPart> result() const {
    std::vector<GrowingPart> parts;
    for (const std::size_t i : alive_) parts.push_back(parts_[i]);
    return parts;
  }

 private:
  [[nodiscard]] std::pair<std::size_t, std::size_t> least() const {
    std::pair<std::size_t, std::size_t> result{0, 0};
    double least = never_merged;
    for (const std::size_t i : alive_)
      for (const std::size_t j : alive_)
        if (j < i && growth_[i][j].least < least) {
          least = growth_[i][j].least;
          result = {i, j};
        }
    return result;
  }

  [[nodiscard]] double volume_of(std::size_t i, std::size_t j) const { return parts_[i].volume + parts_[j].volume; }

  /// From the outlines, whose hull lies in that of the parts.
  [[nodiscard]] Growth at_least(std::size_t i, std::size_t j) const {
    if (!measures_apart_ && are_apart(boxes_[i], boxes_[j])) return {};
    return {hull_volume(joined_corners(outlines_[i], outlines_[j])) - volume_of(i, j), false};
  }

  /// With those before it.
  void measure(std::size_t i) {
    std::vector<std::size_t> others;
    for (const std::size_t j : alive_)
      if (j < i) others.push_back(j);
    parallel_for(others.size(), threads_, [&](std::size_t k) { growth_[i][others[k]] = at_least(i, others[k]); });
  }

  std::vector<GrowingPart> parts_;
  int threads_;
  std::vector<std::vector<Growth>> growth_;  // by the greater number, then the lesser
  std::vector<std::size_t> alive_;
  std::vector<Aabb> boxes_;
  std::vector<std::vector<Vec3>> outlines_;
  bool measures_apart_ = false;
};

}  // namespace

std::vector<Vec3> snapped(std::vector<Vec3> points) {
  const auto on_grid = [](double c) { return std::nearbyint(c * 0x1p30) * 0x1p-30; };
  for (Vec3& p : points) p = {on_grid(p.x), on_grid(p.y), on_grid(p.z)};
  std::ranges::sort(points, lexicographically_less);
  points.erase(std::unique(points.begin(), points.end()), points.end());
  return points;
}

std::vector<GrowingPart> merged_parts(std::vector<GrowingPart> parts, std::size_t most, int threads,
                                      const std::function<bool(const GrowingPart&)>& allowed) {
  PartMerging merging(std::move(parts), threads);
  while (merging.count() > 1) {
    const auto pair = merging.best();
    if (pair.first == pair.second && merging.count() <= most) break;
    if (pair.first == pair.second) {
      merging.measure_apart();
      continue;
    }
    GrowingPart part = merging.joined(pair);
    if (merging.count() > most || allowed(part))
      merging.merge(pair, std::move(part));
    else
      merging.forbid(pair);
  }
  return merging.result();
}

}  // namespace toccata
