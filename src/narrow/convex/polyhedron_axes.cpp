#include "narrow/convex/polyhedron_axes.hpp"

#include <algorithm>
#include <cmath>

#include "math/constants.hpp"
#include "math/vec3_measures.hpp"

// Let D' be the difference of the polyhedra without rounding of world vertices; their topologies are those of the
// shapes' own frames, exactly. World vertices lie up to `bent` beside, so every reach of D differs from that of D' by
// no more.
//
// The least reach of D' is attained along the normal of one of its facets. A facet is a face of A and a vertex of B, a
// vertex of A and a face of B, or an edge of each; with an edge of each, the arc of A's edge on the Gauss map (from the
// normal of its one face to that of the other) crosses the arc of B's, turned round. Arcs that are certain not to cross
// are left out. A pair that is not left out by mistake does no harm: the reach along any direction is no less than the
// least.
//
// Faces' normals are known to 2^-34, and cannot be the mistake. But vertices that lie beside turn an edge, and one that
// is short by any angle, so that arcs may seem not to cross that do, near an end of one of them; say, of the arc of B's
// edge, at the normal L of a face. On the way there from where they cross, A's farthest vertex changes only along edges
// that are left out like this one, from p to q, and the reach becomes more by L · (q - p) at most. As world vertices
// have it this is negative: so it is twice `bent` at most, and for that the least reach is lowered.
//
// A rounded normal is off by an angle (expanding_polytope.cpp has the bound); the reach along it is then off by that
// angle times the extent of D. The angle of nearly parallel edges is large. Then the pair may be left out, for a small
// price: along the arc of A's edge, the reach is that of a polygon, D' seen along the edge. B's edge is one of its
// sides, of length |e × f| / |e|. Without it, the least reach along the arc is attained at its ends, which are faces of
// A, or where another edge of B crosses; and taking it away changes no reach by more than its length.
namespace toccata {
namespace {

constexpr double doubtful_angle = 0x1p-34;  ///< of faces; arcs are compared with 2^-30

/// How far a world vertex may lie beside the one without rounding: four roundings a coordinate, each of at most 2^-53
/// of what was added up so far.
double bend_of(const PosedPolytope& shape) {
  if (shape.in_world()) return 0;
  Vec3 largest;
  for (int axis = 0; axis < 3; ++axis)
    for (Index i = 0; i < shape.vertex_count(); ++i)
      largest[axis] = std::max(largest[axis], std::fabs(shape.along(axis)[i]));
  double sum = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const Vec3& row = shape.pose().linear[axis];
    const Vec3 magnitudes{std::fabs(row.x), std::fabs(row.y), std::fabs(row.z)};
    sum += dot(magnitudes, largest) + std::fabs(shape.pose().offset[axis]);
  }
  return 0x1p-50 * sum;
}

/// The same of a box, whose own coordinates are not kept; other shapes of few vertices cannot be bent.
double bend_of_box(const CoreVertices& core) {
  const Vec3 x = core.relative(1), y = core.relative(2), z = core.relative(4);
  const auto beside = [&](Index i, const Vec3& expected) { return sum_of_magnitudes(core.relative(i) - expected); };
  const double most = std::max({beside(3, x + y), beside(5, x + z), beside(6, y + z), beside(7, (x + y) + z)});
  return most + 0x1p-48 * (sum_of_magnitudes(x) + sum_of_magnitudes(y) + sum_of_magnitudes(z));
}

using Edge = PolyhedronAxes::Edge;

/// The arc of one edge and the arc of the other, turned round, cross, or rounding hides that they do not (D.
/// Gregorius).
bool may_cross(const Edge& e, const Vec3& along_e, const Edge& f, const Vec3& along_f) {
  constexpr double unsure = 0x1p-30;
  const auto same = [](double p, double q) { return (p > unsure && q > unsure) || (p < -unsure && q < -unsure); };
  const double left_f = dot(f.left, along_e), right_f = dot(f.right, along_e);
  const double left_e = dot(e.left, along_f), right_e = dot(e.right, along_f);
  // The ends of each lie on both sides of the other's great circle, and the circles' common point is not on the far
  // side.
  return !same(left_f, right_f) && !same(left_e, right_e) && !same(left_f, right_e);
}

}  // namespace

