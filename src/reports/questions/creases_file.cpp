#include <limits>
#include <string>

#include "core/no_index.hpp"
#include "io/formats/file_error.hpp"
#include "io/formats/number_lines.hpp"
#include "toccata/reports/scene_question.hpp"

namespace toccata {
namespace {

Index vertex_on_line(io::TextCursor& cursor) {
  const std::int64_t vertex = cursor.integer("the vertex");
  if (vertex < 0 || vertex >= std::int64_t{no_index})
    cursor.fail("there is no vertex " + std::to_string(vertex), "count vertices from 0");
  return static_cast<Index>(vertex);
}

double sharpness_on_line(io::TextCursor& cursor) {
  if (cursor.at_line_end()) return std::numeric_limits<double>::infinity();
  const double sharpness = cursor.number("the sharpness");
  if (sharpness < 0) cursor.fail("the sharpness is negative", "write 0 or more, or nothing for sharp for ever");
  return sharpness;
}

void add_feature(io::TextCursor& cursor, CageFeatures& features) {
  const std::string word(cursor.word());
  if (word == "crease") {
    const Index first = vertex_on_line(cursor), second = vertex_on_line(cursor);
    features.creases.push_back({first, second, sharpness_on_line(cursor)});
  } else if (word == "corner") {
    const Index vertex = vertex_on_line(cursor);
    features.corners.push_back({vertex, sharpness_on_line(cursor)});
  } else {
    cursor.fail("the line begins with " + io::in_quotes(word), "write crease A B [SHARPNESS] or corner V [SHARPNESS]");
  }
  if (!cursor.at_line_end())
    cursor.fail(io::in_quotes(cursor.peek_word()) + " does not belong after the sharpness", "start a new line there");
}

}  // namespace

CageFeatures read_creases(const std::string& path) {
  CageFeatures features;
  io::for_each_line_of_numbers(path, [&](io::TextCursor& cursor) { add_feature(cursor, features); });
  if (features.creases.empty() && features.corners.empty())
    io::fail_in_file(path, {"the file holds no crease", "write a line for each: crease A B [SHARPNESS]"});
  return features;
}

}  // namespace toccata
