#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "toccata/broad/box_bvh.hpp"
#include "toccata/world/world_queries.hpp"

namespace toccata {

/// A question about pairs of bodies, some of which may be placed elsewhere.
class BodyPairSearch {
 public:
  /// Throws Error naming a placed body that is none, is there twice, or may not be there. All have to outlive it.
  BodyPairSearch(const WorldBodies& bodies, const BoxBvh& boxes, const BodyPairs& pairs);

  /// The least pair that is at most so far apart.
  [[nodiscard]] std::optional<BodyPair> first_within(double max_distance, Workspace& workspace) const;
  /// The nearest pair, if it is at most so far apart.
  [[nodiscard]] std::optional<BodyPairAnswer<Distance>> nearest(double max_distance, Workspace& workspace) const;

 private:
  struct Placed {
    Index index;
    const Pose* pose;
    Aabb box;
  };

  [[nodiscard]] const Placed* placed(Index body) const;
  [[nodiscard]] const Aabb& box(Index body) const;
  [[nodiscard]] InstanceView at(Index body) const;
  [[nodiscard]] bool is_wanted(const IndexPair& pair) const;
  [[nodiscard]] BodyPair named(const IndexPair& pair) const;
  /// Those that may be so near.
  [[nodiscard]] std::vector<IndexPair> near_pairs(Index body, double distance) const;
  /// `ask(model a, model b, query, workspace)`, whose errors get the names of the bodies.
  template <class Ask>
  auto ask(const IndexPair& pair, Workspace& workspace, const Ask& question) const;
  /// The first of these, which are ascending.
  [[nodiscard]] std::optional<BodyPair> first_of(const std::vector<IndexPair>& pairs, double distance,
                                                 Workspace& workspace) const;

  const WorldBodies& bodies_;
  const BoxBvh& boxes_;
  const BodyPairs& pairs_;
  std::vector<Placed> placed_;  ///< ascending
};

}  // namespace toccata
