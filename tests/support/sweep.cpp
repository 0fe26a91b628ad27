#include "support/sweep.hpp"

#include <utility>

namespace toccata::test {
namespace {

/// Made on first use, because sweeps are registered by static initialisers of other files.
std::vector<Sweep>& registry() {
  static std::vector<Sweep> known;
  return known;
}

}  // namespace

bool register_sweep(Sweep sweep) {
  registry().push_back(std::move(sweep));
  return true;
}

const std::vector<Sweep>& sweeps() { return registry(); }

}  // namespace toccata::test
