#include "broad/pair_finder.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include <fmt/format.h>

#include "toccata/core/error.hpp"
#include "toccata/core/suggestion.hpp"

namespace toccata {
namespace {

struct Known {
  BroadPhaseMethod method;
  std::string_view name;
};

constexpr std::array known_methods{
    Known{BroadPhaseMethod::automatic, "auto"},
    Known{BroadPhaseMethod::brute_force, "brute-force"},
};

/// Every pair, one by one: the oracle.
class EveryPair final : public PairFinder {
 public:
  PairList find(const BoxesNow& now, PairList) override { return overlapping_pairs_by_brute_force(now.boxes); }
  [[nodiscard]] std::size_t bytes() const override { return 0; }
};

/// By a tree over the boxes, built anew.
class ByTree final : public PairFinder {
 public:
  PairList find(const BoxesNow& now, PairList) override { return overlapping_pairs(now.boxes); }
  [[nodiscard]] std::size_t bytes() const override { return 0; }
  [[nodiscard]] BroadPhaseMethod chosen() const override { return BroadPhaseMethod::brute_force; }
};

}  // namespace

std::string_view name_of(BroadPhaseMethod method) {
  for (const Known& known : known_methods)
    if (known.method == method) return known.name;
  return {};
}

std::span<const BroadPhaseMethod> broad_phase_methods() {
  static const auto methods = [] {
    std::array<BroadPhaseMethod, known_methods.size()> all{};
    std::transform(known_methods.begin(), known_methods.end(), all.begin(), [](const Known& k) { return k.method; });
    return all;
  }();
  return methods;
}

BroadPhaseMethod broad_phase_method(std::string_view name) {
  for (const Known& known : known_methods)
    if (known.name == name) return known.method;
  std::vector<std::string> names;
  for (const Known& known : known_methods) names.emplace_back(known.name);
  throw Error(fmt::format("there is no broad phase '{}'{}", name, suggestion(std::string(name), names)));
}

std::unique_ptr<PairFinder> make_pair_finder(BroadPhaseMethod method) {
  if (method == BroadPhaseMethod::brute_force) return std::make_unique<EveryPair>();
  return std::make_unique<ByTree>();
}

}  // namespace toccata