// An end of f is off by what it is itself, and by what the direction of e is off by; no image is longer than f. In this
// order, where the length of e underflows nothing is known of the angle.
double greatest_image(const Vec3& e, const Vec3& f, double extent, double bent) {
  const double beside = 0x1p-48 * extent + 4 * bent, size_f = sum_of_magnitudes(f);
  return std::min(size_f, (plain_length(cross(e, f)) + beside * size_f) / plain_length(e)) + beside;
}

PolyhedronAxes::PolyhedronAxes(const PosedPolytope& a, const PosedPolytope& b)
    : body_(a, b), a_(outline_of(a, body_.a())), b_(outline_of(b, body_.b())), bent_(a_.bent + b_.bent) {}

double PolyhedronAxes::angle_error(const Vec3& u, const Vec3& v, double length) const {
  const double off = 0x1p-48 * body_.extent() + 2 * bent_;
  return off * (sum_of_magnitudes(u) + sum_of_magnitudes(v)) / length;
}

PolyhedronAxes::Face PolyhedronAxes::face_of(const PosedPolytope& shape, const CoreVertices& core, Index f,
                                             double bent) const {
  const HullTopology topology = shape.topology();
  const Index first = topology.face_start[f], count = topology.face_start[f + 1] - first;
  if (count < 3) return {};
  // Three corners far apart.
  const Vec3 p = core.relative(topology.origin[first]);
  const Vec3 u = core.relative(topology.origin[first + count / 3]) - p,
             v = core.relative(topology.origin[first + 2 * count / 3]) - p;
  const Vec3 n = cross(u, v);
  const double length = plain_length(n);
  const Mat3& m = shape.pose().linear;
  const double mirrored = dot(cross(m[0], m[1]), m[2]) < 0 ? -1 : 1;
  const double angle = (0x1p-48 * body_.extent() + 2 * bent) * (sum_of_magnitudes(u) + sum_of_magnitudes(v)) / length;
  if (!(angle < doubtful_angle)) return {{}, infinity};
  return {(mirrored / length) * n, angle};
}

PolyhedronAxes::Outline PolyhedronAxes::outline_of(const PosedPolytope& shape, const CoreVertices& core) const {
  Outline outline;
  const HullTopology topology = shape.topology();
  outline.bent =
      shape.vertex_count() == 8 && shape.in_world() ? bend_of_box(core) : body_.scaled_length(bend_of(shape));
  for (Index f = 0; f < topology.face_count(); ++f) outline.faces.push_back(face_of(shape, core, f, outline.bent));
  const Mat3& m = shape.pose().linear;
  const double mirrored = dot(cross(m[0], m[1]), m[2]) < 0 ? -1 : 1;
  for (Index h = 0; h < topology.origin.size(); ++h) {
    if (topology.twin[h] < h) continue;
    const Vec3 &left = outline.faces[topology.face[h]].normal,
               &right = outline.faces[topology.face[topology.twin[h]]].normal;
    const Vec3 along = core.relative(topology.target(h)) - core.relative(topology.origin[h]);
    outline.edges.push_back(
        {mirrored * along, topology.origin[h], left, right, dot(left + right, left + right) > 0x1p-20});
  }
  return outline;
}

bool PolyhedronAxes::try_axis(const Vec3& axis, double angle, const Edge* e, const Edge* f) {
  const double reach = dot(axis, body_.support(axis).value), margin = 0x1p-48 * body_.extent();
  // The length of a vector of D is at most √3 times its extent.
  least_.lower = std::min(least_.lower, reach - (2 * angle * body_.extent() + margin));
  if (reach + margin < least_.upper) {
    least_.upper = reach + margin;
    least_.direction = axis;
    least_.edge_a = e;
    least_.edge_b = f;
  }
  return least_.upper >= 0;
}

