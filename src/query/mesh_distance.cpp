#include "query/mesh_distance.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <tuple>

#include "math/world_vertex.hpp"
#include "narrow/triangle_gaps.hpp"
#include "query/near_view.hpp"
#include "query/pair_search.hpp"
#include "query/part_inside.hpp"
#include "query/triangles_shape.hpp"
#include "query/world_search.hpp"
#include "toccata/narrow/convex_half_space.hpp"

namespace toccata {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// What is kept of every pair is an interval around its distance, of at most this relative width or from one double to
/// the next, that depends on the pair alone. The least of the upper ends is the distance of the meshes up to that
/// width, and the first pair that has it the nearest one, in whichever order they were found.
constexpr double interval_width = 0.99e-12;

/// A distance that lies in an interval of that width and is less than `upper`, or has an interval with a lesser upper
/// end, is not above this.
double limit_from(double upper) { return std::nextafter(upper * (1 + 4e-12), infinity); }

/// The lower end that goes with the least upper one.
double lower_from(double upper) {
  return upper == 0 ? 0 : std::min(upper * (1 - 0.995e-12), std::nextafter(upper, 0.0));
}

PosedConvex convex(const PosedMesh& mesh, Index triangle) { return PosedConvex(mesh.triangle(triangle)); }

void put(TrianglePairBlock::Corners& corners, std::size_t lane, const Triangle& triangle) {
  for (std::size_t i = 0; i < 3; ++i)
    for (int axis = 0; axis < 3; ++axis) corners[i][static_cast<std::size_t>(axis)][lane] = triangle.vertex[i][axis];
}

/// World triangles for a loop over many.
class WorldTriangles {
 public:
  explicit WorldTriangles(const PosedMesh& mesh)
      : pose_(mesh.pose()), vertices_(mesh.model().mesh().vertices()), triangles_(mesh.model().mesh().triangles()) {}

  Triangle operator[](Index number) const {
    const auto& corner = triangles_[number];
    return {{world_vertex(pose_, vertices_[corner[0]]), world_vertex(pose_, vertices_[corner[1]]),
             world_vertex(pose_, vertices_[corner[2]])}};
  }

 private:
  Pose pose_;
  std::span<const Vec3> vertices_;
  std::span<const std::array<Index, 3>> triangles_;
};

/// Keeps the pairs of triangles that may be the nearest; ends when two meet.
class NearestTriangles final : public NearQuestion {
 public:
  NearestTriangles(const PosedMesh& a, const PosedMesh& b, SearchScratch& scratch)
      : a_(a), b_(b), block_(scratch.main.blocks[0]), candidates_(scratch.candidates) {
    candidates_.clear();
  }

  [[nodiscard]] double limit() const override { return limit_; }

  void visit(std::span<const ItemPair> pairs) override {
    for (; !pairs.empty(); pairs = pairs.subspan(std::min(TrianglePairBlock::lanes, pairs.size())))
      bound(pairs.first(std::min(TrianglePairBlock::lanes, pairs.size())));
  }

  [[nodiscard]] bool found_meeting() const { return limit_ < 0; }

  /// Of all pairs that were seen; none of them meet.
  Distance nearest() {
    Key best{infinity, {}};
    std::sort(candidates_.begin(), candidates_.end(),
              [](const NearCandidate& x, const NearCandidate& y) { return x.lower < y.lower; });
    for (const NearCandidate& candidate : candidates_) {
      if (candidate.lower > limit_) break;
      const Key key{upper_of(candidate), candidate.pair};
      limit_ = std::min(limit_, limit_from(key.upper));
      if (key < best) best = key;
    }
    Distance result = exact(best.pair);
    result.upper = std::min(result.upper, best.upper);
    result.lower = lower_from(result.upper);
    result.element_a = best.pair.first;
    result.element_b = best.pair.second;
    return result;
  }

 private:
  struct Key {
    double upper;
    ItemPair pair;
    bool operator<(const Key& other) const { return std::tie(upper, pair) < std::tie(other.upper, other.pair); }
  };

  [[nodiscard]] Distance exact(const ItemPair& pair) const {
    return distance(PosedConvex(a_[pair.first]), PosedConvex(b_[pair.second]));
  }

  /// Not when the upper end is infinite: nothing is known then.
  static bool is_narrow(double lower, double upper) { return upper - lower < 0.9 * interval_width * upper; }

  /// The upper end of the pair's own interval.
  [[nodiscard]] double upper_of(const NearCandidate& candidate) const {
    if (is_narrow(candidate.lower, candidate.upper)) return candidate.upper;
    const auto [x, y] = in_order(candidate.pair);
    const GapInterval precise = precise_gap(x, y, candidate.points);
    return is_narrow(precise.lower, precise.upper) ? precise.upper : exact(candidate.pair).upper;
  }

