#include "query/decomposition/part_concavity.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <queue>
#include <utility>

#include "math/vec3_measures.hpp"
#include "narrow/primitives/closed_forms.hpp"
#include "query/decomposition/hull_sides.hpp"
#include "query/decomposition/solid_piece.hpp"
#include "toccata/query/relation.hpp"
#include "toccata/query/signed_distance.hpp"

namespace toccata {
namespace {

constexpr int most_questions = 1'500;
constexpr double fraction = 0.05;
constexpr Index few_faces = 64;

using Tetrahedron = std::array<Vec3, 4>;

struct ConcavityRegion {
  Tetrahedron corners;     ///< local
  RoundedTriangle near{};  ///< of the surface; local
  double upper = 0;        ///< no point of the region that is in the hull is farther from the solid
  FaceRange faces{};       ///< of the hull, those that cut off something of the region
  double slack = 0;        ///< for what rounds on the way to it
  friend bool operator<(const ConcavityRegion& a, const ConcavityRegion& b) { return a.upper < b.upper; }
};

Vec3 middle_of(const ConvexHull& hull) {
  Vec3 sum{};
  for (Index v = 0; v < hull.vertex_count(); ++v) sum = sum + (1.0 / hull.vertex_count()) * hull.vertex(v);
  return sum;
}

double square_of(const Vec3& v) { return dot(v, v); }

double largest_of(const Aabb& box) { return std::fmax(largest_magnitude(box.lower), largest_magnitude(box.upper)); }

Vec3 middle_of(const Tetrahedron& t) { return 0.25 * ((t[0] + t[1]) + (t[2] + t[3])); }

double distance_of(const Vec3& p, const RoundedTriangle& triangle) {
  const Vec3 a = triangle[0] - p, b = triangle[1] - p, c = triangle[2] - p;
  const TriangleWeights at = nearest_weights(a, b, c);
  // Whichever point of the triangle it is; of one without area the weights may be no numbers.
  const double v = at.v > 0 ? std::fmin(at.v, 1) : 0, w = at.w > 0 ? std::fmin(at.w, 1 - v) : 0;
  return std::sqrt(square_of((a + v * (b - a)) + w * (c - a)));
}

/// How far the farthest point of a tetrahedron is from a triangle: a corner, as the distance from what is convex is a
/// convex function.
double reach_of(const Tetrahedron& t, const RoundedTriangle& from) {
  double reach = 0;
  for (const Vec3& corner : t) reach = std::max(reach, distance_of(corner, from));
  return reach;
}

/// The same from a point.
double reach_of(const Tetrahedron& t, const Vec3& from) {
  double square = 0;
  for (const Vec3& corner : t) square = std::max(square, square_of(corner - from));
  return std::sqrt(square);
}

/// What is asked of the solid, and how exactly.
struct ConcavityQuestion {
  const Model& solid;
  const NearestSearch& nearest;
  const SideSearch& sides;
  const SolidFrame& frame;
  double largest = 0;  ///< coordinate of the solid and the hull
  double resolution = 0;
  std::optional<double> limit;
};

class ConcavitySearch {
 public:
  ConcavitySearch(const ConvexHull& hull, const ConcavityQuestion& question)
      : q_(question), slack_(0x1p-46 * question.largest + 0x1p-1070) {
    if (hull.dimension() < 3 || hull.topology().face_count() <= few_faces)
      start_at_faces(hull);
    else
      start_at_box(hull);
  }

  Concavity narrowed() {
    while (!regions_.empty() && questions_ < most_questions) {
      const double upper = regions_.top().upper;
      if (is_settled(upper) || (q_.limit && lower_ > *q_.limit)) break;
      const ConcavityRegion widest = regions_.top();
      regions_.pop();
      halve(widest);
    }
    return {lower_, regions_.empty() ? 0 : std::max(lower_, regions_.top().upper)};
  }

