#include "query/subdivision/cage_checks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "math/vec3_measures.hpp"
#include "toccata/core/error.hpp"

namespace toccata {
namespace {

/// Beyond this, sums of as many coordinates as a cage has and squares of their differences might overflow.
constexpr double greatest_cage_coordinate = 1e150;

std::string place_text(const Vec3& p) { return fmt::format("({:g}, {:g}, {:g})", p.x, p.y, p.z); }

void require_cage_vertices(const PolygonMesh& polygons, const CageNames& names) {
  if (polygons.vertices.size() >= no_index) throw Error("a cage has at most 4294967294 vertices");
  for (Index v = 0; v < polygons.vertices.size(); ++v) {
    if (!is_finite(polygons.vertices[v])) throw Error(names.vertex(v) + " has a coordinate that is not finite");
    if (largest_magnitude(polygons.vertices[v]) > greatest_cage_coordinate)
      throw Error(names.vertex(v) + " has a coordinate beyond 1e150: scale the cage down");
  }
}

void require_cage_face(const PolygonMesh& polygons, Index face, SubdivisionScheme scheme, const CageNames& names) {
  const Index count = polygons.first[face + 1] - polygons.first[face];
  const std::span<const Index> corners = std::span(polygons.corners).subspan(polygons.first[face], count);
  if (count < 3) throw Error(fmt::format("{} has {} corners, and needs at least 3", names.face(face), count));
  if (scheme == SubdivisionScheme::loop && count != 3)
    throw Error(
        fmt::format("{} has {} corners: Loop's scheme is for triangles; cut the faces into triangles, or use "
                    "Catmull–Clark",
                    names.face(face), count));
  if (count > most_face_corners)
    throw Error(fmt::format("{} has more than {} corners: cut it", names.face(face), most_face_corners));
  for (const Index corner : corners)
    if (corner >= polygons.vertices.size())
      throw Error(fmt::format("{} names vertex {}, but there are {} vertices, counted from 0", names.face(face), corner,
                              polygons.vertices.size()));
}

void require_cage_faces(const PolygonMesh& polygons, SubdivisionScheme scheme, const CageNames& names) {
  if (polygons.first.size() < 2) throw Error("a cage needs at least one face");
  if (polygons.corners.size() >= no_index / 8) throw Error("a cage has at most 536870911 corners of faces");
  if (polygons.first.front() != 0 || polygons.first.back() != polygons.corners.size())
    throw Error("`first` of a cage's faces must begin with 0 and end with the number of corners");
  for (std::size_t f = 0; f + 1 < polygons.first.size(); ++f)
    if (polygons.first[f + 1] < polygons.first[f])
      throw Error(fmt::format("`first` of a cage's faces falls after face {}; it must ascend", f));
  for (Index f = 0; f + 1 < polygons.first.size(); ++f) require_cage_face(polygons, f, scheme, names);
}

/// Two sides from one vertex to the same other are of three faces, or of two that are turned differently.
void require_surface_at(const LevelMesh& mesh, Index vertex, const CageNames& names) {
  const std::span<const Index> sides = mesh.sides_at(vertex);
  for (std::size_t i = 0; i + 1 < sides.size(); ++i) {
    const Index end = mesh.end_of(sides[i]);
    if (end != mesh.end_of(sides[i + 1])) continue;
    const Index face = mesh.face_of_side[sides[i]], other = mesh.face_of_side[sides[i + 1]];
    const std::string edge = names.edge(vertex, end);
    if (face == other)
      throw Error(fmt::format("{} uses {} twice: a face has every vertex once", names.face(face), edge));
    if (mesh.side_between(end, vertex) != no_index || (i + 2 < sides.size() && mesh.end_of(sides[i + 2]) == end))
      throw Error(
          fmt::format("{} is shared by more than two faces, among them {} and {}: a surface has at most two; leave "
                      "one out, or move what belongs together apart from the rest",
                      edge, names.face(face), names.face(other)));
    throw Error(fmt::format("{} and {} both use {} in this direction: turn one of them round", names.face(face),
                            names.face(other), edge));
  }
}

void require_cage_vertex(const LevelMesh& mesh, Index vertex, SubdivisionScheme scheme, const CageNames& names) {
  const std::span<const Index> sides = mesh.sides_at(vertex);
  if (sides.empty()) throw Error(names.vertex(vertex) + " is of no face: leave it out");
  std::vector<Index> faces;
  for (const Index side : sides) faces.push_back(mesh.face_of_side[side]);
  std::sort(faces.begin(), faces.end());
  const auto twice = std::adjacent_find(faces.begin(), faces.end());
  if (twice != faces.end()) throw Error(fmt::format("{} has {} twice", names.face(*twice), names.vertex(vertex)));
  if (scheme == SubdivisionScheme::loop && sides.size() == 2 && mesh.twin(sides[0]) != no_index &&
      mesh.twin(sides[1]) != no_index)
    throw Error(names.vertex(vertex) +
                " lies between two triangles and nothing else, which are the same from two sides: leave one out");
}

/// Three sides that it shares with one other triangle: Loop's rule has no limit for what is the same from two sides.
void require_not_doubled(const LevelMesh& mesh, Index face, const CageNames& names) {
  Index other = no_index;
  for (Index side = mesh.first_side[face]; side < mesh.first_side[face + 1]; ++side) {
    const Index twin = mesh.twin(side);
    if (twin == no_index || (other != no_index && mesh.face_of_side[twin] != other)) return;
    other = mesh.face_of_side[twin];
  }
  throw Error(fmt::format("{} and {} are one triangle from two sides: leave one out", names.face(std::min(face, other)),
                          names.face(std::max(face, other))));
}

void require_sharpness(double sharpness, const std::string& what) {
  if (!(sharpness >= 0)) throw Error("the sharpness of " + what + " must be at least 0; infinite is sharp for ever");
}

void require_features(const LevelMesh& mesh, const CageFeatures& features, const CageNames& names) {
  for (const CageCrease& crease : features.creases) {
    const bool are_vertices = crease.first < mesh.points.size() && crease.second < mesh.points.size();
    if (!are_vertices)
      throw Error(
          fmt::format("a crease names the edge {}–{}, which is no edge of the cage: it has {} vertices, "
                      "counted from 0",
                      crease.first, crease.second, mesh.points.size()));
    const std::string edge = names.edge(crease.first, crease.second);
    if (mesh.edge_between(crease.first, crease.second) == no_index)
      throw Error(fmt::format("a crease names {} which is no edge of the cage", edge));
    require_sharpness(crease.sharpness, edge);
  }
  for (const CageCorner& corner : features.corners) {
    if (corner.vertex >= mesh.points.size())
      throw Error(fmt::format("a corner names vertex {}, but the cage has {} vertices, counted from 0", corner.vertex,
                              mesh.points.size()));
    require_sharpness(corner.sharpness, names.vertex(corner.vertex));
  }
}

}  // namespace

std::string CageNames::vertex(Index v) const {
  if (vertices.empty()) return fmt::format("vertex {} of the cage, at {},", v, place_text(points[v]));
  return fmt::format("vertex {} of the mesh (from 0), at {},", vertices[v], place_text(points[v]));
}

std::string CageNames::face(Index f) const {
  if (faces.empty()) return fmt::format("face {} of the cage", f);
  return fmt::format("face {} of the mesh (from 0)", faces[f]);
}

std::string CageNames::edge(Index a, Index b) const {
  const auto number = [&](Index v) { return vertices.empty() ? v : vertices[v]; };
  return fmt::format("the edge {}–{}, from {} to {},", number(a), number(b), place_text(points[a]),
                     place_text(points[b]));
}

LevelMesh checked_level(const PolygonMesh& polygons, SubdivisionScheme scheme, const CageFeatures& features,
                        const CageNames& names) {
  require_cage_vertices(polygons, names);
  require_cage_faces(polygons, scheme, names);
  LevelMesh mesh;
  mesh.points = polygons.vertices;
  mesh.corners = polygons.corners;
  mesh.first_side = polygons.first;
  mesh.connect();
  for (Index v = 0; v < mesh.points.size(); ++v) require_surface_at(mesh, v, names);
  for (Index v = 0; v < mesh.points.size(); ++v) require_cage_vertex(mesh, v, scheme, names);
  if (scheme == SubdivisionScheme::loop)
    for (Index f = 0; f < mesh.face_count(); ++f) require_not_doubled(mesh, f, names);
  require_features(mesh, features, names);
  return mesh;
}

}  // namespace toccata
