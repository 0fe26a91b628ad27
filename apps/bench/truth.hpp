#pragma once

#include "library.hpp"

namespace toccata::bench {

/// Do the triangles meet, in rational arithmetic (tests/oracle).
bool truly_meet(const Triangle& a, const Triangle& b);

/// Two posed meshes as the triangles of docs/truth.md, and the truth about them by brute force.
class TrueMeshes {
 public:
  TrueMeshes(const TriangleMesh& a, const TriangleMesh& b, const PosePair& poses);

  [[nodiscard]] bool meet(const std::pair<Index, Index>& pair) const;
  [[nodiscard]] bool meet() const;
  /// The square of the distance of the pair.
  [[nodiscard]] double squared_distance(const std::pair<Index, Index>& pair) const;
  /// Every pair whose boxes overlap: no other can meet. No tree is involved.
  [[nodiscard]] TrianglePairs candidates() const;

 private:
  std::vector<Triangle> a_;
  std::vector<Triangle> b_;
};

}  // namespace toccata::bench
