#include "world/swept_box.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "motion/moving_part.hpp"
#include "toccata/broad/broad_phase.hpp"
#include "world/body_box.hpp"

namespace toccata {
namespace {

/// Between two of the moments at which it is looked at a body turns so far at most, in radians: a point then leaves the
/// chord between its places by a 64th of its distance from the axis.
constexpr double greatest_turn = 0.35;
constexpr double most_moments = 64;
constexpr double moments_of_function = 16;  ///< of which no more than the speed is known

/// How far points of it may be from where they are posed, and from the chord of their places at two moments that are
/// `step` apart.
double farthest_off(const MotionBounds& bounds, double step) {
  return farthest_from_chord(bounds, step) + 2 * bounds.pad * (1 + 0x1p-30);
}

double moments_in(const PartMotion& motion, double duration) {
  if (std::isinf(motion.alike.bending)) return moments_of_function;
  return std::clamp(std::ceil(motion.rate * duration / greatest_turn), 1.0, most_moments);
}

/// The moments at which the body is looked at, from the begin of the stretch to its end.
std::vector<double> times_in(const TimeStretch& stretch, const std::vector<MovingPart>& parts) {
  const double duration = stretch.end - stretch.begin;
  double moments = 1;
  for (const MovingPart& part : parts) moments = std::max(moments, moments_in(part.motion(stretch), duration));
  std::vector<double> times{stretch.begin};
  for (int i = 1; i < moments; ++i) times.push_back(std::min(stretch.begin + duration * (i / moments), stretch.end));
  times.push_back(stretch.end);
  return times;
}

std::vector<TimeStretch> stretches_of(const RigidMotion& motion) {
  std::vector<TimeStretch> stretches;
  for (const RigidMotion::Piece& piece : motion.pieces()) stretches.push_back({piece.begin, piece.end});
  if (stretches.empty()) stretches.push_back({0, 1});
  return stretches;
}

}  // namespace

Aabb swept_box(const Body& body, const RigidMotion& motion, FunctionRef<std::string()> who) {
  Aabb box;
  double off = 0;
  const std::string name = who();
  const std::vector<MovingPart> parts = moving_parts(body.model, motion, body.solid, name);
  for (const TimeStretch& stretch : stretches_of(motion)) {
    const std::vector<double> times = times_in(stretch, parts);
    double longest = 0;
    for (std::size_t i = 1; i < times.size(); ++i) longest = std::max(longest, times[i] - times[i - 1]);
    for (const MovingPart& part : parts) {
      const PartMotion moved = part.motion(stretch);
      off = std::max(off, farthest_off(moved.bounds(moved.reach), longest));
      for (const double time : times) static_cast<void>(part.pose_at(time));  // is the bound of a function kept?
    }
    for (const double time : times) box = merge(box, body_box(body, motion.at(time), who));
  }
  return off > 0 ? offset_outward(box, off) : box;
}

}  // namespace toccata
