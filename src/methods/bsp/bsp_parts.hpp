#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "math/floats.hpp"
#include "methods/bsp/bsp_fragments.hpp"
#include "methods/bsp/bsp_planes.hpp"
#include "toccata/core/function_ref.hpp"
#include "toccata/methods/bsp_tree.hpp"

namespace toccata {

/// A node's child: another node by its number, or a cell that is not cut, whose winding number w is kept as
/// -1 - 2w for w ≥ 0 and 2w for others: all numbers below 0 in turn.
using BspChild = std::int32_t;

[[nodiscard]] constexpr bool is_leaf(BspChild child) { return child < 0; }
[[nodiscard]] constexpr BspChild leaf_of_winding(int winding) { return winding >= 0 ? -1 - 2 * winding : 2 * winding; }
[[nodiscard]] constexpr int winding_of_leaf(BspChild leaf) { return leaf % 2 == 0 ? leaf / 2 : (-1 - leaf) / 2; }

/// A plane for floats, which take half the memory: questions about points are answered mostly from these alone.
///
/// The proof, for ε = 2^-24, with S the sum of |n| over the axes, |q| ≤ 1, and the offset at most S but for the bound:
/// rounding normal, place and offset costs 3εS, four roundings of each product 4εS, and that of the difference 2εS;
/// second orders and what the bound of the double plane allows for are less than another εS. So 16εS, rounded upwards,
/// is enough, beside the bound of the plane of doubles; `least` is more than what underflow can lose.
struct FloatBspPlane {
  std::array<float, 3> normal{};
  float offset = 0;
  float bound = infinite_float;

  static constexpr double share = 0x1p-20;
  static constexpr double least = 0x1p-120;

  [[nodiscard]] float height(const std::array<float, 3>& place) const {
    return ((normal[0] * place[0] + normal[1] * place[1]) + normal[2] * place[2]) - offset;
  }
};

[[nodiscard]] FloatBspPlane as_floats(const RoundedBspPlane& plane);

struct alignas(32) BspNode {
  FloatBspPlane floats;
  std::array<BspChild, 2> child{};  ///< behind the plane, in front of it
  BspPlane plane = 0;

  [[nodiscard]] BspChild back() const { return child[0]; }
  [[nodiscard]] BspChild front() const { return child[1]; }
};

/// A fragment that lies in a node's plane; its corners go on to those of the next.
struct StoredFragment {
  Index triangle = 0;
  Index first_corner = 0;
};

struct BspTree::Parts {
  explicit Parts(const Model& solid);
  Parts(const Parts&) = delete;
  Parts& operator=(const Parts&) = delete;

  [[nodiscard]] std::span<const StoredFragment> fragments_of(BspChild node) const {
    const auto i = static_cast<std::size_t>(node);
    return std::span(fragments).subspan(first_fragment[i], first_fragment[i + 1] - first_fragment[i]);
  }

  Model model;
  BspFrame frame;
  BspPlanes planes;
  std::vector<BspNode> nodes;             ///< the first is the root
  std::vector<Index> first_fragment;      ///< of each node, and the end of all
  std::vector<StoredFragment> fragments;  ///< in the order of the nodes; one more, for its first_corner
  std::vector<Vec3> corners;              ///< in the frame of the mesh, rounded
  BspStatistics statistics;
};

/// Throws Error that names it.
void require_finite_point(const Vec3& p);

/// Throws Error as the constructor of BspTree does.
void require_solid_for_bsp(const Model& solid);

/// A node whose plane has just cut its cell.
struct CutBspCell {
  std::size_t node = 0;
  std::size_t depth = 0;                   ///< nodes above it
  std::span<const PooledFragment> within;  ///< what of the surface lies in the plane, within the cell
};

class BspChoice;

/// Is told each node, and may cut further what is within its plane; what it puts into the pool it takes out again.
using BspCellVisitor = FunctionRef<void(const CutBspCell&, BspFragments&, BspChoice&)>;

/// The tree of a closed mesh that does not intersect itself and has no triangle without area.
void build_bsp(BspTree::Parts& parts, const BspOptions& options, BspCellVisitor visit);

/// Throws Error when a tree of so many triangles has come to more fragments than `max_growth` allows.
void require_growth_allowed(double fragments, Index triangles, const BspOptions& options);

/// Throws Error for options that are not positive.
void require_possible(const BspOptions& options);

}  // namespace toccata
