#include <tuple>

#include "core/require_length.hpp"
#include "query/keep_least.hpp"
#include "robots/each_configuration.hpp"
#include "robots/placed_robot.hpp"
#include "robots/scene_made.hpp"
#include "toccata/robots/robot_scene.hpp"

namespace toccata {
namespace {

/// Looks for the least distance of a robot at its place.
class NearestRobotPair {
 public:
  NearestRobotPair(PlacedRobot& placed, double max_distance)
      : placed_(placed), scene_(placed.scene()), max_distance_(max_distance) {}

  std::optional<RobotDistance> found() {
    for (const SelfPair& self : scene_.self_pairs) look_at(self.pair);
    for (Index body = 0; body < scene_.robot.bodies().size(); ++body)
      scene_.nearest_parts.visit_nearest(box_around(placed_.box(body)), limit(), [&](Index part) {
        if (!scene_.is_allowed(body, part)) look_at({body, true, part});
        return limit();
      });
    if (least_) add_gradient(*least_);
    return least_;
  }

 private:
  [[nodiscard]] double limit() const { return last_distance(least_, max_distance_); }

  void look_at(const RobotBodyPair& pair) {
    if (placed_.certainly_apart(pair, limit()) || (least_ && placed_.hull_gap(pair, limit()) > limit())) return;
    const std::optional<Nearby> near = placed_.nearby(pair, {.limit = limit()});
    if (near && near->is_within) keep({scene_.contact_of(pair), near->distance, pair.body, other_body_of(pair), {}});
  }

  static Index other_body_of(const RobotBodyPair& pair) { return pair.with_part ? 0 : pair.other; }

  void keep(const RobotDistance& found) {
    keep_least(least_, found, [](const RobotDistance& d) {
      return std::tie(d.distance.upper, d.pair, d.body, d.other_body, d.distance.element_b);
    });
  }

  void add_gradient(RobotDistance& found) const {
    found.gradient.assign(scene_.robot.positions().size(), 0);
    const Distance& distance = found.distance;
    const Vec3 normal = distance.upper > 0 ? normalized(distance.on_a - distance.on_b) : Vec3{};
    if (normal == Vec3{}) return;
    add_motion(found.body, distance.on_a, normal, found.gradient);
    if (!found.pair.with_obstacle) add_motion(found.other_body, distance.on_b, -normal, found.gradient);
  }

  /// How fast a point of the body goes along a direction when each of the positions changes.
  void add_motion(Index body, const Vec3& point, const Vec3& along, std::vector<double>& gradient) const {
    for (const Index number : scene_.body_frames[body]) {
      const RobotFrame& frame = scene_.robot.tree().frames[number];
      if (frame.motion == RobotFrame::Motion::none) continue;
      const Pose& pose = placed_.frames()[number];
      const Vec3 axis = pose.linear * frame.axis;
      const Vec3 velocity = frame.motion == RobotFrame::Motion::turn ? cross(axis, point - pose.offset) : axis;
      gradient[frame.position] += frame.multiplier * dot(along, velocity);
    }
  }

  PlacedRobot& placed_;
  const RobotScene::Made& scene_;
  double max_distance_;
  std::optional<RobotDistance> least_;
};

}  // namespace

std::optional<RobotDistance> RobotScene::distance(std::span<const double> configuration, double max_distance) const {
  require_length(max_distance, "the greatest distance");
  return of_configuration(*made_, configuration,
                          [&](PlacedRobot& placed) { return NearestRobotPair(placed, max_distance).found(); });
}

std::vector<std::optional<RobotDistance>> RobotScene::distance_each(std::span<const double> configurations,
                                                                    double max_distance,
                                                                    const BatchOptions& options) const {
  require_length(max_distance, "the greatest distance");
  return of_each_configuration<std::optional<RobotDistance>>(*made_, configurations, options, [&](PlacedRobot& placed) {
    return NearestRobotPair(placed, max_distance).found();
  });
}

}  // namespace toccata
