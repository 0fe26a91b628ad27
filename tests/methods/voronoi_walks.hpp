#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <ranges>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "support/convex_cases.hpp"
#include "support/sweep.hpp"
#include "toccata/math/pose.hpp"
#include "toccata/methods/voronoi.hpp"
#include "toccata/narrow/convex_convex.hpp"

// Pairs that move by small steps, asked by walking and from nothing by GJK and by separating axes.
namespace toccata::test {

inline const std::vector<std::string>& walk_families() {
  static const std::vector<std::string> families = {"hull-8", "hull-32",    "hull-128", "hull-512",
                                                    "boxes",  "degenerate", "parallel", "distant",
                                                    "tiny",   "deep",       "kinds",    "sheared"};
  return families;
}

inline VoronoiRegions regions_of(const ConvexShape& shape) {
  if (const auto* sphere = std::get_if<Sphere>(&shape)) return VoronoiRegions(Point(sphere->centre()));
  if (const auto* capsule = std::get_if<Capsule>(&shape))
    return VoronoiRegions(Segment(capsule->start(), capsule->end()));
  if (const auto* rounded = std::get_if<Rounded>(&shape))
    return std::visit([](const auto& core) { return VoronoiRegions(core); }, rounded->core());
  if (const auto* point = std::get_if<Point>(&shape)) return VoronoiRegions(*point);
  if (const auto* segment = std::get_if<Segment>(&shape)) return VoronoiRegions(*segment);
  if (const auto* triangle = std::get_if<Triangle>(&shape)) return VoronoiRegions(*triangle);
  if (const auto* box = std::get_if<Box>(&shape)) return VoronoiRegions(*box);
  return VoronoiRegions(std::get<ConvexHull>(shape));
}

inline Vec3 vector_within(Random& random, double reach) {
  const double x = random.between(-reach, reach), y = random.between(-reach, reach), z = random.between(-reach, reach);
  return {x, y, z};
}

/// Points of about the unit sphere; of whole numbers they have faces of many corners, and coplanar neighbours.
inline ConvexHull walked_hull(Random& random, int count, bool on_grid) {
  std::vector<Vec3> points;
  for (int i = 0; i < count; ++i) {
    Vec3 p = vector_within(random, 1);
    p = (1 / std::sqrt(dot(p, p) + 1e-9)) * p;
    if (on_grid) p = {0.25 * std::round(4 * p.x), 0.25 * std::round(4 * p.y), 0.25 * std::round(4 * p.z)};
    points.push_back(p);
  }
  return ConvexHull(points);
}

/// How a pair moves: B along a line and about an axis.
struct WalkedMotion {
  Pose a;
  Mat3 turn_b;
  Vec3 axis{0, 0, 1};
  double degrees = 0;  ///< a step
  Vec3 from;
  Vec3 step;
  double scale = 1;

