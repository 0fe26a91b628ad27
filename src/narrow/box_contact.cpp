#include "narrow/box_contact.hpp"

#include <cmath>
#include <utility>

namespace toccata {
namespace {

constexpr double cosine_of_face_contact = 0.9995;

constexpr int next(int i) { return i == 2 ? 0 : i + 1; }
std::size_t index(int i) { return static_cast<std::size_t>(i); }

/// The corners and the sides of each face, in the order of box_topology(): side k leaves corner k.
constexpr std::array<std::array<std::uint8_t, 4>, 6> corners_of_face = {
    {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}}};

/// The face whose normal is nearest to the direction.
struct FacingFace {
  BoxFace face;
  double cosine = 0;
};

FacingFace facing_face(const BoxView& box, const Vec3& direction) {
  FacingFace best;
  for (int i = 0; i < 3; ++i) {
    const double along = dot(box.axes->column(i), direction);
    if (std::fabs(along) > best.cosine) best = {{i, along < 0}, std::fabs(along)};
  }
  return best;
}

/// The face of the other box that turns most against a face: `cosine(j)` is between the normal and the other's edge j.
template <class Cosine>
BoxFace face_against(const Cosine& cosine) {
  int best = 0;
  for (int j = 1; j < 3; ++j)
    if (std::fabs(cosine(j)) > std::fabs(cosine(best))) best = j;
  return {best, cosine(best) > 0};
}

struct Facing {
  BoxFacePair faces;
  double cosine;  ///< between the reference face's normal and the direction
};

Facing facing_of_edges(const BoxView& a, const BoxView& b, const Vec3& direction) {
  const FacingFace of_a = facing_face(a, direction), of_b = facing_face(b, -direction);
  if (of_b.cosine > of_a.cosine) return {{of_b.face, of_a.face, true}, of_b.cosine};
  return {{of_a.face, of_b.face, false}, of_a.cosine};
}

BoxFacePair facing_of_face(const RigidBoxAxes& axes, const ChosenBoxAxis& along) {
  if (along.edge_b == 3) {
    const std::size_t i = index(along.edge_a);
    const bool low = axes.way_a[i] < 0;
    return {{along.edge_a, low},
            face_against([&](int j) { return low ? -axes.cosines[i][index(j)] : axes.cosines[i][index(j)]; }),
            false};
  }
  const std::size_t j = index(along.edge_b);
  const bool low = axes.way_b[j] > 0;
  return {{along.edge_b, low},
          face_against([&](int i) { return low ? -axes.cosines[index(i)][j] : axes.cosines[index(i)][j]; }),
          true};
}

/// The incident box in the frame of the reference face: x and y along its edges, z outwards.
struct SeenBox {
  Vec3 centre;
  std::array<Vec3, 3> half;
};

SeenBox seen_from_reference(const BoxView& a, const BoxView& b, const RigidBoxAxes& axes, const BoxFacePair& faces) {
  const int z = faces.reference.axis, x = next(z), y = next(x);
  const double up = faces.reference.low ? -1 : 1;
  const auto& way = faces.b_is_reference ? axes.way_b : axes.way_a;
  const double turn = faces.b_is_reference ? -1 : 1;
  SeenBox seen{{turn * way[index(x)], turn * way[index(y)], turn * up * way[index(z)]}, {}};
  const Vec3& half = (faces.b_is_reference ? a : b).box->half_extents;
  for (int j = 0; j < 3; ++j) {
    const auto cosine = [&](int i) {
      return faces.b_is_reference ? axes.cosines[index(j)][index(i)] : axes.cosines[index(i)][index(j)];
    };
    seen.half[index(j)] = half[j] * Vec3{cosine(x), cosine(y), up * cosine(z)};
  }
  return seen;
}

/// Moves everything along the normal into the plane through the middle of the box: z becomes the way to go.
void lean(SeenBox& seen, const BoxView& reference, const BoxFace& face, const Vec3& outwards) {
  const int x = next(face.axis);
  const double up = face.low ? -1 : 1;
  const double steepness = 1 / (up * dot(reference.axes->column(face.axis), outwards));
  const double lean_x = dot(reference.axes->column(x), outwards),
               lean_y = dot(reference.axes->column(next(x)), outwards);
  const auto moved = [&](const Vec3& v) {
    const double gap = v.z * steepness;
    return Vec3{v.x - gap * lean_x, v.y - gap * lean_y, gap};
  };
  // The plane of the face, not of the middle.
  seen.centre = moved(seen.centre - Vec3{0, 0, reference.box->half_extents[face.axis]});
  for (Vec3& half : seen.half) half = moved(half);
}

/// Corners in one of two places, clipped to and fro.
class Polygon {
 public:
  void append(const BoxContactCorner& corner) {
    if (count_ < BoxContact::capacity) corners_[count_++] = corner;
  }
  void clear() { count_ = 0; }
  [[nodiscard]] std::size_t size() const { return count_; }
  [[nodiscard]] const BoxContactCorner& operator[](std::size_t i) const { return corners_[i]; }

