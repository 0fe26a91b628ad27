#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include "query/subdivision/level_mesh.hpp"

namespace toccata::test {

/// Levels after one, and where the faces of that one alone, flat or bilinear, have their points.
class Descent {
 public:
  explicit Descent(LevelMesh mesh) : mesh_(std::move(mesh)), own_(mesh_.points), ancestor_(mesh_.face_count()) {
    for (Index f = 0; f < mesh_.face_count(); ++f) ancestor_[f] = f;
  }

  void descend() {
    LevelMesh finer = subdivided(mesh_, std::vector<char>(mesh_.face_count(), 1));
    std::vector<Vec3> own(finer.points.size());
    for (Index v = 0; v < mesh_.points.size(); ++v) own[mesh_.point_of_vertex[v]] = own_[v];
    for (Index e = 0; e < mesh_.edges.size(); ++e)
      own[mesh_.point_of_edge[e]] = 0.5 * (own_[mesh_.edges[e].ends[0]] + own_[mesh_.edges[e].ends[1]]);
    std::vector<Index> ancestor(finer.face_count());
    Index child = 0;
    for (Index f = 0; f < mesh_.face_count(); ++f) {
      Vec3 middle{};
      for (const Index corner : mesh_.face(f)) middle += own_[corner] / double(mesh_.corner_count(f));
      if (mesh_.scheme == SubdivisionScheme::catmull_clark) own[finer.face(child)[2]] = middle;
      for (int i = 0; i < 4; ++i) ancestor[child++] = ancestor_[f];
    }
    mesh_ = std::move(finer);
    own_ = std::move(own);
    ancestor_ = std::move(ancestor);
  }

  [[nodiscard]] const LevelMesh& mesh() const { return mesh_; }

  /// How far points have moved from each face, at most.
  [[nodiscard]] std::vector<double> moved(Index faces) const {
    std::vector<double> most(faces, 0);
    for (Index f = 0; f < mesh_.face_count(); ++f)
      for (const Index corner : mesh_.face(f))
        most[ancestor_[f]] = std::max(most[ancestor_[f]], length(mesh_.points[corner] - own_[corner]));
    return most;
  }

 private:
  LevelMesh mesh_;
  std::vector<Vec3> own_;
  std::vector<Index> ancestor_;
};

}  // namespace toccata::test
