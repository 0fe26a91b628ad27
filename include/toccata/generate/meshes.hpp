#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "toccata/math/predicates.hpp"
#include "toccata/shapes/triangle_mesh.hpp"

namespace toccata {

/// A parameter of a generator: its name, the value it has when not given, and what it means.
struct GeneratorParameter {
  std::string name;
  double standard;
  double least;
  double greatest;
  bool whole;  ///< must be a whole number
  std::string meaning;
};

struct NamedGenerator {
  std::string name;
  std::string description;
  bool closed;  ///< the meshes are closed and turn outward
  std::vector<GeneratorParameter> parameters;
};

/// All mesh generators, by name. Their meshes have the same bits on every platform.
[[nodiscard]] const std::vector<NamedGenerator>& mesh_generators();

using GeneratorParameters = std::map<std::string, double>;

/// The mesh of a named generator; parameters that are not given have their standard values. Throws Error naming an
/// unknown generator or parameter (with the closest known one), and a value out of range.
[[nodiscard]] TriangleMesh generate_mesh(std::string_view name, const GeneratorParameters& parameters = {});

/// A generator with parameters, as written in "gen:torus-knot?p=2&q=3".
struct GeneratorSpecification {
  std::string name;
  GeneratorParameters parameters;
};

/// Whether `text` starts with "gen:".
[[nodiscard]] bool is_generator_specification(std::string_view text);

/// Throws Error when `text` is not of the form above.
[[nodiscard]] GeneratorSpecification parse_generator(std::string_view text);

/// A mesh turned inside out within a box: the solid is the box, `margin` larger than the mesh's box on every side,
/// without the inside of the mesh. For a closed mesh it is closed, and touches the mesh everywhere on its surface.
[[nodiscard]] TriangleMesh negative_image(const TriangleMesh& mesh, double margin);

/// The mesh with every coordinate multiplied by `factor`.
[[nodiscard]] TriangleMesh scaled_mesh(const TriangleMesh& mesh, double factor);

// Meshes made from numbers, with the same bits on every platform. All are closed and turn outward, except the height
// field. Lengths are in the mesh's units. Numbers out of the ranges given are an Error.

/// Six square-cornered faces around `centre`, twelve triangles.
[[nodiscard]] TriangleMesh box_mesh(const Vec3& half_extents, const Vec3& centre = {});

/// The regular tetrahedron whose corners are corners of the cube [−half_edge, half_edge]³.
[[nodiscard]] TriangleMesh tetrahedron_mesh(double half_edge);

/// An icosahedron whose triangles are cut into four `subdivisions` (0 … 8) times and pushed out to the radius.
[[nodiscard]] TriangleMesh icosphere_mesh(double radius, int subdivisions);

/// Circles of latitude and longitude: `around` ≥ 3 meridians, `along` ≥ 2 steps from pole to pole (the z axis).
[[nodiscard]] TriangleMesh uv_sphere_mesh(double radius, int around, int along);

/// The prism over a simple counter-clockwise outline in the xy-plane, from z = 0 to `height`.
[[nodiscard]] TriangleMesh extruded_mesh(std::span<const Vec2> outline, double height);

/// The prism over a regular polygon, around the z axis from z = 0 to `height`; a cylinder when `sides` is large.
[[nodiscard]] TriangleMesh prism_mesh(double radius, double height, int sides);

struct TorusShape {
  double radius = 1;
  double tube_radius = 0.25;
  int around = 48;
  int sides = 16;
};
/// A ring around the z axis.
[[nodiscard]] TriangleMesh torus_mesh(const TorusShape& shape);

struct TorusKnotShape {
  int p = 2;                   ///< times around the z axis
  int q = 3;                   ///< times through the ring; p and q have no common divisor
  double radius = 1;           ///< that of the ring on which the knot lies
  double second_radius = 0.4;  ///< of that ring's tube
  double tube_radius = 0.12;   ///< of the knot's own tube
  int around = 240;            ///< steps along the knot
  int sides = 12;
};
[[nodiscard]] TriangleMesh torus_knot_mesh(const TorusKnotShape& shape);
/// The middle line of the knot at `turns` of one passage along it, 0 … 1.
[[nodiscard]] Vec3 torus_knot_point(const TorusKnotShape& shape, double turns);

struct HelixShape {
  double radius = 3;       ///< of the middle line around the z axis; more than 1.1 tube radii
  double pitch = 5;        ///< climb per turn
  double tube_radius = 1;  ///< of the inscribed circle of the tube's section
  int turns = 3;
  int steps_per_turn = 48;
  int sides = 8;  ///< a multiple of 4
};
/// A tube that climbs around the z axis, with flat ends. Its section in every plane through the axis is a regular
/// polygon with a flat top and bottom, so one helix, moved along z, rests on another over its whole length. The
/// triangles of top and bottom are translates of each other.
[[nodiscard]] TriangleMesh helix_mesh(const HelixShape& shape);

struct GearShape {
  int teeth = 16;
  double root_radius = 0.85;
  double tip_radius = 1.1;
  double tooth_root = 0.62;  ///< the share of the pitch that a tooth takes at its root
  double tooth_tip = 0.26;   ///< and at its tip
  double height = 0.3;
};
/// A toothed wheel around the z axis from z = 0 to the height; the middle of a tooth lies on the x axis.
[[nodiscard]] TriangleMesh gear_mesh(const GearShape& shape);

struct NoiseSphereShape {
  double radius = 1;
  double roughness = 0.3;  ///< 0 … 0.9: the radius stays within (1 ± roughness) times `radius`
  int subdivisions = 3;    ///< 0 … 8, as of an icosphere
  std::uint64_t seed = 1;
};
/// A bumpy ball, star-shaped about the origin: every ray from there crosses it once, and a copy scaled by less than 1
/// lies inside it.
[[nodiscard]] TriangleMesh noise_sphere_mesh(const NoiseSphereShape& shape);

struct HeightFieldShape {
  int cells_x = 32;
  int cells_y = 32;
  double cell = 0.1;    ///< edge length of a cell
  double height = 0.5;  ///< heights lie within [0, height]
  std::uint64_t seed = 1;
};
/// A landscape over the xy-plane around the origin: a surface, open at its border.
[[nodiscard]] TriangleMesh height_field_mesh(const HeightFieldShape& shape);

}  // namespace toccata
