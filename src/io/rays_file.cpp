#include "toccata/io/rays_file.hpp"

#include <algorithm>
#include <array>
#include <string>

#include "io/file_bytes.hpp"
#include "io/file_error.hpp"
#include "io/text_cursor.hpp"

namespace toccata {
namespace {

/// What is left of the cursor's line.
RayQuery read_line(io::TextCursor& cursor) {
  std::array<double, 6> numbers{};
  std::size_t count = 0;
  for (; !cursor.at_line_end(); ++count) {
    const double number = cursor.number("the number");
    if (count < numbers.size()) numbers[count] = number;
  }
  if (count != numbers.size())
    cursor.fail("a line of 6 numbers has " + std::to_string(count), "give where the ray starts and where it ends");
  const Vec3 from{numbers[0], numbers[1], numbers[2]}, to{numbers[3], numbers[4], numbers[5]};
  if (from == to) cursor.fail("the ray ends where it starts", "give two points");
  if (!is_finite(to - from))
    cursor.fail("the ray is longer than doubles can tell", "give two points nearer to each other");
  return {.origin = from, .motion = to - from};
}

}  // namespace

std::vector<RayQuery> read_rays(const std::filesystem::path& path) {
  const io::FileBytes bytes = io::read_file(path);
  const std::string name = path.string();
  std::string text(bytes.span().begin(), bytes.span().end());
  std::replace(text.begin(), text.end(), ',', ' ');
  io::TextCursor cursor(text, name, {.hash_comments = true});
  std::vector<RayQuery> rays;
  while (cursor.next_line_with_words()) {
    rays.push_back(read_line(cursor));
    cursor.next_line();
  }
  if (rays.empty()) io::fail_in_file(name, {"the file holds no ray", "write a line of 6 numbers for each"});
  return rays;
}

}  // namespace toccata
