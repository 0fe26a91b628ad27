#pragma once

#include <vector>

#include "query/meshes/posed_mesh.hpp"
#include "toccata/shapes/convex_hull.hpp"

namespace toccata {

/// Tells quickly of most triangles before a face of a convex body that they do not meet it: along the normal of the
/// face, all of the triangle is farther than all of the body. Triangles that come one after the other are mostly before
/// the same face.
class OutsideFaces {
 public:
  /// The body has three dimensions and has to outlive this.
  explicit OutsideFaces(const ConvexHull& body);

  /// Proved; false where the faces do not tell.
  [[nodiscard]] bool tell_apart(const Triangle& triangle);

 private:
  struct Face {
    Vec3 normal;
    double height;             ///< along the normal, of a vertex of the face
    double of_body = 0;        ///< of the vertex that is the farthest, rounded
    bool is_measured = false;  ///< `of_body` is known: only of faces that seem to tell something
  };

  [[nodiscard]] bool is_before(Face& face, const Triangle& triangle, double reach) const;

  const ConvexHull& body_;
  std::vector<Face> faces_;
  double reach_ = 0;  ///< no coordinate of the body is greater
  std::size_t last_ = 0;
};

}  // namespace toccata
