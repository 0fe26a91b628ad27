#pragma once

#include <cstddef>
#include <memory>

#include "toccata/methods/bsp_tree.hpp"
#include "toccata/narrow/triangle_triangle.hpp"

namespace toccata {

/// What a tree has become. Its regions have three dimensions (the cells of space), two, one or none, and each point of
/// space lies in exactly one.
struct MspStatistics {
  std::size_t triangles = 0;  ///< of the mesh
  std::size_t planes = 0;     ///< nodes at which a plane cuts space
  std::size_t lines = 0;      ///< nodes at which a line cuts what a plane has within its cell
  std::size_t points = 0;     ///< nodes at which a point cuts what a line has within its cell
  std::size_t faces = 0;      ///< regions that lie on a face of the mesh, of whichever dimension
  std::size_t edges = 0;      ///< on an edge
  std::size_t vertices = 0;   ///< on a vertex: as many as the mesh has at different places
  std::size_t splits = 0;     ///< how often a triangle or what was left of it was cut in two, in space, planes or lines
  std::size_t depth = 0;      ///< most nodes from the root to a region
  std::size_t bytes = 0;      ///< without the model
};

/// Where a point lies, and of a boundary on which vertex, edge or face.
struct MspLocation : PointLocation {
  Index triangle = 0;    ///< the least of those that it lies on; 0 where it lies on none
  Feature feature = {};  ///< what of that triangle it lies on. So edge i leads from its vertex i to (i + 1) % 3
};

/// A multidimensional space partitioning tree of a closed mesh: a BSP tree that partitions its planes again, by lines,
/// and these lines again, by points, so that a point of the boundary too comes to a region of its own, which knows the
/// vertex, edge or face. This is how we read "MSP tree": as the Brep-index of G. Vaněček ("Brep-index: a
/// multidimensional space partitioning tree", International Journal of Computational Geometry & Applications 1, 1991),
/// known to us by its title and idea alone (docs/methods/space-partitions.md#msp-trees).
///
/// At a node the point is in front of a plane, behind it, or in it; in it, it goes on among the nodes of that plane. A
/// line is where another plane cuts that plane, a point where a third one cuts the line: so all that is asked is the
/// side of a plane, an exact sign. In the mesh's own frame. Immutable; copies share all, and any number of threads may
/// ask.
class MspTree {
 public:
  /// Throws Error as the constructor of BspTree does; fragments in planes and on lines count for `max_growth` too.
  explicit MspTree(const Model& solid, const BspOptions& options = {});

  /// The same answer as `locate` of the model, exact: a few comparisons for each level of the tree. Throws Error when
  /// the point is not finite.
  [[nodiscard]] MspLocation locate(const Vec3& point) const;

  [[nodiscard]] const MspStatistics& statistics() const;

  struct Parts;

 private:
  std::shared_ptr<const Parts> parts_;
};

}  // namespace toccata
