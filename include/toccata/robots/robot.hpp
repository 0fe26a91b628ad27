#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "toccata/core/index.hpp"
#include "toccata/core/parallel.hpp"
#include "toccata/math/pose.hpp"
#include "toccata/query/check_all.hpp"
#include "toccata/query/model.hpp"
#include "toccata/shapes/scene.hpp"
#include "toccata/shapes/shape.hpp"

namespace toccata {

/// How a link moves against the one that it hangs on. Positions are in radians where it turns and in world units where
/// it slides, as in URDF.
enum class RobotJointKind : std::uint8_t {
  fixed,       ///< not at all; no position
  revolute,    ///< turns about its axis, counter-clockwise seen against it, within limits; one position
  continuous,  ///< the same without limits
  prismatic,   ///< slides along its axis; one position
  planar,      ///< slides in the plane across its axis and turns about it: x, y and turn
  floating,    ///< freely: x, y, z, then roll, pitch and yaw about the fixed axes x, y and z, one after the other
};

/// "fixed", "revolute", …
[[nodiscard]] std::string_view name_of(RobotJointKind kind);

struct JointLimits {
  double lower = 0;
  double upper = 0;
  friend constexpr bool operator==(const JointLimits&, const JointLimits&) = default;
};

/// A joint whose position follows another's: multiplier · position + offset.
struct JointMimic {
  std::string joint;
  double multiplier = 1;
  double offset = 0;
};

struct RobotJoint {
  std::string name;
  RobotJointKind kind = RobotJointKind::fixed;
  std::string parent;  ///< links, by name
  std::string child;
  Pose origin{};       ///< a rotation and a translation: where the child is in the parent's frame at the position 0
  Vec3 axis{1, 0, 0};  ///< in the child's frame, through its origin; of any length above 0
  std::optional<JointLimits> limits{};
  std::optional<JointMimic> mimic{};
};

/// A shape of a link, in its frame.
struct LinkShape {
  Shape shape;
  Pose pose{};  ///< may scale, where the shape may be scaled
  Solid solid = Solid::automatic;
  std::string name{};  ///< for messages and pictures
};

struct RobotLink {
  std::string name;
  std::vector<LinkShape> shapes{};  ///< none: a link that is only a frame
};

struct RobotDescription {
  std::string name;
  std::vector<RobotLink> links;
  std::vector<RobotJoint> joints;
  Pose base{};  ///< where the root link is in the world: a rotation and a translation
};

/// One of the numbers that a configuration is made of.
struct RobotPosition {
  std::string name;  ///< the joint's; of a planar or floating one with "/x", "/y", …
  Index joint = 0;
  std::optional<JointLimits> limits{};
  bool turns = false;  ///< radians; else world units
};

/// Something that a robot holds: a link of its own from then on.
struct AttachedObject {
  RobotLink object;
  std::string link;                        ///< to which it is fixed
  Pose pose{};                             ///< in the frame of that link
  std::vector<std::string> touch_links{};  ///< others that it may touch
};

/// A tree of links and joints, checked and made ready. Immutable; copies share all.
///
/// The links' poses at a configuration are one formula, and what is computed is what is asked about: from the root
/// outwards pose(child) = (pose(parent) · origin) · motion, rounded as poses are composed (pose.hpp), where the motion
/// is a translation by position · axis / |axis|, or a rotation about that axis with sine and cosine of position / 2π
/// whole turns (trigonometry.hpp), that quotient being one product. A shape of a link is at pose(link) · pose(shape).
class Robot {
 public:
  /// A shape of a link, as questions see it.
  struct Body {
    Index link = 0;
    Model model;
    Pose pose{};  ///< in the link's frame
    Solid solid = Solid::automatic;
    std::string name{};
  };

  /// Throws Error naming the link or joint: no link at all, two of one name, a joint of a link that there is not, a
  /// link with two parents, links in a circle, several links that hang on none, an axis or a number that is not finite
  /// or zero, an origin that is off from a rotation by more than 2⁻⁴⁰, limits the wrong way round, and what a joint
  /// mimics that there is not, that has not one position, or that mimics it back.
  explicit Robot(RobotDescription description, int threads = own_thread);

  [[nodiscard]] const std::string& name() const;
  [[nodiscard]] std::span<const RobotLink> links() const;
  [[nodiscard]] std::span<const RobotJoint> joints() const;
  [[nodiscard]] Index root() const;  ///< the link that hangs on none
  /// The numbers that a configuration is made of, in the order of the joints; joints that mimic others have none.
  [[nodiscard]] std::span<const RobotPosition> positions() const;
  /// All shapes of all links, in their order.
  [[nodiscard]] std::span<const Body> bodies() const;
  /// The joint that a link hangs on; none of the root.
  [[nodiscard]] std::optional<Index> parent_joint(Index link) const;

  /// Throw Error with what may have been meant where there is none of that name.
  [[nodiscard]] Index link_of(std::string_view name) const;
  [[nodiscard]] Index joint_of(std::string_view name) const;

  /// All positions 0, or the middle of the limits where 0 is beyond them.
  [[nodiscard]] std::vector<double> rest() const;

  /// The first position that is beyond its limits.
  [[nodiscard]] std::optional<Index> beyond_limits(std::span<const double> configuration) const;

  /// Where the links are, in their order. Limits are not looked at. Throws Error when there is not one number for each
  /// position, or one is not finite.
  [[nodiscard]] std::vector<Pose> link_poses(std::span<const double> configuration) const;

  /// The same of many configurations, one after the other: link l of the i-th is at [i · links + l]. Throws Error
  /// beginning with "configuration i: ".
  [[nodiscard]] std::vector<Pose> link_poses_each(std::span<const double> configurations, int threads = all_threads,
                                                  const Progress& progress = {}) const;

  /// The bodies where a configuration puts them, with names: what a scene of them is.
  [[nodiscard]] std::vector<SceneInstance> posed(std::span<const double> configuration) const;

  /// The robot with one link more, fixed to another. Other links and positions keep their numbers. Throws Error as the
  /// constructor does, and for links to be touched that there are not.
  [[nodiscard]] Robot with_attached(const AttachedObject& object, int threads = own_thread) const;

  /// Links that were attached, and what they may touch: pairs of links.
  [[nodiscard]] std::span<const IndexPair> touching_attachments() const;

  // For the library itself.
  struct Tree;
  [[nodiscard]] const Tree& tree() const { return *tree_; }

 private:
  explicit Robot(std::shared_ptr<const Tree> tree) : tree_(std::move(tree)) {}

  std::shared_ptr<const Tree> tree_;
};

}  // namespace toccata
