#pragma once

#include <string>
#include <vector>

#include "toccata/core/parallel.hpp"
#include "toccata/robots/allowed_pairs.hpp"
#include "toccata/robots/robot.hpp"

// Robots as ROS writes them. URDF and SRDF are read with urdfdom and the parser below it (Debian's liburdfdom-dev);
// where the library was built without, these functions throw Error saying so.
namespace toccata {

struct UrdfOptions {
  /// Where packages are looked for: `package://name/path` is `folder/name/path`, or `folder/path` where the folder is
  /// itself called so, of the first of these folders in which it exists; then of the folders that the file lies in, the
  /// nearest first.
  std::vector<std::string> package_folders{};
};

struct RobotFile {
  RobotDescription description;
  /// Sentences: sizes that look like another unit, angles that look like degrees, attributes that are not read, links
  /// that have pictures alone.
  std::vector<std::string> warnings;
};

/// Reads a URDF file with the meshes that it names: STL, OBJ, PLY, OFF, glTF, scaled as it says. What collides are the
/// collision elements; a link without any meets nothing. A file name without `package://` or `file://` begins at the
/// URDF file's folder. Throws Error naming the file and the element, mostly with its line: what is no XML, no robot or
/// no tree, an unknown joint type, missing limits, a mesh that is missing, broken or of a format that is not read.
[[nodiscard]] RobotFile read_urdf(const std::string& path, const UrdfOptions& options = {});

/// Reads which pairs of links an SRDF file disables (disable_collisions, disable_default_collisions,
/// enable_collisions), with the reasons that it gives. Throws Error naming the file and the line, also for links that
/// the robot has not.
[[nodiscard]] std::vector<AllowedPair> read_srdf(const std::string& path, const Robot& robot);

/// Whether URDF and SRDF can be read.
[[nodiscard]] bool reads_urdf();

/// Reads a file of configurations: a line of numbers for each, in the order of Robot::positions, or, where the first
/// line has names, in theirs. Numbers are separated by commas or blanks, # starts a comment. One after the other.
/// Throws Error naming the file and the line: a number too many or too few, what is no number, a position that is
/// beyond its limits, a name that the robot has not or twice or lacks, and for a file without a configuration.
[[nodiscard]] std::vector<double> read_configurations(const std::string& path, const Robot& robot);

/// Writes `folder`/robot.urdf with every mesh beside it as an OBJ file. Reading it gives the same robot, but for what
/// roll, pitch and yaw round. The folder is made where it is missing. Throws Error naming the file, when one is there
/// already that holds something else, and the link whose shape URDF has not: it has meshes, spheres, boxes, cylinders.
void write_urdf(const RobotDescription& robot, const std::string& folder);

}  // namespace toccata
