#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "toccata/robots/robot.hpp"

namespace toccata {

/// One step on the way from the base to a link: it turns about an axis, slides along it, or rests. A planar or floating
/// joint is several of them.
struct RobotFrame {
  enum class Motion : std::uint8_t { none, turn, slide };

  Index parent = 0;  ///< a frame before it
  Pose origin{};     ///< in the parent's frame
  Motion motion = Motion::none;
  Vec3 axis{};  ///< of length 1
  /// Its position is multiplier · the number of the configuration + offset.
  Index position = 0;
  double multiplier = 1;
  double offset = 0;
  bool is_shifted_alone = false;    ///< the origin turns nothing
  std::optional<int> along_axis{};  ///< the axis is one of the coordinate axes, not against it

  [[nodiscard]] double position_in(std::span<const double> configuration) const {
    return multiplier * configuration[position] + offset;
  }
};

/// What is known of a robot. Frame 0 is the base.
struct Robot::Tree {
  RobotDescription description;
  std::vector<RobotPosition> positions;
  std::vector<Body> bodies;
  std::vector<RobotFrame> frames;
  std::vector<Index> frame_of_link;
  std::vector<std::optional<Index>> parent_joint;  ///< of each link
  std::vector<IndexPair> touching_attachments;
  Index root = 0;
};

/// Where the frames are. The memory is made as large as is needed.
void place_frames(const Robot::Tree& tree, std::span<const double> configuration, std::vector<Pose>& poses);

/// Throws Error unless there is one finite number for each position.
void require_configuration(const Robot& robot, std::span<const double> configuration);

/// How many configurations these numbers are. Throws Error unless each is complete.
[[nodiscard]] std::size_t configuration_count(const Robot& robot, std::span<const double> configurations);

/// The numbers of one of many.
[[nodiscard]] inline std::span<const double> configuration_at(const Robot& robot,
                                                              std::span<const double> configurations, std::size_t i) {
  const std::size_t count = robot.positions().size();
  return configurations.subspan(i * count, count);
}

}  // namespace toccata
