#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "motion/moving_part.hpp"
#include "toccata/shapes/shape.hpp"

namespace toccata {

/// What of a body is swept as one convex set: a convex shape, or the hull of the triangles below a node of a mesh's
/// tree. In the frame of the part of the body that it belongs to.
struct ConvexCluster {
  const MovingPart* part = nullptr;
  std::vector<Vec3> corners;
  double radius = 0;               ///< around the hull of the corners
  double excess = 0;               ///< no point of it is farther from the shape, in world units
  double spread = 0;               ///< the diagonal of the box of its corners, at the start
  std::vector<Index> triangles{};  ///< of a mesh
  std::optional<Index> node{};     ///< of the mesh's tree
};
using SharedCluster = std::shared_ptr<const ConvexCluster>;

/// The clusters of a part from which refining begins: one. Not for half-spaces.
[[nodiscard]] SharedCluster whole_cluster(const MovingPart& part);

/// The clusters of the children of its node, or its triangles; none for what is one convex shape.
[[nodiscard]] std::vector<SharedCluster> finer_clusters(const ConvexCluster& cluster);

/// A cluster in a stretch of time, and the hull of both ends that contains what it passes there.
struct SweptCell {
  SharedCluster cluster;
  TimeStretch stretch;
  /// How all of it moves, when it has moved by nothing else before: without a turn, from where it was posed.
  std::optional<Vec3> translation{};
  double bow = 0;    ///< no point leaves the chord between its places at both ends by more
  double shear = 0;  ///< no point of the hull of two such chords is farther from what is passed, beyond the bow
  double pad = 0;    ///< poses are no farther off

  [[nodiscard]] double excess_in_time() const { return 2 * (bow + pad) + shear; }
  [[nodiscard]] double excess() const { return cluster->excess + excess_in_time(); }
};

/// `piece`: of the motion, that which the stretch is of; null of a function.
[[nodiscard]] SweptCell swept_cell(const SharedCluster& cluster, const TimeStretch& stretch,
                                   const RigidMotion::Piece* piece);

/// The set in the world, and how far outside of what is passed it may reach.
struct SweptHull {
  Shape shape;
  double excess = 0;
};
[[nodiscard]] SweptHull hull_of(const SweptCell& cell);

}  // namespace toccata
