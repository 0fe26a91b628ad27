#pragma once

#include <cstdint>
#include <functional>
#include <string>

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
  std::uint64_t mask = ~std::uint64_t{0};  ///< those that are in one of these groups
  /// Those whose own mask has one of these groups, as if the question were a body in them; 0: masks do not matter.
  std::uint64_t group = 0;
  /// Of them, those for which it says yes; none: all. The same answer each time, from many threads at once.
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

  /// Looks where the bodies are now: takes time as a pass over their boxes does.
  void update();
};

}  // namespace toccata
