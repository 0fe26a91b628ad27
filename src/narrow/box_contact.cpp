#include "narrow/box_contact.hpp"

#include <cmath>

#include "narrow/plain_topology.hpp"

namespace toccata {
namespace {

constexpr double cosine_of_face_contact = 0.9995;

int next(int i) { return i == 2 ? 0 : i + 1; }

struct FacingFace {
  int axis = 0;
  double cosine = 0;  ///< of the outward normal and the direction, which it is nearest to
  bool low = false;   ///< the face where the axis begins
  [[nodiscard]] Index number() const { return static_cast<Index>(2 * axis + (low ? 0 : 1)); }
};

FacingFace facing_face(const BoxView& box, const Vec3& direction) {
  FacingFace best;
  for (int i = 0; i < 3; ++i) {
    const double along = dot(box.axes->column(i), direction);
    if (std::fabs(along) > best.cosine) best = {i, std::fabs(along), along < 0};
  }
  return best;
}

/// A corner of the incident face or of what is left of it, and the side that leaves it: an edge of the incident face,
/// or the side of the reference face that cut it.
struct Corner {
  double x, y, gap;
  bool of_reference;
  Index half_edge;
};

class Polygon {
 public:
  void append(const Corner& corner) { corners_[count_++] = corner; }
  [[nodiscard]] std::size_t size() const { return count_; }
  [[nodiscard]] const Corner& operator[](std::size_t i) const { return corners_[i]; }

 private:
  std::array<Corner, 12> corners_;
  std::size_t count_ = 0;
};

Corner between(const Corner& p, double height_p, const Corner& q, double height_q, bool of_reference, Index half_edge) {
  const double share = height_p / (height_p - height_q);
  return {p.x + share * (q.x - p.x), p.y + share * (q.y - p.y), p.gap + share * (q.gap - p.gap), of_reference,
          half_edge};
}

/// What lies beyond a side of the reference face, at sign · coordinate = limit, is taken off.
template <double Corner::*coordinate>
void clip(Polygon& polygon, double sign, double limit, Index half_edge) {
  std::array<double, 12> height;
  double highest = -1;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    height[i] = sign * (polygon[i].*coordinate) - limit;
    if (height[i] > highest) highest = height[i];
  }
  if (!(highest > 0)) return;
  Polygon result;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const std::size_t j = i + 1 == polygon.size() ? 0 : i + 1;
    const Corner& corner = polygon[i];
    // A corner on the side, with the next beyond, is left along the side.
    if (height[i] < 0 || (height[i] == 0 && height[j] <= 0)) result.append(corner);
    if (height[i] == 0 && height[j] > 0) result.append({corner.x, corner.y, corner.gap, true, half_edge});
    if (height[i] < 0 && height[j] > 0)
      result.append(between(corner, height[i], polygon[j], height[j], true, half_edge));
    if (height[i] > 0 && height[j] < 0)
      result.append(between(corner, height[i], polygon[j], height[j], corner.of_reference, corner.half_edge));
  }
  polygon = result;
}

class FaceContact {
 public:
  FaceContact(const BoxView& reference, const FacingFace& reference_face, const BoxView& incident,
              const FacingFace& incident_face, const Vec3& outwards)
      : reference_(reference),
        reference_face_(reference_face),
        incident_(incident),
        incident_face_(incident_face),
        outwards_(outwards),
        across_(reference_face.axis),
        x_(next(across_)),
        y_(next(x_)) {}

  BoxContact contact();

 private:
  [[nodiscard]] Polygon incident_polygon() const;
  [[nodiscard]] BoxContactPoint point(const Corner& corner, const Corner& before) const;

  const BoxView& reference_;
  const FacingFace& reference_face_;
  const BoxView& incident_;
  const FacingFace& incident_face_;
  const Vec3& outwards_;
  int across_, x_, y_;
  HullTopology topology_ = box_topology();
};

