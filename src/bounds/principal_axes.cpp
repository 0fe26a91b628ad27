#include "toccata/bounds/obb.hpp"

#include <cmath>
#include <vector>

#include "bounds/point_clouds.hpp"
#include "toccata/math/mat3.hpp"

namespace toccata {
namespace {

/// Σ weight, Σ weight · x, and Σ weight · x xᵀ (its upper triangle).
struct Moments {
  double weight = 0;
  Vec3 first;
  Mat3 second{{Vec3{}, Vec3{}, Vec3{}}};

  void add_second(double factor, const Vec3& x) {
    for (int i = 0; i < 3; ++i) second[i] = second[i] + (factor * x[i]) * x;
  }
  void add_point(const Vec3& x) {
    weight += 1;
    first = first + x;
    add_second(1, x);
  }
  void add_surface(const Vec3& p, const Vec3& q, const Vec3& r) {
    const Vec3 normal = cross(q - p, r - p), middle = (1.0 / 3) * ((p + q) + r);
    const double area = 0.5 * std::sqrt(dot(normal, normal));
    weight += area;
    first = first + area * middle;
    add_second(9 * area / 12, middle);
    for (const Vec3& corner : {p, q, r}) add_second(area / 12, corner);
  }
};

PrincipalAxes axes_of(const Moments& moments, const CloudScale& scaled) {
  if (!(moments.weight > 0)) return {};
  const Vec3 mean = (1 / moments.weight) * moments.first;
  Mat3 covariance;
  for (int i = 0; i < 3; ++i) covariance[i] = (1 / moments.weight) * moments.second[i] - mean[i] * mean;
  const SymmetricEigen eigen = symmetric_eigen(covariance);
  // Rounding may leave a variance of zero a little below it.
  const auto deviation = [&](double variance) { return std::sqrt(std::max(variance, 0.0)) / scaled.factor; };
  return {
      scaled.back(mean), eigen.axes, {deviation(eigen.values.x), deviation(eigen.values.y), deviation(eigen.values.z)}};
}

}  // namespace

PrincipalAxes principal_axes(std::span<const Vec3> points) {
  const CloudScale scaled(checked_box(points));
  Moments moments;
  for (const Vec3& p : points) moments.add_point(scaled(p));
  return axes_of(moments, scaled);
}

PrincipalAxes principal_axes(std::span<const Triangle> triangles) {
  const std::vector<Vec3> corners = corners_of(triangles);
  const CloudScale scaled(checked_box(corners));
  Moments moments;
  for (const Triangle& t : triangles) moments.add_surface(scaled(t[0]), scaled(t[1]), scaled(t[2]));
  return moments.weight > 0 ? axes_of(moments, scaled) : principal_axes(corners);
}

}  // namespace toccata
