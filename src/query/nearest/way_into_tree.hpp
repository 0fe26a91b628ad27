#pragma once

#include <array>

#include "query/meshes/posed_mesh.hpp"
#include "toccata/math/mat3.hpp"
#include "trees/ray_frame.hpp"

namespace toccata {

/// The way of points from the world into the units of a posed mesh's tree, from
/// its origin, with a bound on what it is off by: docs/design/rays.md, whose
/// names these are.
class WayIntoTree {
 public:
  explicit WayIntoTree(const PosedMesh& mesh);

  /// The way into a mesh at the identity, where most of it is known: the same numbers for a sixth of the work.
  explicit WayIntoTree(const WideBvh& tree);

  /// Otherwise nothing is known of where a point comes to be.
  [[nodiscard]] bool usable() const { return usable_; }

  /// The place of a point of the world, which is given less the pose's offset.
  [[nodiscard]] Vec3 place(const Vec3& from_offset) const { return direction(from_offset) - origin_; }
  [[nodiscard]] Vec3 direction(const Vec3& v) const { return {dot(back_[0], v), dot(back_[1], v), dot(back_[2], v)}; }

  /// What world triangles and points are off from where the tree has them, at
  /// most, along any axis; `size` is at least the greatest magnitude of the
  /// points' coordinates.
  [[nodiscard]] double off(double size) const { return off_ + off_by_size_ * size; }

  /// The parts of `off`: off_at_origin + off_by_size · size. The latter is also
  /// what a direction is off by from where the matrix takes it.
  [[nodiscard]] double off_at_origin() const { return off_; }
  [[nodiscard]] double off_by_size() const { return off_by_size_; }
  [[nodiscard]] const Vec3& origin() const { return origin_; }

  [[nodiscard]] const Mat3& back() const { return back_; }

 private:
  Mat3 back_;    ///< about the inverse of the pose's matrix, in the tree's units
  Vec3 origin_;  ///< of the tree, in its units
  double off_ = 0;
  double off_by_size_ = 0;
  bool usable_ = false;
};

/// The same for rays at a mesh whose pose has that offset.
[[nodiscard]] RayFrame ray_frame(const WideBvh& tree, const WayIntoTree& way, const Vec3& offset);

/// What a matrix does to lengths.
struct Stretch {
  double greatest = 0;    ///< at least by how much any length grows; infinite
                          ///< where squares leave the doubles
  bool is_equal = false;  ///< every length grows by so much, but for 2⁻³⁸
};

[[nodiscard]] Stretch stretch_of(const Mat3& m);

/// The same of the way from a mesh at the identity into its tree, which only divides by the unit.
[[nodiscard]] Stretch stretch_into(const WideBvh& tree);

}  // namespace toccata
