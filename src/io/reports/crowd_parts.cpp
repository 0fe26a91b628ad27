#include "io/reports/crowd_parts.hpp"

#include <fmt/format.h>

#include <cstdint>

#include "toccata/core/error.hpp"
#include "toccata/core/random.hpp"

namespace toccata::io {

std::string text_of(std::span<const PairDigest> frames) {
  std::uint64_t digest = 0;
  for (const PairDigest& frame : frames) digest = Random(digest + frame.sum).bits() + frame.count;
  return fmt::format("{:016x}", digest);
}

void require_threads(int threads) {
  constexpr int most = 1024;
  if (threads < 0 || threads > most)
    throw Error(fmt::format("{} threads cannot be: say from 1 to {}, or 0 for as many as there are", threads, most));
}

}  // namespace toccata::io
