#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace toccata::test {

/// How two meshes move from question to question: by 1e-6 … 10 % of their size a step, in jumps, the one or both, under
/// poses that deform, into one another as solids.
const std::vector<std::string>& motion_families();

/// Two random meshes that move `steps` times; what is wrong with the first distance that a cache does not tell to the
/// bit, empty when none is.
std::string fault_of_coherence(const std::string& family, std::uint64_t seed, int steps);

}  // namespace toccata::test
