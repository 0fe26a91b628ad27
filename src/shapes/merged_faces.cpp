
#include "core/no_index.hpp"
#include "shapes/hull_faces.hpp"
#include "toccata/math/predicates.hpp"

namespace toccata {
namespace {

class FaceMerging {
 public:
  FaceMerging(std::span<const Vec3> points, std::span<const HullTriangle> triangles)
      : points_(points), triangles_(triangles), face_of_(triangles.size(), no_index) {
    for (Index t = 0; t < triangles.size(); ++t)
      if (face_of_[t] == no_index) spread(t);
  }

  [[nodiscard]] HullFaces faces() const {
    std::vector<bool> traced(count_, false);
    HullFaces all{3, {}, {0}};
    std::vector<Index> uses(points_.size(), 0);
    for (Index t = 0; t < triangles_.size(); ++t)
      for (std::size_t e = 0; e < 3; ++e) {
        if (traced[face_of_[t]] || !is_border(t, e)) continue;
        traced[face_of_[t]] = true;
        trace(t, e, all);
      }
    for (const Index corner : all.corners) ++uses[corner];
    return without_flat_corners(all, uses);
  }

 private:
  [[nodiscard]] bool coplanar(Index t, std::size_t edge) const {
    const auto& [a, b, c] = triangles_[t].vertices;
    const HullTriangle& other = triangles_[triangles_[t].neighbours[edge]];
    const Index to = triangles_[t].vertices[(edge + 1) % 3];
    // In the neighbour the edge runs the other way round, so after its start `to` come `from` and the third vertex.
    const std::size_t corner = other.vertices[0] == to ? 0 : other.vertices[1] == to ? 1 : 2;
    const Index third = other.vertices[(corner + 2) % 3];
    return orient3d(points_[a], points_[b], points_[c], points_[third]) == Sign::zero;
  }

  /// Gives a new face number to all triangles in the plane of the first that are connected with it.
  void spread(Index first) {
    std::vector<Index>& open = open_;
    open.assign(1, first);
    face_of_[first] = count_;
    while (!open.empty()) {
      const Index t = open.back();
      open.pop_back();
      for (std::size_t e = 0; e < 3; ++e) {
        const Index neighbour = triangles_[t].neighbours[e];
        if (face_of_[neighbour] != no_index || !coplanar(t, e)) continue;
        face_of_[neighbour] = count_;
        open.push_back(neighbour);
      }
    }
    ++count_;
  }

  [[nodiscard]] bool is_border(Index t, std::size_t edge) const {
    return face_of_[triangles_[t].neighbours[edge]] != face_of_[t];
  }

  /// Goes round the face that has the border edge: from the end of an edge on, triangles are crossed until the next
  /// edge of the border. A convex face has one border.
  void trace(Index start, std::size_t start_edge, HullFaces& faces) const {
    Index t = start;
    std::size_t edge = start_edge;
    do {
      faces.corners.push_back(triangles_[t].vertices[edge]);
      edge = (edge + 1) % 3;
      while (!is_border(t, edge)) {
        const Index from = triangles_[t].vertices[edge];
        t = triangles_[t].neighbours[edge];
        // The edge ends in `from` here; the one that starts there is next.
        edge = triangles_[t].vertices[0] == from ? 0 : triangles_[t].vertices[1] == from ? 1 : 2;
      }
    } while (t != start || edge != start_edge);
    faces.close_face();
  }

  /// A vertex of the hull is a corner of at least three faces, a point within an edge of two, one within a face of
  /// none.
  [[nodiscard]] static HullFaces without_flat_corners(const HullFaces& all, const std::vector<Index>& uses) {
    HullFaces kept{3, {}, {0}};
    kept.corners.reserve(all.corners.size());
    kept.first.reserve(all.first.size());
    for (std::size_t f = 0; f + 1 < all.first.size(); ++f) {
      for (Index c = all.first[f]; c < all.first[f + 1]; ++c)
        if (uses[all.corners[c]] > 2) kept.corners.push_back(all.corners[c]);
      kept.close_face();
    }
    return kept;
  }

  std::span<const Vec3> points_;
  std::span<const HullTriangle> triangles_;
  std::vector<Index> face_of_;
  std::vector<Index> open_;
  Index count_ = 0;
};

}  // namespace

HullFaces merged_faces(std::span<const Vec3> points, std::span<const HullTriangle> triangles) {
  return FaceMerging(points, triangles).faces();
}

}  // namespace toccata
