#include "toccata/motion/rigid_motion.hpp"

#include <algorithm>
#include <optional>
#include <vector>

#include <fmt/format.h>

#include "math/expansion.hpp"
#include "motion/item_contact.hpp"
#include "motion/tree_sweep.hpp"
#include "query/ask.hpp"
#include "query/casts/cast_until.hpp"
#include "query/casts/mesh_casts.hpp"
#include "toccata/core/error.hpp"
#include "toccata/query/distance.hpp"

namespace toccata {
namespace {

/// Straight on all the way.
const Vec3* straight_way(const RigidMotion& motion) {
  const auto pieces = motion.pieces();
  return pieces.size() == 1 && pieces[0].move.turns == 0 ? &pieces[0].move.translation : nullptr;
}

/// The way of A as seen from B, where doubles hold it.
std::optional<Vec3> relative_way(const Vec3& a, const Vec3& b) {
  const Vec3 way = a - b;
  for (int axis = 0; axis < 3; ++axis)
    if (!std::isfinite(way[axis]) || two_difference(a[axis], b[axis]).low != 0) return {};
  return way;
}

/// Times at which a motion changes its piece, 0 and 1 included; ascending.
std::vector<double> times_of_change(const RigidMotion& a, const RigidMotion& b) {
  std::vector<double> times{0, 1};
  for (const RigidMotion* motion : {&a, &b})
    for (const RigidMotion::Piece& piece : motion->pieces()) times.push_back(piece.begin);
  std::sort(times.begin(), times.end());
  times.erase(std::unique(times.begin(), times.end()), times.end());
  return times;
}

/// One question.
class Sweep {
 public:
  Sweep(const Model& a, const RigidMotion& motion_a, const Model& b, const RigidMotion& motion_b,
        const SweepQuery& query, Workspace& workspace)
      : model_a_(a),
        model_b_(b),
        motion_a_(motion_a),
        motion_b_(motion_b),
        query_(query),
        start_{motion_a.at(0), motion_b.at(0), query.solid_a, query.solid_b},
        workspace_(workspace) {}

  std::optional<ShapeHit> answer() {
    if (const auto way = straight_relative_way()) return along_straight(*way);
    require_defined();
    if (const auto hit = at_start()) return hit;
    const std::vector<double> times = times_of_change(motion_a_, motion_b_);
    workspace_.scratch().counts = {};
    for (std::size_t i = 1; i < times.size(); ++i)
      if (const auto hit = within({times[i - 1], times[i]})) return hit;
    return {};
  }

 private:
  /// How A goes straight on, seen from B; none where that is no way of doubles.
  std::optional<Vec3> straight_relative_way() const {
    const Vec3 *way_a = straight_way(motion_a_), *way_b = straight_way(motion_b_);
    if (way_a == nullptr || way_b == nullptr || query_.stop_before != 0) return {};
    return relative_way(*way_a, *way_b);
  }

  std::optional<ShapeHit> along_straight(const Vec3& way) {
    std::optional<ShapeHit> hit = cast_shape(model_a_, way, model_b_, start_, workspace_);
    if (hit) hit->point += hit->upper * *straight_way(motion_b_);
    return hit;
  }

  void require_defined() {
    const PosedModelPair models(model_a_, model_b_, start_, workspace_.scratch());
    require_all_answered(ShapeQuestion::cast_shape, models.a, models.b);
  }

  std::optional<ShapeHit> at_start() {
    if (query_.stop_before < 0) return {};
    // What they meet where they are is told by a cast that does not move.
    const auto met = cast_until(model_a_, Vec3{}, model_b_, start_, 1, workspace_);
    if (met || query_.stop_before == 0) return met;
    if (!within_distance(model_a_, model_b_, query_.stop_before, start_, workspace_)) return {};
    const Distance found = distance(model_a_, model_b_, start_, workspace_);
    const Vec3 normal = found.upper > 0 ? normalized(found.on_a - found.on_b) : Vec3{};
    return ShapeHit{
        {0, 0, found.on_b, normal, found.status}, found.element_a, found.element_b, found.face_a, found.face_b};
  }

  /// A function that is faster than its bound from one end to the other is found out, whatever else is looked at.
  static void require_bounds(const std::vector<MovingPart>& parts, const TimeStretch& stretch) {
    for (const MovingPart& part : parts)
      for (const double time : {stretch.begin, stretch.end}) static_cast<void>(part.pose_at(time));
  }

  std::optional<ShapeHit> within(const TimeStretch& stretch) {
    std::optional<ShapeHit> first;
    const auto parts_a = moving_parts(model_a_, motion_a_, query_.solid_a, "model a");
    const auto parts_b = moving_parts(model_b_, motion_b_, query_.solid_b, "model b");
    for (const auto* parts : {&parts_a, &parts_b}) require_bounds(*parts, stretch);
    for (const MovingPart& a : parts_a)
      for (const MovingPart& b : parts_b)
        if (const auto hit = of_parts(a, b, stretch, first ? first->upper : stretch.end))
          keep_first(first, completed(*hit, a, b));
    return first;
  }

  std::optional<ShapeHit> of_parts(const MovingPart& a, const MovingPart& b, const TimeStretch& stretch, double limit) {
    if (a.shape().has_mesh() || b.shape().has_mesh())
      return tree_sweep(a, b, stretch, query_.stop_before, limit, workspace_.scratch().counts);
    const auto found = item_contact(a, 0, b, 0, stretch, gap_bounds(a, b, stretch), query_.stop_before);
    if (!found) return {};
    return ShapeHit{{found->lower, found->upper, {}, found->normal, found->status}};
  }

  /// The hit with where they meet, and elements and faces as the models count them.
  static ShapeHit completed(ShapeHit hit, const MovingPart& a, const MovingPart& b) {
    hit.point = item_point_on_b(a, hit.element_a, b, hit.element_b, hit.lower);
    hit.face_a = face_of(a, hit.element_a) + a.first_face;
    hit.face_b = face_of(b, hit.element_b) + b.first_face;
    hit.element_a += a.first_element;
    hit.element_b += b.first_element;
    return hit;
  }

  static Index face_of(const MovingPart& part, Index element) {
    return part.shape().has_mesh() ? part.shape().mesh().face_of(element) : 0;
  }

  const Model& model_a_;
  const Model& model_b_;
  const RigidMotion& motion_a_;
  const RigidMotion& motion_b_;
  const SweepQuery& query_;
  PairQuery start_;
  Workspace& workspace_;
};

}  // namespace

std::optional<ShapeHit> sweep(const Model& a, const RigidMotion& motion_a, const Model& b, const RigidMotion& motion_b,
                              const SweepQuery& query) {
  Workspace workspace;
  return sweep(a, motion_a, b, motion_b, query, workspace);
}

std::optional<ShapeHit> sweep(const Model& a, const RigidMotion& motion_a, const Model& b, const RigidMotion& motion_b,
                              const SweepQuery& query, Workspace& workspace) {
  if (!std::isfinite(query.stop_before))
    throw Error(fmt::format("a sweep: stop_before is {:g}; it has to be a finite length", query.stop_before));
  return Sweep(a, motion_a, b, motion_b, query, workspace).answer();
}

}  // namespace toccata
