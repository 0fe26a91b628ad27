#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "toccata/core/parallel.hpp"
#include "toccata/robots/robot.hpp"

// Pairs that are not asked about: links that are made to touch, and others of which somebody knows that it does not
// matter. They are data: a list, from wherever.
namespace toccata {

/// Why a pair need not be looked at.
enum class AllowedReason : std::uint8_t {
  given,     ///< somebody said so: an SRDF file, or the caller
  adjacent,  ///< a joint joins them, or joints and links without shapes do
  always,    ///< they meet in every sample
  at_rest,   ///< they meet where all positions are those of Robot::rest
  never,     ///< they meet in no sample, which is no proof
};

/// "given", "adjacent", "always", "at rest", "never".
[[nodiscard]] std::string_view name_of(AllowedReason reason);

/// Two links, or a link and an obstacle, by name.
struct AllowedPair {
  std::string a;
  std::string b;
  AllowedReason reason = AllowedReason::given;
  friend bool operator==(const AllowedPair&, const AllowedPair&) = default;
};

/// Links with shapes that are joined, by a joint or by joints and links without shapes.
[[nodiscard]] std::vector<AllowedPair> adjacent_pairs(const Robot& robot);

struct SampleOptions {
  std::size_t samples = 10'000;
  std::uint64_t seed = 1;
  int threads = all_threads;
  Progress progress{};
};

/// Positions drawn evenly between their limits; what turns without limits from all directions, and what slides without
/// limits from −1 to 1. The i-th is the same for every number of threads.
[[nodiscard]] std::vector<double> sampled_configurations(const Robot& robot, std::size_t count, std::uint64_t seed = 1);

/// Which pairs of links with shapes need not be looked at, each with its first reason in the order adjacent, always,
/// at rest, never; ascending by the numbers of the links. The way of MoveIt's setup assistant, which also finds pairs
/// by samples. `never` is no proof, and the more samples, the less it is a guess.
[[nodiscard]] std::vector<AllowedPair> allowed_pairs_by_samples(const Robot& robot, const SampleOptions& options = {});

}  // namespace toccata