  [[nodiscard]] Pose b(int i) const {
    Pose pose{turn_b, from + i * step};
    if (degrees != 0) pose.linear = rotation_about(axis, i * degrees) * turn_b;
    return pose;
  }
};

struct WalkedPair {
  ConvexShape a, b;
  WalkedMotion motion;
};

inline ConvexShape walked_shape(const std::string& family, Random& random) {
  if (family.starts_with("hull-")) return walked_hull(random, std::stoi(family.substr(5)), false);
  if (family == "boxes") return Box({0.5 + 0.5 * static_cast<double>(random.below(2)), 0.5, 1});
  if (family == "degenerate" || family == "parallel")
    return walked_hull(random, 12 + static_cast<int>(random.below(40)), true);
  if (family == "kinds") return random_convex(convex_kinds()[random.below(convex_kinds().size())], random);
  return walked_hull(random, 6 + static_cast<int>(random.below(40)), random.below(3) == 0);
}

/// Symmetric places are whole numbers and quarter turns; what is parallel stays so.
inline WalkedMotion walked_motion(const std::string& family, Random& random) {
  WalkedMotion m;
  const double size = std::pow(10, random.between(-6, -0.7));
  const bool straight = family == "boxes" || family == "parallel";
  m.axis = straight ? Vec3{0, 0, 1} : vector_within(random, 1) + Vec3{0, 0, 1.5};
  m.degrees = straight && random.below(2) == 0 ? 0 : 50 * size;
  m.step = family == "boxes"
               ? 0.125 * Vec3{static_cast<double>(random.below(3)) - 1, static_cast<double>(random.below(3)) - 1, 0}
               : vector_within(random, size);
  if (!straight) m.turn_b = rotation_about(vector_within(random, 1) + Vec3{1.5, 0, 0}, random.between(0, 360));
  const Vec3 away = vector_within(random, 1) + Vec3{0, 0, 1e-3};
  const double gap = family == "deep" ? 0.4 : random.between(1.2, 3);
  m.from = (gap / std::sqrt(dot(away, away))) * away;
  if (family == "boxes")
    m.from = {static_cast<double>(random.below(3)), static_cast<double>(random.below(3)),
              2.0 + static_cast<double>(random.below(2))};
  if (family == "deep") m.step = 0.08 * vector_within(random, 1);
  return m;
}

inline Pose scaled_pose(const Pose& pose, double scale, const Vec3& offset) {
  Pose result = scaled(pose, scale);
  result.offset = scale * pose.offset + offset;
  return result;
}

inline WalkedPair walked_pair(const std::string& family, Random& random) {
  ConvexShape a = walked_shape(family, random), b = walked_shape(family, random);
  return {std::move(a), std::move(b), walked_motion(family, random)};
}

/// The poses of a step, as the family has them.
inline std::pair<Pose, Pose> walked_poses(const std::string& family, const WalkedMotion& motion, int i) {
  Pose a = motion.a, b = motion.b(i);
  if (family == "distant") {
    const Vec3 offset{3e6, -1e6, 2e6};
    return {scaled_pose(a, 1, offset), scaled_pose(b, 1, offset)};
  }
  if (family == "tiny") return {scaled_pose(a, 1e-9, {}), scaled_pose(b, 1e-9, {})};
  if (family == "sheared") {
    a.linear[0] = {1, 0.5, 0};
    b.linear[1] = b.linear[1] + 0.3 * b.linear[2];
    b.linear[2] = -b.linear[2];
  }
  return {a, b};
}

inline std::vector<Vec3> world_vertices(const PosedPolytope& shape) {
  std::vector<Vec3> vertices;
  for (Index i = 0; i < shape.vertex_count(); ++i) vertices.push_back(shape.vertex(i));
  return vertices;
}

/// How far apart along an axis, of whatever length; negative where they overlap.
inline double gap_along(const Vec3& axis, std::span<const Vec3> a, std::span<const Vec3> b) {
  const auto along = [&](const Vec3& v) { return dot(axis, v); };
  const auto [least_a, greatest_a] = std::ranges::minmax(a, {}, along);
  const auto [least_b, greatest_b] = std::ranges::minmax(b, {}, along);
  return std::max(along(least_a) - along(greatest_b), along(least_b) - along(greatest_a)) / std::sqrt(dot(axis, axis));
}

/// The ways of edges, each once, and the normals of faces, in the world.
struct AxesOf {
  std::vector<Vec3> edges, normals;
};

inline AxesOf axes_of(const PosedPolytope& shape) {
  AxesOf axes;
  const HullTopology t = shape.topology();
  for (Index h = 0; h < t.origin.size(); ++h)
    if (h < t.twin[h]) axes.edges.push_back(shape.vertex(t.target(h)) - shape.vertex(t.origin[h]));
  for (Index f = 0; f < t.face_count(); ++f) {
    const Index h = t.face_start[f], next = t.next(h);
    const Vec3 along = shape.vertex(t.target(h)) - shape.vertex(t.origin[h]);
    axes.normals.push_back(cross(along, shape.vertex(t.target(next)) - shape.vertex(t.origin[next])));
  }
  return axes;
}

/// The widest gap between the cores along any axis of the method of separating axes, in doubles.
inline double widest_gap(const PosedPolytope& a, const PosedPolytope& b) {
  const std::vector<Vec3> vertices_a = world_vertices(a), vertices_b = world_vertices(b);
  const AxesOf of_a = axes_of(a), of_b = axes_of(b);
  double widest = -std::numeric_limits<double>::infinity();
  const auto look = [&](const Vec3& axis) { widest = std::max(widest, gap_along(axis, vertices_a, vertices_b)); };
  for (const std::vector<Vec3>* normals : {&of_a.normals, &of_b.normals})
    for (const Vec3& normal : *normals)
      if (!(normal == Vec3{})) look(normal);
  for (const Vec3& e : of_a.edges)
    for (const Vec3& f : of_b.edges) {
      const Vec3 axis = cross(e, f);
      if (dot(axis, axis) > 1e-18 * dot(e, e) * dot(f, f)) look(axis);
    }
  return widest;
}

/// The last features, which are edges: their product is no axis.
inline bool are_parallel(const PosedPolytope& a, const PosedPolytope& b, const TrackedPair& walked) {
  const auto along = [](const PosedPolytope& shape, Index h) {
    return shape.vertex(shape.topology().target(h)) - shape.vertex(shape.topology().origin[h]);
  };
  const Vec3 e = along(a, walked.on_a.index), f = along(b, walked.on_b.index), axis = cross(e, f);
  return dot(axis, axis) <= 1e-18 * dot(e, e) * dot(f, f);
}

/// Between a vertex and a face and between two edges that are not parallel the distance is the widest gap of separating
/// axes; between other features it is wider. The fault, or nothing.
inline std::string gap_fault(const PosedPolytope& a, const PosedPolytope& b, const TrackedPair& walked,
                             double distance) {
  if (distance == 0) return "";
  using Kind = ConvexFeature::Kind;
  const Kind on_a = walked.on_a.kind, on_b = walked.on_b.kind;
  const bool is_plane = on_a == Kind::face || on_b == Kind::face ||
                        (on_a == Kind::edge && on_b == Kind::edge && !are_parallel(a, b, walked));
  const double cores = distance + a.radius() + b.radius(), gap = widest_gap(a, b);
  const Vec3 across = a.vertex(0) - b.vertex(0);
  const double off = 1e-6 * (cores + std::sqrt(dot(across, across)));
  if (gap > cores + off) return "nearer than the widest gap of separating axes";
  return is_plane && gap < cores - off ? "farther than the widest gap of separating axes" : "";
}

/// What is wrong with an answer, compared with answers that know nothing; or nothing. The number of separating axes
/// grows with the product of the numbers of vertices: of large hulls they are asked at the first step only.
inline std::string walk_fault(const PosedPolytope& a, const PosedPolytope& b, const Distance& walked,
                              const TrackedPair& tracked, bool first) {
  const Distance cold = distance_by_gjk(a, b);
  if (!(walked == cold)) return "another distance than by GJK";
  const bool few = a.vertex_count() * b.vertex_count() <= 20'000;
  if ((few || first) && overlap_by_separating_axes(a, b) != (walked.upper == 0))
    return "another relation than by separating axes";
  const Index axes = a.vertex_count() * b.vertex_count();
  if (axes <= 150 || (first && axes <= 1200))
    if (std::string fault = gap_fault(a, b, tracked, walked.upper); !fault.empty()) return fault;
  const Distance usual = distance(a, b);
  const bool agree = usual.lower <= walked.upper && walked.lower <= usual.upper;
  return agree ? "" : "an interval that the usual one does not meet";
}

/// Moves a pair so many steps; the first fault.
inline std::string fault_of_walks(const std::string& family, Random& random, int steps) {
  const WalkedPair pair = walked_pair(family, random);
  const VoronoiRegions regions_a = regions_of(pair.a), regions_b = regions_of(pair.b);
  const std::size_t features = regions_a.features().size() + regions_b.features().size();
  // As if the first vertices had been the nearest: the first walk is a long one.
  TrackedPair tracked, exchanged;
  tracked.state = exchanged.state = TrackedPair::State::apart;
  for (int i = 0; i < steps; ++i) {
    const auto [pose_a, pose_b] = walked_poses(family, pair.motion, i);
    const PosedPolytope a = posed({pair.a, pose_a}), b = posed({pair.b, pose_b});
    const std::uint64_t before = tracked.counts.steps;
    const Distance walked = distance_by_voronoi_walk(a, regions_a, b, regions_b, tracked);
    std::string fault = walk_fault(a, b, walked, tracked, i == 0);
    const Distance back = distance_by_voronoi_walk(b, regions_b, a, regions_a, exchanged);
    if (back.lower != walked.lower || back.upper != walked.upper) fault = "exchanged, another distance";
    if (tracked.counts.steps - before > features) fault = "more steps than features";
    if (!fault.empty()) return fault + " at step " + std::to_string(i);
  }
  return "";
}

}  // namespace toccata::test
