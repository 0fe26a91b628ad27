#include "robots/tree_building.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "narrow/pose_checks.hpp"
#include "robots/robot_tree.hpp"
#include "toccata/core/error.hpp"

namespace toccata {
namespace {

using NumberOfName = std::map<std::string, Index, std::less<>>;

constexpr Index no_parent_yet = 0xFFFFFFFF;

template <class Named>
NumberOfName numbers_of_names(const std::vector<Named>& all, std::string_view noun) {
  NumberOfName numbers;
  for (std::size_t i = 0; i < all.size(); ++i)
    if (!numbers.emplace(all[i].name, static_cast<Index>(i)).second)
      throw Error(fmt::format("two {}s are called '{}'; give each a name of its own", noun, all[i].name));
  return numbers;
}

Index found_name(const NumberOfName& numbers, const std::string& name, const std::string& asked_by) {
  if (const auto found = numbers.find(name); found != numbers.end()) return found->second;
  std::vector<std::string> known;
  for (const auto& [other, number] : numbers) known.push_back(other);
  throw Error(fmt::format("{} '{}', which there is not{}", asked_by, name, suggestion(name, known)));
}

/// Lengths of ways are bounded by those of origins, which a rotation keeps.
void require_rigid_origin(const Pose& pose, const std::string& who) {
  require_finite(pose, who);
  double off = 0;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      off = std::max(off, std::fabs(dot(pose.linear.column(i), pose.linear.column(j)) - (i == j ? 1 : 0)));
  if (!(off <= 0x1p-40) || dot(pose.linear[0], cross(pose.linear[1], pose.linear[2])) < 0)
    throw Error(fmt::format("{}: its origin is no rotation and translation; Pose::nearest_rigid makes one of it", who));
}

void require_sound(const RobotJoint& joint) {
  const std::string who = fmt::format("joint '{}'", joint.name);
  require_rigid_origin(joint.origin, who);
  if (joint.kind != RobotJointKind::fixed && joint.kind != RobotJointKind::floating &&
      (!is_finite(joint.axis) || normalized(joint.axis) == Vec3{}))
    throw Error(fmt::format("{}: its axis has no direction; give three finite numbers that are not all 0", who));
  if (!joint.limits) return;
  const auto [lower, upper] = *joint.limits;
  if (!(lower <= upper) || !std::isfinite(lower) || !std::isfinite(upper))
    throw Error(
        fmt::format("{}: its limits are {} to {}; the lower one comes first, and both are finite", who, lower, upper));
}

bool has_one_position(RobotJointKind kind) {
  return kind == RobotJointKind::revolute || kind == RobotJointKind::continuous || kind == RobotJointKind::prismatic;
}

/// Makes the tree of a description.
class TreeBuilding {
 public:
  explicit TreeBuilding(RobotDescription description)
      : description_(std::move(description)),
        links_(numbers_of_names(description_.links, "link")),
        joints_(numbers_of_names(description_.joints, "joint")) {
    if (description_.links.empty())
      throw Error(fmt::format("the robot '{}' has no link; describe one at least", description_.name));
    require_rigid_origin(description_.base, "the base of the robot");
    for (const RobotJoint& joint : description_.joints) require_sound(joint);
  }

  std::shared_ptr<const Robot::Tree> built(int threads) {
    find_parents();
    tree_.root = only_root();
    add_positions();
    add_frames();
    add_bodies(threads);
    tree_.description = std::move(description_);
    return std::make_shared<const Robot::Tree>(std::move(tree_));
  }

 private:
  void find_parents() {
    tree_.parent_joint.resize(description_.links.size());
    for (std::size_t i = 0; i < description_.joints.size(); ++i) {
      const RobotJoint& joint = description_.joints[i];
      const Index parent = found_name(links_, joint.parent, fmt::format("joint '{}': its parent is link", joint.name));
      const Index child = found_name(links_, joint.child, fmt::format("joint '{}': its child is link", joint.name));
      parent_link_.push_back(parent);
      child_link_.push_back(child);
      std::optional<Index>& known = tree_.parent_joint[child];
      if (known)
        throw Error(fmt::format("link '{}' has two parents, by joints '{}' and '{}'; a robot is a tree", joint.child,
                                description_.joints[*known].name, joint.name));
      known = static_cast<Index>(i);
    }
  }

