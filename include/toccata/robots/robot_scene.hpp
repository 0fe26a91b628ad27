#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "toccata/core/status.hpp"
#include "toccata/query/batch.hpp"
#include "toccata/query/check_all.hpp"
#include "toccata/query/distance.hpp"
#include "toccata/robots/allowed_pairs.hpp"
#include "toccata/robots/robot.hpp"

namespace toccata {

/// A link and what it meets or is near to: a link of a greater number, or an obstacle.
struct RobotContact {
  Index link = 0;
  bool with_obstacle = false;
  Index other = 0;  ///< the number of the link or of the obstacle
  friend constexpr auto operator<=>(const RobotContact&, const RobotContact&) = default;
};

/// The least distance at a configuration.
struct RobotDistance {
  RobotContact pair;
  /// A is the link; elements and faces are those of the link's body and of the obstacle.
  Distance distance;
  Index body = 0;        ///< of the robot: which shape of the link
  Index other_body = 0;  ///< which of the other link; of an obstacle 0
  /// How it changes with each position of the configuration: world units per radian or per world unit, by the witness
  /// points; all 0 where they meet. Where several pairs of points are nearest it is that of this pair.
  std::vector<double> gradient;
};

struct EdgeOptions {
  /// How narrow the interval of the first contact is, as a part of the way; at least 2⁻⁴⁰. What comes so near for so
  /// short a time that this does not decide counts as a contact.
  double precision = 0x1p-20;
  int threads = own_thread;
  Progress progress{};
};

/// What happens on the straight way from one configuration to another, in the time from 0 to 1.
struct RobotEdge {
  bool is_free = true;  ///< proved for every moment, and not for some of them
  /// The first contact: none before `lower`, which is proved. exact: at the configuration of `upper` they meet;
  /// undecided: within [lower, upper] they come nearer than can be resolved, and whether they meet there is not known.
  double lower = 1;
  double upper = 1;
  Status status = Status::exact;
  RobotContact pair{};  ///< the least of those that meet then
};

/// How many contacts are reported.
enum class ContactsTold : std::uint8_t {
  first,  ///< the least one
  all,
};

struct RobotSceneOptions {
  /// Not looked at. Names are those of links and obstacles.
  std::vector<AllowedPair> allowed{};
  bool allow_adjacent = true;  ///< nor are those of `adjacent_pairs`
};

/// A robot among obstacles, made ready for questions. What is said of a configuration is what `overlap` and `distance`
/// say of the bodies at the poses of `Robot::posed`, pair by pair: exactly, on meshes too. Pairs that are allowed, of
/// bodies of one link, and what an attached object may touch, are left out; limits are not looked at. Copies share all;
/// questions may be asked from many threads at once, and answers do not depend on threads.
///
/// A configuration is one number for each of Robot::positions; many are written one after the other. Errors of many
/// begin with "configuration i: ".
class RobotScene {
 public:
  /// Throws Error naming the obstacle that has a pose which its shape may not have, and for names that there are not.
  explicit RobotScene(const Robot& robot, std::span<const SceneInstance> obstacles = {},
                      const RobotSceneOptions& options = {});

  [[nodiscard]] const Robot& robot() const;
  [[nodiscard]] std::span<const SceneInstance> obstacles() const;
  /// Whether the two are looked at; of two links the lesser number is the first.
  [[nodiscard]] bool looks_at(const RobotContact& pair) const;

  /// Does any pair that is looked at have a point in common?
  [[nodiscard]] bool meets(std::span<const double> configuration) const;
  /// 1 where one has.
  [[nodiscard]] std::vector<std::uint8_t> meets_each(std::span<const double> configurations,
                                                     const BatchOptions& options = {}) const;

  /// Which, ascending.
  [[nodiscard]] std::vector<RobotContact> contacts(std::span<const double> configuration,
                                                   ContactsTold told = ContactsTold::all) const;
  [[nodiscard]] std::vector<std::vector<RobotContact>> contacts_each(std::span<const double> configurations,
                                                                     ContactsTold told = ContactsTold::all,
                                                                     const BatchOptions& options = {}) const;

  /// The least of all pairs, by (upper, pair, bodies); none where there is none within the greatest distance. Its
  /// interval contains the least of all exact distances.
  [[nodiscard]] std::optional<RobotDistance> distance(std::span<const double> configuration,
                                                      double max_distance = unlimited) const;
  [[nodiscard]] std::vector<std::optional<RobotDistance>> distance_each(std::span<const double> configurations,
                                                                        double max_distance = unlimited,
                                                                        const BatchOptions& options = {}) const;

  /// All positions go from the first configuration to the second at even speeds; what turns without limits goes as the
  /// numbers say, and not the shorter way. The first contact, found by bounds of how far points of the bodies move: a
  /// stretch of time is free where all pairs are farther apart in its middle than they can come nearer, and is halved
  /// where that is not known (conservative advancement in halves; B. Mirtich, "Impulse-based dynamic simulation of
  /// rigid body systems", 1996, section 2.3). Throws Error when the precision is not at least 2⁻⁴⁰, or more than 1.
  [[nodiscard]] RobotEdge edge(std::span<const double> from, std::span<const double> to,
                               const EdgeOptions& options = {}) const;
  /// The i-th from the i-th of the first configurations to the i-th of the others.
  [[nodiscard]] std::vector<RobotEdge> edge_each(std::span<const double> from, std::span<const double> to,
                                                 const EdgeOptions& options = {}) const;
  /// Only whether each is free, 1 or 0, as `edge` says: it ends at any contact, and so is quicker.
  [[nodiscard]] std::vector<std::uint8_t> free_each(std::span<const double> from, std::span<const double> to,
                                                    const EdgeOptions& options = {}) const;

  // For the library itself.
  struct Made;

 private:
  static constexpr double unlimited = std::numeric_limits<double>::infinity();

  std::shared_ptr<const Made> made_;
};

/// A point cloud as an obstacle: a ball of this radius around each point. Each stands in the tree by itself. Throws
/// Error without a point, and for a radius that is not positive.
[[nodiscard]] SceneInstance point_cloud(std::span<const Vec3> points, double radius, const std::string& name = "cloud");

/// The occupied cells of a voxel map or octree, all of one size, as an obstacle: a cube around each middle.
[[nodiscard]] SceneInstance voxel_map(std::span<const Vec3> middles, double edge, const std::string& name = "voxels");

/// What people call it: "upper_arm and forearm", "hand and obstacle 'table'".
[[nodiscard]] std::string text_of(const RobotContact& contact, const RobotScene& scene);

}  // namespace toccata
