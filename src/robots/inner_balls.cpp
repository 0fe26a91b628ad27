#include "robots/inner_balls.hpp"

#include <algorithm>
#include <cmath>

#include "query/posed_shape.hpp"
#include "toccata/query/signed_distance.hpp"

namespace toccata {
namespace {

constexpr std::size_t most_balls = 6;
constexpr int places_along = 9;             ///< of the longest side of the box, at the middles of so many cells
constexpr double least_beside_first = 0.4;  ///< smaller ones are hardly ever met alone

/// Distances are certain, and poses are rotations, to far less than this.
constexpr double certain_share = 1 - 0x1p-20;

/// The middles of the cells of a grid over the box.
std::vector<Vec3> places_in(const Aabb& box) {
  const Vec3 size = box.upper - box.lower;
  const double cell = std::max({size.x, size.y, size.z}) / places_along;
  const auto count = [&](int axis) {
    return std::clamp(static_cast<int>(std::ceil(size[axis] / cell)), 1, places_along);
  };
  std::vector<Vec3> places;
  for (int i = 0; i < count(0); ++i)
    for (int j = 0; j < count(1); ++j)
      for (int k = 0; k < count(2); ++k) {
        const auto at = [&](int axis, int n) { return box.lower[axis] + (n + 0.5) / count(axis) * size[axis]; };
        places.push_back({at(0, i), at(1, j), at(2, k)});
      }
  return places;
}

/// The largest first, then the largest of those whose middles are outside of all so far.
std::vector<Ball> spread_out(std::vector<Ball> balls) {
  std::stable_sort(balls.begin(), balls.end(), [](const Ball& x, const Ball& y) { return x.radius > y.radius; });
  std::vector<Ball> chosen;
  for (const Ball& ball : balls) {
    if (chosen.size() == most_balls || (!chosen.empty() && ball.radius < least_beside_first * chosen[0].radius)) break;
    const bool is_apart =
        std::ranges::all_of(chosen, [&](const Ball& c) { return length(ball.centre - c.centre) > 0.8 * c.radius; });
    if (is_apart) chosen.push_back(ball);
  }
  return chosen;
}

}  // namespace

std::vector<Ball> inner_balls(const Model& model, const Pose& pose, Solid solid) {
  const bool is_solid_mesh = model.has_mesh() && taken_as_solid(model, solid) && !is_singular(pose.linear);
  if (!is_solid_mesh) return {};
  const Aabb box = world_box(pose_model(model, pose, solid, "a solid"));
  if (is_empty(box) || !(length(box.upper - box.lower) < 0x1p400) || box.lower == box.upper) return {};
  std::vector<Ball> balls;
  const std::vector<Vec3> places = places_in(box);
  const std::vector<SignedDistance> distances =
      signed_distance_each(places, model, pose, SignBy::winding_number, {.threads = own_thread});
  for (std::size_t i = 0; i < places.size(); ++i)
    if (distances[i].status == Status::exact && distances[i].upper < 0)
      balls.push_back({places[i], -certain_share * distances[i].upper});
  return spread_out(std::move(balls));
}

}  // namespace toccata