  Index only_root() const {
    require_no_circle();
    std::optional<Index> root;
    for (std::size_t link = 0; link < tree_.parent_joint.size(); ++link) {
      if (tree_.parent_joint[link]) continue;
      if (root)
        throw Error(fmt::format("links '{}' and '{}' both hang on none; join them, so that the robot is one tree",
                                description_.links[*root].name, description_.links[link].name));
      root = static_cast<Index>(link);
    }
    return *root;  // one that no circle leads to
  }

  /// From each link up: who is met again on a way hangs on itself.
  void require_no_circle() const {
    const std::size_t count = description_.links.size();
    for (std::size_t link = 0; link < count; ++link) {
      auto at = static_cast<Index>(link);
      for (std::size_t steps = 0; tree_.parent_joint[at]; ++steps) {
        if (steps == count)
          throw Error(
              fmt::format("link '{}' hangs on itself, in a circle of joints of which '{}' is one; a robot is a "
                          "tree",
                          description_.links[at].name, description_.joints[*tree_.parent_joint[at]].name));
        at = parent_link_[*tree_.parent_joint[at]];
      }
    }
  }

  void add_position(Index joint, std::string_view suffix, bool turns) {
    const RobotJoint& of = description_.joints[joint];
    tree_.positions.push_back(
        {of.name + std::string(suffix), joint, has_one_position(of.kind) ? of.limits : std::nullopt, turns});
  }

  void add_positions() {
    for (std::size_t i = 0; i < description_.joints.size(); ++i) {
      const auto joint = static_cast<Index>(i);
      const RobotJoint& of = description_.joints[i];
      first_position_.push_back(static_cast<Index>(tree_.positions.size()));
      if (of.mimic) {
        require_mimic(of);
      } else if (has_one_position(of.kind)) {
        add_position(joint, "", of.kind != RobotJointKind::prismatic);
      } else if (of.kind == RobotJointKind::planar) {
        for (const char* suffix : {"/x", "/y"}) add_position(joint, suffix, false);
        add_position(joint, "/turn", true);
      } else if (of.kind == RobotJointKind::floating) {
        for (const char* suffix : {"/x", "/y", "/z"}) add_position(joint, suffix, false);
        for (const char* suffix : {"/roll", "/pitch", "/yaw"}) add_position(joint, suffix, true);
      }
    }
  }

  void require_mimic(const RobotJoint& joint) const {
    const JointMimic& mimic = *joint.mimic;
    const std::string who = fmt::format("joint '{}'", joint.name);
    const RobotJoint& of =
        description_.joints[found_name(joints_, mimic.joint, fmt::format("{}: it mimics joint", who))];
    if (!has_one_position(joint.kind) || !has_one_position(of.kind))
      throw Error(
          fmt::format("{}: it mimics joint '{}', and one of the two has not one position; both have to turn "
                      "or slide",
                      who, of.name));
    if (!std::isfinite(mimic.multiplier) || !std::isfinite(mimic.offset))
      throw Error(fmt::format("{}: the multiplier or offset by which it mimics is not finite", who));
  }

  /// The number of a configuration by which a joint moves.
  RobotFrame followed(Index joint) const {
    RobotFrame frame;
    Index at = joint;
    for (std::size_t steps = 0; description_.joints[at].mimic; ++steps) {
      if (steps == description_.joints.size())
        throw Error(fmt::format("joint '{}' mimics itself, by way of '{}'; let one of them move by itself",
                                description_.joints[joint].name, description_.joints[at].name));
      const JointMimic& mimic = *description_.joints[at].mimic;
      frame.offset = frame.multiplier * mimic.offset + frame.offset;
      frame.multiplier *= mimic.multiplier;
      at = joints_.find(mimic.joint)->second;
    }
    frame.position = first_position_[at];
    return frame;
  }

  Index add_frame(RobotFrame frame) {
    frame.is_shifted_alone = frame.origin.linear == Mat3{};
    for (int axis = 0; axis < 3; ++axis)
      if (frame.axis == Mat3{}[axis]) frame.along_axis = axis;
    tree_.frames.push_back(frame);
    return static_cast<Index>(tree_.frames.size() - 1);
  }

  /// One of several steps of a joint, by a number of its own.
  Index add_step(Index parent, const Pose& origin, RobotFrame::Motion motion, const Vec3& axis, Index position) {
    return add_frame({parent, origin, motion, axis, position, 1, 0, false, {}});
  }

