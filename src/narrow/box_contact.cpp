#include "narrow/box_contact.hpp"

#include <algorithm>
#include <cmath>

namespace toccata {
namespace {

constexpr double cosine_of_face_contact = 0.9995;

std::size_t next(std::size_t i) { return i == 2 ? 0 : i + 1; }

/// The face whose normal is nearest to the direction.
struct FacingFace {
  BoxFace face;
  double cosine = 0;
};

FacingFace facing_face(const BoxView& box, const Vec3& direction) {
  FacingFace best;
  for (std::size_t i = 0; i < 3; ++i) {
    const double along = dot(box.axis(i), direction);
    if (std::fabs(along) > best.cosine) best = {{i, along < 0}, std::fabs(along)};
  }
  return best;
}

/// The cosines of an edge pair's axis with the normals of faces are those of the edges over the sine of their angle.
bool turns_to_a_face(const RigidBoxAxes& axes, std::size_t i, std::size_t j) {
  const std::size_t k = next(i), l = next(k), m = next(j), n = next(m);
  const double of_a = std::max(std::fabs(axes.cosines[k][j]), std::fabs(axes.cosines[l][j]));
  const double of_b = std::max(std::fabs(axes.cosines[i][m]), std::fabs(axes.cosines[i][n]));
  const double greatest = std::max(of_a, of_b);
  return greatest * greatest >= cosine_of_face_contact * cosine_of_face_contact * axes.squared_sine(i, j);
}

BoxFacePair facing_of_edges(const BoxView& a, const BoxView& b, const Vec3& direction) {
  const FacingFace of_a = facing_face(a, direction), of_b = facing_face(b, -direction);
  if (of_b.cosine > of_a.cosine) return {of_b.face, of_a.face, true};
  return {of_a.face, of_b.face, false};
}

/// Of an edge of the reference box and one of the incident box.
double cosine(const RigidBoxAxes& axes, bool b_is_reference, std::size_t of_reference, std::size_t of_incident) {
  return axes.cosines[b_is_reference ? of_incident : of_reference][b_is_reference ? of_reference : of_incident];
}

/// The face of the other box that turns most against the chosen one.
BoxFacePair facing_of_face(const RigidBoxAxes& axes, const ChosenBoxAxis& along) {
  const bool b_is_reference = along.edge_b != 3;
  const std::size_t i = b_is_reference ? along.edge_b : along.edge_a;
  const bool low = b_is_reference ? axes.way_b[i] > 0 : axes.way_a[i] < 0;
  std::size_t most = 0;
  double greatest = -1, turn = 0;
  for (std::size_t j = 0; j < 3; ++j) {
    const double here = cosine(axes, b_is_reference, i, j);
    const bool is_greater = std::fabs(here) > greatest;
    most = is_greater ? j : most;
    turn = is_greater ? here : turn;
    greatest = is_greater ? std::fabs(here) : greatest;
  }
  return {{i, low}, {most, low ? turn < 0 : turn > 0}, b_is_reference};
}

/// In the frame of the reference face: x and y along its edges, z outwards.
SeenFace seen_from_reference(const BoxView& a, const BoxView& b, const RigidBoxAxes& axes, const BoxFacePair& faces) {
  const std::size_t z = faces.reference.axis, x = next(z), y = next(x);
  const double up = faces.reference.low ? -1 : 1, turn = faces.b_is_reference ? -1 : 1;
  const FourDoubles& way = faces.b_is_reference ? axes.way_b : axes.way_a;
  const BoxView &reference = faces.b_is_reference ? b : a, &incident = faces.b_is_reference ? a : b;
  const auto half_edge = [&](std::size_t j) {
    const auto along = [&](std::size_t i) { return cosine(axes, faces.b_is_reference, i, j); };
    return incident.half_extent(j) * Vec3{along(x), along(y), up * along(z)};
  };
  const std::size_t across = faces.incident.axis, first = next(across);
  const Vec3 middle{turn * way[x], turn * way[y], turn * up * way[z]};
  const Vec3 to_face = (faces.incident.low ? -1.0 : 1.0) * half_edge(across);
  return {middle + to_face, half_edge(first), half_edge(next(first)), reference.half_extent(x),
          reference.half_extent(y)};
}

/// Moves everything along the normal into the plane of the reference face: z becomes the way to go.
void lean(SeenFace& seen, const BoxView& reference, const BoxFace& face, const Vec3& outwards) {
  const std::size_t x = next(face.axis);
  const double up = face.low ? -1 : 1;
  const double steepness = 1 / (up * dot(reference.axis(face.axis), outwards));
  const double lean_x = dot(reference.axis(x), outwards), lean_y = dot(reference.axis(next(x)), outwards);
  for (Vec3* v : {&seen.centre, &seen.along_x, &seen.along_y}) {
    const double gap = v->z * steepness;
    *v = {v->x - gap * lean_x, v->y - gap * lean_y, gap};
  }
}

}  // namespace

BoxFacePlane::BoxFacePlane(const BoxView& box, const BoxFace& face)
    : along_x_(box.axis(next(face.axis))),
      along_y_(box.axis(next(next(face.axis)))),
      middle_(box.box->centre + ((face.low ? -1 : 1) * box.half_extent(face.axis)) * box.axis(face.axis)) {}

BoxContact contact_of_faces(const BoxView& a, const BoxView& b, const RigidBoxAxes& axes, const ChosenBoxAxis& along) {
  const bool of_edges = is_of_edges(along);
  if (of_edges && !turns_to_a_face(axes, along.edge_a, along.edge_b)) return {};
  const BoxFacePair faces = of_edges ? facing_of_edges(a, b, along.direction) : facing_of_face(axes, along);
  const BoxView& reference = faces.b_is_reference ? b : a;
  SeenFace seen = seen_from_reference(a, b, axes, faces);
  // The plane of the face, not of the middle.
  seen.centre.z -= reference.half_extent(faces.reference.axis);
  if (of_edges) lean(seen, reference, faces.reference, faces.b_is_reference ? -along.direction : along.direction);
  return {faces, overlay_of(seen)};
}

}  // namespace toccata
