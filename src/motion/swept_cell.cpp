#include "motion/swept_cell.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "math/expansion.hpp"
#include "math/vec3_measures.hpp"
#include "motion/outer_polytope.hpp"
#include "query/posed_shape.hpp"

namespace toccata {
namespace {

constexpr double more_than_roundings = 1 + 0x1p-40;  ///< more than the roundings of a few operations

Aabb box_under(const Pose& pose, const std::vector<Vec3>& corners) {
  Aabb box;
  for (const Vec3& corner : corners) box = merge(box, transform(pose, corner));
  return box;
}

double diagonal_of(const Aabb& box) { return length(box.upper - box.lower) * more_than_roundings; }

/// ‖L‖ of the map that stretches the quadric of size 1 and poses it: no vector becomes longer by more.
double greatest_stretch(const PosedQuadric& quadric) {
  Vec3 lengths;
  for (int i = 0; i < 3; ++i) lengths[i] = quadric.half()[i] * length(quadric.pose().linear.column(i));
  return length(lengths) * more_than_roundings;
}

ConvexCluster cluster_of(const PosedQuadric& posed, const MovingPart& part) {
  OuterPolytope outer = outer_polytope(posed);
  ConvexCluster cluster{&part, std::move(outer.corners)};
  // A point of it is λ times one of the quadric, with λ ≤ the stretch, so off by (λ − 1) times a vector of it.
  cluster.excess = (outer.stretch - 1) * greatest_stretch(posed);
  return cluster;
}

ConvexCluster cluster_of(const PosedPolytope& local, const MovingPart& part) {
  ConvexCluster cluster{&part, {}};
  cluster.radius = local.radius();
  for (Index i = 0; i < local.vertex_count(); ++i) cluster.corners.push_back(local.vertex(i));
  return cluster;
}

void gather_triangles(const Bvh<Aabb>& tree, Index node, std::vector<Index>& triangles) {
  const BvhNode<Aabb>& at = tree.nodes[node];
  for (Index i = 0; i < at.count; ++i) triangles.push_back(tree.items[at.first + i]);
  for (Index i = 0; i < at.child_count; ++i) gather_triangles(tree, at.first + i, triangles);
}

/// The point of a hull of points that is farthest from all of them is within the radius of a ball around them:
/// Σ λᵢ |vᵢ − x|² = Σ λᵢ |vᵢ − c|² − |x − c|² for x = Σ λᵢ vᵢ, so that some vᵢ is as near to x as the radius.
SharedCluster cluster_of(const MovingPart& part, std::vector<Index> triangles, std::optional<Index> node) {
  const TriangleMesh& mesh = part.shape().mesh();
  ConvexCluster cluster{&part, {}};
  std::vector<Index> used;
  for (const Index triangle : triangles)
    for (const Index vertex : mesh.triangles()[triangle]) used.push_back(vertex);
  std::sort(used.begin(), used.end());
  used.erase(std::unique(used.begin(), used.end()), used.end());
  for (const Index vertex : used) cluster.corners.push_back(mesh.vertices()[vertex]);
  cluster.spread = diagonal_of(box_under(part.pose_at(0), cluster.corners));
  if (triangles.size() > 1) cluster.excess = 0.5 * cluster.spread;
  cluster.triangles = std::move(triangles);
  cluster.node = node;
  return std::make_shared<const ConvexCluster>(std::move(cluster));
}

SharedCluster cluster_below(const MovingPart& part, Index node) {
  std::vector<Index> triangles;
  gather_triangles(part.shape().tree(), node, triangles);
  return cluster_of(part, std::move(triangles), node);
}

/// A coordinate a + b, and the doubles around it where it is none.
struct DoublesAround {
  double lower;
  double upper;
};
DoublesAround doubles_around_sum(double a, double b) { return {-sum_not_less(-a, -b), sum_not_less(a, b)}; }

/// Corners of the least box of doubles around point + by; their greatest distance from it is added to `off`.
void add_corners_around(const Vec3& point, const Vec3& by, std::vector<Vec3>& corners, double& off) {
  std::array<DoublesAround, 3> around{};
  for (int axis = 0; axis < 3; ++axis)
    around[static_cast<std::size_t>(axis)] = doubles_around_sum(point[axis], by[axis]);
  const auto& [x, y, z] = around;
  for (int i = 0; i < 8; ++i) {
    const auto is_repeated = [i](int axis, const DoublesAround& a) {
      return (i >> axis & 1) != 0 && a.lower == a.upper;
    };
    if (is_repeated(0, x) || is_repeated(1, y) || is_repeated(2, z)) continue;
    corners.push_back(
        {(i & 1) != 0 ? x.upper : x.lower, (i & 2) != 0 ? y.upper : y.lower, (i & 4) != 0 ? z.upper : z.lower});
  }
  off = std::max(off, length(Vec3{x.upper - x.lower, y.upper - y.lower, z.upper - z.lower}) * more_than_roundings);
}

Shape shape_of(const std::vector<Vec3>& corners, double radius) {
  const ConvexHull hull(corners);
  if (hull.dimension() == 0) return radius > 0 ? Shape(Sphere(radius, hull.vertex(0))) : Shape(Point(hull.vertex(0)));
  if (hull.dimension() == 1 && radius > 0) return Capsule(hull.vertex(0), hull.vertex(1), radius);
  if (hull.dimension() == 1) return Segment(hull.vertex(0), hull.vertex(1));
  return radius > 0 ? Shape(Rounded(hull, radius)) : Shape(hull);
}

/// What is straight on is exact but where an end is no double: then the doubles around it are taken, or the radius, if
/// there is one, is made larger by as much as ends are off.
SweptHull hull_of_straight(const SweptCell& cell) {
  const ConvexCluster& cluster = *cell.cluster;
  const std::vector<Vec3> starts = transform(cluster.part->pose_at(cell.stretch.begin), cluster.corners);
  std::vector<Vec3> corners = starts;
  double off = 0;
  for (const Vec3& start : starts) add_corners_around(start, *cell.translation, corners, off);
  if (cluster.radius == 0 || off == 0) return {shape_of(corners, cluster.radius), cluster.excess + off};
  corners.resize(starts.size());
  for (const Vec3& start : starts) corners.push_back(start + *cell.translation);
  return {shape_of(corners, sum_not_less(cluster.radius, off)), cluster.excess + (2 * off + 0x1p-52 * cluster.radius)};
}

}  // namespace

SharedCluster whole_cluster(const MovingPart& part) {
  if (part.shape().has_mesh()) return cluster_below(part, 0);
  const PosedShape local = pose_shape(part.shape(), {}, Solid::automatic, "a shape");
  const auto* quadric = std::get_if<PosedQuadric>(&local);
  ConvexCluster cluster = quadric != nullptr ? cluster_of(std::get<PosedQuadric>(part.at(0)), part)
                                             : cluster_of(std::get<PosedPolytope>(local), part);
  cluster.spread = diagonal_of(box_under(part.pose_at(0), cluster.corners));
  return std::make_shared<const ConvexCluster>(std::move(cluster));
}

std::vector<SharedCluster> finer_clusters(const ConvexCluster& cluster) {
  std::vector<SharedCluster> finer;
  if (cluster.triangles.size() < 2) return finer;
  if (cluster.node) {
    const BvhNode<Aabb>& node = cluster.part->shape().tree().nodes[*cluster.node];
    for (Index i = 0; i < node.child_count; ++i) finer.push_back(cluster_below(*cluster.part, node.first + i));
  }
  if (finer.empty())
    for (const Index triangle : cluster.triangles) finer.push_back(cluster_of(*cluster.part, {triangle}, std::nullopt));
  return finer;
}

/// Between the places f₀ and f₁ of the body at both ends, which are affine in its points, take λ f₀(a) + (1 − λ) f₁(b)
/// for two of its points: a point of the hull. It is λ (1 − λ) (A₀ − A₁) (a − b) from where λ f₀ + (1 − λ) f₁, which is
/// off from a pose of the motion by no more than the bow, has the point λ a + (1 − λ) b of the body; A is the linear
/// part. λ (1 − λ) ≤ 1/4; (A₀ − A₁) (a − b) is no longer than 2 |a − b|, and than the angle times the part of a − b
/// that is across the axis.
SweptCell swept_cell(const SharedCluster& cluster, const TimeStretch& stretch, const RigidMotion::Piece* piece) {
  SweptCell cell{cluster, stretch};
  const MovingPart& part = *cluster->part;
  const bool is_posed_exactly = !is_quadric(part.kind());
  if (piece != nullptr && piece->begin == 0 && piece->move.turns == 0 && is_posed_exactly) {
    cell.translation = piece->move.translation;
    return cell;
  }
  const PartMotion motion = part.motion(stretch);
  double reach = 0;
  for (const Vec3& corner : cluster->corners) reach = std::max(reach, motion.reach_of(transform(motion.pose, corner)));
  reach = reach * more_than_roundings + motion.rounding;
  const double step = stretch.end - stretch.begin;
  cell.bow = farthest_from_chord(motion.bounds(reach), step);
  if (piece != nullptr) cell.bow = std::min(cell.bow, 2 * reach * (1 + 0x1p-30));  // about an axis it stays on a circle
  cell.pad = std::max(motion.alike.pad, is_posed_exactly ? 0 : motion.rounding);
  const double across = std::min(cluster->spread, 2 * reach);
  cell.shear = 0.25 * std::min(motion.rate * step, 2.0) * across * (1 + 0x1p-30);
  return cell;
}

SweptHull hull_of(const SweptCell& cell) {
  if (cell.translation) return hull_of_straight(cell);
  const ConvexCluster& cluster = *cell.cluster;
  std::vector<Vec3> corners = transform(cluster.part->pose_at(cell.stretch.begin), cluster.corners);
  const std::vector<Vec3> ends = transform(cluster.part->pose_at(cell.stretch.end), cluster.corners);
  corners.insert(corners.end(), ends.begin(), ends.end());
  const double grown = (cluster.radius + (cell.bow + cell.pad)) * (1 + 0x1p-50);
  return {shape_of(corners, grown), cell.excess() + 0x1p-49 * grown};
}

}  // namespace toccata
