#include "toccata/io/query_files.hpp"

#include <string>

#include "io/formats/file_error.hpp"
#include "io/formats/number_lines.hpp"

namespace toccata {
namespace {

/// What is left of the cursor's line.
RayQuery read_line(io::TextCursor& cursor) {
  const auto [numbers, count] = io::numbers_of_line<6>(cursor);
  if (count != numbers.size())
    cursor.fail("a line of 6 numbers has " + std::to_string(count), "give where the ray starts and where it ends");
  const Vec3 from{numbers[0], numbers[1], numbers[2]}, to{numbers[3], numbers[4], numbers[5]};
  if (from == to) cursor.fail("the ray ends where it starts", "give two points");
  if (!is_finite(to - from))
    cursor.fail("the ray is longer than doubles can tell", "give two points nearer to each other");
  return {.origin = from, .motion = to - from};
}

}  // namespace

std::vector<RayQuery> read_rays(const std::string& path) {
  std::vector<RayQuery> rays;
  io::for_each_line_of_numbers(path, [&](io::TextCursor& cursor) { rays.push_back(read_line(cursor)); });
  if (rays.empty()) io::fail_in_file(path, {"the file holds no ray", "write a line of 6 numbers for each"});
  return rays;
}

}  // namespace toccata
