#include "toccata/robots/robot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "query/ask_each.hpp"
#include "robots/robot_tree.hpp"
#include "robots/tree_building.hpp"
#include "toccata/core/error.hpp"
#include "toccata/math/trigonometry.hpp"

namespace toccata {
namespace {

constexpr double turns_in_a_radian = 0.15915494309189535;  ///< 1 / 2π

/// The rotation by Rodrigues' formula, for an axis of length 1: in the form of `rotation_about`.
Mat3 turned_about(const Vec3& a, double radians) {
  const auto [s, c] = sine_cosine_of_turns(turns_in_a_radian * radians);
  Mat3 m;
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    m[i][i] = c * (a[j] * a[j] + a[k] * a[k]) + a[i] * a[i];
    m[i][j] = a[i] * a[j] * (1 - c) - a[k] * s;
    m[j][i] = a[i] * a[j] * (1 - c) + a[k] * s;
  }
  return m;
}

/// linear · turned_about(axis, radians), to the bit but for signs of zeros, where the axis is a coordinate axis: what
/// is multiplied by 0 and 1 there is not.
Mat3 turned_about_coordinate_axis(const Mat3& linear, int axis, double radians) {
  const auto [s, c] = sine_cosine_of_turns(turns_in_a_radian * radians);
  const int j = (axis + 1) % 3, k = (axis + 2) % 3;
  Mat3 m = linear;
  for (Vec3& row : m.row) {
    const double old_j = row[j], old_k = row[k];
    row[j] = old_j * c + old_k * s;
    row[k] = old_k * c - old_j * s;
  }
  return m;
}

/// pose · origin, to the bit but for signs of zeros.
Pose shifted_by(const Pose& pose, const RobotFrame& frame) {
  return frame.is_shifted_alone ? Pose{pose.linear, transform(pose, frame.origin.offset)} : pose * frame.origin;
}

template <class Named>
Index named_number(std::span<const Named> all, std::string_view name, std::string_view noun) {
  const auto found = std::find_if(all.begin(), all.end(), [&](const Named& one) { return one.name == name; });
  if (found != all.end()) return static_cast<Index>(found - all.begin());
  std::vector<std::string> known;
  known.reserve(all.size());
  for (const Named& one : all) known.push_back(one.name);
  throw Error(fmt::format("the robot has no {} '{}'{}", noun, name, suggestion(name, known)));
}

}  // namespace

void place_frames(const Robot::Tree& tree, std::span<const double> configuration, std::vector<Pose>& poses) {
  poses.resize(tree.frames.size());
  poses[0] = tree.description.base;
  for (std::size_t i = 1; i < tree.frames.size(); ++i) {
    const RobotFrame& frame = tree.frames[i];
    Pose pose = shifted_by(poses[frame.parent], frame);
    if (frame.motion == RobotFrame::Motion::turn && frame.along_axis)
      pose.linear = turned_about_coordinate_axis(pose.linear, *frame.along_axis, frame.position_in(configuration));
    else if (frame.motion == RobotFrame::Motion::turn)
      pose.linear = pose.linear * turned_about(frame.axis, frame.position_in(configuration));
    else if (frame.motion == RobotFrame::Motion::slide)
      pose.offset = transform(pose, frame.position_in(configuration) * frame.axis);
    poses[i] = pose;
  }
}

void require_configuration(const Robot& robot, std::span<const double> configuration) {
  const auto positions = robot.positions();
  if (configuration.size() != positions.size())
    throw Error(fmt::format("a robot of {} positions was given {}; give one number for each", positions.size(),
                            configuration.size()));
  for (std::size_t i = 0; i < configuration.size(); ++i)
    if (!std::isfinite(configuration[i]))
      throw Error(fmt::format("the position of '{}' is {}; it has to be finite", positions[i].name, configuration[i]));
}

std::size_t configuration_count(const Robot& robot, std::span<const double> configurations) {
  const std::size_t positions = robot.positions().size();
  if (positions == 0)
    throw Error("a robot without a position has one configuration: ask about it alone, and not about many");
  if (configurations.size() % positions != 0)
    throw Error(fmt::format("{} numbers are no configurations of {} positions each", configurations.size(), positions));
  return configurations.size() / positions;
}

std::string_view name_of(RobotJointKind kind) {
  constexpr std::array<std::string_view, 6> names{"fixed", "revolute", "continuous", "prismatic", "planar", "floating"};
  return names[static_cast<std::size_t>(kind)];
}

Robot::Robot(RobotDescription description, int threads) : tree_(robot_tree_of(std::move(description), threads)) {}

const std::string& Robot::name() const { return tree_->description.name; }
std::span<const RobotLink> Robot::links() const { return tree_->description.links; }
std::span<const RobotJoint> Robot::joints() const { return tree_->description.joints; }
Index Robot::root() const { return tree_->root; }
std::span<const RobotPosition> Robot::positions() const { return tree_->positions; }
std::span<const Robot::Body> Robot::bodies() const { return tree_->bodies; }
std::optional<Index> Robot::parent_joint(Index link) const { return tree_->parent_joint[link]; }
std::span<const IndexPair> Robot::touching_attachments() const { return tree_->touching_attachments; }

Index Robot::link_of(std::string_view name) const { return named_number(links(), name, "link"); }
Index Robot::joint_of(std::string_view name) const { return named_number(joints(), name, "joint"); }

std::vector<double> Robot::rest() const {
  std::vector<double> configuration;
  for (const RobotPosition& position : positions()) {
    const bool is_beyond = position.limits && !(position.limits->lower <= 0 && 0 <= position.limits->upper);
    configuration.push_back(is_beyond ? 0.5 * position.limits->lower + 0.5 * position.limits->upper : 0);
  }
  return configuration;
}

std::optional<Index> Robot::beyond_limits(std::span<const double> configuration) const {
  require_configuration(*this, configuration);
  for (std::size_t i = 0; i < configuration.size(); ++i) {
    const std::optional<JointLimits>& limits = positions()[i].limits;
    if (limits && !(limits->lower <= configuration[i] && configuration[i] <= limits->upper))
      return static_cast<Index>(i);
  }
  return std::nullopt;
}

std::vector<Pose> Robot::link_poses(std::span<const double> configuration) const {
  require_configuration(*this, configuration);
  std::vector<Pose> frames, poses;
  place_frames(*tree_, configuration, frames);
  for (const Index frame : tree_->frame_of_link) poses.push_back(frames[frame]);
  return poses;
}

std::vector<Pose> Robot::link_poses_each(std::span<const double> configurations, int threads,
                                         const Progress& progress) const {
  const std::size_t count = configuration_count(*this, configurations), link_count = links().size();
  std::vector<Pose> poses(count * link_count);
  ask_each(count, "configuration", {.threads = threads, .progress = progress}, [&](std::size_t i, Workspace&) {
    const std::vector<Pose> placed = link_poses(configuration_at(*this, configurations, i));
    std::copy(placed.begin(), placed.end(), poses.begin() + static_cast<std::ptrdiff_t>(i * link_count));
    return std::uint8_t{};
  });
  return poses;
}

std::vector<SceneInstance> Robot::posed(std::span<const double> configuration) const {
  const std::vector<Pose> poses = link_poses(configuration);
  std::vector<SceneInstance> instances;
  for (const Body& body : bodies())
    instances.push_back({body.model, poses[body.link] * body.pose, body.solid, body.name});
  return instances;
}

}  // namespace toccata
