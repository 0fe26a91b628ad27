#pragma once

#include <optional>
#include <span>
#include <vector>

#include "methods/bsp/bsp_fragments.hpp"
#include "toccata/core/function_ref.hpp"
#include "toccata/methods/bsp_tree.hpp"

namespace toccata {

/// Chooses the plane that cuts a cell: of some triangles' planes, and one across each axis, the one with the least
/// |front − back| + split_weight · cut, counted over a sample of what is in the cell. All by rounded numbers, in a
/// fixed order: it is not what the tree's answers rest on, and the same for the same mesh.
class BspChoice {
 public:
  BspChoice(const BspFrame& frame, BspPlanes& planes, const BspFragments& fragments, const BspOptions& options)
      : frame_(frame), planes_(planes), fragments_(fragments), options_(options) {}

  /// The plane with which a fragment would cut its cell.
  using Candidate = FunctionRef<BspPlane(const PooledFragment&)>;

  /// The candidate of a fragment in the cell, or a plane across an axis, beyond which on both sides is something.
  [[nodiscard]] BspPlane of(std::span<const PooledFragment> cell, Candidate candidate);

 private:
  struct Counts {
    std::size_t front = 0;
    std::size_t back = 0;
    std::size_t cut = 0;
  };
  void take_sample(std::span<const PooledFragment> cell);
  [[nodiscard]] Counts counted(const RoundedBspPlane& plane) const;
  [[nodiscard]] double score(const Counts& counts) const;
  [[nodiscard]] std::optional<double> axis_score(const AxisPlane& plane) const;
  [[nodiscard]] AxisPlane middle_across(int axis);
  [[nodiscard]] double coordinate(const PooledFragment& fragment, int axis) const;

  const BspFrame& frame_;
  BspPlanes& planes_;
  const BspFragments& fragments_;
  const BspOptions& options_;
  std::vector<PooledFragment> sample_;
  std::vector<double> coordinates_;
};

}  // namespace toccata
