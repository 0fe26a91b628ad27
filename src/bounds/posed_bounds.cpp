#include "bounds/posed_bounds.hpp"

namespace toccata {

// With ε = 2⁻⁵³: the transform rounds by less than 5ε of the sum of magnitudes; the direction Rᵀn by less than 4ε of
// Σ_i |n_i| |R_ij|, times at most 2 |x_j|. Together 13ε, where 128ε is taken: the rest is for the questions that are
// asked of the posed volume with rounding of their own. Products below the range lose 2⁻¹⁰⁷⁴, times a coordinate.
Vec3 posing_slack(const Pose& pose, const Aabb& box) {
  Vec3 slack;
  for (int i = 0; i < 3; ++i) {
    double sum = std::fabs(pose.offset[i]);
    for (int j = 0; j < 3; ++j) {
      const double x = std::max(std::fabs(box.lower[j]), std::fabs(box.upper[j]));
      sum += (std::fabs(pose.linear[i][j]) + 0x1p-1000) * x;
    }
    slack[i] = 0x1p-46 * sum + 0x1p-1060;
  }
  return slack;
}

double stretch_bound(const Mat3& linear) {
  const double size =
      std::max({largest_magnitude(linear[0]), largest_magnitude(linear[1]), largest_magnitude(linear[2])});
  if (size == 0) return 0;
  // |R|² ≤ ‖RᵀR‖∞, the largest row sum of magnitudes.
  double largest = 0;
  for (int i = 0; i < 3; ++i) {
    double row = 0;
    for (int j = 0; j < 3; ++j) {
      const Vec3 p = linear.column(i), q = linear.column(j);
      UpperSum product;
      for (int k = 0; k < 3; ++k) product.add(p[k] / size, q[k] / size);
      row += product.magnitude_bound();
    }
    largest = std::max(largest, row);
  }
  return rounded_up(size * std::sqrt(largest));
}

}  // namespace toccata
