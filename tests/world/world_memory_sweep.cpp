#include <malloc.h>

#include <algorithm>
#include <cstdlib>
#include <new>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "support/sweep.hpp"
#include "toccata/world/world.hpp"
#include "world/random_bodies.hpp"

// Counts what this thread holds of the heap, whoever holds it. The sanitizers bring their own operator new.
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)

namespace {

thread_local std::ptrdiff_t held = 0;

void* allocate(std::size_t size, std::size_t alignment) {
  const std::size_t whole = (size + alignment - 1) / alignment * alignment;
  void* memory = std::aligned_alloc(alignment, whole == 0 ? alignment : whole);
  if (memory == nullptr) throw std::bad_alloc();
  held += static_cast<std::ptrdiff_t>(malloc_usable_size(memory));
  return memory;
}

void release(void* memory) noexcept {
  held -= static_cast<std::ptrdiff_t>(malloc_usable_size(memory));
  std::free(memory);
}

}  // namespace

void* operator new(std::size_t size) { return allocate(size, alignof(std::max_align_t)); }
void* operator new(std::size_t size, std::align_val_t alignment) {
  return allocate(size, static_cast<std::size_t>(alignment));
}
void operator delete(void* memory) noexcept { release(memory); }
void operator delete(void* memory, std::size_t) noexcept { release(memory); }
void operator delete(void* memory, std::align_val_t) noexcept { release(memory); }
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept { release(memory); }

namespace toccata::test {
namespace {

constexpr std::size_t fewest = 20, most = 40;

/// A World in which bodies, rules, pairs and their details come and go, always about as many.
class BusyWorld {
 public:
  explicit BusyWorld(std::string_view family)
      : family_(family), world_({.relation = true, .distance = true, .contacts = true, .manifold = true}) {}

  void live(std::uint64_t step, Random& random) {
    std::size_t removed = 0;
    if (ids_.size() > fewest)
      for (; removed < 3; ++removed) remove_one(random);
    if (step % 100 == 99)
      for (; !ids_.empty(); ++removed) remove_one(random);
    while (ids_.size() < fewest || (ids_.size() < most && random.below(2) == 0))
      ids_.push_back(world_.add(random_body(family_, random)));
    needed_ = std::max(needed_, ids_.size() + removed);
    for (const BodyId id : ids_)
      if (random.below(2) == 0) world_.move(id, random_place(family_, random));
    world_.replace(any(random), random_body(family_, random));
    for (int i = 0; i < 4; ++i) set_rule(random);
    if (step % 10 == 9) world_ = World(world_);
    world_.step();
  }

  [[nodiscard]] std::size_t numbers() const { return world_.boxes().size(); }
  /// So many were in use at once, those included that were removed since the step before.
  [[nodiscard]] std::size_t needed() const { return needed_; }

 private:
  [[nodiscard]] BodyId any(Random& random) const { return ids_[random.below(ids_.size())]; }

  void remove_one(Random& random) {
    const std::size_t place = random.below(ids_.size());
    world_.remove(ids_[place]);
    ids_[place] = ids_.back();
    ids_.pop_back();
  }

  void set_rule(Random& random) {
    PairRule rule{any(random), any(random)};
    if (rule.a == rule.b) return;
    rule.excluded = random.below(4) == 0;
    if (random.below(2) == 0) rule.margin = 0.25;
    world_.set_rule(rule);
  }

  std::string_view family_;
  World world_;
  std::vector<BodyId> ids_;
  std::size_t needed_ = 0;
};

/// Steps of one life, a case each. What the World holds must not become more than it was at most in the first fifth,
/// but for the chance of a more crowded step; numbers are never more than are needed at once.
SweepResult run_world_memory(const std::string& family, std::uint64_t seed, std::uint64_t steps) {
  Random random(seed);
  const std::ptrdiff_t before = held;
  BusyWorld life(family);
  SweepResult result;
  std::ptrdiff_t most_early = 0;
  for (; result.cases < steps; ++result.cases) {
    life.live(result.cases, random);
    const std::ptrdiff_t now = held - before;
    const bool is_early = result.cases < std::max<std::uint64_t>(steps / 5, 100);
    if (is_early) most_early = std::max(most_early, now);
    if ((now > most_early + most_early / 2 || now <= 0 || life.numbers() > life.needed()) && result.wrong++ == 0)
      result.first_failure = fmt::format("{} with seed {}: {} bytes, at most {} before, {} numbers for {}, in step {}",
                                         family, seed, now, most_early, life.numbers(), life.needed(), result.cases);
  }
  return result;
}

const bool world_memory_known =
    register_sweep({"world-memory", {"whole", "convex"}, 100'000, 400, run_world_memory, 100'000, 150});

}  // namespace
}  // namespace toccata::test

#endif
