#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "query/posed_shape.hpp"
#include "toccata/core/index.hpp"
#include "trees/swept_walk.hpp"

namespace toccata {

/// World directions along which a thing that moves is compared with one that stands: those for which the tests are
/// certain (docs/design/culling.md). One of two is a mesh.
class SweptView {
 public:
  SweptView(const PosedMesh& a, const Vec3& motion, const PosedMesh& b);
  SweptView(const PosedMesh& a, const Vec3& motion, const PosedPolytope& b);
  SweptView(const PosedPolytope& a, const Vec3& motion, const PosedMesh& b);
  SweptView(const PosedMesh& a, const Vec3& motion, const PosedQuadric& b);
  SweptView(const PosedQuadric& a, const Vec3& motion, const PosedMesh& b);
  SweptView(const PosedMesh& a, const Vec3& motion, const PosedHalfSpace& b);
  SweptView(const PosedHalfSpace& a, const Vec3& motion, const PosedMesh& b);

  /// For a triangle of a mesh on `side`, and boxes of the other mesh that are small beside it: its normal and those of
  /// its sides in its plane.
  SweptView(const PosedMesh& a, const Vec3& motion, const PosedMesh& b, std::size_t side, Index triangle);

  [[nodiscard]] std::span<const SweptDirection> directions() const { return {directions_.data(), count_}; }

 private:
  template <class A, class B>
  void add(const A& a, const Vec3& motion, const B& b, const Vec3& direction);
  template <class A, class B>
  void add_around(const PosedMesh& mesh, const A& a, const Vec3& motion, const B& b);

  std::array<SweptDirection, SweptWalk::most_directions> directions_;
  std::size_t count_ = 0;
};

}  // namespace toccata
