#include "toccata/io/query_files.hpp"

#include <algorithm>
#include <span>
#include <string>
#include <vector>

#include "io/formats/file_bytes.hpp"
#include "io/formats/file_error.hpp"
#include "io/formats/parse_poses.hpp"
#include "io/formats/pose_text.hpp"
#include "io/formats/text_cursor.hpp"

namespace toccata {
namespace io {
namespace {

/// What is left of the cursor's line; the last pose of it places B, the one before, if any, A.
PairQuery read_line(TextCursor& cursor) {
  std::vector<double> numbers;
  while (!cursor.at_line_end()) numbers.push_back(cursor.number("the number"));
  const std::size_t count = numbers.size();
  const bool places_both = count % 2 == 0 && is_count_of_pose(count / 2);
  if (!places_both && !is_count_of_pose(count))
    cursor.fail("a line of 12 or 24 numbers has " + std::to_string(count),
                "give the pose of B in A's frame, or first that of A and then that of B, each of " +
                    std::string(numbers_of_a_pose));
  const FailPose fail = [&](const std::string& what, const std::string& advice) { cursor.fail(what, advice); };
  const std::span<const double> all(numbers);
  if (!places_both) return {.pose_b = pose_of_numbers(all, fail)};
  return {.pose_a = pose_of_numbers(all.first(count / 2), fail), .pose_b = pose_of_numbers(all.last(count / 2), fail)};
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
