#include "narrow/boxes/box_contact.hpp"

#include <algorithm>
#include <cmath>

#include "narrow/boxes/next_axis.hpp"
#include "narrow/convex/contact_choices.hpp"

namespace toccata {
namespace {

// Which face it is cannot be guessed: it is looked up and not asked for.
constexpr std::array<double, 2> sign_of_low = {1, -1};  // of what is not low, or turned; of what is

double sign(bool is_negative) { return sign_of_low[is_negative ? 1 : 0]; }

/// What the table of axes says, seen from the box of the reference face.
struct SeenAxes {
  const FourDoubles* cosines;  ///< [edge of the reference box][edge of the incident box]
  const FourDoubles& way;      ///< from A to B
};

SeenAxes seen_axes(const RigidBoxAxes& axes, bool b_is_reference) {
  return {b_is_reference ? axes.turned_cosines.data() : axes.cosines.data(), b_is_reference ? axes.way_b : axes.way_a};
}

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
  const std::size_t k = next_axis(i), l = next_axis(k), m = next_axis(j), n = next_axis(m);
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

std::size_t place_of_greatest(double x, double y, double z) {
  const std::size_t of_two = y > x ? 1 : 0;
  return z > (y > x ? y : x) ? 2 : of_two;
}

/// The face of the other box that turns most against the chosen one.
BoxFacePair facing_of_face(const RigidBoxAxes& axes, const ChosenBoxAxis& along) {
  const bool b_is_reference = along.edge_b != 3;
  const std::size_t i = b_is_reference ? along.edge_b : along.edge_a;
  const SeenAxes seen = seen_axes(axes, b_is_reference);
  const bool low = std::signbit(sign(b_is_reference) * seen.way[i]);  // as the direction, where both are 0 too
  const FourDoubles& cosines = seen.cosines[i];
  const std::size_t most = place_of_greatest(std::fabs(cosines[0]), std::fabs(cosines[1]), std::fabs(cosines[2]));
  return {{i, low}, {most, sign(low) * cosines[most] > 0}, b_is_reference};
}

/// In the frame of the reference face: x and y along its edges, z outwards.
SeenFace seen_from_reference(const BoxView& reference, const BoxView& incident, const RigidBoxAxes& axes,
                             const BoxFacePair& faces) {
  const std::size_t z = faces.reference.axis, x = next_axis(z), y = next_axis(x);
  const double up = sign(faces.reference.low), turn = sign(faces.b_is_reference);
  const SeenAxes seen = seen_axes(axes, faces.b_is_reference);
  const auto half_edge = [&](std::size_t j) {
    return incident.half_extent(j) * Vec3{seen.cosines[x][j], seen.cosines[y][j], up * seen.cosines[z][j]};
  };
  const std::size_t across = faces.incident.axis, first = next_axis(across);
  const Vec3 middle{turn * seen.way[x], turn * seen.way[y], turn * up * seen.way[z]};
  return {middle + sign(faces.incident.low) * half_edge(across), half_edge(first), half_edge(next_axis(first)),
          reference.half_extent(x), reference.half_extent(y)};
}

/// Moves everything along the normal into the plane of the reference face: z becomes the way to go.
void lean(SeenFace& seen, const BoxView& reference, const BoxFace& face, const Vec3& outwards) {
  const std::size_t x = next_axis(face.axis);
  const double up = sign(face.low);
  const double steepness = 1 / (up * dot(reference.axis(face.axis), outwards));
  const double lean_x = dot(reference.axis(x), outwards), lean_y = dot(reference.axis(next_axis(x)), outwards);
  for (Vec3* v : {&seen.centre, &seen.along_x, &seen.along_y}) {
    const double gap = v->z * steepness;
    *v = {v->x - gap * lean_x, v->y - gap * lean_y, gap};
  }
}

}  // namespace

BoxFacePlane::BoxFacePlane(const BoxView& box, const BoxFace& face)
    : along_x_(box.axis(next_axis(face.axis))),
      along_y_(box.axis(next_axis(next_axis(face.axis)))),
      middle_(box.box->centre + (sign(face.low) * box.half_extent(face.axis)) * box.axis(face.axis)) {}

BoxContact contact_of_faces(const BoxView& a, const BoxView& b, const RigidBoxAxes& axes, const ChosenBoxAxis& along) {
  const bool of_edges = is_of_edges(along);
  if (of_edges && !turns_to_a_face(axes, along.edge_a, along.edge_b)) return {};
  const BoxFacePair faces = of_edges ? facing_of_edges(a, b, along.direction) : facing_of_face(axes, along);
  const BoxView &reference = faces.b_is_reference ? b : a, &incident = faces.b_is_reference ? a : b;
  SeenFace seen = seen_from_reference(reference, incident, axes, faces);
  // The plane of the face, not of the middle.
  seen.centre.z -= reference.half_extent(faces.reference.axis);
  if (of_edges) lean(seen, reference, faces.reference, faces.b_is_reference ? -along.direction : along.direction);
  return {faces, overlay_of(seen)};
}

}  // namespace toccata
