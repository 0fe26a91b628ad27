#include "toccata/generate/crowds.hpp"

#include "toccata/core/random.hpp"

namespace toccata {

PairDigest digest_of(std::span<const IndexPair> pairs) {
  PairDigest digest{pairs.size(), 0};
  for (const IndexPair& pair : pairs) digest.sum += Random(std::uint64_t{pair.first} << 32 | pair.second).bits();
  return digest;
}

double CrowdFrames::median_ms() const {
  std::vector<double> sorted = milliseconds;
  std::sort(sorted.begin(), sorted.end());
  return sorted[sorted.size() / 2];
}

}  // namespace toccata
