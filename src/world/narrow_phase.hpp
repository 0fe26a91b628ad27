#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "narrow/near.hpp"
#include "query/workspace_pool.hpp"
#include "toccata/bounds/ball.hpp"
#include "toccata/broad/broad_phase.hpp"
#include "toccata/world/world.hpp"
#include "world/bodies_on_the_way.hpp"

namespace toccata {

enum class BodyNearness : std::uint8_t {
  apart,
  near,
  contact,
  passed,  ///< they have met on the way, and are neither near nor in contact now
};

/// They are a pair.
[[nodiscard]] constexpr bool is_told(BodyNearness nearness) { return nearness != BodyNearness::apart; }

/// Besides that two bodies are a pair.
[[nodiscard]] constexpr bool tells_details(const WorldOptions& options) {
  return options.relation || options.distance || options.contacts || options.manifold || options.penetration;
}

/// Two bodies whose boxes overlap, and what was found out about them.
struct DecidedPair {
  IndexPair pair;
  BodyNearness nearness = BodyNearness::apart;
  std::shared_ptr<const PairDetails> details{};
  std::uint64_t sure_until = 0;  ///< with space_time, while both fly: before this step nothing else can be told of them
};

/// For how long a pair is as it was found, of which it was said how its bodies go on.
struct AnswerLasts {
  DirectedGap gap{};  ///< of two that are apart: until it is closed
  /// Else while offset + w is within the radius, where w is how far any point of A has gone against any of B, of which
  /// only this share of how far they turn counts. 0: until the next step.
  Vec3 offset{};
  double radius = 0;
  double turning = 1;
};

/// A pair to be decided, and how near counts.
struct UndecidedPair {
  std::size_t number = 0;  ///< in the list of pairs
  double margin = 0;
};

/// How long the answer about a pair lasts, with space_time.
struct WantedLasting {
  double enough = 0;     ///< gaps and ways need not be longer; 0: nothing is wanted
  bool of_told = false;  ///< wanted also of two that are in contact or near
  Ball inner{{}, 0};     ///< within the difference A − B; of radius 0 where none is known
  AnswerLasts lasts{};   ///< found
};

struct UndecidedPairs {
  std::vector<UndecidedPair> pairs;
  std::vector<WantedLasting> lasting;  ///< with space_time, of each pair; else none
};

/// Decides pairs of bodies. What it keeps is memory to work in.
class NarrowPhase {
 public:
  explicit NarrowPhase(const WorldOptions& options) : options_(options) {}
  NarrowPhase(const NarrowPhase& other) : options_(other.options_) {}
  NarrowPhase& operator=(const NarrowPhase&) = delete;
  ~NarrowPhase() = default;

  /// Fills in pairs[undecided.number] for each of them, and what lasts. Bodies are by index.
  void decide(std::span<const Body> bodies, const BodiesOnTheWay& on_the_way, UndecidedPairs& undecided,
              std::span<DecidedPair> pairs, const Progress& progress = {});

 private:
  void decide(const Body& a, const Body& b, double margin, WantedLasting& wanted, DecidedPair& pair,
              Workspace& workspace) const;
  /// Adds the first contact of two bodies of which one at least has been on its way.
  void add_first_contact(std::span<const Body> bodies, const BodiesOnTheWay& on_the_way, DecidedPair& pair,
                         Workspace& workspace) const;
  [[nodiscard]] PairDetails details_of(const Body& a, const Body& b, bool in_contact, Workspace& workspace) const;

  const WorldOptions options_;
  WorkspacePool workspaces_;
};

}  // namespace toccata
