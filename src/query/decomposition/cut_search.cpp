#include "query/decomposition/cut_search.hpp"

#include <algorithm>
#include <cmath>

#include "math/constants.hpp"
#include "toccata/bounds/obb.hpp"
#include "toccata/core/parallel.hpp"

namespace toccata {
namespace {

constexpr double near_plane = 0x1p-30;
constexpr int offsets = 9;
constexpr std::size_t most_reflex = 24;
constexpr std::size_t few_triangles = 256;
constexpr std::size_t many_triangles = 2048;
constexpr std::size_t looked_at_again = 6;
constexpr double balance_weight = 0.02;
constexpr double reflex_weight = 0.06;

/// Some triangles of a piece, evenly taken, and its edges: enough to compare the hulls of its parts.
struct Sketch {
  std::vector<RoundedTriangle> triangles;
  std::vector<RoundedSegment> edges;
};

Sketch sketch_of(const SolidPiece& piece, std::size_t most) {
  Sketch sketch{{}, piece.edges};
  const std::size_t step = (piece.surface.size() + most - 1) / most;
  for (std::size_t i = 0; i < piece.surface.size(); i += std::max<std::size_t>(step, 1))
    sketch.triangles.push_back(piece.surface[i]);
  return sketch;
}

double hull_volume_in_front(const Sketch& sketch, const RoundedPlane& plane) {
  std::vector<Vec3> points;
  for (const RoundedTriangle& t : sketch.triangles) {
    const std::vector<Vec3> part = part_in_front(t, plane, flat_height);
    points.insert(points.end(), part.begin(), part.end());
  }
  for (const RoundedSegment& s : sketch.edges) {
    const double p = plane.height(s[0]), q = plane.height(s[1]);
    // What has no more than an end in the plane belongs to the other side.
    if (std::max(p, q) <= flat_height) continue;
    if (p >= -flat_height) points.push_back(s[0]);
    if (q >= -flat_height) points.push_back(s[1]);
    if (p * q < 0) points.push_back(s[0] + (p / (p - q)) * (s[1] - s[0]));
  }
  return hull_volume(points);
}

/// The less, the better.
double score(const SolidPiece& piece, const Sketch& sketch, const RoundedPlane& plane, double excess) {
  const double front = volume_in_front(piece, plane), back = piece.volume - front;
  const double least = 1e-9 * std::fabs(piece.volume);
  if (!(front > least && back > least)) return infinity;
  const RoundedPlane other{-plane.normal, -plane.offset};
  const double over = std::max(0.0, hull_volume_in_front(sketch, plane) - front) +
                      std::max(0.0, hull_volume_in_front(sketch, other) - back);
  return over + balance_weight * excess * (std::fabs(front - back) / piece.volume);
}

/// How much of the concave edges a cut takes away: those that lie in it. A cavity of flat walls is in the hull of what
/// is left until cuts along several of them have been made, so the volumes alone do not see that these are good.
double share_in(const RoundedPlane& plane, std::span<const ReflexEdge* const> edges) {
  double all = 0, taken = 0;
  for (const ReflexEdge* edge : edges) {
    const auto is_on = [&](const Vec3& end) { return std::fabs(plane.height(end)) <= near_plane; };
    all += edge->weight;
    if (is_on(edge->ends[0]) && is_on(edge->ends[1])) taken += edge->weight;
  }
  return all > 0 ? taken / all : 0;
}

Vec3 coarse(const Vec3& normal) {
  const auto rounded = [](double c) { return std::nearbyint(c * 0x1p8) * 0x1p-8; };
  return {rounded(normal.x), rounded(normal.y), rounded(normal.z)};
}

/// Corners so near a plane that what it cuts off of them is a sliver.
bool makes_slivers(const SolidPiece& piece, const CutPlane& exact, const RoundedPlane& plane, const SolidFrame& frame) {
  const auto is_off = [&](const Vec3& corner) {
    const double height = std::fabs(plane.height(corner));
    return height < near_plane && (height > flat_height || exact.side(frame.world(corner)) != Sign::zero);
  };
  return std::ranges::any_of(piece.surface, [&](const RoundedTriangle& t) { return std::ranges::any_of(t, is_off); });
}

/// A plane like that one which makes no slivers, if one is near. What is nearly in the plane of a face goes to the
/// side behind the face, where its solid is.
PlaneChoice without_slivers(const PlaneChoice& choice, const SolidPiece& piece, const SolidFrame& frame) {
  PlaneChoice moved = choice;
  for (int attempt = 0; attempt < 16; ++attempt) {
    const RoundedPlane plane = frame.plane(moved);
    if (!makes_slivers(piece, CutPlane(moved), plane, frame)) return moved;
    const double way = moved.of_points || attempt > 0 ? 4 * near_plane : 0x1p-18;
    moved = {frame.world(frame.local(moved.through) + way * plane.normal), moved.normal, false, {}};
  }
  return choice;
}

struct ExtentAlong {
  double least = infinity;
  double greatest = -infinity;
};

}  // namespace

std::vector<const ReflexEdge*> CutSearch::edges_in(std::span<const RoundedPlane> planes,
                                                   std::span<const CellSide> cell) const {
  std::vector<const ReflexEdge*> edges;
  for (const ReflexEdge& edge : reflex_.edges) {
    const Vec3 middle = edge.middle();
    const auto is_within = [&](const CellSide& side) {
      return side.sign * planes[side.plane].height(middle) > flat_height;
    };
    if (std::ranges::all_of(cell, is_within)) edges.push_back(&edge);
  }
  return edges;
}

void CutSearch::add_reflex(std::vector<PlaneChoice>& choices, std::span<const ReflexEdge* const> edges) const {
  std::vector<double> weights(reflex_.planes.size(), 0);
  for (const ReflexEdge* edge : edges)
    for (const Index plane : edge->planes) weights[plane] += edge->weight;
  std::vector<Index> order;
  for (Index i = 0; i < weights.size(); ++i)
    if (weights[i] > 0) order.push_back(i);
  std::ranges::stable_sort(order, [&](Index a, Index b) { return weights[a] > weights[b]; });
  if (order.size() > most_reflex) order.resize(most_reflex);
  for (const Index i : order) choices.push_back(reflex_.planes[i].choice);
}

std::vector<PlaneChoice> CutSearch::candidates(const SolidPiece& piece,
                                               std::span<const ReflexEdge* const> edges) const {
  std::vector<PlaneChoice> choices;
  add_reflex(choices, edges);
  const Sketch sketch = sketch_of(piece, many_triangles);
  std::vector<Vec3> points;
  for (const RoundedTriangle& t : sketch.triangles) points.insert(points.end(), t.begin(), t.end());
  for (const RoundedSegment& s : sketch.edges) points.insert(points.end(), s.begin(), s.end());
  if (points.empty()) return choices;
  std::vector<Vec3> normals{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  for (const Vec3& axis : principal_axes(points).axes.row)
    if (const Vec3 normal = coarse(axis); dot(normal, normal) > 0.5) normals.push_back(normal);
  for (const Vec3& normal : normals) {
    ExtentAlong extent;
    for (const Vec3& p : points) {
      extent.least = std::min(extent.least, dot(normal, p));
      extent.greatest = std::max(extent.greatest, dot(normal, p));
    }
    for (int i = 1; i <= offsets; ++i) {
      const double at = extent.least + (extent.greatest - extent.least) * i / (offsets + 1);
      choices.push_back({frame_.world((at / dot(normal, normal)) * normal), normal, false, {}});
    }
  }
  return choices;
}

std::optional<PlaneChoice> CutSearch::best_cut(const SolidPiece& piece, std::span<const RoundedPlane> planes,
                                               std::span<const CellSide> cell, double excess) const {
  const std::vector<const ReflexEdge*> edges = edges_in(planes, cell);
  const std::vector<PlaneChoice> choices = candidates(piece, edges);
  std::vector<double> scores(choices.size());
  const auto rate = [&](std::span<const std::size_t> which, std::size_t triangles) {
    const Sketch sketch = sketch_of(piece, triangles);
    parallel_for(which.size(), threads_, [&](std::size_t i) {
      const RoundedPlane plane = frame_.plane(choices[which[i]]);
      scores[which[i]] = score(piece, sketch, plane, excess) - reflex_weight * excess * share_in(plane, edges);
    });
  };
  std::vector<std::size_t> order(choices.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  const auto by_score = [&](std::size_t a, std::size_t b) { return scores[a] < scores[b]; };
  rate(order, few_triangles);
  std::ranges::stable_sort(order, by_score);
  if (piece.surface.size() > few_triangles) {
    order.resize(std::min(order.size(), looked_at_again));
    rate(order, many_triangles);
    std::ranges::stable_sort(order, by_score);
  }
  if (order.empty() || !std::isfinite(scores[order[0]])) return {};
  return without_slivers(choices[order[0]], piece, frame_);
}

}  // namespace toccata