 private:
  /// From the middle to every face: nothing of it is outside the hull.
  void start_at_faces(const ConvexHull& hull) {
    const Vec3 middle = q_.frame.local(middle_of(hull));
    const HullTopology topology = hull.topology();
    for (Index f = 0; f < topology.face_count(); ++f) {
      const Index first = topology.face_start[f], end = topology.face_start[f + 1];
      const auto corner = [&](Index h) { return q_.frame.local(hull.vertex(topology.origin[h])); };
      if (end - first == 2) begin_with({middle, corner(first), corner(first), corner(first + 1)});
      for (Index h = first + 2; h < end; ++h) begin_with({middle, corner(first), corner(h - 1), corner(h)});
    }
  }

  /// The box around the hull, in six: along each order of axes from its lower corner to its upper (H. Freudenthal,
  /// 1942). Each of many faces would be a region, where one is enough for what lies deep inside the solid.
  void start_at_box(const ConvexHull& hull) {
    Aabb box;
    for (Index v = 0; v < hull.vertex_count(); ++v) box = merge(box, q_.frame.local(hull.vertex(v)));
    sides_.emplace(hull);
    std::array<int, 3> axes{0, 1, 2};
    do {
      Tetrahedron t{box.lower, box.lower, box.lower, box.upper};
      for (std::size_t i = 1; i < 3; ++i) {
        t[i] = t[i - 1];
        t[i][axes[i - 1]] = box.upper[axes[i - 1]];
      }
      begin_with(t, sides_->all());
    } while (std::next_permutation(axes.begin(), axes.end()));
  }

  void begin_with(const Tetrahedron& corners, const FaceRange& faces = {}) {
    add({corners, {}, HUGE_VAL, faces, slack_});
  }

  /// No region that is bounded so need be looked at further, now or later.
  [[nodiscard]] bool is_settled(double upper) const {
    return upper - lower_ <= std::max(q_.resolution, fraction * lower_) || (q_.limit && upper <= *q_.limit);
  }

  // The slacks are for what rounding leaves between a point and its place in the frame, and at each halving between
  // the halves: a point of the hull that lies between them belongs to either. With u = 2⁻⁵³, a middle is off by less
  // than 4 u of the largest coordinate, which is far less than the slack; but nothing else bounds what is left out by
  // many halvings.
  static void bound(ConcavityRegion& region, double reach, double lengths) {
    region.upper = std::min(region.upper, reach + (region.slack + 0x1p-47 * lengths));
  }
  void bound_by_near(ConcavityRegion& region) const {
    const double reach = q_.frame.length(reach_of(region.corners, region.near));
    bound(region, reach, reach);
  }

  [[nodiscard]] RoundedTriangle triangle(Index element) const {
    const TriangleMesh& mesh = q_.solid.mesh();
    RoundedTriangle result;
    for (std::size_t i = 0; i < 3; ++i) result[i] = q_.frame.local(mesh.vertices()[mesh.triangles()[element][i]]);
    return result;
  }

  /// Leaves out what lies in front of a face.
  [[nodiscard]] bool reaches_into_hull(ConcavityRegion& region) {
    if (region.faces.count == 0) return true;
    Tetrahedron in_world;
    for (std::size_t i = 0; i < 4; ++i) in_world[i] = q_.frame.world(region.corners[i]);
    const auto cutting = sides_->cutting(region.faces, in_world);
    if (cutting) region.faces = *cutting;
    return cutting.has_value();
  }

  /// What is known of a larger region bounds it, which is enough for most; then its middle is asked about. Cheap
  /// questions come first.
  void add(ConcavityRegion region) {
    if (std::isfinite(region.upper)) bound_by_near(region);
    if (!is_settled(region.upper)) {
      const Vec3 middle = middle_of(region.corners);
      const SurfacePoint found = measured(region, middle);
      if (!is_settled(region.upper)) {
        if (!reaches_into_hull(region)) return;
        take_side(region, middle, found);
      }
    }
    regions_.push(region);
  }