  /// The triangles of a pair that do not meet: so it is told which comes first, and what is computed of them is the
  /// same either way round.
  [[nodiscard]] std::pair<Triangle, Triangle> in_order(const ItemPair& pair) const {
    const Triangle x = a_[pair.first], y = b_[pair.second];
    return lexicographically_less(x[0], y[0]) ? std::pair(x, y) : std::pair(y, x);
  }

  void bound(std::span<const ItemPair> pairs) {
    for (std::size_t lane = 0; lane < pairs.size(); ++lane) {
      const auto [x, y] = in_order(pairs[lane]);
      put(block_.a, lane, x);
      put(block_.b, lane, y);
    }
    bound_gaps(block_, gaps_);
    for (std::size_t lane = 0; lane < pairs.size() && limit_ >= 0; ++lane)
      keep({gaps_.lower[lane], gaps_.upper[lane], pairs[lane], gaps_.points(lane)});
  }

  void keep(NearCandidate candidate) {
    if (candidate.lower > limit_) return;
    if (candidate.lower == 0 && meet(candidate.pair)) {
      limit_ = -1;
      return;
    }
    if (candidate.upper == infinity) {
      const Distance found = exact(candidate.pair);
      candidate.lower = found.lower;
      candidate.upper = found.upper;
    }
    limit_ = std::min(limit_, limit_from(candidate.upper));
    if (!(candidate.lower > limit_)) candidates_.push_back(candidate);
  }

  [[nodiscard]] bool meet(const ItemPair& pair) const { return overlap(a_[pair.first], b_[pair.second]); }

  WorldTriangles a_;
  WorldTriangles b_;
  TrianglePairBlock& block_;
  TriangleGaps gaps_{};
  std::vector<NearCandidate>& candidates_;
  double limit_ = infinity;
};

/// The nearest triangle to a convex shape.
class NearestToShape final : public NearQuestion {
 public:
  NearestToShape(const PosedMesh& mesh, const PosedConvex& shape, ConvexWorkspace& workspace)
      : mesh_(mesh), shape_(shape), workspace_(workspace) {}

  /// Of the shape's core, which boxes are compared with.
  [[nodiscard]] double limit() const override { return std::nextafter(limit_ + shape_.radius(), infinity); }

  void visit(std::span<const ItemPair> pairs) override {
    for (const ItemPair& pair : pairs) {
      Distance found = distance(convex(mesh_, pair.first), shape_, &workspace_);
      found.element_a = pair.first;
      if (best && std::tie(best->upper, best->element_a) <= std::tie(found.upper, found.element_a)) continue;
      best = found;
      limit_ = limit_from(found.upper);
    }
  }

  std::optional<Distance> best;

