#include <fmt/format.h>

#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
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

/// The keys of a text, line by line.
class KeyReader {
 public:
  void read(io::TextCursor& cursor) {
    const double time = cursor.number("the time");
    std::vector<std::string_view> words;
    while (!cursor.at_line_end()) words.push_back(cursor.word());
    const io::FailPose fail = [&](const std::string& what, const std::string& advice) { cursor.fail(what, advice); };
    const io::WrittenPose written = io::pose_of_words(words, fail);
    if (!keys_.empty() && !(keys_.back().time < time))
      cursor.fail("the time is not later than that of the line before", "write the keys in the order of time");
    if (!keys_.empty()) require_shorter_way(written, cursor);
    keys_.push_back({time, written.pose});
    turn_ = written.turn;
  }

  [[nodiscard]] std::vector<MotionKey> keys() && { return std::move(keys_); }

 private:
  /// What is written as a turn of more than half a circle is not what would be done.
  void require_shorter_way(const io::WrittenPose& next, const io::TextCursor& cursor) const {
    const auto degrees = turn_ && next.turn ? io::degrees_between(*turn_, *next.turn) : std::nullopt;
    if (!degrees || !(std::fabs(*degrees) > 180 + 1e-9)) return;  // half a circle, but for rounding
    cursor.fail(
        fmt::format("from the key before it turns by {} degrees, which is more than half a circle, and from one "
                    "key to the next the shorter way is taken",
                    *degrees),
        "write a key between them, or the same pose by other degrees");
  }

  std::vector<MotionKey> keys_;
  std::optional<io::WrittenTurn> turn_;  ///< of the last
};

}  // namespace

FileMotion read_motion(const std::string& path, const std::string& node) {
  if (io::is_gltf(path)) return io::read_gltf_motion(path, node);
  if (!node.empty())
    io::fail_in_file(path, {"only a glTF or GLB file has nodes that move", "name such a file, or no node"});
  KeyReader reader;
  const auto read = [&](io::TextCursor& cursor) { reader.read(cursor); };
  io::for_each_line_of_numbers(path, read, io::blanks_in_poses);
  std::vector<MotionKey> keys = std::move(reader).keys();
  if (keys.size() < 2)
    io::fail_in_file(path, {"a motion has at least two keys", "write a line for each, its time and its pose"});
  const double first = keys.front().time, length = keys.back().time - first;
  if (!(length < infinity)) io::fail_in_file(path, {"the times are farther apart than doubles can tell", "use others"});
  for (MotionKey& key : keys) key.time = (key.time - first) / length;
  return {std::move(keys), {}};
}

}  // namespace toccata
