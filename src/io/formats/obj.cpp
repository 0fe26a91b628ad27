#include <algorithm>
#include <limits>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "io/formats/file_error.hpp"
#include "io/formats/parse.hpp"
#include "io/formats/text_cursor.hpp"

namespace toccata::io {
namespace {

/// Reads the vertices and faces of an OBJ file (Wavefront, "Object files", 1995); other statements are skipped.
class ObjReader {
 public:
  ObjReader(std::span<const char> bytes, std::string_view name)
      : cursor_(bytes, name, {.hash_comments = true, .backslash_joins = true}) {}

  /// A face may name vertices that come later in the file, up to `vertices_in_file`.
  PolygonMesh read(std::size_t vertices_in_file) {
    while (cursor_.next_line_with_words()) {
      const std::string_view keyword = cursor_.word();
      if (keyword == "v") {
        read_vertex();
      } else if (keyword == "f" || keyword == "fo") {
        read_face(vertices_in_file);
      } else if (keyword == "o" || keyword == "g") {
        read_name(keyword == "o" ? object_ : group_);
      } else {
        cursor_.next_line();
      }
    }
    return std::move(mesh_);
  }

  [[nodiscard]] std::size_t largest_vertex() const { return largest_vertex_; }

  /// For each face that was read, what it stands under: a number into `part_names`.
  [[nodiscard]] const std::vector<Index>& part_of_face() const { return part_of_face_; }
  [[nodiscard]] const std::vector<std::string>& part_names() const { return part_names_; }

 private:
  void read_vertex() {
    const double x = cursor_.number("the x coordinate");
    const double y = cursor_.number("the y coordinate");
    const double z = cursor_.number("the z coordinate");
    if (mesh_.vertices.size() == most_elements) cursor_.fail("there are too many vertices", "split the file");
    mesh_.vertices.push_back({x, y, z});
    skip_weight_or_colour();
  }

  /// The words behind `o` or `g`. A new object has no group yet.
  void read_name(std::string& name) {
    name.clear();
    if (&name == &object_) group_.clear();
    while (!cursor_.at_line_end()) {
      if (!name.empty()) name += ' ';
      name += cursor_.word();
    }
    part_.reset();
    cursor_.next_line();
  }

  /// The number of the part to which the faces belong that are read now.
  Index part() {
    if (part_) return *part_;
    const bool has_both = !object_.empty() && !group_.empty() && object_ != group_;
    const std::string name = has_both ? object_ + "/" + group_ : object_.empty() ? group_ : object_;
    const auto [found, is_new] = number_of_part_.emplace(name, static_cast<Index>(part_names_.size()));
    if (is_new) part_names_.push_back(name);
    return *(part_ = found->second);
  }

  void skip_weight_or_colour() {
    constexpr int most_values = 4;
    for (int values = 0; values < most_values && !cursor_.at_line_end(); ++values)
      static_cast<void>(cursor_.number("the weight or colour"));
    cursor_.expect_line_end("a vertex");
  }

  void read_face(std::size_t vertices_in_file) {
    while (!cursor_.at_line_end()) mesh_.corners.push_back(read_corner(vertices_in_file));
    const std::size_t corners = mesh_.corners.size() - mesh_.first.back();
    if (corners < 3) cursor_.fail("a face has " + std::to_string(corners) + " corners", "give it three or more");
    if (mesh_.corners.size() > most_elements) cursor_.fail("there are too many face corners", "split the file");
    mesh_.first.push_back(static_cast<Index>(mesh_.corners.size()));
    part_of_face_.push_back(part());
    cursor_.next_line();
  }

  /// One of "v", "v/vt", "v//vn", "v/vt/vn", where only v matters here.
  Index read_corner(std::size_t vertices_in_file) {
    const std::string_view word = cursor_.word();
    const std::size_t slash = std::min(word.find('/'), word.size());
    const ParsedInteger vertex = parse_integer(word.substr(0, slash));
    if (!vertex.valid || !is_texture_and_normal(word.substr(slash)))
      cursor_.fail("the face corner " + in_quotes(word) + " is not an index",
                   "write vertex, vertex/texture, vertex//normal or vertex/texture/normal");
    return resolve(vertex.value, vertices_in_file);
  }

  /// What may follow the vertex of a corner: at most two slashes, each with an integer or nothing behind it.
  static bool is_texture_and_normal(std::string_view rest) {
    for (int part = 0; part < 2 && !rest.empty(); ++part) {
      const std::size_t next = std::min(rest.find('/', 1), rest.size());
      const std::string_view index = rest.substr(1, next - 1);
      if (!index.empty() && !parse_integer(index).valid) return false;
      rest.remove_prefix(next);
    }
    return rest.empty();
  }

