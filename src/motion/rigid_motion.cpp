#include "toccata/motion/rigid_motion.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "math/vec3_measures.hpp"
#include "motion/move_between.hpp"
#include "motion/point_bounds.hpp"
#include "narrow/pose_checks.hpp"
#include "toccata/core/error.hpp"
#include "toccata/math/trigonometry.hpp"

namespace toccata {
namespace {

constexpr std::string_view who = "a motion";

void require_finite(const RigidMove& move) {
  if (!is_finite(move.centre) || !is_finite(move.axis) || !is_finite(move.translation) || !std::isfinite(move.turns))
    throw Error("a motion: a number of its move is not finite");
  if (move.turns != 0 && move.axis == Vec3{}) throw Error("a motion: the axis of its turn is zero; give a direction");
}

RigidMove move_between(const Pose& start, const Pose& end, const Vec3& centre) {
  require_finite(start, who);
  require_finite(end, who);
  const TurnBetween turn = turn_between(start.linear, end.linear);
  const Vec3 from = transform(start, centre), to = transform(end, centre);
  return {from, turn.axis, turn.turns, to - from};
}

/// The point of the axis that is nearest to where the origin of the shape is at the start: with d the part of its way
/// that lies across the axis, (I − R)(c − start) = d.
RigidMove screw_between(const Pose& start, const Pose& end) {
  RigidMove move = move_between(start, end, {});
  // A turn that is but rounding has no axis that means anything.
  if (std::fabs(move.turns) < 0x1p-48) move.turns = 0;
  if (move.turns == 0) return move;
  const Vec3 along = dot(move.axis, move.translation) * move.axis, across = move.translation - along;
  const SineCosine half = sine_cosine_of_turns(0.5 * move.turns);
  move.centre += 0.5 * (across + (half.cosine / half.sine) * cross(move.axis, across));
  move.translation = along;
  return move;
}

void require_times(std::span<const MotionKey> keys) {
  if (keys.size() < 2) throw Error("a motion through poses needs at least two of them");
  if (keys.front().time != 0 || keys.back().time != 1)
    throw Error(fmt::format("a motion through poses: the times go from {} to {}; they have to go from 0 to 1",
                            keys.front().time, keys.back().time));
  for (std::size_t i = 1; i < keys.size(); ++i)
    if (!(keys[i - 1].time < keys[i].time))
      throw Error(fmt::format("a motion through poses: the time of pose {} is {}, which does not come after {}", i,
                              keys[i].time, keys[i - 1].time));
}

/// How far a point under a pose is from another at most. The place passes four roundings of what it is made of, the
/// length of the difference five; twice as much is allowed.
double most_beside(const Pose& pose, const Vec3& point, const Vec3& other) {
  double sizes = sum_of_magnitudes(pose.offset) + sum_of_magnitudes(other);
  for (int i = 0; i < 3; ++i) sizes += dot(magnitudes(pose.linear[i]), magnitudes(point));
  return length(pose * point - other) + 0x1p-49 * sizes;
}

}  // namespace

RigidMotion::RigidMotion(const Pose& pose) : RigidMotion(pose, RigidMove{}) {}

RigidMotion::RigidMotion(const Pose& start, const RigidMove& move) {
  require_finite(start, who);
  require_finite(move);
  pieces_.push_back({0, 1, start, move});
}

RigidMotion RigidMotion::straight(const Pose& start, const Vec3& translation) {
  return {start, RigidMove{.translation = translation}};
}

RigidMotion RigidMotion::between(const Pose& start, const Pose& end, const Vec3& centre) {
  return {start, move_between(start, end, centre)};
}

RigidMotion RigidMotion::screw(const Pose& start, const Pose& end) { return {start, screw_between(start, end)}; }

RigidMotion RigidMotion::through(std::span<const MotionKey> keys, const Vec3& centre) {
  require_times(keys);
  RigidMotion motion;
  Pose start = keys.front().pose;
  for (std::size_t i = 1; i < keys.size(); ++i) {
    const RigidMove move = move_between(start, keys[i].pose, centre);
    require_finite(move);
    motion.pieces_.push_back({keys[i - 1].time, keys[i].time, start, move});
    start = moved(start, move, 1);  // and not the key, from which it may be off by what the key's matrix is off
  }
  return motion;
}

RigidMotion RigidMotion::of_pieces(std::vector<Piece> pieces) {
  double time = 0;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const Piece& piece = pieces[i];
    require_finite(piece.start, who);
    require_finite(piece.move);
    if (piece.begin != time || !(piece.begin < piece.end))
      throw Error(fmt::format("a motion of pieces: piece {} is from {} to {}; it has to begin at {} and to end later",
                              i, piece.begin, piece.end, time));
    time = piece.end;
  }
  if (time != 1) throw Error(fmt::format("a motion of pieces: the last piece ends at {}; it has to end at 1", time));
  RigidMotion motion;
  motion.pieces_ = std::move(pieces);
  return motion;
}

RigidMotion RigidMotion::of(std::function<Pose(double)> pose_at, const MotionSpeed& bound) {
  if (!pose_at) throw Error("a motion told by a function: there is no function");
  const auto is_bound = [](double number) { return number >= 0 && std::isfinite(number); };
  if (!is_finite(bound.centre) || !is_bound(bound.speed) || !is_bound(bound.turns) || !is_bound(bound.rounding))
    throw Error(
        fmt::format("a motion told by a function: its speed {}, its turns {} and its rounding {} have to be bounds, 0 "
                    "or more",
                    bound.speed, bound.turns, bound.rounding));
  RigidMotion motion;
  motion.pose_at_ = std::move(pose_at);
  motion.speed_ = bound;
  return motion;
}

RigidMotion RigidMotion::carrying(const Pose& fixed) const {
  require_finite(fixed, who);
  RigidMotion motion = *this;
  for (Piece& piece : motion.pieces_) piece.start = piece.start * fixed;
  if (!pieces_.empty()) return motion;
  motion.pose_at_ = [pose_at = pose_at_, fixed](double time) { return pose_at(time) * fixed; };
  motion.speed_.centre = inverse(fixed) * speed_.centre;
  motion.speed_.speed += radians_in_a_turn * speed_.turns * most_beside(fixed, motion.speed_.centre, speed_.centre);
  return motion;
}

Pose RigidMotion::at(double time) const {
  if (!(time >= 0 && time <= 1)) throw Error(fmt::format("a motion: the time {} is not between 0 and 1", time));
  if (pieces_.empty()) {
    const Pose pose = pose_at_(time);
    require_finite(pose, who);
    return pose;
  }
  const auto piece =
      std::partition_point(pieces_.begin(), pieces_.end() - 1, [&](const Piece& p) { return p.end < time; });
  return moved(piece->start, piece->move, (time - piece->begin) / (piece->end - piece->begin));
}

}  // namespace toccata
