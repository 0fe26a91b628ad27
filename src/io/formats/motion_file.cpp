#include <string>
#include <string_view>
#include <vector>

#include "io/formats/file_error.hpp"
#include "io/formats/gltf_motion.hpp"
#include "io/formats/number_lines.hpp"
#include "io/formats/pose_text.hpp"
#include "io/scenes/scene_parts.hpp"
#include "math/constants.hpp"
#include "toccata/io/query_files.hpp"

namespace toccata {
namespace {

/// What is left of the cursor's line.
MotionKey key_of_line(io::TextCursor& cursor) {
  const double time = cursor.number("the time");
  std::vector<std::string_view> words;
  while (!cursor.at_line_end()) words.push_back(cursor.word());
  const io::FailPose fail = [&](const std::string& what, const std::string& advice) { cursor.fail(what, advice); };
  return {time, io::pose_of_words(words, fail)};
}

}  // namespace

FileMotion read_motion(const std::string& path, const std::string& node) {
  if (io::is_gltf(path)) return io::read_gltf_motion(path, node);
  if (!node.empty())
    io::fail_in_file(path, {"only a glTF or GLB file has nodes that move", "name such a file, or no node"});
  std::vector<MotionKey> keys;
  const auto read = [&](io::TextCursor& cursor) {
    keys.push_back(key_of_line(cursor));
    if (keys.size() > 1 && !(keys[keys.size() - 2].time < keys.back().time))
      cursor.fail("the time is not later than that of the line before", "write the keys in the order of time");
  };
  io::for_each_line_of_numbers(path, read, io::blanks_in_poses);
  if (keys.size() < 2)
    io::fail_in_file(path, {"a motion has at least two keys", "write a line for each, its time and its pose"});
  const double first = keys.front().time, length = keys.back().time - first;
  if (!(length < infinity)) io::fail_in_file(path, {"the times are farther apart than doubles can tell", "use others"});
  for (MotionKey& key : keys) key.time = (key.time - first) / length;
  return {std::move(keys), {}};
}

}  // namespace toccata
