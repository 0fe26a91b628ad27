#include "methods/bsp/bsp_bevels.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace toccata {
namespace {

/// So many of the planes around a cell are combined: those nearest to the leaf of the tree.
constexpr std::size_t most_combined = 8;

/// Planes that the shape is somewhere beyond: with the others alone it would be in the cell all the time.
std::vector<BspSide> sides_in_reach(const BspSweep& sweep, const BspStretch& in_cell) {
  std::vector<BspSide> all = sweep.sides_of_cell();
  std::reverse(all.begin(), all.end());
  std::vector<BspSide> near;
  for (const BspSide& side : all)
    if (near.size() < most_combined && sweep.heights(side).side(in_cell) != Sign::negative) near.push_back(side);
  return near;
}

/// Cuts a stretch by sums of planes, as long as something is left of it.
template <std::size_t count>
class SumOfSides {
 public:
  using Sides = std::array<const BspSide*, count>;
  using Weights = std::array<double, count>;

  SumOfSides(const BspSweep& sweep, const Sides& sides) : sweep_(sweep), sides_(sides) {}

  /// The greatest weight is made 1, so that nothing underflows that matters; none where the others are not numbers.
  void cut(BevelledStretch& bevelled, Weights weights) const {
    const double greatest = *std::max_element(weights.begin(), weights.end());
    if (!(greatest > 0x1p-500) || !(greatest < 0x1p500) || bevelled.stretch.is_empty()) return;
    BspSide sum;
    for (std::size_t i = 0; i < count; ++i) {
      const double weight = weights[i] / greatest;
      sum.normal += weight * sides_[i]->normal;
      sum.offset += weight * sides_[i]->offset;
      sum.bound += weight * sides_[i]->bound;
      sum.slope += weight * sides_[i]->slope;
    }
    const BspHeights heights = sweep_.heights(sum);
    const BspStretch before = bevelled.stretch;
    bevelled.stretch = heights.side(before) == Sign::positive ? nothing : heights.behind(before);
    if (bevelled.stretch.from > before.from) bevelled.normal = sum.normal;
  }

  void cut_by_unit_normals(BevelledStretch& bevelled) const {
    Weights weights;
    for (std::size_t i = 0; i < count; ++i) weights[i] = 1 / plain_length(sides_[i]->normal);
    cut(bevelled, weights);
  }

  /// If they are all of one sign: of which sign does not matter.
  void cut_with_one_sign(BevelledStretch& bevelled, Weights weights) const {
    const bool none_below = std::all_of(weights.begin(), weights.end(), [](double w) { return w >= 0; });
    const bool none_above = std::all_of(weights.begin(), weights.end(), [](double w) { return w <= 0; });
    if (!none_below && !none_above) return;
    for (double& weight : weights) weight = std::fabs(weight);
    cut(bevelled, weights);
  }

 private:
  static constexpr BspStretch nothing{0, -1, 1, 0};

  const BspSweep& sweep_;
  Sides sides_;
};

void cut_along_edge(const BspSweep& sweep, const BspSide& p, const BspSide& q, BevelledStretch& bevelled) {
  const SumOfSides<2> sums(sweep, {&p, &q});
  sums.cut_by_unit_normals(bevelled);
  for (int axis = 0; axis < 3; ++axis) sums.cut_with_one_sign(bevelled, {-q.normal[axis], p.normal[axis]});
}

void cut_at_corner(const BspSweep& sweep, const BspSide& p, const BspSide& q, const BspSide& r,
                   BevelledStretch& bevelled) {
  const SumOfSides<3> sums(sweep, {&p, &q, &r});
  sums.cut_by_unit_normals(bevelled);
  const Vec3 qr = cross(q.normal, r.normal), rp = cross(r.normal, p.normal), pq = cross(p.normal, q.normal);
  // By Cramer's rule their sum is the axis, times the determinant.
  for (int axis = 0; axis < 3; ++axis) sums.cut_with_one_sign(bevelled, {qr[axis], rp[axis], pq[axis]});
}

}  // namespace

BevelledStretch narrowed_by_bevels(const BspSweep& sweep, const BspStretch& in_cell) {
  const std::vector<BspSide> sides = sides_in_reach(sweep, in_cell);
  BevelledStretch bevelled{in_cell};
  for (std::size_t i = 0; i < sides.size(); ++i)
    for (std::size_t j = 0; j < i && !bevelled.stretch.is_empty(); ++j)
      cut_along_edge(sweep, sides[i], sides[j], bevelled);
  for (std::size_t i = 0; i < sides.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      for (std::size_t k = 0; k < j && !bevelled.stretch.is_empty(); ++k)
        cut_at_corner(sweep, sides[i], sides[j], sides[k], bevelled);
  return bevelled;
}

}  // namespace toccata
