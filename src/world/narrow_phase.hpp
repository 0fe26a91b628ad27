#pragma once

#include <cstdint>
#include <memory>
#include <span>

#include "narrow/near.hpp"
#include "query/workspace_pool.hpp"
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

/// A pair to be decided, how near counts, and how long the answer lasts.
struct UndecidedPair {
  std::size_t number = 0;  ///< in the list of pairs
  double margin = 0;
  // How long the answer lasts, with space_time:
  double enough = 0;           ///< what is found need not be more; 0: nothing is wanted
  bool is_told_until = false;  ///< wanted also of two that are in contact or near
  /// Found: the answer is the same while they do not come nearer to each other by this along the direction, which is
  /// from A to B; with a direction of zero, while no points of theirs move against each other by so much.
  DirectedGap lasts{};
};

/// Decides pairs of bodies. What it keeps is memory to work in.
class NarrowPhase {
 public:
  explicit NarrowPhase(const WorldOptions& options) : options_(options) {}
  NarrowPhase(const NarrowPhase& other) : options_(other.options_) {}
  NarrowPhase& operator=(const NarrowPhase&) = delete;
  ~NarrowPhase() = default;

  /// Fills in pairs[undecided.number] for each of them, and what lasts. Bodies are by index.
  void decide(std::span<const Body> bodies, const BodiesOnTheWay& on_the_way, std::span<UndecidedPair> undecided,
              std::span<DecidedPair> pairs);

 private:
  void decide(const Body& a, const Body& b, UndecidedPair& wanted, DecidedPair& pair, Workspace& workspace) const;
  /// Of two bodies of which one at least has been on its way.
  void add_first_contact(std::span<const Body> bodies, const BodiesOnTheWay& on_the_way, DecidedPair& pair,
                         Workspace& workspace) const;
  [[nodiscard]] PairDetails details_of(const Body& a, const Body& b, bool in_contact, Workspace& workspace) const;

  const WorldOptions options_;
  WorkspacePool workspaces_;
};

}  // namespace toccata
