#include <utility>

#include "generate/mesh_building.hpp"
#include "math/vec3_measures.hpp"
#include "toccata/generate/meshes.hpp"
#include "toccata/math/trigonometry.hpp"

namespace toccata {
namespace {

constexpr double least_tube_length = 1e-300;
constexpr double greatest_tube_length = 1e100;

void require_tube(double tube_radius, int steps, int sides) {
  require_range("the tube radius", tube_radius, least_tube_length, greatest_tube_length);
  require_range("the number of steps along the tube", steps, 3, 1e6);
  require_range("the number of sides of the tube", sides, 3, 10000);
}

SineCosine part_of_turn(int i, int count) { return sine_cosine_of_turns(static_cast<double>(i) / count); }

/// A point of a torus knot, with the outward normal n of the torus it lies on and the direction t of the knot there.
/// Both are smooth along the knot and perpendicular, so they carry the tube without a seam.
struct KnotFrame {
  Vec3 point, n, t;
};

KnotFrame knot_frame(const TorusKnotShape& shape, const SineCosine& around, const SineCosine& through) {
  const double distance = shape.radius + shape.second_radius * through.cosine;
  const Vec3 outward{around.cosine, around.sine, 0}, forward{-around.sine, around.cosine, 0}, up{0, 0, 1};
  const Vec3 n = through.cosine * outward + through.sine * up;
  const Vec3 across = through.cosine * up - through.sine * outward;
  const Vec3 t = shape.p * distance * forward + shape.q * shape.second_radius * across;
  return {distance * outward + shape.second_radius * through.sine * up, n, plain_unit_or_zero(t)};
}

void add_ring(Rings& rings, const KnotFrame& frame, double tube_radius, int sides) {
  const Vec3 b = cross(frame.t, frame.n);
  for (int i = 0; i < sides; ++i) {
    const SineCosine angle = part_of_turn(i, sides);
    rings.points.push_back(frame.point + (tube_radius * angle.cosine) * frame.n + (tube_radius * angle.sine) * b);
  }
}

/// The section of a helix: distance from the axis and height, symmetric to the bit in the height.
struct SectionPoint {
  double distance, height;
};

std::vector<SectionPoint> helix_section(const HelixShape& shape) {
  // The corners lie so that the inscribed circle has the tube's radius.
  const double corner_radius = shape.tube_radius / sine_cosine_of_turns(0.5 / shape.sides).cosine;
  std::vector<SectionPoint> section;
  for (int i = 0; i < shape.sides; ++i) {
    const bool lower = i < shape.sides / 2;
    const int mirrored = lower ? i : shape.sides - 1 - i;
    const SineCosine angle = sine_cosine_of_turns((mirrored + 0.5) / shape.sides);
    const double height = corner_radius * angle.sine;
    section.push_back({shape.radius + corner_radius * angle.cosine, lower ? -height : height});
  }
  return section;
}

Rings helix_rings(const HelixShape& shape, const std::vector<SectionPoint>& section) {
  Rings rings;
  rings.per_ring = shape.sides;
  for (int k = 0; k <= shape.turns * shape.steps_per_turn; ++k) {
    const SineCosine angle = part_of_turn(k % shape.steps_per_turn, shape.steps_per_turn);
    const double climb = shape.pitch * k / shape.steps_per_turn;
    for (const SectionPoint& p : section)
      rings.points.push_back({p.distance * angle.cosine, p.distance * angle.sine, climb + p.height});
  }
  return rings;
}

}  // namespace

TriangleMesh torus_mesh(const TorusShape& shape) {
  require_tube(shape.tube_radius, shape.around, shape.sides);
  require_range("the radius", shape.radius, shape.tube_radius, greatest_tube_length);
  Rings rings;
  rings.per_ring = shape.sides;
  for (int k = 0; k < shape.around; ++k) {
    const SineCosine angle = part_of_turn(k, shape.around);
    const Vec3 outward{angle.cosine, angle.sine, 0}, forward{-angle.sine, angle.cosine, 0};
    add_ring(rings, {shape.radius * outward, outward, forward}, shape.tube_radius, shape.sides);
  }
  return tube_closed_on_itself(std::move(rings));
}

Vec3 torus_knot_point(const TorusKnotShape& shape, double turns) {
  return knot_frame(shape, sine_cosine_of_turns(shape.p * turns), sine_cosine_of_turns(shape.q * turns)).point;
}

TriangleMesh torus_knot_mesh(const TorusKnotShape& shape) {
  require_tube(shape.tube_radius, shape.around, shape.sides);
  require_range("p", shape.p, 1, 1000);
  require_range("q", shape.q, 1, 1000);
  require_range("the second radius", shape.second_radius, least_tube_length, greatest_tube_length);
  require_range("the radius", shape.radius, shape.second_radius, greatest_tube_length);
  Rings rings;
  rings.per_ring = shape.sides;
  for (int k = 0; k < shape.around; ++k) {
    const auto angle = [&](int times) {
      return part_of_turn(static_cast<int>(static_cast<long long>(times) * k % shape.around), shape.around);
    };
    add_ring(rings, knot_frame(shape, angle(shape.p), angle(shape.q)), shape.tube_radius, shape.sides);
  }
  return tube_closed_on_itself(std::move(rings));
}

TriangleMesh helix_mesh(const HelixShape& shape) {
  require_tube(shape.tube_radius, shape.steps_per_turn, shape.sides);
  require_range("the number of sides, in fours,", shape.sides % 4, 0, 0);
  require_range("the number of turns", shape.turns, 1, 1000);
  require_range("the radius", shape.radius, 1.1 * shape.tube_radius, greatest_tube_length);
  require_range("the pitch", shape.pitch, 2 * shape.tube_radius, greatest_tube_length);
  const std::vector<SectionPoint> section = helix_section(shape);
  Rings rings = helix_rings(shape, section);
  PolygonMesh mesh;
  std::vector<Index> start, end;
  for (int i = 0; i < shape.sides; ++i) {
    start.push_back(rings.at(0, shape.sides - 1 - i));
    end.push_back(rings.at(rings.count() - 1, i));
  }
  add_face(mesh, start);
  for (int k = 0; k + 1 < rings.count(); ++k)
    for (int i = 0; i < shape.sides; ++i) {
      const Index a = rings.at(k, i), b = rings.at(k, i + 1), c = rings.at(k + 1, i + 1), d = rings.at(k + 1, i);
      // The diagonal runs from the inner corner behind to the outer ahead, on top as at the bottom: see helix_mesh.
      const int next = (i + 1) % shape.sides;
      if (section[static_cast<std::size_t>(i)].distance < section[static_cast<std::size_t>(next)].distance) {
        add_face(mesh, {a, b, c});
        add_face(mesh, {a, c, d});
      } else {
        add_face(mesh, {a, b, d});
        add_face(mesh, {b, c, d});
      }
    }
  add_face(mesh, end);
  mesh.vertices = std::move(rings.points);
  return triangulate(mesh);
}

}  // namespace toccata
