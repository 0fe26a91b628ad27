#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "arguments.hpp"
#include "three_mf.hpp"
#include "toccata/bounds/aabb.hpp"
#include "toccata/bounds/ball.hpp"

namespace toccata::command {

/// One scene of everything the files hold, and what to warn about.
struct LoadedScene {
  Scene scene;
  std::vector<std::size_t> first_object;  ///< of each file, and one past the last
  std::vector<std::size_t> first_node;    ///< the same of nodes
  std::vector<std::string> warnings;
  std::vector<std::string> units{};  ///< of each file; the scene has that of the first
  std::size_t told_warnings = 0;     ///< so many of the first warnings have been printed
  std::string scaled_by{};  ///< what the coordinates of a file were multiplied by and rounded, as --unit and --scale
                            ///< say; empty where that changed no digit
};

/// How many times as long a pose makes a length at most; of a turn it is 1, up to rounding.
[[nodiscard]] double stretch_of(const Pose& pose);

/// Closes the gaps of the open meshes as --close says, and warns of how wide that is in the scene's unit, and of each
/// mesh what was done. Throws Error for what is no length.
void close_meshes(LoadedScene& loaded, const InputArguments& input);

/// Throws Error where --unit is about none of the files.
void require_use_of_unit(const InputArguments& input);

/// What one of the files holds, whatever its format; in metres, where --unit says what the numbers of some other file
/// are.
ConvertedScene read_file(const std::string& file, const InputArguments& input);

/// Its numbers become metres, and a note tells `why`. Throws Error where its unit is not known.
void make_metres(ConvertedScene& read, const std::string& file, std::string_view why);

/// Why the numbers of all these files become metres: two state different units. Empty where none do. Throws Error where
/// one states none beside such.
std::string why_metres(const std::map<std::string, ConvertedScene>& read);

/// One scene of what the files hold, by their names, as `load` makes it of files whose units are equal.
LoadedScene joined(const InputArguments& input, const std::map<std::string, ConvertedScene>& read);

/// Reads all files into one scene. Objects of different files that are named alike get the file's path, or a number,
/// added to their names. A file named twice is read once.
LoadedScene load(const InputArguments& input);

/// As `pose_from_text` takes it, in one word or several. `option` names them in errors.
Pose parse_pose(const std::vector<std::string>& words, const std::string& option);

/// Three numbers. `option` names them in errors.
Vec3 parse_point(const std::vector<std::string>& words, const std::string& option);

/// Six numbers, the least corner and the greatest; four, a centre and a radius. `option` names them in errors, also of
/// what is empty.
Aabb parse_box(const std::vector<std::string>& words, const std::string& option);
Ball parse_ball(const std::vector<std::string>& words, const std::string& option);

}  // namespace toccata::command
