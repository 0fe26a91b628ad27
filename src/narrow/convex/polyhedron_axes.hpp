#pragma once

#include <vector>

#include "narrow/convex/difference_body.hpp"

namespace toccata {

/// How long an edge f of a polyhedron is at most, seen along an edge e of another, where both are differences of
/// rounded vertices; the difference body is of that extent, and its vertices are bent by so much.
[[nodiscard]] double greatest_image(const Vec3& e, const Vec3& f, double extent, double bent);

/// The axes along which two polyhedra can be separated, all of them, in doubles and with bounds on the errors. Lengths
/// are those of the difference body.
class PolyhedronAxes {
 public:
  PolyhedronAxes(const PosedPolytope& a, const PosedPolytope& b);

  struct Edge {
    Vec3 along;  ///< scaled; the faces' normals, left × right, turn round it counter-clockwise
    Index vertex = 0;
    Vec3 left, right;
    bool is_arc = false;  ///< the normals span an arc that is shorter than half a circle
  };

  /// The least reach of the difference, which is the depth when it is positive, lies in [lower, upper]; upper is that
  /// of the direction. −∞ and ∞ where rounding leaves all in doubt.
  struct Least {
    double lower;
    double upper;
    Vec3 direction;
    const Edge* edge_a = nullptr;  ///< whose cross product it is, and which reach as far; none: a face's normal
    const Edge* edge_b = nullptr;
  };
  /// Stops at the first axis that is certain to separate: upper < 0.
  [[nodiscard]] Least least(const Vec3& first_axis);

  [[nodiscard]] const DifferenceBody& body() const { return body_; }

 private:
  struct Face {
    Vec3 normal;       ///< unit, outwards; zero when the face has no area
    double angle = 0;  ///< by which it may be off
  };
  struct Outline {
    std::vector<Face> faces;
    std::vector<Edge> edges;
    double bent = 0;  ///< how far world vertices lie beside those without rounding
  };

  [[nodiscard]] Outline outline_of(const PosedPolytope& shape, const CoreVertices& core) const;
  [[nodiscard]] Face face_of(const PosedPolytope& shape, const CoreVertices& core, Index f, double bent) const;
  [[nodiscard]] double angle_error(const Vec3& u, const Vec3& v, double length) const;
  /// Along a unit vector that may be off by the angle; false when it separates.
  bool try_axis(const Vec3& axis, double angle, const Edge* e = nullptr, const Edge* f = nullptr);
  bool try_faces(const Outline& outline, double turn);
  bool try_edges();
  bool try_edge_pair(const Edge& e, const Edge& f, double& loss);
  void settle_edges();

  DifferenceBody body_;
  Outline a_;
  Outline b_;
  double bent_ = 0;
  Least least_{};
};

}  // namespace toccata
