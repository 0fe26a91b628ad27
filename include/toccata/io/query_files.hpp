#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "toccata/math/pose.hpp"
#include "toccata/math/vec3.hpp"
#include "toccata/motion/rigid_motion.hpp"
#include "toccata/query/batch.hpp"
#include "toccata/query/pair_query.hpp"

namespace toccata {

/// Reads a points file (docs/reference/nearest-report.md): a line per point, of 3 numbers, in the world. Numbers are
/// the doubles nearest to the text, finite, and separated by blanks or commas; # starts a comment. Throws Error naming
/// the file and the line, also for a file without a point.
[[nodiscard]] std::vector<Vec3> read_points(const std::string& path);

/// Reads a poses file (docs/reference/poses-file.md): a line per query, of 12 numbers (the pose of B in A's frame; A
/// stays where it is) or of 24 (the pose of A, then that of B), each pose R row by row and then t. Numbers are the
/// doubles nearest to the text, finite, and separated by blanks or commas; # starts a comment. The models' semantics
/// are left automatic. Throws Error naming the file and the line, also for a file without a pose.
[[nodiscard]] std::vector<PairQuery> read_poses(const std::string& path);

/// Reads a rays file (docs/reference/ray-report.md): a line per ray, of 6 numbers, where it starts and where it ends,
/// in the world. Numbers are the doubles nearest to the text, finite, and separated by blanks or commas; # starts a
/// comment. Throws Error naming the file and the line, also for a ray without length and a file without a ray.
[[nodiscard]] std::vector<RayQuery> read_rays(const std::string& path);

/// A pose as people write it (docs/reference/motion-file.md): 12 numbers, R row by row and then t; 3 numbers, a
/// translation; or words with numbers: `translation=X,Y,Z` and one rotation, `axis=X,Y,Z degrees=D`,
/// `quaternion=X,Y,Z,W` or `euler=ORDER:A,B,C` in degrees. The order is three letters: `xyz` turns about the fixed axes
/// x, y and z, one after the other, `XYZ` about the axes as they have been turned. The shape turns first and is
/// translated then. Throws Error that quotes the text and says what is wrong with it.
[[nodiscard]] Pose pose_from_text(std::string_view text);

/// A motion that a file gives, as `RigidMotion::through` takes it.
struct FileMotion {
  std::vector<MotionKey> keys;
  Vec3 centre{};              ///< what goes straight on from key to key; the origin, but of a glTF file
  bool is_in_metres = false;  ///< whether the file says so: a glTF file does
};

/// Reads a motion file (docs/reference/motion-file.md): a line per key, its time and then its pose, as `pose_from_text`
/// takes it; # starts a comment. From a glTF or GLB file it reads how an animation moves the node of that name, or the
/// only one that moves where none is given: the poses, in metres, are those that lead from where things are in the file
/// to where they are then. The times ascend and are scaled so that the first is 0 and the last 1. Throws Error naming
/// the file and the line or the element, for a file of fewer than two keys, where a node is named and the file is a
/// text, and for an animation that is no rigid motion: one of scales, weights or two nodes above each other, in steps,
/// or on splines.
[[nodiscard]] FileMotion read_motion(const std::string& path, const std::string& node = "");

}  // namespace toccata
