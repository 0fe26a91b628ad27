#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>

#include "math/constants.hpp"
#include "math/vec3_measures.hpp"
#include "narrow/boxes/box_axes.hpp"
#include "narrow/boxes/box_manifold.hpp"
#include "narrow/contact/manifold_along.hpp"
#include "narrow/convex/aligned_cores.hpp"
#include "narrow/convex/canonical_order.hpp"
#include "narrow/convex/contact_choices.hpp"
#include "narrow/convex/convex_separation.hpp"
#include "narrow/convex/face_clipping.hpp"
#include "narrow/convex/plain_scale.hpp"
#include "narrow/primitives/pair_depths.hpp"

// Where shapes meet with a face, the contact is a region: the incident face as far as it lies over the reference face.
// The reference face is the one that turns most to the other shape, at most about two degrees beside the direction in
// which the shapes are parted; the incident one is the other shape's. Everything else is a single point.
namespace toccata {
namespace {

using ManifoldPoints = std::pmr::vector<ManifoldPoint>;

/// A point on each face's plane, as near to the contact as one is known: a plane is as rough as its normal far from it.
struct Anchors {
  Vec3 on_a;
  Vec3 on_b;
};

/// The two faces, and which of them is the reference.
struct FacePair {
  ContactFace a;
  ContactFace b;
  Anchors anchors;
  bool b_is_reference;
  [[nodiscard]] const ContactFace& reference() const { return b_is_reference ? b : a; }
  [[nodiscard]] const ContactFace& incident() const { return b_is_reference ? a : b; }
};

Index farthest_corner(const PosedPolytope& box, const Vec3& direction) {
  Index corner = 0;
  for (const Index bit : {1U, 2U, 4U})
    if (dot(box.vertex(bit) - box.vertex(0), direction) > 0) corner |= bit;
  return corner;
}

bool is_segment(const ContactFace& face) { return face.face != ContactFace::none && face.last() - face.first() == 2; }

Vec3 unit_along(const ContactFace& segment) {
  const HullTopology topology = segment.shape->topology();
  const Vec3 along =
      segment.shape->vertex(topology.target(segment.first())) - segment.shape->vertex(topology.origin[segment.first()]);
  return (1 / std::sqrt(dot(along, along))) * along;
}

/// Two cores that are parallel segments, as those of two lying capsules: the normal takes the place of a face's.
void make_face_of_parallel_segments(FacePair& faces, const Vec3& normal) {
  if (!is_segment(faces.a) || !is_segment(faces.b)) return;
  const Vec3 along_a = unit_along(faces.a), along_b = unit_along(faces.b);
  if (!(std::fabs(dot(along_a, along_b)) >= cosine_of_face_contact)) return;
  if (!(std::fabs(dot(along_a, normal)) <= 0.01)) return;
  faces.a.normal = normal;
  faces.a.facing = 1;
}

ManifoldPoint single_point(const PosedPolytope& a, const PosedPolytope& b, const ConvexSeparation& separation) {
  const Penetration& p = separation.penetration;
  return {p.on_a + 0.5 * (p.on_b - p.on_a), dot(p.on_a - p.on_b, p.direction),
          feature_of(a, separation.pairs.a, separation.pairs.size),
          feature_of(b, separation.pairs.b, separation.pairs.size)};
}

/// The features of a polygon's corner, between the side that comes in and the one that leaves.
struct CornerFeatures {
  ConvexFeature on_reference;
  ConvexFeature on_incident;
};

CornerFeatures features_of(const FacePair& faces, const PolygonSide& in, const PolygonSide& out) {
  using Kind = ConvexFeature::Kind;
  const HullTopology reference = faces.reference().shape->topology(), incident = faces.incident().shape->topology();
  if (faces.incident().face == ContactFace::none)
    return {{Kind::face, faces.reference().face}, {Kind::vertex, faces.incident().vertex}};
  if (!in.of_reference && !out.of_reference)
    return {{Kind::face, faces.reference().face}, {Kind::vertex, incident.origin[out.half_edge]}};
  // Planes across the ends of a segment.
  if (is_segment(faces.reference()))
    return {{Kind::vertex, reference.target((in.of_reference ? in : out).half_edge)},
            {Kind::edge, edge_number(incident, (in.of_reference ? out : in).half_edge)}};
  if (in.of_reference && out.of_reference) {
    const bool follows = reference.next(in.half_edge) == out.half_edge;
    return {{Kind::vertex, reference.origin[follows ? out.half_edge : in.half_edge]},
            {Kind::face, faces.incident().face}};
  }
  const PolygonSide &side = in.of_reference ? in : out, &edge = in.of_reference ? out : in;
  return {{Kind::edge, edge_number(reference, side.half_edge)}, {Kind::edge, edge_number(incident, edge.half_edge)}};
}

/// A point of the incident face, seen along the normal against the reference face.
ManifoldPoint point_over_face(const FacePair& faces, const Vec3& normal, const Vec3& position) {
  const ContactFace& reference = faces.reference();
  const Vec3& origin = faces.b_is_reference ? faces.anchors.on_b : faces.anchors.on_a;
  const double gap = dot(reference.normal, position - origin) / std::fabs(dot(reference.normal, normal));
  const double radius_a = faces.a.shape->radius(), radius_b = faces.b.shape->radius();
  // Half way from the reference surface to the incident one, along the normal.
  const double back = faces.b_is_reference ? 0.5 * ((gap + radius_a) - radius_b) : 0.5 * ((radius_a - radius_b) - gap);
  return {position + back * normal, (radius_a + radius_b) - gap, {}, {}};
}

/// A point of the incident segment against the reference segment, which passes it to the side: the cores' surfaces
/// there overlap along the normal by as much as the way on which two circles come to touch. Nothing where they pass
/// each other.
std::optional<ManifoldPoint> point_beside_segment(const FacePair& faces, const Vec3& normal, const Vec3& position) {
  const PosedPolytope& reference = *faces.reference().shape;
  const HullTopology topology = reference.topology();
  const Index half_edge = faces.reference().first();
  const Vec3 from = reference.vertex(topology.origin[half_edge]), along = unit_along(faces.reference());
  const double length = dot(reference.vertex(topology.target(half_edge)) - from, along);
  const Vec3 on_reference = from + std::clamp(dot(position - from, along), 0.0, length) * along;
  const Vec3 &on_a = faces.b_is_reference ? position : on_reference,
             &on_b = faces.b_is_reference ? on_reference : position;
  const Vec3 way = on_b - on_a;
  const double gap = dot(way, normal), reach = faces.a.shape->radius() + faces.b.shape->radius();
  const Vec3 aside = way - gap * normal;
  const double left = reach * reach - dot(aside, aside);
  if (!(left >= 0 || plain_length(aside) <= 0x1p-40 * length)) return {};
  const double depth = std::sqrt(std::max(left, 0.0)) - gap;
  // The point of A at which the two touch once B has gone so far, and from there half the way back to B's.
  const double share = reach > 0 ? faces.a.shape->radius() / reach : 0.5;
  return ManifoldPoint{on_a + share * (way + depth * normal) - 0.5 * depth * normal, depth, {}, {}};
}

std::optional<ManifoldPoint> point_of_contact(const FacePair& faces, const Vec3& normal, const Vec3& position) {
  if (is_segment(faces.reference())) return point_beside_segment(faces, normal, position);
  return point_over_face(faces, normal, position);
}

bool are_the_same(const ManifoldPoint& p, const ManifoldPoint& q) {
  return p.position == q.position || (p.on_a == q.on_a && p.on_b == q.on_b);
}

/// In place of the one that is the same, if there is one.
void put(ManifoldPoints& points, const ManifoldPoint& point) {
  const auto same =
      std::find_if(points.begin(), points.end(), [&](const ManifoldPoint& p) { return are_the_same(p, point); });
  if (same == points.end())
    points.push_back(point);
  else
    *same = point;
}

ManifoldPoints face_points(const FacePair& faces, const Vec3& normal, std::pmr::memory_resource& memory) {
  const Vec3 outwards = faces.b_is_reference ? -normal : normal;
  const ContactPolygon polygon = clipped_incident(faces.reference(), faces.incident(), outwards, memory);
  ManifoldPoints points(&memory);
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const PolygonSide& in = polygon[(i + polygon.size() - 1) % polygon.size()].side;
    const CornerFeatures features = features_of(faces, in, polygon[i].side);
    std::optional<ManifoldPoint> point = point_of_contact(faces, normal, polygon[i].position);
    if (!point) continue;
    point->on_a = faces.b_is_reference ? features.on_incident : features.on_reference;
    point->on_b = faces.b_is_reference ? features.on_reference : features.on_incident;
    if (std::none_of(points.begin(), points.end(), [&](const ManifoldPoint& p) { return are_the_same(p, *point); }))
      points.push_back(*point);
  }
  return points;
}

double greatest_span_squared(const ManifoldPoints& points) {
  double span = 0;
  for (const ManifoldPoint& p : points) {
    const Vec3 way = p.position - points.front().position;
    span = std::max(span, dot(way, way));
  }
  return span;
}

void drop_gaps(ManifoldPoints& points) {
  if (points.empty()) return;
  const double gap = gap_of_resting * std::sqrt(greatest_span_squared(points));
  std::erase_if(points, [&](const ManifoldPoint& p) { return p.depth < -gap; });
}

/// The deepest, the farthest from it, and the farthest to both sides of the line through these.
void take_four(Manifold& result, ManifoldPoints& points) {
  const auto take_greatest = [&](const auto& measure) {
    const auto less = [&](const ManifoldPoint& p, const ManifoldPoint& q) { return measure(p) < measure(q); };
    const auto best = std::max_element(points.begin(), points.end(), less);
    result.points[static_cast<std::size_t>(result.count++)] = *best;
    points.erase(best);
  };
  take_greatest([](const ManifoldPoint& p) { return p.depth; });
  if (points.empty()) return;
  const Vec3 origin = result.points[0].position;
  take_greatest([&](const ManifoldPoint& p) { return dot(p.position - origin, p.position - origin); });
  if (points.empty()) return;
  const Vec3 aside = cross(result.normal, result.points[1].position - origin);
  take_greatest([&](const ManifoldPoint& p) { return dot(aside, p.position - origin); });
  if (points.empty()) return;
  const double third = dot(aside, result.points[2].position - origin);
  // To the other side of the line, or beyond the third.
  take_greatest([&](const ManifoldPoint& p) { return (third > 0 ? -1 : 1) * dot(aside, p.position - origin); });
}

/// Of a face so narrow for its length the plane is rough, and where its sides meet.
bool is_sliver(const ContactFace& face) {
  if (face.face == ContactFace::none || is_segment(face)) return false;
  const HullTopology topology = face.shape->topology();
  const Vec3 first = face.shape->vertex(topology.origin[face.first()]);
  double longest = 0;
  for (Index h = face.first() + 1; h < face.last(); ++h) {
    const Vec3 way = face.shape->vertex(topology.origin[h]) - first;
    longest = std::max(longest, dot(way, way));
  }
  return face.area <= 0x1p-12 * longest;
}

/// Whether it is on both shapes, grown by half its depth.
bool lies_between(const ManifoldPoint& point, const PosedPolytope& a, const PosedPolytope& b) {
  const PosedPolytope at(Point(point.position));
  const auto is_near = [&](const PosedPolytope& shape) {
    const Distance apart = distance(at, shape);
    return apart.lower <= 0.5 * std::fabs(point.depth) + 0x1p-46 * largest_magnitude(point.position);
  };
  return is_near(a) && is_near(b);
}

/// The points of the contact of two faces; none when the normal is not that of a face. Along it the shapes overlap by
/// no more than `most`, whatever the rough plane of a needle's face makes of it.
ManifoldPoints points_of_faces(const PosedPolytope& a, const PosedPolytope& b, const Vec3& normal, double most,
                               const std::optional<Anchors>& anchors, std::pmr::memory_resource& memory) {
  FacePair faces{facing_face(a, normal), facing_face(b, -normal), {}, false};
  faces.anchors = anchors ? *anchors : Anchors{a.vertex(faces.a.vertex), b.vertex(faces.b.vertex)};
  make_face_of_parallel_segments(faces, normal);
  faces.b_is_reference = faces.b.facing > faces.a.facing;
  if (faces.reference().facing < cosine_of_face_contact) return ManifoldPoints(&memory);
  ManifoldPoints points = face_points(faces, normal, memory);
  for (ManifoldPoint& point : points) point.depth = std::min(point.depth, most);
  drop_gaps(points);
  if (is_sliver(faces.a) || is_sliver(faces.b))
    std::erase_if(points, [&](const ManifoldPoint& point) { return !lies_between(point, a, b); });
  return points;
}

/// The point of the edges, each between two box corners, that are nearest along a direction.
ManifoldPoint point_of_edges(const PosedPolytope& a, const PosedPolytope& b, const BoxAxis& axis) {
  const Index low_a = farthest_corner(a, axis.direction) & ~(1U << axis.edge_a), high_a = low_a | 1U << axis.edge_a;
  const Index low_b = farthest_corner(b, -axis.direction) & ~(1U << axis.edge_b), high_b = low_b | 1U << axis.edge_b;
  const Vec3 p = a.vertex(low_a), u = a.vertex(high_a) - p, q = b.vertex(low_b), v = b.vertex(high_b) - q, w = q - p;
  const double uu = dot(u, u), uv = dot(u, v), vv = dot(v, v), uw = dot(u, w), vw = dot(v, w);
  const double determinant = uu * vv - uv * uv;
  const double s = determinant > 0 ? std::clamp((vv * uw - uv * vw) / determinant, 0.0, 1.0) : 0.5;
  const Vec3 on_a = p + s * u;
  const Vec3 on_b = q + std::clamp(dot(v, on_a - q) / vv, 0.0, 1.0) * v;
  return {on_a + 0.5 * (on_b - on_a), axis.depth, feature_of(a, {low_a, high_a}, 2), feature_of(b, {low_b, high_b}, 2)};
}

Manifold made_of(const Vec3& normal, ManifoldPoints& points) {
  Manifold result;
  result.normal = normal;
  take_four(result, points);
  return result;
}

Manifold of_boxes(const PosedPolytope& a, const PosedPolytope& b, const BoxAxes& axes) {
  std::array<std::byte, 4096> buffer;
  std::pmr::monotonic_buffer_resource memory(buffer.data(), buffer.size());
  const BoxAxis axis = axes.least(edge_share);
  ManifoldPoints points = points_of_faces(a, b, axis.direction, infinity, {}, memory);
  if (points.empty() && axis.edge_a < 3 && axis.edge_b < 3) points.push_back(point_of_edges(a, b, axis));
  if (points.empty()) points.push_back(single_point(a, b, part_by_expansion(a, b)));
  return made_of(axis.direction, points);
}

/// How wide the bracket of the depth may be that a manifold begins with, relative: it proves the direction, and limits
/// the depths of points, which are rounded. What `penetration` tells is narrower, with twice the digits where shallow.
constexpr double width_of_depth = 0x1p-24;

/// How shapes that meet are parted.
ConvexSeparation part_shapes(const PosedPolytope& a, const PosedPolytope& b) {
  if (a.radius() == 0 && b.radius() == 0) return part_meeting_cores(a, b, width_of_depth);
  if (const std::optional<ConvexSeparation> aligned = part_aligned_cores(a, b)) return *aligned;
  return part_by_expansion(a, b);
}

Manifold of_any(const PosedPolytope& a, const PosedPolytope& b) {
  std::array<std::byte, 8192> buffer;
  std::pmr::monotonic_buffer_resource memory(buffer.data(), buffer.size());
  const ConvexSeparation separation = part_shapes(a, b);
  const Penetration& p = separation.penetration;
  const Anchors anchors{p.on_a - a.radius() * p.direction, p.on_b + b.radius() * p.direction};
  ManifoldPoints points = points_of_faces(a, b, p.direction, p.upper, anchors, memory);
  // The deepest point may lie beside the reference face.
  double deepest = -infinity;
  for (const ManifoldPoint& point : points) deepest = std::max(deepest, point.depth);
  if (!(deepest >= (1 - 0x1p-20) * p.upper))
    put(points, single_point(a, b, separation.pairs.size > 0 ? separation : part_by_expansion(a, b)));
  return made_of(p.direction, points);
}

/// The manifold of shapes that meet, of any size.
Manifold of_any_size(const PosedPolytope& a, const PosedPolytope& b) {
  const int exponent = exponent_to_plain(a, b);
  return exponent == 0 ? of_any(a, b) : scaled(of_any(a.scaled(exponent), b.scaled(exponent)), -exponent);
}

bool are_boxes(const PosedPolytope& a, const PosedPolytope& b) {
  return is_box(a) && is_box(b) && a.radius() == 0 && b.radius() == 0;
}

Manifold in_canonical_order(const PosedPolytope& a, const PosedPolytope& b, SimplexCache* workspace) {
  const auto any = [&] { return overlap(a, b, workspace) ? of_any_size(a, b) : Manifold{}; };
  if (!are_boxes(a, b)) return any();
  const BoxAxes axes(a, b);
  if (!axes.is_of_plain_size()) return any();
  const std::optional<bool> meet = axes.meet();
  return (meet.has_value() ? *meet : overlap(a, b, workspace)) ? of_boxes(a, b, axes) : Manifold{};
}

/// The manifold of two boxes; nothing where their formula finds no points.
std::optional<Manifold> of_rigid_boxes(const PosedPolytope& a, const PosedPolytope& b, SimplexCache* workspace) {
  if (!is_rigid_and_plain(view_of(a)) || !is_rigid_and_plain(view_of(b))) return {};
  const std::optional<bool> by_centre = is_order_of_centres(view_of(a), view_of(b));
  const bool is_first = by_centre ? *by_centre : is_canonical_order(a, b);
  const BoxView first = view_of(is_first ? a : b), second = view_of(is_first ? b : a);
  RigidBoxAxes axes;
  const Nearness nearness = nearness_of_rigid_boxes(first, second, axes);
  if (nearness == Nearness::apart) return Manifold{};
  const RigidBoxContact contact(first, second, axes);
  if (!contact.has_points()) return {};
  if (nearness == Nearness::unknown && !overlap(a, b, workspace)) return Manifold{};
  return contact.manifold(!is_first);
}

}  // namespace

