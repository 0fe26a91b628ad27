#include <algorithm>
#include <string>
#include <utility>

#include "io/formats/file_error.hpp"
#include "io/formats/number.hpp"
#include "io/formats/parse.hpp"
#include "io/formats/text_cursor.hpp"

namespace toccata::io {
namespace {

/// What the letters before "OFF" announce behind the three coordinates of a vertex can stay unread: only a fourth
/// coordinate or another dimension changes what the first three mean.
struct OffKeyword {
  bool valid = false;
  bool other_dimension = false;
  std::size_t length = 0;
};

OffKeyword off_keyword(std::string_view word) {
  std::string_view rest = word;
  const auto take = [&](std::string_view prefix) {
    const bool present = rest.starts_with(prefix);
    if (present) rest.remove_prefix(prefix.size());
    return present;
  };
  OffKeyword keyword;
  take("ST");
  take("C");
  take("N");
  keyword.other_dimension = take("4");
  keyword.other_dimension = take("n") || keyword.other_dimension;
  // Some collections write the counts right behind the keyword: "OFF490 518 0".
  keyword.valid = take("OFF") && (rest.empty() || is_digit(rest.front()));
  keyword.length = word.size() - rest.size();
  return keyword;
}

/// Reads an OFF file (Geomview manual, "OFF files", 1996).
class OffReader {
 public:
  OffReader(std::span<const char> bytes, std::string_view name)
      : name_(name), cursor_(bytes, name, {.hash_comments = true}) {}

  PolygonMesh read() {
    read_keyword();
    read_counts();
    mesh_.vertices.reserve(vertices_);
    mesh_.first.reserve(faces_ + 1);
    for (std::size_t vertex = 0; vertex < vertices_; ++vertex) read_vertex();
    for (std::size_t face = 0; face < faces_; ++face) read_face(face);
    if (cursor_.next_line_with_words())
      cursor_.fail("there is more in the file than the " + std::to_string(vertices_) + " vertices and " +
                       std::to_string(faces_) + " faces that were announced",
                   "correct the counts at its beginning");
    return std::move(mesh_);
  }

 private:
  void read_keyword() {
    if (!cursor_.next_line_with_words()) cursor_.fail("the file holds only comments", "export the mesh again");
    const OffKeyword keyword = off_keyword(cursor_.peek_word());
    if (!keyword.valid) cursor_.fail("an OFF file begins with OFF", "check that the extension is that of the format");
    if (keyword.other_dimension)
      cursor_.fail("vertices of four or more dimensions are not read", "export the mesh in three dimensions");
    cursor_.skip(keyword.length);
  }

  void read_counts() {
    if (!cursor_.next_line_with_words()) fail_truncated("the counts");
    vertices_ = count("the number of vertices");
    faces_ = count("the number of faces");
    if (!cursor_.at_line_end()) static_cast<void>(cursor_.integer("the number of edges"));
    const std::size_t counts_line = cursor_.line();
    cursor_.expect_line_end("the counts");
    require_room(counts_line);
    if (faces_ == 0) fail_at_line(name_, counts_line, {"there is no face in it", "export the mesh with its faces"});
  }

  std::size_t count(std::string_view what) {
    const std::int64_t value = cursor_.integer(what);
    if (value < 0 || value > static_cast<std::int64_t>(most_elements))
      cursor_.fail(std::string(what) + " is " + std::to_string(value), "correct the count or split the file");
    return static_cast<std::size_t>(value);
  }

  /// Counts are believed only if the file is long enough for them: "0 0 0" and "3 0 1 2" are the shortest lines.
  void require_room(std::size_t counts_line) const {
    constexpr std::size_t shortest_vertex = 6, shortest_face = 8;
    if (vertices_ * shortest_vertex + faces_ * shortest_face > cursor_.bytes_left() + 1)
      fail_at_line(name_, counts_line,
                   {"the file is too short for " + std::to_string(vertices_) + " vertices and " +
                        std::to_string(faces_) + " faces",
                    "correct the counts or export the mesh again"});
  }

  void read_vertex() {
    if (!cursor_.next_line_with_words()) fail_truncated("vertex " + std::to_string(mesh_.vertices.size()));
    const double x = cursor_.number("the x coordinate");
    const double y = cursor_.number("the y coordinate");
    const double z = cursor_.number("the z coordinate");
    mesh_.vertices.push_back({x, y, z});
    // A normal, a colour or a texture coordinate may follow, in whatever notation.
    cursor_.next_line();
  }

  void read_face(std::size_t face) {
    if (!cursor_.next_line_with_words()) fail_truncated("face " + std::to_string(face));
    const std::int64_t corners = cursor_.integer("the number of corners");
    if (corners < 3)
      cursor_.fail("face " + std::to_string(face) + " has " + std::to_string(corners) + " corners",
                   "give it three or more");
    for (std::int64_t corner = 0; corner < corners; ++corner) mesh_.corners.push_back(read_corner(face));
    mesh_.first.push_back(static_cast<Index>(mesh_.corners.size()));
    // A colour may follow, in whatever notation.
    cursor_.next_line();
  }

  Index read_corner(std::size_t face) {
    const std::int64_t index = cursor_.integer("a corner");
    if (index < 0 || index >= static_cast<std::int64_t>(vertices_))
      cursor_.fail("face " + std::to_string(face) + " names vertex " + std::to_string(index) + ", but there are " +
                       std::to_string(vertices_),
                   "count vertices from 0");
    if (mesh_.corners.size() == most_elements) cursor_.fail("there are too many face corners", "split the file");
    return static_cast<Index>(index);
  }

  [[noreturn]] void fail_truncated(const std::string& missing) const {
    cursor_.fail("the file ends before " + missing, "export the mesh again");
  }

  std::string_view name_;
  TextCursor cursor_;
  PolygonMesh mesh_;
  std::size_t vertices_ = 0;
  std::size_t faces_ = 0;
};

}  // namespace

PolygonMesh parse_off(std::span<const char> bytes, std::string_view name) {
  const std::string_view text(bytes.data(), bytes.size());
  const std::string_view first_line = text.substr(0, text.find_first_of("\r\n"));
  if (looks_like_off(bytes) && first_line.find("BINARY") != std::string_view::npos)
    fail_at_line(name, 1, {"binary OFF files are not read", "export the mesh as text"});
  return OffReader(bytes, name).read();
}

bool looks_like_off(std::span<const char> bytes) {
  constexpr std::size_t longest_keyword = 16;
  const std::string_view head(bytes.data(), std::min(bytes.size(), longest_keyword));
  const OffKeyword keyword = off_keyword(head.substr(0, head.find_first_of(" \t\r\n")));
  return keyword.valid;
}

}  // namespace toccata::io
