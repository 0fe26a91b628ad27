#include <algorithm>
#include <bit>
#include <string>
#include <utility>
#include <vector>

#include "io/formats/file_error.hpp"
#include "io/formats/parse.hpp"
#include "io/formats/ply_header.hpp"
#include "io/formats/ply_values.hpp"

namespace toccata::io {
namespace {

/// What a property of an element is to this reader.
enum class PlyRole { x, y, z, corners, strips, other };

bool is_vertex_list(const PlyProperty& property) {
  return property.count_type && (property.name == "vertex_indices" || property.name == "vertex_index");
}

PlyRole role_in_vertex(const PlyProperty& property) {
  if (property.count_type) return PlyRole::other;
  if (property.name == "x") return PlyRole::x;
  if (property.name == "y") return PlyRole::y;
  return property.name == "z" ? PlyRole::z : PlyRole::other;
}

PlyRole role_of(const PlyProperty& property, const PlyElement& element) {
  if (element.name == "vertex") return role_in_vertex(property);
  if (element.name == "face" && is_vertex_list(property)) return PlyRole::corners;
  if (element.name == "tristrips" && is_vertex_list(property)) return PlyRole::strips;
  return PlyRole::other;
}

/// Reads the values of all elements, in the order of the header.
template <PlyValues Values>
class PlyBodyReader {
 public:
  PlyBodyReader(const PlyHeader& header, std::string_view name, Values values)
      : header_(header), name_(name), values_(std::move(values)) {}

  PolygonMesh read() {
    vertices_ = require_vertices().count;
    for (const PlyElement& element : header_.elements) read_elements(element);
    values_.expect_end();
    if (mesh_.first.size() == 1)
      fail_in_file(name_, {"there is no face in it (" + std::to_string(vertices_) + " vertices)",
                           "export the mesh with its faces"});
    return std::move(mesh_);
  }

 private:
  const PlyElement& require_vertices() const {
    const auto is_vertex = [](const PlyElement& element) { return element.name == "vertex"; };
    if (std::ranges::count_if(header_.elements, is_vertex) != 1)
      fail_in_file(name_, {"there must be exactly one element called vertex", "export the mesh again"});
    const PlyElement& vertex = *std::ranges::find_if(header_.elements, is_vertex);
    for (const PlyRole role : {PlyRole::x, PlyRole::y, PlyRole::z})
      if (std::ranges::count(vertex.properties, role, role_in_vertex) != 1)
        fail_at_line(name_, vertex.line,
                     {"vertices must have each of the properties x, y and z once", "export the mesh again"});
    return vertex;
  }

  void read_elements(const PlyElement& element) {
    if (element.properties.empty() || element.count == 0) return;
    require_room(element);
    std::vector<PlyRole> roles;
    for (const PlyProperty& property : element.properties) roles.push_back(role_of(property, element));
    require_corner_list(element, roles);
    if (element.name == "vertex") mesh_.vertices.reserve(element.count);
    if (element.name == "face") reserve_faces(element, roles);
    const bool are_vertices = element.name == "vertex";
    for (element_ = 0; element_ < element.count; ++element_) {
      const Vec3 vertex = read_element(element, roles);
      if (are_vertices) mesh_.vertices.push_back(vertex);
    }
  }

  /// Counts are believed only if the file is long enough for them.
  void require_room(const PlyElement& element) const {
    std::size_t bytes = 0;
    for (const PlyProperty& property : element.properties)
      bytes += size_of(property.count_type.value_or(property.type));
    if (element.count > values_.most_elements_left(element.properties.size(), bytes))
      fail_at_line(
          name_, element.line,
          {"the file is too short for " + std::to_string(element.count) + " elements " + in_quotes(element.name),
           "correct the count or export the mesh again"});
  }

  void require_corner_list(const PlyElement& element, const std::vector<PlyRole>& roles) const {
    if (element.name != "face" && element.name != "tristrips") return;
    const auto is_list = [](PlyRole role) { return role == PlyRole::corners || role == PlyRole::strips; };
    if (std::ranges::count_if(roles, is_list) != 1)
      fail_at_line(name_, element.line,
                   {in_quotes(element.name) + " must have one list called vertex_indices", "export the mesh again"});
    const auto list = std::ranges::find_if(roles, is_list) - roles.begin();
    if (!is_integer(element.properties[static_cast<std::size_t>(list)].type))
      fail_at_line(name_, element.line, {"the corners of faces are floats", "use an integer type"});
  }

  /// Reserves as for triangles, so far as the file has room for them.
  void reserve_faces(const PlyElement& element, const std::vector<PlyRole>& roles) {
    const auto list = std::ranges::find(roles, PlyRole::corners) - roles.begin();
    const PlyProperty& property = element.properties[static_cast<std::size_t>(list)];
    const std::size_t bytes = size_of(*property.count_type) + 3 * size_of(property.type);
    const std::size_t faces = std::min(element.count, values_.most_elements_left(4, bytes));
    mesh_.corners.reserve(3 * faces);
    mesh_.first.reserve(mesh_.first.size() + faces);
  }

