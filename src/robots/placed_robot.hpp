#pragma once

#include <optional>
#include <span>
#include <vector>

#include "narrow/near.hpp"
#include "query/posed_shape.hpp"
#include "robots/scene_made.hpp"
#include "toccata/query/pair_query.hpp"

namespace toccata {

/// A robot at one configuration after the other, and what it meets there. It keeps memory and what met last, which save
/// time and change no answer. One thread uses it at a time; the scene outlives it.
class PlacedRobot {
 public:
  explicit PlacedRobot(const RobotScene::Made& scene);

  /// From now on it is there.
  void place(std::span<const double> configuration);

  [[nodiscard]] const RobotScene::Made& scene() const { return scene_; }
  [[nodiscard]] const std::vector<Pose>& frames() const { return frames_; }
  [[nodiscard]] const TurnedBox& box(Index body) const { return boxes_[body]; }
  [[nodiscard]] const TurnedBox& box_of_other(const RobotBodyPair& pair) const {
    return pair.with_part ? scene_.part_boxes[pair.other] : boxes_[pair.other];
  }
  /// Proved to be farther apart than this, by balls and by boxes.
  [[nodiscard]] bool certainly_apart(const RobotBodyPair& pair, double by) const;

  /// Proved to be farther apart than the length that is told, by what is convex around the two: tighter than by boxes,
  /// and slower. As long as is wanted or, where that is not found, what was; 0 where nothing is known.
  [[nodiscard]] double hull_gap(const RobotBodyPair& pair, double enough, SimplexCache* kept = nullptr);

  /// One of the two is a mesh with a hull around it; else what is around them is what they are.
  [[nodiscard]] bool has_hull(const RobotBodyPair& pair) const;

  /// Proved by balls within the two to have a point in common. False says nothing.
  [[nodiscard]] bool certainly_meet(const RobotBodyPair& pair) const;

  /// The two have a point in common: by what is certain in doubles, and else by `overlap`.
  [[nodiscard]] bool are_met(const RobotBodyPair& pair);
  /// The same where nothing of their hulls need be asked.
  [[nodiscard]] bool are_met_within_hulls(const RobotBodyPair& pair);
  /// The same by the exact question alone.
  [[nodiscard]] bool overlap(const RobotBodyPair& pair);

  /// How near they are: as the question of that name says.
  [[nodiscard]] std::optional<Nearby> nearby(const RobotBodyPair& pair, const WantedDistance& wanted);

  /// Some pair has.
  [[nodiscard]] bool meets();

  /// The pairs that have, or the least, as links and obstacles.
  [[nodiscard]] std::vector<RobotContact> contacts(ContactsTold told);

 private:
  [[nodiscard]] std::span<const PosedPart> posed(Index body);
  [[nodiscard]] std::span<const PosedPart> posed_other(const RobotBodyPair& pair);
  [[nodiscard]] const PosedPolytope* convex_around(Index body);
  [[nodiscard]] bool meets_at_sight(const RobotBodyPair& pair);
  [[nodiscard]] bool body_meets_at_sight(Index body);
  [[nodiscard]] bool meets_after_waiting(const RobotBodyPair& pair);

  const RobotScene::Made& scene_;
  Workspace workspace_;
  std::vector<Pose> frames_;
  std::vector<TurnedBox> boxes_;
  std::vector<PosedModel> posed_;
  std::vector<std::uint8_t> is_posed_;
  std::vector<std::optional<PosedPolytope>> hulls_;  ///< of meshes, where they were needed
  std::vector<RobotBodyPair> waiting_;  ///< of the configuration: what is decided last, as it takes longest
  std::optional<RobotBodyPair> met_last_;
};

}  // namespace toccata
