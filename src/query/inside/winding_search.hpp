#pragma once

#include <span>

#include "query/inside/winding_entry.hpp"
#include "query/meshes/posed_mesh.hpp"
#include "toccata/query/signed_distance.hpp"
#include "trees/winding_moments.hpp"

namespace toccata {

/// A posed mesh of which winding numbers are asked, and what is the same for all points. The mesh must outlive it.
class WindingSearch {
 public:
  explicit WindingSearch(const PosedMesh& mesh);

  /// The point is finite. Blocks are opened, that of the greatest bound first, until the bounds add up to no more than
  /// the tolerance.
  [[nodiscard]] WindingNumber at(const Vec3& point, double tolerance, WindingEntries& memory) const;

  /// Until it is certain whether it is more than a half in magnitude, or known to 10⁻¹².
  [[nodiscard]] WindingNumber beside_a_half(const Vec3& point, WindingEntries& memory) const;

 private:
  struct Seen;  ///< a point, and what was found around it
  void open(std::size_t block, Seen& seen) const;
  template <class Done>
  [[nodiscard]] WindingNumber search(const Vec3& point, WindingEntries& memory, const Done& done) const;

  const PosedMesh& mesh_;
  const WideBvh& tree_;
  std::span<const WindingMoments> moments_;
  // From the world into the tree's units, up to rounding and up to what the pose deforms.
  Mat3 back_;
  Vec3 world_middle_;
  double turned_ = 1;           ///< −1 for a pose that mirrors
  double off_ = 0;              ///< how far points in the tree's units may be from where they should be: this,
  double off_by_distance_ = 0;  ///< and that for each unit of the world from the middle
  bool rigid_ = false;          ///< else every triangle is asked
};

}  // namespace toccata