 private:
  std::array<BoxContactCorner, BoxContact::capacity> corners_;
  std::size_t count_ = 0;
};

BoxContactCorner between(const BoxContactCorner& p, double height_p, const BoxContactCorner& q, double height_q,
                         std::uint8_t side) {
  const double share = height_p / (height_p - height_q);
  return {p.x + share * (q.x - p.x), p.y + share * (q.y - p.y), p.gap + share * (q.gap - p.gap), side};
}

/// What lies beyond a side of the reference face, at sign · coordinate = limit, is taken off; false if nothing does.
template <double BoxContactCorner::*coordinate>
bool clip(const Polygon& polygon, Polygon& result, double sign, double limit, std::uint8_t side) {
  std::array<double, BoxContact::capacity> height;
  double highest = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    height[i] = sign * (polygon[i].*coordinate) - limit;
    highest = height[i] > highest ? height[i] : highest;
  }
  if (!(highest > 0)) return false;
  result.clear();
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const std::size_t j = i + 1 == polygon.size() ? 0 : i + 1;
    const BoxContactCorner& corner = polygon[i];
    if (height[i] <= 0) {
      result.append(corner);
      // A corner on the side, with the next beyond, is left along the side.
      if (height[j] > 0 && height[i] == 0) {
        BoxContactCorner left = corner;
        left.side = side;
        result.append(left);
      }
    }
    if (height[i] < 0 && height[j] > 0) result.append(between(corner, height[i], polygon[j], height[j], side));
    if (height[i] > 0 && height[j] < 0) result.append(between(corner, height[i], polygon[j], height[j], corner.side));
  }
  return true;
}

Polygon incident_face(const SeenBox& seen, const BoxFace& face) {
  Polygon polygon;
  const auto& corners = corners_of_face[face.number()];
  for (std::size_t k = 0; k < 4; ++k) {
    Vec3 at = seen.centre;
    for (std::size_t i = 0; i < 3; ++i) at = (corners[k] >> i & 1U) != 0 ? at + seen.half[i] : at - seen.half[i];
    polygon.append({at.x, at.y, at.z, static_cast<std::uint8_t>(4 * face.number() + k)});
  }
  return polygon;
}

/// Takes off what does not lie over the reference face.
const Polygon& clipped(Polygon& polygon, Polygon& other, const BoxFace& reference, const Vec3& half_extents) {
  Polygon *now = &polygon, *then = &other;
  const auto& corners = corners_of_face[reference.number()];
  const int x = next(reference.axis), y = next(x);
  for (std::size_t k = 0; k < 4; ++k) {
    // Both ends of a side have the bit of one of the other two axes in common.
    const unsigned from = corners[k], to = corners[(k + 1) % 4];
    const int axis = (from ^ to) == 1U << x ? y : x;
    const double sign = (from >> axis & 1U) != 0 ? 1 : -1;
    const auto side = static_cast<std::uint8_t>(BoxContactCorner::of_reference + 4 * reference.number() + k);
    const bool is_cut = axis == x ? clip<&BoxContactCorner::x>(*now, *then, sign, half_extents[axis], side)
                                  : clip<&BoxContactCorner::y>(*now, *then, sign, half_extents[axis], side);
    if (is_cut) std::swap(now, then);
  }
  return *now;
}

}  // namespace

BoxFacePlane::BoxFacePlane(const BoxView& box, const BoxFace& face)
    : along_x_(box.axes->column(next(face.axis))),
      along_y_(box.axes->column(next(next(face.axis)))),
      middle_(box.box->centre +
              ((face.low ? -1 : 1) * box.box->half_extents[face.axis]) * box.axes->column(face.axis)) {}

BoxContact contact_of_faces(const BoxView& a, const BoxView& b, const RigidBoxAxes& axes, const ChosenBoxAxis& along) {
  BoxContact contact;
  const bool is_of_edges = along.edge_a != 3 && along.edge_b != 3;
  if (is_of_edges) {
    const Facing facing = facing_of_edges(a, b, along.direction);
    if (facing.cosine < cosine_of_face_contact) return contact;
    contact.faces = facing.faces;
  } else {
    contact.faces = facing_of_face(axes, along);
  }
  const BoxView& reference = contact.faces.b_is_reference ? b : a;
  const BoxFace& face = contact.faces.reference;
  SeenBox seen = seen_from_reference(a, b, axes, contact.faces);
  if (is_of_edges)
    lean(seen, reference, face, contact.faces.b_is_reference ? -along.direction : along.direction);
  else
    seen.centre.z -= reference.box->half_extents[face.axis];
  Polygon polygon = incident_face(seen, contact.faces.incident), other;
  for (const Polygon& result = clipped(polygon, other, face, reference.box->half_extents);
       contact.count < result.size(); ++contact.count)
    contact.corners[contact.count] = result[contact.count];
  return contact;
}

}  // namespace toccata