/// The corners of the incident face, moved along the normal into the plane of the reference face.
Polygon FaceContact::incident_polygon() const {
  const double up = reference_face_.low ? -1 : 1;
  const Vec3 n = up * reference_.axes->column(across_), e = reference_.axes->column(x_),
             f = reference_.axes->column(y_);
  const Vec3 way = incident_.box->centre - reference_.box->centre;
  const double steepness = 1 / dot(n, outwards_), lean_x = dot(e, outwards_), lean_y = dot(f, outwards_);
  const auto seen = [&](const Vec3& v) {
    const double gap = dot(n, v) * steepness;
    return Vec3{dot(e, v) - gap * lean_x, dot(f, v) - gap * lean_y, gap};
  };
  const Vec3& g = incident_.box->half_extents;
  const Vec3 centre = seen(way);
  const std::array<Vec3, 3> halves{g.x * seen(incident_.axes->column(0)), g.y * seen(incident_.axes->column(1)),
                                   g.z * seen(incident_.axes->column(2))};
  const double top = reference_.box->half_extents[across_] * steepness;
  Polygon polygon;
  const Index first = 4 * incident_face_.number();
  for (Index h = first; h < first + 4; ++h) {
    const Index corner = topology_.origin[h];
    Vec3 at = centre;
    for (Index i = 0; i < 3; ++i) at = (corner >> i & 1U) != 0 ? at + halves[i] : at - halves[i];
    // The reference face lies above the centre by a half edge, which leans as the normal does not.
    polygon.append({at.x + top * lean_x, at.y + top * lean_y, at.z - top, false, h});
  }
  return polygon;
}

/// The features between the side that comes in and the one that leaves.
BoxContactPoint FaceContact::point(const Corner& corner, const Corner& before) const {
  using Kind = ConvexFeature::Kind;
  const auto edge_number = [&](Index h) { return h < topology_.twin[h] ? h : topology_.twin[h]; };
  BoxContactPoint point{
      corner.x, corner.y, corner.gap, {Kind::face, reference_face_.number()}, {Kind::face, incident_face_.number()}};
  if (!before.of_reference && !corner.of_reference) {
    point.on_incident = {Kind::vertex, topology_.origin[corner.half_edge]};
  } else if (before.of_reference && corner.of_reference) {
    const bool follows = topology_.next(before.half_edge) == corner.half_edge;
    point.on_reference = {Kind::vertex, topology_.origin[follows ? corner.half_edge : before.half_edge]};
  } else {
    const Corner &side = before.of_reference ? before : corner, &edge = before.of_reference ? corner : before;
    point.on_reference = {Kind::edge, edge_number(side.half_edge)};
    point.on_incident = {Kind::edge, edge_number(edge.half_edge)};
  }
  return point;
}

bool are_the_same(const BoxContactPoint& p, const BoxContactPoint& q) {
  return (p.x == q.x && p.y == q.y && p.gap == q.gap) ||
         (p.on_reference == q.on_reference && p.on_incident == q.on_incident);
}

BoxContact FaceContact::contact() {
  Polygon polygon = incident_polygon();
  const Vec3& h = reference_.box->half_extents;
  const Index first = 4 * reference_face_.number();
  for (Index side = first; side < first + 4; ++side) {
    // Both ends of a side have the bit of one of the other two axes in common.
    const Index from = topology_.origin[side], to = topology_.origin[side + 1 < first + 4 ? side + 1 : first];
    const int axis = (from ^ to) == 1U << x_ ? y_ : x_;
    const double sign = (from >> axis & 1U) != 0 ? 1 : -1;
    if (axis == x_)
      clip<&Corner::x>(polygon, sign, h[axis], side);
    else
      clip<&Corner::y>(polygon, sign, h[axis], side);
  }
  BoxContact result;
  result.axis = {x_, y_, across_};
  result.middle =
      reference_.box->centre + ((reference_face_.low ? -1 : 1) * h[across_]) * reference_.axes->column(across_);
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const BoxContactPoint p = point(polygon[i], polygon[i == 0 ? polygon.size() - 1 : i - 1]);
    bool is_new = result.count < result.points.size();
    for (std::size_t k = 0; k < result.count && is_new; ++k) is_new = !are_the_same(result.points[k], p);
    if (is_new) result.points[result.count++] = p;
  }
  return result;
}

}  // namespace

Vec3 BoxContact::position(const BoxContactPoint& p, const BoxView& reference, const Vec3& normal) const {
  const double half_gap = b_is_reference ? -0.5 * p.gap : 0.5 * p.gap;
  return (middle + (p.x * reference.axes->column(axis[0]) + p.y * reference.axes->column(axis[1]))) + half_gap * normal;
}

BoxContact contact_of_faces(const BoxView& a, const BoxView& b, const ChosenBoxAxis& along) {
  const FacingFace face_a = facing_face(a, along.direction), face_b = facing_face(b, -along.direction);
  const bool is_face_of_b = along.edge_a == 3;
  const bool b_is_reference = is_face_of_b || (along.edge_b != 3 && face_b.cosine > face_a.cosine);
  if ((b_is_reference ? face_b : face_a).cosine < cosine_of_face_contact) return {};
  BoxContact contact = b_is_reference ? FaceContact(b, face_b, a, face_a, -along.direction).contact()
                                      : FaceContact(a, face_a, b, face_b, along.direction).contact();
  contact.b_is_reference = b_is_reference;
  return contact;
}

}  // namespace toccata