 private:
  const PosedMesh& mesh_;
  const PosedConvex& shape_;
  ConvexWorkspace& workspace_;
  double limit_ = infinity;
};

Distance with_faces(Distance d, const PosedMesh& a) {
  d.face_a = a.model().mesh().face_of(d.element_a);
  return d;
}

Distance at_common_point(const Vec3& point) { return {0, 0, point, point, Status::exact}; }

/// At the least pair of triangles that meet.
Distance at_contact(const PosedMesh& a, const PosedMesh& b, SearchScratch& scratch) {
  const Contact contact = *first_surface_contact(a, b, scratch);
  Distance found = distance(convex(a, contact.triangle_a), convex(b, contact.triangle_b));
  found.element_a = contact.triangle_a;
  found.element_b = contact.triangle_b;
  return found;
}

/// Of solids whose surfaces do not meet, where one lies within the other.
std::optional<Distance> inner_point(const PosedTriangles& a, const PosedTriangles& b) {
  if (!overlap(a.mesh.box(), b.mesh.box())) return {};
  if (b.solid)
    if (const auto triangle = part_inside(a.mesh, b.mesh)) {
      Distance found = at_common_point(a.mesh.triangle(*triangle)[0]);
      found.element_a = *triangle;
      return found;
    }
  if (a.solid)
    if (const auto triangle = part_inside(b.mesh, a.mesh)) {
      Distance found = at_common_point(b.mesh.triangle(*triangle)[0]);
      found.element_b = *triangle;
      return found;
    }
  return {};
}

Distance surface_distance(const PosedMesh& a, const PosedMesh& b, SearchScratch& scratch) {
  const NearFrame frame_a = near_frame(a), frame_b = near_frame(b);
  const NearWalk walk({a.model().oriented_boxes(), a.model().wide_tree().items},
                      {b.model().oriented_boxes(), b.model().wide_tree().items}, near_view(frame_a, frame_b),
                      near_view(frame_b, frame_a));
  NearestTriangles question(a, b, scratch);
  ConvexWorkspace& kept = scratch.convex;
  const ItemPair warm{kept.element_a, kept.element_b};
  if (warm.first < a.model().element_count() && warm.second < b.model().element_count()) question.visit({&warm, 1});
  walk.run(scratch.near, question);
  if (question.found_meeting()) return at_contact(a, b, scratch);
  scratch.counts = scratch.near.counts;
  const Distance nearest = question.nearest();
  kept.element_a = nearest.element_a;
  kept.element_b = nearest.element_b;
  return nearest;
}

/// Where a shape meets triangles or lies inside the solid.
template <class Shape>
std::optional<Distance> at_least_triangle(const PosedTriangles& a, const Shape& b, SearchScratch& scratch) {
  const auto meeting = triangles_meeting(a.mesh, b, scratch);
  if (meeting.empty()) return {};
  Distance found = distance(convex(a.mesh, meeting.front()), b);
  found.element_a = meeting.front();
  return with_faces(found, a.mesh);
}

Distance outer_distance(const PosedMesh& a, const PosedConvex& b, SearchScratch& scratch) {
  const ConvexNearTree shape(b);
  const NearFrame frame = near_frame(a);
  const NearWalk walk({a.model().oriented_boxes(), a.model().wide_tree().items}, shape.tree(),
                      near_view(frame, shape.frame), near_view(shape.frame, frame));
  NearestToShape question(a, b, scratch.convex);
  const ItemPair warm{scratch.convex.element_a, 0};
  if (warm.first < a.model().element_count()) question.visit({&warm, 1});
  walk.run(scratch.near, question);
  scratch.counts = scratch.near.counts;
  scratch.convex.element_a = question.best->element_a;
  question.best->lower = lower_from(question.best->upper);
  return with_faces(*question.best, a);
}

/// The triangle with the corner that is lowest over the half-space, but for rounding.
Index lowest_triangle(const PosedMesh& a, const PosedHalfSpace& b) {
  Index lowest = 0;
  double least = infinity;
  for (Index i = 0; i < a.model().element_count(); ++i)
    for (const Vec3& corner : a.triangle(i).vertex) {
      const double height = dot(corner - b.point, b.normal);
      if (!(height < least)) continue;
      least = height;
      lowest = i;
    }
  return lowest;
}

/// Contains all that is within the distance of the half-space.
PosedHalfSpace widened(PosedHalfSpace b, double by) {
  const double length = std::sqrt(dot(b.normal, b.normal));
  const double size = std::max({std::abs(b.point.x), std::abs(b.point.y), std::abs(b.point.z)});
  b.point = b.point + ((by + 1e-9 * (by + size)) / length) * b.normal;
  return b;
}

Distance outer_distance(const PosedMesh& a, const PosedHalfSpace& b) {
  std::optional<Distance> best;
  const auto see = [&](Index triangle) {
    Distance found = distance(convex(a, triangle), b);
    found.element_a = triangle;
    if (!best || std::tie(found.upper, found.element_a) < std::tie(best->upper, best->element_a)) best = found;
    return true;
  };
  see(lowest_triangle(a, b));
  const PosedHalfSpace region = widened(b, best->upper);
  if (is_finite(region.point))
    visit_triangles_near(a, region, see);
  else
    for (Index i = 0; i < a.model().element_count(); ++i) see(i);
  best->lower = lower_from(best->upper);
  return with_faces(*best, a);
}

}  // namespace

Distance distance(const PosedTriangles& a, const PosedTriangles& b, SearchScratch& scratch) {
  Distance found = surface_distance(a.mesh, b.mesh, scratch);
  if (found.upper > 0)
    if (const auto common = inner_point(a, b)) found = *common;
  found.face_b = b.mesh.model().mesh().face_of(found.element_b);
  return with_faces(found, a.mesh);
}

Distance distance(const PosedTriangles& a, const PosedConvex& b, SearchScratch& scratch) {
  scratch.counts = {};
  if (const auto common = at_least_triangle(a, b, scratch)) return *common;
  if (a.solid && is_interior(b.vertex(0), a.mesh)) return with_faces(at_common_point(b.vertex(0)), a.mesh);
  return outer_distance(a.mesh, b, scratch);
}

Distance distance(const PosedTriangles& a, const PosedHalfSpace& b, SearchScratch& scratch) {
  scratch.counts = {};
  if (const auto common = at_least_triangle(a, b, scratch)) return *common;
  return outer_distance(a.mesh, b);
}

}  // namespace toccata
