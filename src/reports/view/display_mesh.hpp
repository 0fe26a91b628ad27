#pragma once

#include <array>
#include <vector>

#include "toccata/bounds/aabb.hpp"
#include "toccata/core/index.hpp"
#include "toccata/query/model.hpp"
#include "toccata/shapes/shape.hpp"

namespace toccata::io {

/// What is drawn of a shape, in its own frame. A segment has two vertices and a point one, and both no triangle.
struct DisplayMesh {
  std::vector<Vec3> vertices;
  std::vector<std::array<Index, 3>> triangles;
  std::vector<Index> faces;  ///< of each triangle, the face that answers name; ascending
  bool smooth = false;       ///< a round shape, of which the triangles are no part
};

/// The number of circles of latitude by which round shapes are drawn at their finest.
inline constexpr int most_circles = 12;

/// The mesh of any shape but a half-space, which is drawn as the square of that half side around a point of its
/// boundary. Round shapes are drawn as triangles inside them, of so many circles of latitude.
[[nodiscard]] DisplayMesh display_mesh(const Model& model, int circles = most_circles);
[[nodiscard]] DisplayMesh display_mesh(const HalfSpace& shape, const Vec3& centre, double half_side);

/// The sphere of radius 1 and the box of half extents 1, which are drawn wherever there is a sphere or a box.
[[nodiscard]] DisplayMesh unit_sphere(int circles = most_circles);
[[nodiscard]] DisplayMesh unit_box();

/// Points of the unit sphere, on so many circles of latitude that are turned against each other, and the poles.
[[nodiscard]] std::vector<Vec3> sphere_points(int circles);

}  // namespace toccata::io
