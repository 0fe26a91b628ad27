#pragma once

#include <cstdint>
#include <memory>
#include <span>

#include "math/constants.hpp"
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
  beyond,  ///< apart, and farther than was asked
};

/// They are a pair.
[[nodiscard]] constexpr bool is_told(BodyNearness nearness) {
  return nearness != BodyNearness::apart && nearness != BodyNearness::beyond;
}

/// Two bodies whose boxes overlap, and what was found out about them.
struct DecidedPair {
  IndexPair pair;
  BodyNearness nearness = BodyNearness::apart;
  std::shared_ptr<const PairDetails> details{};
};

/// A pair to be decided, and how near counts.
struct UndecidedPair {
  std::size_t number = 0;  ///< in the list of pairs
  double margin = 0;
  double beyond = infinity;  ///< not less than the margin: nothing more is wanted of the two if they are farther apart
  int steps = 1;             ///< after which they are looked at again if they are
};

/// Decides pairs of bodies. What it keeps is memory to work in.
class NarrowPhase {
 public:
  explicit NarrowPhase(const WorldOptions& options) : options_(options) {}
  NarrowPhase(const NarrowPhase& other) : options_(other.options_) {}
  NarrowPhase& operator=(const NarrowPhase&) = delete;
  ~NarrowPhase() = default;

  /// Fills in pairs[undecided.number] for each of them. Bodies are by index.
  void decide(std::span<const Body> bodies, const BodiesOnTheWay& on_the_way, std::span<const UndecidedPair> undecided,
              std::span<DecidedPair> pairs);

 private:
  void decide(const Body& a, const Body& b, const UndecidedPair& wanted, DecidedPair& pair, Workspace& workspace) const;
  /// Of two bodies of which one at least has been on its way.
  void add_first_contact(std::span<const Body> bodies, const BodiesOnTheWay& on_the_way, DecidedPair& pair,
                         Workspace& workspace) const;
  [[nodiscard]] PairDetails details_of(const Body& a, const Body& b, bool in_contact, Workspace& workspace) const;

  const WorldOptions options_;
  WorkspacePool workspaces_;
};

}  // namespace toccata
