#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "toccata/shapes/triangle_mesh.hpp"
#include "toccata/trees/wide_bvh.hpp"

namespace toccata {

/// Turned boxes around what the lanes of a block of a wide tree hold, in that tree's units from its origin: lane i lies
/// within centre + Σ αₖ axisₖ with |αₖ| ≤ extentₖ, all taken as real numbers. The first two axes are stored and the
/// third is their cross product in doubles; they are orthonormal up to 2⁻²¹. Within the box |axisₖ · (x − centre)| is
/// at most extentₖ as well.
struct alignas(64) OrientedBlock {
  static constexpr std::size_t width = WideBlock::width;

  std::array<std::array<float, width>, 3> centre;
  std::array<std::array<std::array<float, width>, 3>, 2> axis;
  std::array<std::array<float, width>, 3> extent;
  std::array<std::int32_t, width> child;  ///< as in WideBlock
  std::uint32_t count;

  [[nodiscard]] bool is_item(std::size_t lane) const { return child[lane] < 0; }
};

/// A turned box of its own, to be put into a block.
struct OrientedBox {
  std::array<float, 3> centre{};
  std::array<std::array<float, 3>, 2> axis{{{1, 0, 0}, {0, 1, 0}}};
  std::array<float, 3> extent{};
};

void set_lane(OrientedBlock& block, std::size_t lane, const OrientedBox& box);

/// Boxes for every lane of a mesh's tree, which say more than its straight ones of how near things can be: along the
/// principal axes of the surface that they hold (S. Gottschalk, M. Lin, D. Manocha, "OBBTree", 1996, with the
/// covariance of triangles as GAMMA's erratum has it).
[[nodiscard]] std::vector<OrientedBlock> oriented_boxes(const WideBvh& tree, const TriangleMesh& mesh);

}  // namespace toccata