  /// The position, of a vertex.
  Vec3 read_element(const PlyElement& element, const std::vector<PlyRole>& roles) {
    values_.begin_element();
    Vec3 vertex;
    for (std::size_t i = 0; i < roles.size(); ++i) {
      const PlyProperty& property = element.properties[i];
      switch (roles[i]) {
        case PlyRole::x:
          vertex.x = values_.number(property.type, "the x coordinate");
          break;
        case PlyRole::y:
          vertex.y = values_.number(property.type, "the y coordinate");
          break;
        case PlyRole::z:
          vertex.z = values_.number(property.type, "the z coordinate");
          break;
        case PlyRole::corners:
          read_face(property);
          break;
        case PlyRole::strips:
          read_strips(property);
          break;
        case PlyRole::other:
          values_.skip(property.type, property.count_type ? read_count(property) : 1);
      }
    }
    values_.end_element();
    return vertex;
  }

  std::size_t read_count(const PlyProperty& list) {
    const std::int64_t count = values_.integer(*list.count_type, "the length of a list");
    if (count < 0) values_.fail("a list has the length " + std::to_string(count), "export the mesh again");
    if (count > 0 && static_cast<std::size_t>(count) > values_.most_elements_left(1, size_of(list.type)))
      values_.fail("the file is too short for a list of " + std::to_string(count) + " values", "export the mesh again");
    return static_cast<std::size_t>(count);
  }

  void read_face(const PlyProperty& list) {
    const std::size_t corners = read_count(list);
    if (corners < 3)
      values_.fail("face " + std::to_string(element_) + " has " + std::to_string(corners) + " corners",
                   "give it three or more");
    for (std::size_t corner = 0; corner < corners; ++corner) {
      const std::int64_t index = values_.integer(list.type, "a corner");
      require_vertex(index);
      mesh_.corners.push_back(static_cast<Index>(index));
    }
    close_face();
  }

  /// Every three successive vertices are a triangle, every second of them with its corners in reverse; −1 begins
  /// anew. Every triangle is a face.
  void read_strips(const PlyProperty& list) {
    const std::size_t length = read_count(list);
    std::size_t in_strip = 0;
    std::int64_t before_last = 0, last = 0;
    for (std::size_t i = 0; i < length; ++i) {
      const std::int64_t index = values_.integer(list.type, "a strip's vertex");
      if (index == -1) {
        in_strip = 0;
        continue;
      }
      require_vertex(index);
      if (++in_strip >= 3) add_triangle(before_last, last, index, in_strip % 2 == 0);
      before_last = std::exchange(last, index);
    }
  }

  void add_triangle(std::int64_t a, std::int64_t b, std::int64_t c, bool reverse) {
    if (reverse) std::swap(a, b);
    for (const std::int64_t corner : {a, b, c}) mesh_.corners.push_back(static_cast<Index>(corner));
    close_face();
  }

  void close_face() {
    if (mesh_.corners.size() > most_elements) values_.fail("there are too many face corners", "split the file");
    mesh_.first.push_back(static_cast<Index>(mesh_.corners.size()));
  }

  void require_vertex(std::int64_t index) const {
    if (index < 0 || index >= static_cast<std::int64_t>(vertices_)) refuse_vertex(index);
  }

  [[noreturn]] void refuse_vertex(std::int64_t index) const {
    values_.fail("face " + std::to_string(mesh_.first.size() - 1) + " names vertex " + std::to_string(index) +
                     ", but there are " + std::to_string(vertices_),
                 "count vertices from 0");
  }

  const PlyHeader& header_;
  std::string_view name_;
  Values values_;
  PolygonMesh mesh_;
  std::size_t vertices_ = 0;
  std::size_t element_ = 0;  ///< the number of the element that is being read, among its like
};

template <PlyValues Values>
PolygonMesh read_body(const PlyHeader& header, std::string_view name, Values values) {
  return PlyBodyReader<Values>(header, name, std::move(values)).read();
}

}  // namespace

PolygonMesh parse_ply(std::span<const char> bytes, std::string_view name) {
  const PlyHeader header = parse_ply_header(bytes, name);
  if (header.encoding == PlyEncoding::ascii)
    return read_body(header, name, PlyTextValues(bytes.subspan(header.body_offset), name, header.body_line));
  const std::endian order =
      header.encoding == PlyEncoding::binary_little_endian ? std::endian::little : std::endian::big;
  return read_body(header, name, PlyBinaryValues(bytes, header.body_offset, name, order));
}

}  // namespace toccata::io
