#include "world/character_mover/mover_body.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "math/constants.hpp"
#include "math/vec3_measures.hpp"
#include "toccata/core/error.hpp"
#include "toccata/narrow/convex_convex.hpp"
#include "toccata/narrow/quadrics.hpp"
#include "toccata/query/pairs.hpp"

namespace toccata {
namespace {

struct MoverCore {
  Shape shape;
  double radius = 0;
};

/// The shape without the ball that it is grown by.
MoverCore mover_core(const Shape& shape) {
  if (const auto* sphere = std::get_if<Sphere>(&shape)) return {Point(sphere->centre()), sphere->radius()};
  if (const auto* capsule = std::get_if<Capsule>(&shape))
    return {Segment(capsule->start(), capsule->end()), capsule->radius()};
  if (const auto* rounded = std::get_if<Rounded>(&shape))
    return {std::visit([](const auto& core) { return Shape(core); }, rounded->core()), rounded->radius()};
  return {shape, 0};
}

const Model& require_mover(const Model& model) {
  const ShapeClass kind = class_of(kind_of(model.shape()));
  if (kind != ShapeClass::convex && kind != ShapeClass::quadric)
    throw Error(
        fmt::format("a character is a {}: it has to be one bounded convex shape, as a capsule; for anything else "
                    "take a convex hull around it",
                    name_of(model.shape())));
  return model;
}

/// More than it takes to leave a thing 2³⁰ times as large, by twice as much each time, and to turn a few times.
constexpr int most_rounds_apart = 48;

/// Where to move a body that meets a thing, for the two to part.
Vec3 way_apart(const Aabb& body, const LevelElement& thing) {
  if (const auto* floor = std::get_if<PosedHalfSpace>(&thing.set.posed())) return normalized(floor->normal);
  const Vec3 way = normalized((body.lower + body.upper) - (thing.box.lower + thing.box.upper));
  return way == Vec3{} ? Vec3{0, 0, 1} : way;
}

std::variant<PosedPolytope, PosedQuadric> posed_set(const Shape& shape, const Pose& pose) {
  PosedShape posed = pose_shape(Model(shape), pose, Solid::automatic, "the character");
  if (auto* polytope = std::get_if<PosedPolytope>(&posed)) return *polytope;
  return std::get<PosedQuadric>(posed);
}

}  // namespace

ElementSet::ElementSet(LevelSet set)
    : set_(std::make_shared<const LevelSet>(std::move(set))),
      edges_(std::make_shared<const ThingEdges>(edges_of(*set_))) {}

MoverBody::MoverBody(const Model& shape, const Pose& pose)
    : model_(require_mover(shape)),
      pose_(pose),
      radius_(mover_core(shape.shape()).radius),
      core_shape_(mover_core(shape.shape()).shape),
      whole_(posed_set(shape.shape(), pose)),
      core_(posed_set(core_shape_, pose)),
      box_(std::visit([](const auto& set) { return world_box(set); }, whole_)) {
  const Vec3 sides = box_.upper - box_.lower;
  size_ = std::max({sides.x, sides.y, sides.z});
  const auto* polytope = std::get_if<PosedPolytope>(&core_);
  if (polytope != nullptr) point_ = polytope->vertex(0) - pose.offset;
}

Aabb MoverBody::box_at(const Vec3& position) const {
  const Vec3 by = position - pose_.offset;
  const Aabb moved{box_.lower + by, box_.upper + by};
  double extent = 0;
  for (int axis = 0; axis < 3; ++axis)
    extent = std::max({extent, std::abs(position[axis]), std::abs(pose_.offset[axis]), std::abs(box_.lower[axis]),
                       std::abs(box_.upper[axis])});
  return widened(moved, 8 * unit_roundoff * extent);
}

MoverBody::Set MoverBody::at(const Set& set, const Vec3& position) const {
  const Vec3 by = position - pose_.offset;
  if (by == Vec3{}) return set;
  if (const auto* polytope = std::get_if<PosedPolytope>(&set)) return polytope->moved(by);
  return posed_set(core_shape_, pose_at(position));
}

double MoverBody::depth_below(const Vec3& up) const {
  // A half-space so far below that it does not meet the body.
  const double below = 4 * (size_ + length(point_));
  const PosedHalfSpace floor(HalfSpace(pose_.offset - below * up, up));
  const double height = std::visit([&](const auto& set) { return distance(set, floor).lower; }, whole_);
  return below - height;
}

/// By the nearest points of the core, which tell the way out of what the body overlaps as long as the core does not.
template <class Body>
std::optional<MoverGap> MoverBody::core_gap(const Body& core, const LevelSet& set) const {
  const Distance found = std::visit([&](const auto& thing) { return distance(core, thing); }, set);
  if (!(found.lower > 0)) return {};
  const Vec3 normal = normalized(found.on_a - found.on_b);
  if (normal == Vec3{}) return {};
  return MoverGap{found.lower - radius_, normal, found.on_b, found.lower};
}

/// Where even the core meets the thing: the way in which the two part soonest.
MoverGap MoverBody::overlap_at(const Vec3& position, const LevelElement& thing) const {
  const Set whole = at(whole_, position);
  const Manifold overlapping =
      std::visit([](const auto& body, const auto& other) { return manifold(body, other); }, whole, thing.set.posed());
  if (overlapping.count == 0 || overlapping.normal == Vec3{}) return gap_from_apart(position, thing);
  // They are not known to be apart, so a depth below 0 is rounding.
  MoverGap deepest{0, -overlapping.normal, point_at(position), 0};
  for (int i = 0; i < overlapping.count; ++i) {
    const ManifoldPoint& point = overlapping.points[static_cast<std::size_t>(i)];
    if (i > 0 && -point.depth >= deepest.distance) continue;
    deepest.distance = std::min(-point.depth, 0.0);
    deepest.point = point.position;
  }
  return deepest;
}

/// Where the two meet so little that no way out is told, as quadrics that touch but for rounding: the body is moved
/// apart, and the plane across the shortest way between the two then tells how deep they are in each other along its
/// normal before. Moved apart along that normal next, the two are found to be less deep, or as deep.
MoverGap MoverBody::gap_from_apart(const Vec3& position, const LevelElement& thing) const {
  MoverGap best{-infinity, {}, point_at(position), 0};
  Vec3 way = way_apart(box_at(position), thing);
  double by = 0x1p-10 * size_;
  for (int round = 0; round < most_rounds_apart; ++round) {
    const Vec3 apart = position + by * way;
    const Set core = at(core_, apart);
    const auto gap = std::visit([&](const auto& body) { return core_gap(body, thing.set.posed()); }, core);
    if (!gap) {
      by *= 2;
      continue;
    }
    const double before = gap->distance - dot(gap->normal, apart - position);
    if (!(before > best.distance)) break;
    best = {std::min(before, 0.0), gap->normal, gap->point, 0};
    way = gap->normal;
  }
  if (best.normal == Vec3{}) best.distance = 0;
  return best;
}

MoverBody::Placed MoverBody::placed_at(const Vec3& position) const {
  Placed placed{position, {}};
  const auto* core = std::get_if<PosedPolytope>(&core_);
  FewCorners& few = placed.corners;
  if (core == nullptr || core->vertex_count() > few.corners.size()) return placed;
  const Vec3 by = position - pose_.offset;
  for (Index i = 0; i < core->vertex_count(); ++i) few.add(core->vertex(i) + by);
  return placed;
}

RoundedBox MoverBody::reach_of(const Placed& placed, const Vec3& motion, double distance) const {
  const FewCorners& corners = placed.corners;
  const bool has_corners = corners.count > 0;
  Aabb core = has_corners ? Aabb{} : box_at(placed.position);
  for (std::size_t i = 0; i < corners.count; ++i) core = merge(core, corners.corners[i]);
  const double extent = std::max(largest_magnitude(core.lower), largest_magnitude(core.upper));
  const Aabb way = merge(core, Aabb{core.lower + motion, core.upper + motion});
  const double slack = height_slack(extent, largest_magnitude(motion));
  return {way, (has_corners ? radius_ : 0) + distance + slack};
}

RoundedBox MoverBody::reached_in(const Aabb& box) const {
  if (placed_at(pose_.offset).corners.count == 0) return {box, 0};
  const double extent = std::max(largest_magnitude(box.lower), largest_magnitude(box.upper));
  const double slack = 4 * height_slack(extent, 0), inward = radius_ - slack;
  const Vec3 by{inward, inward, inward};
  return {{box.lower + by, box.upper - by}, radius_ + slack};
}

MoverBody::Bound MoverBody::bound_of(const Placed& placed, const LevelElement& thing) const {
  const double radii = radius_ + thing.planes.radius;
  const PlaneGap gap = plane_gap(placed.corners, thing.planes);
  return {gap.distance - radii, gap};
}

MoverGap MoverBody::gap_of(const Placed& placed, const LevelElement& thing) const {
  const Bound bound = bound_of(placed, thing);
  if (bound.planes.is_exact)
    return {bound.distance, bound.planes.normal, bound.planes.foot + thing.planes.radius * bound.planes.normal,
            bound.planes.distance};
  if (const auto edge = thing.set.gap_at_edge(placed.corners))
    return {edge->distance - radius_ - thing.planes.radius, edge->normal,
            edge->foot + thing.planes.radius * edge->normal, edge->distance};
  const Set placed_core = at(core_, placed.position);
  const auto gap = std::visit([&](const auto& core) { return core_gap(core, thing.set.posed()); }, placed_core);
  return gap ? *gap : overlap_at(placed.position, thing);
}

}  // namespace toccata
