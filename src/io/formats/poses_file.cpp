#include "toccata/io/query_files.hpp"

#include <algorithm>
#include <array>
#include <string>

#include "io/formats/file_bytes.hpp"
#include "io/formats/file_error.hpp"
#include "io/formats/parse_poses.hpp"
#include "io/formats/text_cursor.hpp"

namespace toccata {
namespace io {
namespace {

constexpr std::size_t numbers_of_a_pose = 12;

/// What is left of the cursor's line; the last pose of it places B, the one before, if any, A.
PairQuery read_line(TextCursor& cursor) {
  std::array<double, 2 * numbers_of_a_pose> numbers{};
  std::size_t count = 0;
  for (; !cursor.at_line_end(); ++count) {
    const double number = cursor.number("the number");
    if (count < numbers.size()) numbers[count] = number;
  }
  if (count != numbers_of_a_pose && count != numbers.size())
    cursor.fail("a line of 12 or 24 numbers has " + std::to_string(count),
                "give R row by row and then t: of B in A's frame, or first of A and then of B");
  const auto pose_from = [&](std::size_t first) {
    std::array<double, numbers_of_a_pose> twelve{};
    std::copy_n(numbers.begin() + static_cast<std::ptrdiff_t>(first), twelve.size(), twelve.begin());
    return Pose::from_numbers(twelve);
  };
  const bool places_both = count == numbers.size();
  return {.pose_a = places_both ? pose_from(0) : Pose{}, .pose_b = pose_from(places_both ? numbers_of_a_pose : 0)};
}

}  // namespace

std::vector<PairQuery> parse_poses(std::span<const char> bytes, std::string_view name) {
  std::string text(bytes.begin(), bytes.end());
  std::replace(text.begin(), text.end(), ',', ' ');
  TextCursor cursor(text, name, {.hash_comments = true});
  std::vector<PairQuery> queries;
  while (cursor.next_line_with_words()) {
    queries.push_back(read_line(cursor));
    cursor.next_line();
  }
  if (queries.empty())
    fail_in_file(name, {"the file holds no pose", "write a line of 12 or 24 numbers for each query"});
  return queries;
}

}  // namespace io

std::vector<PairQuery> read_poses(const std::string& path) {
  const io::FileBytes bytes = io::read_file(path);
  return io::parse_poses(bytes.span(), path);
}

}  // namespace toccata
