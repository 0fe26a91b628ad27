#include "motion/moving_part.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "bounds/box_corners.hpp"
#include "math/vec3_measures.hpp"
#include "toccata/core/error.hpp"

namespace toccata {
namespace {

constexpr Index most_outline_points = 8;  ///< of a box; what has more vertices is seen as its box

std::vector<Vec3> outline_of(const PosedPolytope& local) {
  std::vector<Vec3> vertices;
  for (Index i = 0; i < local.vertex_count(); ++i) vertices.push_back(local.vertex(i));
  if (local.vertex_count() <= most_outline_points) return vertices;
  Aabb box;
  for (const Vec3& vertex : vertices) box = merge(box, vertex);
  return corners_of(box);
}

MovingCore core_of(const Model& shape) {
  if (shape.has_mesh()) return {corners_of(shape.bounds())};
  if (const auto* half_space = std::get_if<HalfSpace>(&shape.shape())) return {{half_space->point()}};
  const PosedShape local = pose_shape(shape, {}, Solid::automatic, "a shape");
  if (const auto* polytope = std::get_if<PosedPolytope>(&local)) return {outline_of(*polytope), polytope->radius()};
  return {corners_of(world_box(local))};
}

/// |R| v + |t|: as large as the numbers become that are added up for a world coordinate.
Vec3 magnitudes_in(const Pose& pose, const Vec3& v) {
  Vec3 result = magnitudes(pose.offset);
  for (int i = 0; i < 3; ++i) result[i] += dot(magnitudes(pose.linear[i]), v);
  return result;
}

Vec3 greatest_magnitudes_of(const std::vector<Vec3>& points) {
  Vec3 greatest;
  for (const Vec3& point : points)
    for (int axis = 0; axis < 3; ++axis) greatest[axis] = std::max(greatest[axis], std::fabs(point[axis]));
  return greatest;
}

void add_parts(const Model& model, const std::vector<Pose>& chain, const RigidMotion& motion, Solid solid,
               std::string_view who, std::vector<MovingPart>& parts) {
  const auto* compound = std::get_if<Compound>(&model.shape());
  if (compound == nullptr) {
    MovingPart part(model, chain, motion, solid, who);
    if (!parts.empty()) {
      part.first_element = parts.back().first_element + parts.back().shape().element_count();
      part.first_face = parts.back().first_face + parts.back().shape().face_count();
    }
    parts.push_back(std::move(part));
    return;
  }
  for (std::size_t i = 0; i < model.parts().size(); ++i) {
    std::vector<Pose> longer = chain;
    longer.push_back(compound->parts()[i].pose);
    add_parts(model.parts()[i], longer, motion, solid, who, parts);
  }
}

/// How far a point can be from those of a box.
double farthest_from(const Vec3& point, const Aabb& box) {
  Vec3 gap;
  for (int axis = 0; axis < 3; ++axis)
    gap[axis] = std::max(std::fabs(box.upper[axis] - point[axis]), std::fabs(point[axis] - box.lower[axis]));
  return length(gap) * (1 + 0x1p-40);
}

/// With the normal n and the point q of the half-space and a point b of the other, the height is n · (b − q), and
/// |n′| ≤ rate, |n″| ≤ rate². With d = b − q, at most `far` long: |height′| ≤ rate · far + |d′|, and |height″| ≤
/// rate² · far + 2 rate · |d′| + |d″|. What is known of the speed alone has no second derivative.
GapBounds half_space_bounds(const MovingPart& half_space, const MovingPart& other, const TimeStretch& stretch) {
  const PartMotion own = half_space.motion(stretch), others = other.motion(stretch);
  GapBounds bounds = gap_bounds(own.bounds(own.reach), others.bounds(others.reach));
  const Vec3 at = transform(half_space.pose_at(stretch.begin), half_space.core().outline.front());
  const double far = farthest_from(at, world_box(other.at(stretch.begin))) +
                     (bounds.speed * (stretch.end - stretch.begin) + bounds.pad);
  bounds.bending += own.rate * (own.rate * far + 2 * bounds.speed);
  bounds.speed += own.rate * far;
  bounds.pad += half_space.pose_error(stretch) * far;
  return bounds;
}

}  // namespace

MovingPart::MovingPart(const Model& shape, std::vector<Pose> chain, const RigidMotion& motion, Solid solid,
                       std::string_view who)
    : shape_(&shape), chain_(std::move(chain)), motion_(&motion), solid_(solid), who_(who), core_(core_of(shape)) {}

Pose MovingPart::through_chain(Pose pose) const {
  for (const Pose& next : chain_) pose = pose * next;
  return pose;
}

Pose MovingPart::pose_at(double time) const {
  const Pose pose = motion_->at(time);
  if (motion_->pieces().empty()) {
    if (last_) require_bound(*last_, {time, pose});
    last_ = Sample{time, pose};
  }
  return through_chain(pose);
}

/// A column of R is as long as it was, and turns as the shape does. What is allowed beyond the bound covers rounding.
void MovingPart::require_bound(const Sample& before, const Sample& now) const {
  const MotionSpeed& bound = motion_->speed();
  const double passed = std::fabs(now.time - before.time) * (1 + 0x1p-30);
  const Vec3 from = transform(before.pose, bound.centre), to = transform(now.pose, bound.centre);
  bool is_kept = length(to - from) <= bound.speed * passed + 2 * bound.rounding +
                                          0x1p-46 * (sum_of_magnitudes(from) + sum_of_magnitudes(to));
  for (int i = 0; i < 3; ++i) {
    const Vec3 old = before.pose.linear.column(i);
    const double turned = length(now.pose.linear.column(i) - old);
    is_kept = is_kept && turned <= (radians_in_a_turn * bound.turns * passed + 0x1p-44) * length(old);
  }
  if (!is_kept)
    throw Error(fmt::format("{}: between the times {} and {} the motion is faster than its bound (speed {}, turns {})",
                            who_, std::min(before.time, now.time), std::max(before.time, now.time), bound.speed,
                            bound.turns));
}

const RigidMotion::Piece* MovingPart::piece(const TimeStretch& stretch) const {
  for (const RigidMotion::Piece& p : motion_->pieces())
    if (stretch.begin < p.end) return &p;
  return nullptr;
}

/// The distance from an axis, or from a point, is convex: of a hull it is greatest at one of the points.
double MovingPart::farthest_reach(const PartMotion& motion) const {
  double reach = 0;
  for (const Vec3& point : core_.outline) reach = std::max(reach, motion.reach_of(transform(motion.pose, point)));
  return reach * (1 + 0x1p-40) + motion.rounding;
}

/// At least the sum of the magnitudes of all numbers that are added up for a world coordinate of a point of its core.
double MovingPart::size(const Pose& start) const {
  Vec3 largest = greatest_magnitudes_of(core_.outline);
  for (std::size_t i = chain_.size(); i-- > 0;) largest = magnitudes_in(chain_[i], largest);
  return sum_of_magnitudes(magnitudes_in(start, largest));
}

/// With u = 2⁻⁵³, by which one rounding is off at most: R(axis, angle) as computed is off from the rotation by less
/// than (84 + 64 |turns|) u, of which 84 are those of its nine numbers (each of at most 28 u: the direction of the
/// axis, sine and cosine of at most 4 u, six roundings), and the rest the angle's, whose part of the way passes five
/// roundings. The products of the matrices, of the parts' poses and of a vertex are off by less than 44 u of the sizes
/// each. Where a piece begins, the one before has ended, as far off. A function is taken at its word, but for the
/// rounding of vertices.
double MovingPart::pose_error(const TimeStretch& stretch) const {
  const auto composed = static_cast<double>(1 + chain_.size());
  const auto* p = piece(stretch);
  if (p == nullptr) return 16 * unit_roundoff * composed;
  const auto pieces = static_cast<double>(1 + (p - motion_->pieces().data()));
  return pieces * composed * (128 + 64 * std::fabs(p->move.turns)) * unit_roundoff;
}

PartMotion MovingPart::motion(const TimeStretch& stretch) const {
  PartMotion motion;
  double sizes = 0;
  if (const auto* p = piece(stretch)) {
    const double duration = p->end - p->begin;
    motion = {through_chain(p->start),
              p->move.centre,
              normalized(p->move.axis),
              radians_in_a_turn * std::fabs(p->move.turns) / duration,
              {}};
    motion.alike.velocity = p->move.translation / duration;
    sizes = size(p->start) + 2 * sum_of_magnitudes(p->move.centre) + sum_of_magnitudes(p->move.translation);
    const bool rests = p->begin == 0 && p->move.turns == 0 && p->move.translation == Vec3{};
    motion.alike.pad = rests ? 0 : pose_error(stretch) * sizes;
  } else {
    const Pose start = motion_->at(stretch.begin);
    const MotionSpeed& bound = motion_->speed();
    motion = {through_chain(start), transform(start, bound.centre), {}, radians_in_a_turn * bound.turns, {}};
    sizes = size(start);
    motion.alike = {{}, bound.speed, infinity, pose_error(stretch) * sizes + bound.rounding};
    motion.rounding = 2 * bound.rounding;  // of the point and of the centre
  }
  motion.rounding += 0x1p-46 * (sizes + sum_of_magnitudes(motion.centre));
  motion.reach = farthest_reach(motion);
  return motion;
}

std::vector<MovingPart> moving_parts(const Model& model, const RigidMotion& motion, Solid solid, std::string_view who) {
  std::vector<MovingPart> parts;
  add_parts(model, {}, motion, solid, who, parts);
  return parts;
}

GapBounds gap_bounds(const MovingPart& a, const MovingPart& b, const TimeStretch& stretch) {
  if (a.is_half_space()) return half_space_bounds(a, b, stretch);
  if (b.is_half_space()) return half_space_bounds(b, a, stretch);
  const PartMotion of_a = a.motion(stretch), of_b = b.motion(stretch);
  return gap_bounds(of_a.bounds(of_a.reach), of_b.bounds(of_b.reach));
}

}  // namespace toccata