  SurfacePoint measured(ConcavityRegion& region, const Vec3& middle) {
    const SurfacePoint found = q_.nearest.nearest(q_.frame.world(middle), workspace_.scratch());
    ++questions_;
    region.near = triangle(found.element);
    bound_by_near(region);
    const double radius = q_.frame.length(reach_of(region.corners, middle));
    bound(region, found.upper + radius, radius);
    return found;
  }

  void take_side(ConcavityRegion& region, const Vec3& middle, const SurfacePoint& found) {
    const Vec3 at = q_.frame.world(middle);
    const double radius = q_.frame.length(reach_of(region.corners, middle));
    if (found.upper > 0 && q_.sides.side_of(at, workspace_.scratch()).side == Side::inside)
      bound(region, radius - found.lower, radius + found.lower);
    else if (region.faces.count == 0 || sides_->is_behind(region.faces, at))
      lower_ = std::max(lower_, found.lower - region.slack);
  }

  void halve(const ConcavityRegion& region) {
    std::size_t from = 0, to = 1;
    double longest = 0;
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t j = i + 1; j < 4; ++j)
        if (const double square = square_of(region.corners[j] - region.corners[i]); square > longest) {
          longest = square;
          from = i;
          to = j;
        }
    const Vec3 middle = 0.5 * (region.corners[from] + region.corners[to]);
    for (const std::size_t replaced : {from, to}) {
      ConcavityRegion half = region;
      half.corners[replaced] = middle;
      half.slack += slack_;
      add(half);
    }
  }

  const ConcavityQuestion& q_;
  Workspace workspace_;
  std::optional<HullSides> sides_;
  std::priority_queue<ConcavityRegion> regions_;
  double slack_;
  double lower_ = 0;
  int questions_ = 0;
};

/// No surface within it, and a point of it inside.
bool lies_within(const ConvexHull& hull, const Model& solid) {
  if (hull.dimension() < 3) return false;
  if (locate(middle_of(hull), solid).side != Side::inside) return false;
  PairQuery query;
  query.solid_b = Solid::none;
  return relation(Model(hull), solid, query).kind != RelationKind::crossing;
}

/// A hull a little smaller than another.
struct ShrunkHull {
  ConvexHull hull;
  double off = 0;  ///< no point of the other is farther from it
};

/// Towards the middle, by little, so that what rounding lets stick out of a solid does not.
ShrunkHull shrink(const ConvexHull& hull) {
  constexpr double part = 0x1p-30;
  const Vec3 middle = middle_of(hull);
  std::vector<Vec3> corners;
  double off = 0;
  for (Index v = 0; v < hull.vertex_count(); ++v) {
    const Vec3 corner = hull.vertex(v);
    corners.push_back(corner + part * (middle - corner));
    // The distance from what is convex is greatest at a corner.
    off = std::fmax(off, sum_of_magnitudes(corners.back() - corner));
  }
  return {ConvexHull(corners), off * (1 + 0x1p-50)};
}

double largest_of(const ConvexHull& hull) {
  double largest = 0;
  for (Index v = 0; v < hull.vertex_count(); ++v) largest = std::fmax(largest, largest_magnitude(hull.vertex(v)));
  return largest;
}

}  // namespace

ConcaveSolid::ConcaveSolid(const Model& solid, const SolidFrame& frame)
    : solid_(solid), frame_(frame), nearest_(solid, {}, most_questions), sides_(nearest_.posed(), SignBy::automatic) {}

Concavity ConcaveSolid::concavity_of(const ConvexHull& hull, double resolution, std::optional<double> limit) const {
  if (lies_within(hull, solid_)) return {};
  const ShrunkHull shrunk = shrink(hull);
  if (lies_within(shrunk.hull, solid_)) return {0, shrunk.off};
  const double largest = std::fmax(largest_of(solid_.bounds()), largest_of(hull));
  return ConcavitySearch(hull, {solid_, nearest_, sides_, frame_, largest, resolution, limit}).narrowed();
}

}  // namespace toccata
