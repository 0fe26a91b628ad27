#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "io/formats/binary_values.hpp"
#include "io/formats/file_error.hpp"
#include "io/formats/parse.hpp"
#include "io/formats/text_cursor.hpp"
#include "shapes/point_numbers.hpp"

namespace toccata::io {
namespace {

// The binary form: 80 bytes of anything, the number of facets, then for each its normal, three vertices and two bytes.
constexpr std::size_t stl_header_size = 84, facet_size = 50, normal_size = 12, float_size = 4;

/// Facets whose corners are told one by one. Corners of the same coordinates are one vertex: the format has no other
/// way to say so, and a mesh is then a third as large.
class FacetMesh {
 public:
  /// Expects as many vertices as closed meshes have: half as many as facets.
  explicit FacetMesh(std::size_t facets) : numbers_(facets / 2) {
    vertices_.reserve(facets / 2 + 2);
    triangles_.reserve(facets);
  }

  [[nodiscard]] std::size_t corner_count() const { return 3 * triangles_.size() + corners_; }

  void add_corner(const Vec3& corner) {
    const auto number = static_cast<Index>(vertices_.size());
    facet_[corners_] = numbers_.find_or_take(corner, number, vertices_, same_bits);
    if (facet_[corners_] == number) vertices_.push_back(corner);
    if (++corners_ < 3) return;
    triangles_.push_back(facet_);
    corners_ = 0;
  }

  [[nodiscard]] TriangleMesh mesh() && { return {std::move(vertices_), std::move(triangles_)}; }

 private:
  /// −0 stays −0.
  static bool same_bits(const Vec3& a, const Vec3& b) {
    using Bits = std::array<std::uint64_t, 3>;
    return std::bit_cast<Bits>(a) == std::bit_cast<Bits>(b);
  }

  PointNumbers numbers_;
  std::vector<Vec3> vertices_;
  std::vector<std::array<Index, 3>> triangles_;
  std::array<Index, 3> facet_{};
  std::size_t corners_ = 0;  ///< of the facet that is not complete
};

std::size_t announced_facets(std::span<const char> bytes) {
  return stored_value<std::uint32_t>(bytes.subspan(stl_header_size - sizeof(std::uint32_t)), std::endian::little);
}

/// No text comes near it: four printable characters as a count announce more than 26 gigabytes.
bool has_exactly_the_size_of_a_binary(std::span<const char> bytes) {
  return bytes.size() > stl_header_size && bytes.size() == stl_header_size + facet_size * announced_facets(bytes);
}

bool is_letter(char c, char lower) { return c == lower || c == lower - 'a' + 'A'; }

bool same_word(std::string_view word, std::string_view lower) {
  return word.size() == lower.size() && std::ranges::equal(word, lower, is_letter);
}

/// Begins with the word "solid", and what follows is text. Binary files may begin with it, too.
bool looks_like_ascii_stl(std::span<const char> bytes) {
  constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF", keyword = "solid";
  constexpr std::size_t looked_at = 1024;
  std::string_view head(bytes.data(), std::min(bytes.size(), looked_at));
  if (head.find('\0') != std::string_view::npos) return false;
  if (head.starts_with(byte_order_mark)) head.remove_prefix(byte_order_mark.size());
  head.remove_prefix(std::min(head.find_first_not_of(" \t\r\n"), head.size()));
  const std::string_view after = head.substr(std::min(head.size(), keyword.size()));
  return same_word(head.substr(0, keyword.size()), keyword) && (after.empty() || after.find_first_of(" \t\r\n") == 0);
}

/// Reads the binary form (3D Systems, "Stereolithography interface specification", 1988).
class BinaryStlReader {
 public:
  BinaryStlReader(std::span<const char> bytes, std::string_view name) : bytes_(bytes), name_(name) {}

  TriangleMesh read() {
    if (bytes_.size() < stl_header_size)
      fail_in_file(name_, {"this is no STL file: it does not begin with \"solid\" and is shorter than a binary header",
                           "check that the extension is that of the format"});
    const std::size_t facets = announced_facets(bytes_);
    require_size(facets);
    FacetMesh mesh(facets);
    for (std::size_t facet = 0; facet < facets; ++facet)
      for (std::size_t corner = 0; corner < 3; ++corner) mesh.add_corner(read_vertex(facet, corner));
    return std::move(mesh).mesh();
  }

 private:
  /// A little padding may follow the last facet, but nothing in which another would have room.
  void require_size(std::size_t facets) const {
    const std::size_t room = (bytes_.size() - stl_header_size) / facet_size;
    if (facets != room)
      fail_at_byte(name_, stl_header_size - sizeof(std::uint32_t),
                   {"a binary STL file with " + std::to_string(facets) +
                        " facets is announced, but the file has room for " + std::to_string(room),
                    "export the mesh again, or rename the file if it is not STL"});
    if (facets == 0) fail_in_file(name_, {"there is no facet in it", "export the mesh with its faces"});
    if (facets > most_elements / 3) fail_in_file(name_, {"there are too many facets", "split the file"});
  }