  /// Positive indices count from 1, negative ones back from the latest vertex.
  Index resolve(std::int64_t index, std::size_t vertices_in_file) {
    const auto defined = static_cast<std::int64_t>(mesh_.vertices.size());
    if (index == 0) cursor_.fail("a face names vertex 0", "count vertices from 1");
    if (index < -defined || index > static_cast<std::int64_t>(vertices_in_file))
      cursor_.fail("a face names vertex " + std::to_string(index) + ", but there are only " +
                       std::to_string(index < 0 ? defined : static_cast<std::int64_t>(vertices_in_file)) +
                       (index < 0 ? " before it" : ""),
                   "correct the index or add the missing vertices");
    const auto vertex = static_cast<std::size_t>(index < 0 ? defined + index : index - 1);
    largest_vertex_ = std::max(largest_vertex_, vertex);
    return static_cast<Index>(vertex);
  }

  TextCursor cursor_;
  PolygonMesh mesh_;
  std::size_t largest_vertex_ = 0;
  std::string object_, group_;  ///< what `o` and `g` said last
  std::optional<Index> part_;   ///< their number, once a face needs it
  std::vector<Index> part_of_face_;
  std::vector<std::string> part_names_;
  std::map<std::string, Index> number_of_part_;
};

/// A whole file.
struct ObjFile {
  PolygonMesh mesh;
  std::vector<Index> part_of_face;
  std::vector<std::string> part_names;
};

ObjFile read_obj(std::span<const char> bytes, std::string_view name) {
  ObjReader reader(bytes, name);
  PolygonMesh mesh = reader.read(most_elements);
  if (mesh.vertices.empty() && mesh.first.size() == 1)
    fail_in_file(name, {"there is neither a vertex nor a face in it", "check that it is an OBJ file"});
  if (mesh.first.size() == 1)
    fail_in_file(name, {"there is no face in it (" + std::to_string(mesh.vertices.size()) + " vertices)",
                        "export the mesh with its faces"});
  // How many vertices there are is known only now. The second reading stops at the face that names one too many.
  if (reader.largest_vertex() >= mesh.vertices.size())
    static_cast<void>(ObjReader(bytes, name).read(mesh.vertices.size()));
  return {std::move(mesh), reader.part_of_face(), reader.part_names()};
}

/// Cuts a mesh into parts.
class PartsOf {
 public:
  explicit PartsOf(const PolygonMesh& whole) : whole_(whole), number_(whole.vertices.size(), none) {}

  /// These faces with the vertices that they use, both in the order of the file.
  PolygonMesh part(std::span<const Index> faces) {
    PolygonMesh part;
    std::vector<Index> used;
    for (const Index face : faces)
      for (const Index vertex : corners_of(face))
        if (std::exchange(number_[vertex], 0) == none) used.push_back(vertex);
    std::sort(used.begin(), used.end());
    for (const Index vertex : used) {
      number_[vertex] = static_cast<Index>(part.vertices.size());
      part.vertices.push_back(whole_.vertices[vertex]);
    }
    for (const Index face : faces) {
      for (const Index vertex : corners_of(face)) part.corners.push_back(number_[vertex]);
      part.first.push_back(static_cast<Index>(part.corners.size()));
    }
    for (const Index vertex : used) number_[vertex] = none;
    return part;
  }

 private:
  static constexpr Index none = std::numeric_limits<Index>::max();

  [[nodiscard]] std::span<const Index> corners_of(Index face) const {
    return std::span(whole_.corners).subspan(whole_.first[face], whole_.first[face + 1] - whole_.first[face]);
  }

  const PolygonMesh& whole_;
  std::vector<Index> number_;  ///< of each vertex, in the part that is made
};

}  // namespace

PolygonMesh parse_obj(std::span<const char> bytes, std::string_view name) { return read_obj(bytes, name).mesh; }

std::vector<NamedPolygons> parse_obj_parts(std::span<const char> bytes, std::string_view name) {
  const ObjFile file = read_obj(bytes, name);
  std::vector<std::vector<Index>> faces(file.part_names.size());
  for (Index face = 0; face < file.part_of_face.size(); ++face) faces[file.part_of_face[face]].push_back(face);
  PartsOf parts_of(file.mesh);
  std::vector<NamedPolygons> parts;
  for (std::size_t i = 0; i < faces.size(); ++i) parts.push_back({file.part_names[i], parts_of.part(faces[i])});
  return parts;
}

}  // namespace toccata::io
