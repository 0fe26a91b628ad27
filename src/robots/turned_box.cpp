#include "robots/turned_box.hpp"

#include <algorithm>
#include <cmath>
#include <variant>

#include "math/constants.hpp"
#include "math/vec3_measures.hpp"
#include "query/posed_shape.hpp"

namespace toccata {
namespace {

/// Poses that a shape with a radius may have shrink its box by less than this.
constexpr double most_shrunk = 0x1p-8;

/// Roundings of poses, of boxes and of what compares these are far below it.
constexpr double box_slack = 0x1p-38;

/// At least the sum of the magnitudes of the numbers that are added up where a model is placed; the parts of a compound
/// are placed in it first.
double placed_magnitude(const Model& model) {
  const auto* compound = std::get_if<Compound>(&model.shape());
  if (compound == nullptr) {
    const Aabb box = world_box(pose_shape(model, {}, Solid::none, "a link's shape"));
    return sum_of_magnitudes(box.lower) + sum_of_magnitudes(box.upper);
  }
  double magnitude = 0;
  for (std::size_t i = 0; i < model.parts().size(); ++i) {
    const Pose& pose = compound->parts()[i].pose;
    double stretch = 0;
    for (int row = 0; row < 3; ++row) stretch = std::max(stretch, sum_of_magnitudes(pose.linear[row]));
    magnitude = std::max(magnitude, stretch * placed_magnitude(model.parts()[i]) + sum_of_magnitudes(pose.offset));
  }
  return magnitude;
}

double sum_across(const std::array<Vec3, 3>& edges, const Vec3& direction) {
  return std::fabs(dot(edges[0], direction)) + std::fabs(dot(edges[1], direction)) +
         std::fabs(dot(edges[2], direction));
}

bool is_right_angled(const TurnedBox& box) {
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3 &x = box.edges[i], &y = box.edges[(i + 1) % 3];
    if (std::fabs(dot(x, y)) > 0x1p-24 * std::sqrt(dot(x, x) * dot(y, y))) return false;
  }
  return true;
}

}  // namespace

LocalBox local_box(const Model& model) {
  const Aabb box = world_box(pose_model(model, {}, Solid::automatic, "a link's shape"));
  if (is_empty(box)) return {};
  const double magnitude = placed_magnitude(model);
  if (!(magnitude < 0x1p400)) return {{}, {}, infinity};
  const Vec3 half = 0.5 * (box.upper - box.lower);
  return {0.5 * (box.lower + box.upper), (1 + most_shrunk) * half, magnitude};
}

TurnedBox turned_box(const LocalBox& box, const Pose& pose) {
  TurnedBox turned;
  turned.centre = transform(pose, box.centre);
  double size = sum_of_magnitudes(pose.offset);
  for (std::size_t i = 0; i < 3; ++i) {
    turned.axes[i] = pose.linear.column(static_cast<int>(i));
    turned.edges[i] = box.half[static_cast<int>(i)] * turned.axes[i];
    size += sum_of_magnitudes(turned.axes[i]) * box.magnitude;
  }
  turned.slack = size < 0x1p400 ? box_slack * size : infinity;
  return turned;
}

double radius_around(const TurnedBox& box) {
  double squared = 0;
  for (const Vec3& edge : box.edges) squared += dot(edge, edge);
  // Edges that are not at right angles reach at most √3 times as far.
  // Squares of edges below 2⁻⁵³⁷ vanish.
  return (is_right_angled(box) ? 1 + 0x1p-20 : 1.7320509) * std::sqrt(squared) + box.slack + 0x1p-530;
}

Aabb box_around(const TurnedBox& box) {
  if (std::isinf(box.slack)) return {{-infinity, -infinity, -infinity}, {infinity, infinity, infinity}};
  Aabb around;
  for (int i = 0; i < 3; ++i) {
    const double half = (std::fabs(box.edges[0][i]) + std::fabs(box.edges[1][i])) + std::fabs(box.edges[2][i]);
    around.lower[i] = box.centre[i] - (half + 2 * box.slack);
    around.upper[i] = box.centre[i] + (half + 2 * box.slack);
  }
  return around;
}

bool certainly_apart(const TurnedBox& a, const TurnedBox& b, double by) {
  const double margin = by + a.slack + b.slack, squared = (1 + 0x1p-40) * margin * margin;
  const Vec3 between = b.centre - a.centre;
  const auto parts = [&](const Vec3& direction) {
    const double gap =
        std::fabs(dot(between, direction)) - sum_across(a.edges, direction) - sum_across(b.edges, direction);
    return gap > 0 && gap * gap > squared * dot(direction, direction);
  };
  for (const TurnedBox* box : {&a, &b})
    for (const Vec3& axis : box->axes)
      if (parts(axis)) return true;
  for (const Vec3& axis_a : a.axes)
    for (const Vec3& axis_b : b.axes)
      if (parts(cross(axis_a, axis_b))) return true;
  return false;
}

}  // namespace toccata