  Vec3 read_vertex(std::size_t facet, std::size_t corner) const {
    const std::size_t byte = stl_header_size + facet * facet_size + normal_size + corner * 3 * float_size;
    const auto coordinate = [&](std::size_t axis) {
      return static_cast<double>(stored_value<float>(bytes_.subspan(byte + axis * float_size), std::endian::little));
    };
    const Vec3 vertex{coordinate(0), coordinate(1), coordinate(2)};
    if (!is_finite(vertex))
      fail_at_byte(name_, byte,
                   {"vertex " + std::to_string(corner) + " of facet " + std::to_string(facet) + " is not finite",
                    "export the mesh again"});
    return vertex;
  }

  std::span<const char> bytes_;
  std::string_view name_;
};

/// Reads the text form; its words may be in capitals. What stands behind "facet" and "endsolid" is
/// ignored.
class AsciiStlReader {
 public:
  AsciiStlReader(std::span<const char> bytes, std::string_view name) : name_(name), cursor_(bytes, name, {}) {}

  TriangleMesh read() {
    while (cursor_.next_line_with_words()) static_cast<void>(read_solid());
    if (mesh_.corner_count() == 0) fail_without_facets();
    return std::move(mesh_).mesh();
  }

  std::vector<NamedMesh> read_solids() {
    std::vector<NamedMesh> solids;
    while (cursor_.next_line_with_words()) {
      std::string name = read_solid();
      if (mesh_.corner_count() > 0) solids.push_back({std::move(name), std::exchange(mesh_, FacetMesh{0}).mesh()});
    }
    if (solids.empty()) fail_without_facets();
    return solids;
  }

 private:
  [[noreturn]] void fail_without_facets() const {
    fail_in_file(name_, {"there is no facet in it", "export the mesh with its faces"});
  }

  /// Its facets go into the mesh. Returns its name.
  std::string read_solid() {
    expect("solid");
    std::string name;
    while (!cursor_.at_line_end()) {
      if (!name.empty()) name += ' ';
      name += cursor_.word();
    }
    cursor_.next_line();
    read_facets();
    return name;
  }

  void read_facets() {
    while (same_word(next_word(), "facet")) {
      skip_normal();
      read_loop();
    }
    expect("endsolid");
    cursor_.next_line();
  }

  /// "facet normal x y z". Many exporters write normals that are no numbers.
  void skip_normal() {
    constexpr int most_words = 5;
    for (int words = 0; words < most_words && !same_word(next_word(), "outer"); ++words)
      static_cast<void>(cursor_.word());
  }

  void read_loop() {
    expect("outer");
    expect("loop");
    for (int corner = 0; corner < 3; ++corner) {
      expect("vertex");
      const double x = cursor_.number("the x coordinate");
      const double y = cursor_.number("the y coordinate");
      const double z = cursor_.number("the z coordinate");
      mesh_.add_corner({x, y, z});
    }
    if (mesh_.corner_count() > most_elements) cursor_.fail("there are too many facets", "split the file");
    if (same_word(next_word(), "vertex")) cursor_.fail("a facet has more than three vertices", "export triangles only");
    expect("endloop");
    expect("endfacet");
  }

  std::string_view next_word() {
    if (!cursor_.next_line_with_words()) cursor_.fail("the file ends inside a solid", "export the mesh again");
    return cursor_.peek_word();
  }

  void expect(std::string_view keyword) {
    const std::string_view found = next_word();
    if (!same_word(found, keyword))
      cursor_.fail("\"" + std::string(keyword) + "\" was expected, not " + in_quotes(found), "export the mesh again");
    cursor_.skip(found.size());
  }

  std::string_view name_;
  TextCursor cursor_;
  FacetMesh mesh_{0};
};

}  // namespace

bool looks_like_stl(std::span<const char> bytes) {
  return has_exactly_the_size_of_a_binary(bytes) || looks_like_ascii_stl(bytes);
}

std::vector<NamedMesh> parse_stl_solids(std::span<const char> bytes, std::string_view name) {
  if (!has_exactly_the_size_of_a_binary(bytes) && looks_like_ascii_stl(bytes))
    return AsciiStlReader(bytes, name).read_solids();
  std::vector<NamedMesh> solids;
  solids.push_back({"", BinaryStlReader(bytes, name).read()});
  return solids;
}

TriangleMesh parse_stl(std::span<const char> bytes, std::string_view name) {
  // The size is asked before the word "solid", with which binary files may begin.
  if (!has_exactly_the_size_of_a_binary(bytes) && looks_like_ascii_stl(bytes))
    return AsciiStlReader(bytes, name).read();
  return BinaryStlReader(bytes, name).read();
}

}  // namespace toccata::io