Manifold manifold(const PosedPolytope& a, const PosedPolytope& b, SimplexCache* workspace) {
  if (are_boxes(a, b))
    if (const std::optional<Manifold> found = of_rigid_boxes(a, b, workspace)) return *found;
  if (const Manifold found = manifold_of_primitives(a, b); is_known(found)) return found;
  if (is_canonical_order(a, b)) return in_canonical_order(a, b, workspace);
  return flipped(in_canonical_order(b, a, workspace));
}

Manifold manifold_along(const PosedPolytope& a, const PosedPolytope& b, const Vec3& direction) {
  const int exponent = exponent_to_plain(a, b);
  if (exponent != 0) return scaled(manifold_along(a.scaled(exponent), b.scaled(exponent), direction), -exponent);
  std::array<std::byte, 8192> buffer;
  std::pmr::monotonic_buffer_resource memory(buffer.data(), buffer.size());
  ManifoldPoints points = points_of_faces(a, b, direction, infinity, {}, memory);
  return points.empty() ? Manifold{} : made_of(direction, points);
}

double overlap_along(const PosedPolytope& a, const PosedPolytope& b, const Vec3& direction) {
  double reach = -infinity, begin = infinity;
  for (Index i = 0; i < a.vertex_count(); ++i) reach = std::max(reach, dot(a.vertex(i), direction));
  for (Index i = 0; i < b.vertex_count(); ++i) begin = std::min(begin, dot(b.vertex(i), direction));
  return (reach - begin) + (a.radius() + b.radius());
}

}  // namespace toccata
