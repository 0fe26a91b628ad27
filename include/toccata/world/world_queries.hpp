#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "toccata/query/object_queries.hpp"
#include "toccata/world/world.hpp"

namespace toccata {

/// What was found, and of which body.
template <class Answer>
struct BodyAnswer : Answer {
  BodyId body;
  friend constexpr bool operator==(const BodyAnswer&, const BodyAnswer&) = default;
};

/// Which bodies are asked: all, if nothing is said.
struct BodyFilter {
  std::uint64_t mask = ~std::uint64_t{0};  ///< those that are in one of these categories
  /// Asked are those whose own mask has one of these categories, as if the question were a body in them; 0: masks do
  /// not matter.
  std::uint64_t category = 0;
  /// Those of them for which it says yes; all, if it is empty. It has to answer the same each time, from many threads
  /// at once.
  std::function<bool(BodyId)> accepts{};
};

/// What WorldQueries ask: the bodies of a World, as they were at that revision.
struct WorldBodies {
  using Id = BodyId;
  using Filter = BodyFilter;
  template <class Answer>
  using Found = BodyAnswer<Answer>;

  const World* world = nullptr;
  std::uint64_t revision = 0;

  // For the library itself, by the index of a body.
  [[nodiscard]] BodyId id_of(Index object) const;
  [[nodiscard]] InstanceView at(Index object) const;
  [[nodiscard]] std::string name_of(Index object) const;
  [[nodiscard]] bool accepts(const Filter& filter, Index object) const;
  /// Throws Error where the World has another revision.
  void require_unchanged() const;
};

/// A body at a place where it is not.
struct PlacedBody {
  BodyId body;
  Pose pose;
};

/// Which pairs of bodies are asked about: of those that the World compares (categories, types and rules), each of which
/// one body is in one of the categories `first_categories` and the other in one of `second_categories`.
struct BodyPairs {
  std::uint64_t first_categories = ~std::uint64_t{0};
  std::uint64_t second_categories = ~std::uint64_t{0};
  /// Bodies as if they were there, each named once; all others are where they are. If there are any, only pairs of
  /// which one is such a body are asked about.
  std::span<const PlacedBody> placed{};
};

struct BodyPair {
  BodyId a;  ///< a.index < b.index
  BodyId b;
  friend constexpr auto operator<=>(const BodyPair&, const BodyPair&) = default;
};

/// What was found, and of which two bodies; as the question of that name answers it for (a, b).
template <class Answer>
struct BodyPairAnswer : Answer {
  BodyPair bodies;
  friend constexpr bool operator==(const BodyPairAnswer&, const BodyPairAnswer&) = default;
};

/// Questions to all bodies of a World, by a tree over their boxes that is kept from step to step. It looks at the World
/// where it is, which has to outlive it and not be moved; after the bodies have changed, `update` is called once before
/// anything is asked.
///
/// Each answer is what the question of that name gives for every body by itself, where it is now and without its
/// margin. Const functions may be called from many threads at once, while nobody changes the World. They throw Error
/// naming the body, and where the bodies have changed since the last update.
class WorldQueries : public ObjectQueries<WorldBodies> {
 public:
  explicit WorldQueries(const World& world);

  /// Looks where the bodies are now: takes time as a pass over their boxes does, and none where no body has changed.
  void update();

  /// Whether any two bodies have a point in common, whatever their types, groups, margins and rules. Ends with the
  /// first two that it finds. Throws Error naming two bodies that may not be asked about.
  [[nodiscard]] bool any_overlap() const;

  // The questions below are about pairs of bodies. Margins do not matter. They throw like the questions about two
  // models, naming the bodies; and Error for a placed body that is none of the World, is named twice, or has a pose
  // that it may not have.

  /// The least pair (a, b) that has a point in common; none where no pair has. It ends with that pair: what comes after
  /// it is not asked about.
  [[nodiscard]] std::optional<BodyPair> any_contact(const BodyPairs& pairs = {}) const;
  /// The same of pairs that are at most so far apart, decided exactly (`within_distance`). Throws Error when the
  /// greatest distance is negative or no number.
  [[nodiscard]] std::optional<BodyPair> any_within(double max_distance, const BodyPairs& pairs = {}) const;
  /// The least distance, of several such pairs that of the least (upper, a, b); `lower` is such that the least of all
  /// pairs is not below it. None where no pair is within the greatest distance.
  [[nodiscard]] std::optional<BodyPairAnswer<Distance>> least_distance(const BodyPairs& pairs = {},
                                                                       double max_distance = unlimited) const;

  // The same asked many times at once, as of many places of a robot; an error begins with "pairs i: ", of the least
  // such i.
  [[nodiscard]] std::vector<std::optional<BodyPair>> any_contact_each(std::span<const BodyPairs> pairs,
                                                                      const BatchOptions& options = {}) const;
  [[nodiscard]] std::vector<std::optional<BodyPairAnswer<Distance>>> least_distance_each(
      std::span<const BodyPairs> pairs, double max_distance = unlimited, const BatchOptions& options = {}) const;
};

/// WorldQueries::any_overlap by the boxes alone: up to some 2,000 bodies, who asks once after they have moved has the
/// answer before a tree around them is made.
[[nodiscard]] bool any_overlap(const World& world);

}  // namespace toccata
