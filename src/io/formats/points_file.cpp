#include "toccata/io/query_files.hpp"

#include <string>

#include "io/formats/file_error.hpp"
#include "io/formats/number_lines.hpp"

namespace toccata {

std::vector<Vec3> read_points(const std::string& path) {
  std::vector<Vec3> points;
  io::for_each_line_of_numbers(path, [&](io::TextCursor& cursor) {
    const auto line = io::numbers_of_line<3>(cursor);
    if (line.count != 3) cursor.fail("a line of 3 numbers has " + std::to_string(line.count), "give x, y and z");
    points.push_back({line.number[0], line.number[1], line.number[2]});
  });
  if (points.empty()) io::fail_in_file(path, {"the file holds no point", "write a line of 3 numbers for each"});
  return points;
}

}  // namespace toccata
