#include "robots/placed_robot.hpp"

#include <algorithm>

#include "query/part_questions.hpp"
#include "query/search_scratch.hpp"

namespace toccata {
namespace {

/// More than what doubles round of places and lengths, beside the slack of boxes.
bool meets_ball(const Ball& a, const Ball& b) {
  const Vec3 between = b.centre - a.centre;
  const double reach = (a.radius + b.radius) * (1 - 0x1p-20);
  return reach > 0 && dot(between, between) < reach * reach;
}

/// Whether a ball certainly meets a box or another ball; nothing is told of other shapes.
bool meets_convex(const Ball& ball, const PosedPolytope& convex) {
  if (convex.vertex_count() == 1) return meets_ball(ball, {convex.vertex(0), convex.radius()});
  const RigidBox& box = convex.as_box();
  if (!(box.slack < ball.radius) || !(box.skew < 0x1p-30)) return false;
  const Vec3 from = transpose(convex.pose().linear) * (ball.centre - box.centre);
  Vec3 nearest = from;
  for (int axis = 0; axis < 3; ++axis)
    nearest[axis] = std::clamp(from[axis], -box.half_extents[axis], box.half_extents[axis]);
  return meets_ball({from, ball.radius - box.slack}, {nearest, 0});
}

}  // namespace

PlacedRobot::PlacedRobot(const RobotScene::Made& scene) : scene_(scene) {
  const std::size_t count = scene.robot.bodies().size();
  boxes_.resize(count);
  posed_.resize(count);
  is_posed_.resize(count);
  hulls_.resize(count);
}

void PlacedRobot::place(std::span<const double> configuration) {
  const Robot::Tree& tree = scene_.robot.tree();
  place_frames(tree, configuration, frames_);
  for (std::size_t i = 0; i < boxes_.size(); ++i) {
    const Robot::Body& body = tree.bodies[i];
    const Pose& link = frames_[tree.frame_of_link[body.link]];
    const LocalBox& box = scene_.body_boxes[i];
    boxes_[i] = scene_.body_is_link[i] != 0 ? turned_box(box, link) : turned_box(box, link * body.pose);
    is_posed_[i] = 0;
    hulls_[i].reset();
  }
}

bool PlacedRobot::certainly_apart(const RobotBodyPair& pair, double by) const {
  const TurnedBox &box = boxes_[pair.body], &other = box_of_other(pair);
  const double radius_of_other = pair.with_part ? scene_.part_radius[pair.other] : scene_.body_radius[pair.other];
  const double margin = by + (scene_.body_radius[pair.body] + radius_of_other) + (box.slack + other.slack);
  const Vec3 between = other.centre - box.centre;
  return dot(between, between) > (1 + 0x1p-40) * margin * margin || toccata::certainly_apart(box, other, by);
}

std::span<const PosedPart> PlacedRobot::posed(Index number) {
  PosedModel& posed = posed_[number];
  if (is_posed_[number] == 0) {
    const Robot::Tree& tree = scene_.robot.tree();
    const Robot::Body& body = tree.bodies[number];
    const Pose pose = frames_[tree.frame_of_link[body.link]] * body.pose;
    posed = pose_model(body.model, pose, body.solid, body.name, std::move(posed.parts));
    is_posed_[number] = 1;
  }
  return posed.parts;
}

std::span<const PosedPart> PlacedRobot::posed_other(const RobotBodyPair& pair) {
  return pair.with_part ? std::span(scene_.parts).subspan(pair.other, 1) : posed(pair.other);
}

const PosedPolytope* PlacedRobot::convex_around(Index number) {
  if (const std::optional<ConvexHull>& hull = scene_.body_hulls[number]) {
    const Robot::Tree& tree = scene_.robot.tree();
    const Robot::Body& body = tree.bodies[number];
    if (!hulls_[number]) hulls_[number].emplace(*hull, frames_[tree.frame_of_link[body.link]] * body.pose);
    return &*hulls_[number];
  }
  const std::span<const PosedPart> parts = posed(number);
  return parts.size() == 1 ? std::get_if<PosedPolytope>(&parts[0].shape) : nullptr;
}

bool PlacedRobot::has_hull(const RobotBodyPair& pair) const {
  return scene_.body_hulls[pair.body] ||
         (pair.with_part ? scene_.part_hulls[pair.other] : scene_.body_hulls[pair.other]);
}

double PlacedRobot::hull_gap(const RobotBodyPair& pair, double enough, SimplexCache* kept) {
  const PosedPolytope* other = pair.with_part ? scene_.convex_around(pair.other) : convex_around(pair.other);
  const PosedPolytope* body = other == nullptr ? nullptr : convex_around(pair.body);
  if (body == nullptr) return 0;
  // World vertices of a mesh are off from the hull of some of them by what they are rounded.
  const double slack = boxes_[pair.body].slack + box_of_other(pair).slack;
  return std::max(0.0, certain_gap(*body, *other, (enough + slack) * (1 + 0x1p-40), kept).length - slack);
}

bool PlacedRobot::overlap(const RobotBodyPair& pair) {
  const std::span<const PosedPart> parts_a = posed(pair.body), parts_b = posed_other(pair);
  for (const PosedPart& a : parts_a)
    for (const PosedPart& b : parts_b) {
      workspace_.scratch().convex = {};  // it was another pair's
      if (parts_overlap(a, b, workspace_.scratch())) return true;
    }
  return false;
}

std::optional<Nearby> PlacedRobot::nearby(const RobotBodyPair& pair, const WantedDistance& wanted) {
  const std::span<const PosedPart> parts_a = posed(pair.body), parts_b = posed_other(pair);
  std::optional<Nearby> nearest;
  for (const PosedPart& a : parts_a)
    for (const PosedPart& b : parts_b) {
      workspace_.scratch().convex = {};
      const std::optional<Nearby> near = toccata::nearby(a, b, wanted, workspace_.scratch());
      if (!near) continue;
      const double lower = nearest ? std::min(nearest->distance.lower, near->distance.lower) : near->distance.lower;
      const bool is_within = near->is_within || (nearest && nearest->is_within);
      if (!nearest || near->distance.upper < nearest->distance.upper) nearest = near;
      nearest->distance.lower = lower;
      nearest->is_within = is_within;
    }
  return nearest;
}

bool PlacedRobot::certainly_meet(const RobotBodyPair& pair) const {
  const auto& bodies = scene_.robot.bodies();
  const double slack = boxes_[pair.body].slack + box_of_other(pair).slack;
  const auto frame_of = [&](Index body) -> const Pose& {
    return frames_[scene_.robot.tree().frame_of_link[bodies[body].link]];
  };
  const Pose& pose = frame_of(pair.body);
  const std::vector<Ball>& others = pair.with_part ? scene_.part_balls[pair.other] : scene_.body_balls[pair.other];
  const PosedPolytope* convex = pair.with_part ? std::get_if<PosedPolytope>(&scene_.parts[pair.other].shape) : nullptr;
  return std::ranges::any_of(scene_.body_balls[pair.body], [&](const Ball& ball) {
    const Ball placed{transform(pose, ball.centre), ball.radius - slack};
    if (convex != nullptr) return meets_convex(placed, *convex);
    return std::ranges::any_of(others, [&](const Ball& other) {
      return meets_ball(placed,
                        pair.with_part ? other : Ball{transform(frame_of(pair.other), other.centre), other.radius});
    });
  });
}

bool PlacedRobot::are_met(const RobotBodyPair& pair) {
  if (certainly_apart(pair, 0)) return false;
  return certainly_meet(pair) || ((!has_hull(pair) || hull_gap(pair, 0) == 0) && overlap(pair));
}

bool PlacedRobot::are_met_within_hulls(const RobotBodyPair& pair) { return certainly_meet(pair) || overlap(pair); }

/// Whether the pair certainly meets. Where that is not known, and neither that it is apart, it waits.
bool PlacedRobot::meets_at_sight(const RobotBodyPair& pair) {
  if (certainly_apart(pair, 0)) return false;
  if (certainly_meet(pair)) {
    met_last_ = pair;
    return true;
  }
  waiting_.push_back(pair);
  return false;
}

bool PlacedRobot::body_meets_at_sight(Index body) {
  bool meets = false;
  scene_.part_tree.visit_near(boxes_[body], 0, [&](Index part) {
    meets = !scene_.is_allowed(body, part) && meets_at_sight({body, true, part});
    return !meets;
  });
  return meets;
}

bool PlacedRobot::meets_after_waiting(const RobotBodyPair& pair) {
  if ((has_hull(pair) && hull_gap(pair, 0) > 0) || !overlap(pair)) return false;
  met_last_ = pair;
  return true;
}

bool PlacedRobot::meets() {
  if (!scene_.contacts_at_rest.empty()) return true;
  if (met_last_ && are_met(*met_last_)) return true;
  waiting_.clear();
  for (std::size_t i = boxes_.size(); i-- > 0;)  // those far out move most, and meet most
    if (scene_.body_rests[i] == 0 && body_meets_at_sight(static_cast<Index>(i))) return true;
  if (std::ranges::any_of(scene_.self_pairs, [&](const SelfPair& self) { return meets_at_sight(self.pair); }))
    return true;
  return std::ranges::any_of(waiting_, [&](const RobotBodyPair& pair) { return meets_after_waiting(pair); });
}

std::vector<RobotContact> PlacedRobot::contacts(ContactsTold told) {
  struct Candidate {
    RobotContact contact;
    RobotBodyPair pair;
  };
  std::vector<Candidate> candidates;
  const auto add = [&](const RobotBodyPair& pair) {
    if (!certainly_apart(pair, 0)) candidates.push_back({scene_.contact_of(pair), pair});
  };
  for (const SelfPair& self : scene_.self_pairs) add(self.pair);
  for (Index body = 0; body < boxes_.size(); ++body) {
    if (scene_.body_rests[body] != 0) continue;
    scene_.part_tree.visit_near(boxes_[body], 0, [&](Index part) {
      if (!scene_.is_allowed(body, part)) add({body, true, part});
      return true;
    });
  }
  std::stable_sort(candidates.begin(), candidates.end(),
                   [](const Candidate& x, const Candidate& y) { return x.contact < y.contact; });
  std::vector<RobotContact> contacts(scene_.contacts_at_rest);
  for (const Candidate& candidate : candidates) {
    const bool is_known = !contacts.empty() && contacts.back() == candidate.contact;
    const bool is_later = told == ContactsTold::first && !contacts.empty() && contacts.front() < candidate.contact;
    if (is_later) break;
    if (!is_known && are_met(candidate.pair)) contacts.push_back(candidate.contact);
  }
  std::sort(contacts.begin(), contacts.end());
  contacts.erase(std::unique(contacts.begin(), contacts.end()), contacts.end());
  if (told == ContactsTold::first && contacts.size() > 1) contacts.resize(1);
  return contacts;
}

}  // namespace toccata
