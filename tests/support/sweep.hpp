#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace toccata::test {

/// What a run of a sweep counted. A wrong case is a defect; `first_failure` says how to see it again.
struct SweepResult {
  std::uint64_t cases = 0;
  std::uint64_t wrong = 0;
  std::string first_failure{};
};

/// A long comparison of a fast answer with an oracle, in families of input. The tests run a thin slice of every family;
/// `./toccata test --all` runs shards (one seed, some thousand cases each) until every family has reached its goal, and
/// adds them up in docs/evidence/<name>.json.
struct Sweep {
  std::string name;                   ///< of the evidence file, for example "triangle-pairs"
  std::vector<std::string> families;  ///< for example "needles"
  std::uint64_t goal = 0;             ///< cases per family in the long run
  std::uint64_t slice = 1000;         ///< cases per family in the quick run
  std::function<SweepResult(const std::string& family, std::uint64_t seed, std::uint64_t cases)> run;
  std::uint64_t shard = 10'000;  ///< cases per shard: no more than a minute or two
  /// Cases per family where the quick run is slow, or not the first: under sanitizers, without optimisation, at a lower
  /// SIMD level. 0: as many as in the slice.
  std::uint64_t thin_slice = 0;
};

/// Makes a sweep known; call it from a static initialiser: `const bool known = register_sweep({…});`.
bool register_sweep(Sweep sweep);

const std::vector<Sweep>& sweeps();

}  // namespace toccata::test