bool PolyhedronAxes::try_faces(const Outline& outline, double turn) {
  for (const Face& face : outline.faces) {
    if (face.angle == infinity) least_.lower = -infinity;
    if (face.normal == Vec3{}) continue;
    if (!try_axis(turn * face.normal, face.angle)) return false;
  }
  return true;
}

bool PolyhedronAxes::try_edge_pair(const Edge& e, const Edge& f, double& loss) {
  const Vec3 n = cross(e.along, f.along);
  const double length = plain_length(n), image = greatest_image(e.along, f.along, body_.extent(), bent_);
  const double angle = length > 0 ? angle_error(e.along, f.along, length) : infinity;
  if (!(2 * angle * body_.extent() > image)) {
    const double side = dot(n, e.left + e.right);
    // What the product and the normals are off by may turn the axis over only where the side is next to none.
    const bool is_side_sure = e.is_arc && std::fabs(side) > (2 * angle + 0x1p-32) * length;
    const Vec3 axis = ((side >= 0 ? 1 : -1) / length) * n;
    const double reach = dot(axis, body_.point(e.vertex, f.vertex).value);
    const bool may_be_less = reach - (3 * angle + 0x1p-46) * body_.extent() < least_.upper;
    if (may_be_less && !try_axis(axis, angle, &e, &f)) return false;
    return is_side_sure || try_axis(-axis, angle, &e, &f);
  }
  loss += image;
  return true;
}

bool PolyhedronAxes::try_edges() {
  double greatest_loss = 0;
  for (const Edge& e : a_.edges) {
    double loss = 0;
    const Vec3 unit = (1 / plain_length(e.along)) * e.along;
    for (const Edge& f : b_.edges) {
      if (e.is_arc && f.is_arc && !may_cross(e, unit, f, (1 / plain_length(f.along)) * f.along)) continue;
      if (!try_edge_pair(e, f, loss)) return false;
    }
    greatest_loss = std::max(greatest_loss, loss);
  }
  least_.lower -= greatest_loss;
  return true;
}

// Many edges may have one direction, and two edges of a face are across its normal, too, without reaching as far.
void PolyhedronAxes::settle_edges() {
  if (least_.edge_a == nullptr) return;
  const auto farthest = [&](const std::vector<Edge>& edges, const Edge& chosen, const auto& height) {
    const Edge* best = &chosen;
    for (const Edge& e : edges)
      if (sum_of_magnitudes(cross(e.along, chosen.along)) <=
              0x1p-40 * sum_of_magnitudes(e.along) * sum_of_magnitudes(chosen.along) &&
          height(e.vertex) > height(best->vertex))
        best = &e;
    return best;
  };
  const Vec3& axis = least_.direction;
  least_.edge_a = farthest(a_.edges, *least_.edge_a, [&](Index v) { return dot(axis, body_.a().relative(v)); });
  least_.edge_b = farthest(b_.edges, *least_.edge_b, [&](Index v) { return -dot(axis, body_.b().relative(v)); });
  const double reach = dot(axis, body_.point(least_.edge_a->vertex, least_.edge_b->vertex).value);
  if (!(reach >= least_.upper - 0x1p-34 * body_.extent())) least_.edge_a = least_.edge_b = nullptr;
}

PolyhedronAxes::Least PolyhedronAxes::least(const Vec3& first_axis) {
  least_ = {infinity, infinity, {}};
  if (dot(first_axis, first_axis) > 0x1p-900 && !try_axis((1 / plain_length(first_axis)) * first_axis, 0))
    return least_;
  if (!try_faces(a_, 1) || !try_faces(b_, -1) || !try_edges()) return least_;
  settle_edges();
  // The least reach of D lies below that of D', a reach that was taken of D above that of D', and an edge left out
  // between. Where no axis was left, nothing is known.
  least_.lower = least_.lower < infinity ? least_.lower - 4 * bent_ : -infinity;
  return least_;
}

}  // namespace toccata
