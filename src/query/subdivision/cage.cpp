#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "math/vec3_measures.hpp"
#include "query/subdivision/level_mesh.hpp"
#include "toccata/core/error.hpp"

namespace toccata {
namespace {

/// Beyond this, sums of as many coordinates as a cage has and squares of their differences might overflow.
constexpr double greatest_cage_coordinate = 1e150;

std::string vertex_name(Index vertex) { return "vertex " + std::to_string(vertex) + " of the cage"; }
std::string face_name(Index face) { return "face " + std::to_string(face) + " of the cage"; }
std::string edge_name(Index a, Index b) { return "the edge " + std::to_string(a) + "–" + std::to_string(b); }

void check_cage_vertices(const PolygonMesh& polygons) {
  if (polygons.vertices.size() >= no_index) throw Error("a cage has at most 4294967294 vertices");
  for (Index v = 0; v < polygons.vertices.size(); ++v) {
    if (!is_finite(polygons.vertices[v])) throw Error(vertex_name(v) + " has a coordinate that is not finite");
    if (largest_magnitude(polygons.vertices[v]) > greatest_cage_coordinate)
      throw Error(vertex_name(v) + " has a coordinate beyond 1e150: scale the cage down");
  }
}

void check_cage_face(const PolygonMesh& polygons, Index face, SubdivisionScheme scheme) {
  const Index count = polygons.first[face + 1] - polygons.first[face];
  const std::span<const Index> corners = std::span(polygons.corners).subspan(polygons.first[face], count);
  if (count < 3) throw Error(face_name(face) + " has " + std::to_string(count) + " corners, and needs at least 3");
  if (scheme == SubdivisionScheme::loop && count != 3)
    throw Error(face_name(face) + " has " + std::to_string(count) +
                " corners: Loop's scheme is for triangles; cut the faces into triangles, or use Catmull–Clark");
  if (count > most_face_corners)
    throw Error(face_name(face) + " has more than " + std::to_string(most_face_corners) + " corners: cut it");
  for (const Index corner : corners)
    if (corner >= polygons.vertices.size())
      throw Error(face_name(face) + " names vertex " + std::to_string(corner) + ", but there are " +
                  std::to_string(polygons.vertices.size()) + " vertices, counted from 0");
}

void check_cage_faces(const PolygonMesh& polygons, SubdivisionScheme scheme) {
  if (polygons.first.size() < 2) throw Error("a cage needs at least one face");
  if (polygons.corners.size() >= no_index / 8) throw Error("a cage has at most 536870911 corners of faces");
  if (polygons.first.front() != 0 || polygons.first.back() != polygons.corners.size())
    throw Error("`first` of a cage's faces must begin with 0 and end with the number of corners");
  for (std::size_t f = 0; f + 1 < polygons.first.size(); ++f)
    if (polygons.first[f + 1] < polygons.first[f])
      throw Error("`first` of a cage's faces falls after face " + std::to_string(f) + "; it must ascend");
  for (Index f = 0; f + 1 < polygons.first.size(); ++f) check_cage_face(polygons, f, scheme);
}

/// Two sides from one vertex to the same other are of three faces, or of two that are turned differently.
void check_sides(const LevelMesh& mesh, Index vertex) {
  const std::span<const Index> sides = mesh.sides_at(vertex);
  for (std::size_t i = 0; i + 1 < sides.size(); ++i) {
    const Index end = mesh.end_of(sides[i]);
    if (end != mesh.end_of(sides[i + 1])) continue;
    const Index face = mesh.face_of_side[sides[i]], other = mesh.face_of_side[sides[i + 1]];
    if (face == other)
      throw Error(face_name(face) + " uses " + edge_name(vertex, end) + " twice: a face has every vertex once");
    if (mesh.side_between(end, vertex) != no_index || (i + 2 < sides.size() && mesh.end_of(sides[i + 2]) == end))
      throw Error(edge_name(vertex, end) + " of the cage is shared by more than two faces, among them " +
                  std::to_string(face) + " and " + std::to_string(other) + ": a surface has at most two");
    throw Error("the faces " + std::to_string(face) + " and " + std::to_string(other) + " of the cage both use " +
                edge_name(vertex, end) + " in this direction: turn one of them round");
  }
}

/// How many faces one passes who goes around the vertex, from the border if there is one.
std::size_t faces_around(const LevelMesh& mesh, Index vertex) {
  const std::span<const Index> sides = mesh.sides_at(vertex);
  Index begin = sides.front();
  for (const Index side : sides)
    if (mesh.twin(side) == no_index) begin = side;
  std::size_t count = 0;
  Index side = begin;
  do {
    ++count;
    side = mesh.twin(mesh.previous(side));
  } while (side != no_index && side != begin && count <= sides.size());
  return count;
}

void check_cage_vertex(const LevelMesh& mesh, Index vertex) {
  const std::span<const Index> sides = mesh.sides_at(vertex);
  if (sides.empty()) throw Error(vertex_name(vertex) + " is of no face: leave it out");
  std::vector<Index> faces;
  for (const Index side : sides) faces.push_back(mesh.face_of_side[side]);
  std::sort(faces.begin(), faces.end());
  const auto twice = std::adjacent_find(faces.begin(), faces.end());
  if (twice != faces.end()) throw Error(face_name(*twice) + " has vertex " + std::to_string(vertex) + " twice");
  if (faces_around(mesh, vertex) != sides.size())
    throw Error(vertex_name(vertex) + " joins faces that share no edge there: give each group a vertex of its own");
  if (sides.size() == 2 && mesh.twin(sides[0]) != no_index && mesh.twin(sides[1]) != no_index)
    throw Error(vertex_name(vertex) + " lies between two faces and nothing else: give it a third, or join the faces");
}

void check_sharpness(double sharpness, const std::string& what) {
  if (!(sharpness >= 0))
    throw Error("the sharpness of " + what + " of the cage must be at least 0; infinite is sharp for ever");
}

void check_features(const LevelMesh& mesh, const CageFeatures& features) {
  for (const CageCrease& crease : features.creases) {
    const bool are_vertices = crease.first < mesh.points.size() && crease.second < mesh.points.size();
    if (!are_vertices || mesh.edge_between(crease.first, crease.second) == no_index)
      throw Error("a crease names " + edge_name(crease.first, crease.second) + ", which is no edge of the cage");
    check_sharpness(crease.sharpness, edge_name(crease.first, crease.second));
  }
  for (const CageCorner& corner : features.corners) {
    if (corner.vertex >= mesh.points.size())
      throw Error("a corner names vertex " + std::to_string(corner.vertex) + ", but the cage has " +
                  std::to_string(mesh.points.size()) + " vertices, counted from 0");
    check_sharpness(corner.sharpness, "vertex " + std::to_string(corner.vertex));
  }
}

/// Without sharpness, which is still to be checked.
LevelMesh bare_level(const PolygonMesh& polygons) {
  LevelMesh mesh;
  mesh.points = polygons.vertices;
  mesh.corners = polygons.corners;
  mesh.first_side = polygons.first;
  mesh.connect();
  return mesh;
}

}  // namespace

SubdivisionCage::SubdivisionCage(PolygonMesh polygons, SubdivisionScheme scheme, CageFeatures features)
    : polygons_(std::move(polygons)), scheme_(scheme), features_(std::move(features)) {
  check_cage_vertices(polygons_);
  check_cage_faces(polygons_, scheme_);
  const LevelMesh mesh = bare_level(polygons_);
  for (Index v = 0; v < mesh.points.size(); ++v) check_sides(mesh, v);
  for (Index v = 0; v < mesh.points.size(); ++v) check_cage_vertex(mesh, v);
  check_features(mesh, features_);
  closed_ = std::none_of(mesh.edges.begin(), mesh.edges.end(),
                         [](const LevelEdge& edge) { return edge.sides[1] == no_index; });
}

SubdivisionCage SubdivisionCage::posed(const Pose& pose) const {
  return {{transform(pose, polygons_.vertices), polygons_.corners, polygons_.first}, scheme_, features_};
}

}  // namespace toccata
