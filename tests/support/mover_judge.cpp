#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "support/mover_levels.hpp"
#include "toccata/core/random.hpp"
#include "toccata/query/distance.hpp"

namespace toccata::test {
namespace {

/// How many times as far as to a place that is free a character may be pushed, besides the skin.
constexpr double recovery_factor = 10;

/// A step, and what was asked.
struct JudgedStep {
  const MoverLevelCase& level;
  const Model& shape;
  const MoverState<Index>& from;
  const Vec3& motion;
  const MoverOptions& options;
  const MoverStep<Index>& step;
  Vec3 up = normalized(options.up);
  Vec3 own = step.moved - step.carried - step.pushed_out;
  double asked = dot(motion, up);

  [[nodiscard]] bool walks() const { return from.ground && asked <= 0; }
  [[nodiscard]] Vec3 level_part(const Vec3& v) const { return v - dot(v, up) * up; }
  [[nodiscard]] bool is_near(const Pose& pose, double distance) const {
    return is_within(level.level, shape, pose, distance);
  }
};

/// What is wrong with a step in which nothing was met; empty if nothing is. Such a step leads where it was wanted, and
/// the casts of the library, which are made otherwise, meet nothing on the way, which is straight, and then down to the
/// ground.
std::string fault_of_free_way(const JudgedStep& judged) {
  const MoverStep<Index>& step = judged.step;
  if (!step.contacts.empty() || step.stepped || !(judged.own == step.moved) || judged.is_near(judged.from.pose, 0))
    return {};
  const double length_asked = length(judged.motion);
  const Vec3 aside = judged.walks() ? judged.level_part(judged.motion) : judged.motion;
  const Vec3 down = step.moved - aside;
  if (length(judged.level_part(down)) > 1e-12 * (1 + length_asked)) return "it met nothing and went astray";
  if (!judged.walks() && length(down) > 1e-12 * (1 + length_asked)) return "it met nothing and stopped";
  Pose pose = judged.from.pose;
  for (const Vec3& leg : {aside, down}) {
    if (!(leg == Vec3{}) && judged.level.level.cast_shape({{judged.shape, pose}, leg}))
      return "it passed through something";
    pose.offset += leg;
  }
  return {};
}

/// It comes no nearer than it may, and what it says of where it is holds.
std::string fault_of_nearness(const JudgedStep& judged) {
  const MoverStep<Index>& step = judged.step;
  const double skin = judged.options.skin, least = 0.875 * skin - 1e-9;
  if (judged.is_near(step.state.pose, least)) {
    const double before = distance_from_level(judged.level.level, judged.shape, judged.from.pose);
    const double after = distance_from_level(judged.level.level, judged.shape, step.state.pose);
    if (after < std::min(before - 1e-9, least))
      return fmt::format("the distance was {} and is {}, with a skin of {}", before, after, skin);
    if (!step.tight) return fmt::format("it is as near as {} and not said to be", after);
  }
  if (!(step.pushed_out == Vec3{}) && !judged.is_near(judged.from.pose, skin)) return "pushed out of nothing";
  if ((step.stuck || step.crushed) && !judged.is_near(judged.from.pose, 0)) return "stuck in nothing";
  if (step.state.ground && !judged.is_near(step.state.pose, 1.125 * skin + 1e-9)) return "the ground is not near";
  return {};
}

/// It goes no farther and rises no higher than it is asked to.
std::string fault_of_length(const JudgedStep& judged) {
  const double rise = dot(judged.own, judged.up), asked = judged.asked, skin = judged.options.skin;
  const double wanted = length(judged.level_part(judged.motion)), whole = length(judged.motion);
  const double slope = std::tan(judged.options.max_slope_degrees * std::numbers::pi / 180);
  if (rise > std::max(asked, 0.0) + slope * wanted + (judged.step.stepped ? judged.options.step_height : 0) + skin)
    return fmt::format("rose by {}", rise);
  // A wall that leans leads one aside who is put down beside it, by as much as he has gone.
  const double aside = length(judged.level_part(judged.own));
  const double most = judged.walks() && judged.step.met_wall ? 1.01 * std::sqrt(2) * whole : whole;
  if (aside > most * (1 + 1e-9) + 2 * skin) return fmt::format("went aside by {}", aside);
  if (!judged.walks() && length(judged.own) > whole * (1 + 1e-9) + 1e-9)
    return fmt::format("it has gone {}", length(judged.own));
  return {};
}

/// Along one plane nothing is lost: what is wanted along it is gone to the end.
std::string fault_of_slide(const JudgedStep& judged) {
  const MoverStep<Index>& step = judged.step;
  if (step.contacts.empty() || step.stepped || step.tight || step.cut_short) return {};
  const Vec3 normal = step.contacts.front().normal;
  for (const MoverContact<Index>& contact : step.contacts)
    if (length(contact.normal - normal) > 1e-9) return {};
  const double tolerance = 1e-8 * (1 + length(judged.motion) + length(judged.from.pose.offset));
  const Vec3 lost = judged.own - (judged.walks() ? judged.level_part(judged.motion) : judged.motion);
  const Vec3 across = normalized(cross(normal, judged.up));
  const double height = dot(normal, judged.up);
  const bool is_walkable = height >= std::cos(judged.options.max_slope_degrees * std::numbers::pi / 180);
  const bool is_steep = height > 0 && !is_walkable;
  if (std::abs(dot(lost, across)) > tolerance) return fmt::format("it lost {} along a wall", dot(lost, across));
  const Vec3 along = cross(across, normal);
  if (!judged.walks() && !is_steep && std::abs(dot(lost, along)) > tolerance)
    return fmt::format("it lost {} up or down a wall", dot(lost, along));
  // A walker's place costs a million times what his height does.
  const double slowed = length(judged.level_part(lost));
  if (judged.walks() && is_walkable && slowed > 1e-5 * length(judged.motion) + tolerance)
    return fmt::format("it lost {} on a slope", slowed);
  return {};
}

std::string fault_of_place(const JudgedStep& judged) {
  const Vec3& at = judged.step.state.pose.offset;
  const MoverLevelCase& level = judged.level;
  const bool is_held = !(level.lower == level.upper);
  for (int axis = 0; is_held && axis < 3; ++axis)
    if (at[axis] < level.lower[axis] || at[axis] > level.upper[axis]) return "it has left the room";
  return {};
}

/// Ways in 26 directions, those of a cube's faces, edges and corners.
std::vector<Vec3> ways_all_around() {
  std::vector<Vec3> ways;
  for (const double z : {-1, 0, 1})
    for (const double y : {-1, 0, 1})
      for (const double x : {-1, 0, 1})
        if (const Vec3 way{x, y, z}; way != Vec3{}) ways.push_back(normalized(way));
  return ways;
}

/// The same again, and once more without a motion.
std::string fault_of_repeating(const JudgedStep& judged) {
  const SceneIndex& level = judged.level.level;
  const MoverStep<Index>& step = judged.step;
  if (!(move_character(level, judged.shape, judged.from, judged.motion, judged.options) == step))
    return "the same step again is another";
  if (!step.state.ground || step.tight) return {};
  const MoverStep<Index> rest = move_character(level, judged.shape, step.state, {}, judged.options);
  return rest.state.pose == step.state.pose ? "" : "it does not stand still";
}

Vec3 level_motion(Random& random, double slowest) {
  const double angle = random.between(-std::numbers::pi, std::numbers::pi);
  return random.between(slowest, 0.3) * Vec3{std::cos(angle), std::sin(angle), 0};
}

Vec3 random_motion(Vec3& wanted, bool stands, Random& random) {
  if (random.below(12) == 0) wanted = level_motion(random, 0.001);
  Vec3 motion = wanted - Vec3{0, 0, stands ? 0.0 : 0.15};
  if (random.below(20) == 0) motion += Vec3{0, 0, 0.5};
  if (random.below(40) == 0) motion = random_vector(random, std::pow(10, random.between(0, 6)));
  return motion;
}

}  // namespace

double distance_from_level(const SceneIndex& level, const Model& shape, const Pose& pose) {
  double least = std::numeric_limits<double>::infinity();
  for (const SceneInstance& model : level.models())
    least = std::min(least, distance(shape, model.model, {pose, model.pose}).upper);
  return least;
}

bool is_within(const SceneIndex& level, const Model& shape, const Pose& pose, double distance) {
  const auto is_near = [&](const SceneInstance& model) {
    return within_distance(shape, model.model, distance, {pose, model.pose});
  };
  return std::any_of(level.models().begin(), level.models().end(), is_near);
}

std::string fault_of_recovery(const SceneIndex& level, const Model& shape, const Pose& pose,
                              const MoverOptions& options) {
  const MoverStep<Index> out = move_character(level, shape, {pose, {}}, {}, options);
  const Pose& there = out.state.pose;
  const double skin = options.skin, least = 0.875 * skin - 1e-9;
  if (!out.tight && is_within(level, shape, there, least)) return "pushed out, it is still too near";
  if (out.tight && !is_within(level, shape, there, 0.90625 * skin + 1e-9))
    return "it says that it is too near to nothing";
  if (out.stuck != is_within(level, shape, there, 0))
    return out.stuck ? "it says that it overlaps what it does not" : "it still overlaps and does not say so";
  const double shorter = (length(out.pushed_out) - skin) / recovery_factor;
  if (out.tight || !(shorter > 0)) return {};
  for (const Vec3& way : ways_all_around())
    if (!is_within(level, shape, Pose::translation(shorter * way) * pose, skin))
      return fmt::format("pushed out by {}, though {} along {}, {}, {} is enough", length(out.pushed_out), shorter,
                         way.x, way.y, way.z);
  return {};
}

std::string fault_of_step(const MoverLevelCase& level, const Model& shape, const MoverState<Index>& from,
                          const Vec3& motion, const MoverOptions& options, const MoverStep<Index>& step) {
  const Pose& pose = step.state.pose;
  if (!is_finite(pose) || !(pose.linear == from.pose.linear))
    return "the pose is no longer what it was but for its offset";
  const JudgedStep judged{level, shape, from, motion, options, step};
  for (const auto fault_of :
       {fault_of_nearness, fault_of_length, fault_of_slide, fault_of_free_way, fault_of_place, fault_of_repeating})
    if (std::string fault = fault_of(judged); !fault.empty())
      return fmt::format("{}; the motion is {}, {}, {}", fault, motion.x, motion.y, motion.z);
  if (is_within(level.level, shape, from.pose, 0.875 * options.skin))
    return fault_of_recovery(level.level, shape, from.pose, options);
  return {};
}

std::string fault_of_walk(const MoverLevelCase& level, Random& random, int steps) {
  const Model shape = random_character(random);
  MoverOptions options;
  options.skin = random.below(4) == 0 ? 0.002 : 0.01;
  options.step_height = random.below(3) == 0 ? 0 : 0.3;
  options.max_slope_degrees = random.between(20, 60);
  // Where it begins within something it may begin anywhere: the steps are judged by what they begin with.
  MoverState<Index> state{Pose::translation(level.starts[random.below(level.starts.size())])};
  Vec3 wanted = level_motion(random, 0.01);
  int stuck = 0;
  for (int i = 0; i < steps; ++i) {
    const Vec3 motion = random_motion(wanted, state.ground.has_value(), random);
    const MoverStep<Index> step = move_character(level.level, shape, state, motion, options);
    if (const std::string fault = fault_of_step(level, shape, state, motion, options, step); !fault.empty())
      return fmt::format("step {}: {}", i, fault);
    state = step.state;
    stuck = step.stuck ? stuck + 1 : 0;
    if (stuck == 4 || length(state.pose.offset) > 100) return {};  // there is no way out, or it is out of the level
  }
  return {};
}

}  // namespace toccata::test