  Index add_planar(const RobotJoint& joint, Index parent, Index position) {
    using enum RobotFrame::Motion;
    const Mat3 axes = orthonormal_axes(joint.axis, {1, 0, 0});  // the axis, x in the plane across it, and y
    const Index along_x = add_step(parent, joint.origin, slide, axes[1], position);
    const Index along_y = add_step(along_x, {}, slide, axes[2], position + 1);
    return add_step(along_y, {}, turn, axes[0], position + 2);
  }

  Index add_floating(const RobotJoint& joint, Index parent, Index position) {
    using enum RobotFrame::Motion;
    const std::array<Vec3, 3> axis{Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}};
    Index frame = parent;
    for (Index i = 0; i < 3; ++i) frame = add_step(frame, i == 0 ? joint.origin : Pose{}, slide, axis[i], position + i);
    for (Index i = 3; i-- > 0;) frame = add_step(frame, {}, turn, axis[i], position + 3 + i);
    return frame;
  }

  /// The frame of the link that hangs on it.
  Index add_frames_of(Index number, Index parent) {
    const RobotJoint& joint = description_.joints[number];
    if (joint.kind == RobotJointKind::planar) return add_planar(joint, parent, first_position_[number]);
    if (joint.kind == RobotJointKind::floating) return add_floating(joint, parent, first_position_[number]);
    RobotFrame frame;
    if (joint.kind != RobotJointKind::fixed) {
      frame = followed(number);
      frame.motion = joint.kind == RobotJointKind::prismatic ? RobotFrame::Motion::slide : RobotFrame::Motion::turn;
      frame.axis = normalized(joint.axis);
    }
    frame.parent = parent;
    frame.origin = joint.origin;
    return add_frame(frame);
  }

  /// From the root outwards, however the joints are ordered.
  void add_frames() {
    const std::size_t count = description_.links.size();
    std::vector<std::vector<Index>> joints_of(count);
    for (std::size_t i = 0; i < description_.joints.size(); ++i)
      joints_of[parent_link_[i]].push_back(static_cast<Index>(i));
    tree_.frame_of_link.assign(count, no_parent_yet);
    tree_.frame_of_link[tree_.root] = add_frame({});
    std::vector<Index> reached{tree_.root};
    for (std::size_t i = 0; i < reached.size(); ++i)
      for (const Index joint : joints_of[reached[i]]) {
        tree_.frame_of_link[child_link_[joint]] = add_frames_of(joint, tree_.frame_of_link[reached[i]]);
        reached.push_back(child_link_[joint]);
      }
  }

  void add_bodies(int threads) {
    std::map<const TriangleMesh*, Model> shared;
    for (std::size_t link = 0; link < description_.links.size(); ++link) {
      const RobotLink& of = description_.links[link];
      for (std::size_t i = 0; i < of.shapes.size(); ++i) {
        const LinkShape& shape = of.shapes[i];
        const std::string name = of.shapes.size() == 1 ? of.name : fmt::format("{}, shape {}", of.name, i);
        const auto mesh = mesh_of(shape.shape);
        const auto known = mesh ? shared.find(mesh.get()) : shared.end();
        const Model model = known != shared.end() ? known->second : Model(shape.shape, threads);
        if (mesh) shared.emplace(mesh.get(), model);
        require_finite(shape.pose, fmt::format("link '{}'", name));
        tree_.bodies.push_back(
            {static_cast<Index>(link), model, shape.pose, shape.solid, shape.name.empty() ? name : shape.name});
      }
    }
  }

  RobotDescription description_;
  NumberOfName links_, joints_;
  std::vector<Index> parent_link_, child_link_;  ///< of each joint
  std::vector<Index> first_position_;            ///< likewise
  Robot::Tree tree_;
};

}  // namespace

std::shared_ptr<const Robot::Tree> robot_tree_of(RobotDescription description, int threads) {
  return TreeBuilding(std::move(description)).built(threads);
}

Robot Robot::with_attached(const AttachedObject& object, int threads) const {
  const Index holder = link_of(object.link);
  RobotDescription description = tree_->description;
  description.links.push_back(object.object);
  description.joints.push_back({.name = "attached " + object.object.name,
                                .parent = object.link,
                                .child = object.object.name,
                                .origin = object.pose});
  auto tree = std::make_shared<Tree>(*robot_tree_of(std::move(description), threads));
  tree->touching_attachments = tree_->touching_attachments;
  const auto attached = static_cast<Index>(links().size());
  tree->touching_attachments.push_back({holder, attached});
  for (const std::string& link : object.touch_links) tree->touching_attachments.push_back({link_of(link), attached});
  return Robot(std::move(tree));
}

}  // namespace toccata
