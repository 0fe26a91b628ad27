#pragma once

#include <array>

#include "query/manifolds/vertex_fans.hpp"
#include "query/posed_shape.hpp"
#include "toccata/core/function_ref.hpp"

namespace toccata {

/// A triangle within its surface, as far as that limits along which directions something can lie on it: such that the
/// surface does not rise along them beside the point of contact, and outwards of a solid. Within the face that is its
/// normal; on an edge between two faces what lies between their normals, if they fold away from each other, else
/// nothing; at a vertex likewise. (The Voronoi regions of M. Lin, J. Canny, "A fast algorithm for incremental distance
/// calculation", 1991, of what is convex there.) All numbers are rounded.
class TriangleSurroundings {
 public:
  /// Both have to outlive it.
  TriangleSurroundings(const PosedTriangles& surface, Index triangle);

  /// Unit; zero of one without area.
  [[nodiscard]] const Vec3& normal() const { return normal_; }
  [[nodiscard]] bool is_of_solid() const { return surface_.solid; }
  [[nodiscard]] const Triangle& corners() const { return corners_; }

  /// No edge of it folds away from it, and no vertex stands out: nothing but its normals is allowed.
  [[nodiscard]] bool is_flat() const;

  /// Something that the triangle pushes along the direction, which is unit, lies on a part of the surface that is
  /// highest along it.
  [[nodiscard]] bool allows(const Vec3& direction) const;

  /// Calls with the normals, unit, that are allowed where nothing else is: its own, and those of the triangles beyond
  /// edges at which the surface folds away from it; of a surface that is no solid those of the other side too.
  void visit_normals(FunctionRef<void(const Vec3&)> see) const;

  /// Calls with the edges at which the surface folds away from the triangle, or ends, and the vertices around which
  /// something lies below it: there directions between the normals may be allowed.
  void visit_ridges(FunctionRef<void(const PosedPart&)> see) const;

 private:
  [[nodiscard]] const VertexFans& fans() const { return *fans_; }
  [[nodiscard]] Triangle other(Index triangle) const { return surface_.mesh.triangle(triangle); }
  [[nodiscard]] Vec3 normal_of(Index triangle) const;
  [[nodiscard]] bool is_highest_edge(std::size_t edge, const Vec3& direction) const;
  [[nodiscard]] bool is_highest_vertex(std::size_t corner, const Vec3& direction) const;
  /// Calls `see(triangle, its corner that is not of the edge)` for those beyond the edge from corner `edge` to the
  /// next.
  template <class See>
  void visit_beyond(std::size_t edge, const See& see) const;
  [[nodiscard]] bool is_ridge(std::size_t edge) const;
  [[nodiscard]] bool is_peak(std::size_t corner) const;
  void visit_normals_of_side(const Vec3& normal, FunctionRef<void(const Vec3&)> see) const;

  const PosedTriangles& surface_;
  const VertexFans* fans_;
  Index number_;
  double mirrored_;  ///< −1 where the pose turns all triangles round
  Triangle corners_;
  Vec3 normal_;
};

}  // namespace toccata
