#include "toccata/core/simd.hpp"

#include <algorithm>
#include <cstdint>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <hwy/highway.h>

#include "toccata/core/error.hpp"

namespace toccata {
namespace {

/// What Highway calls a level; the scalar one is whatever it compiles for a processor without vectors.
std::int64_t target_of(SimdLevel level) {
  switch (level) {
    case SimdLevel::sse4:
      return HWY_SSE4;
    case SimdLevel::avx2:
      return HWY_AVX2;
    case SimdLevel::avx512:
      return HWY_AVX3;
    case SimdLevel::scalar:
      break;
  }
  return HWY_STATIC_TARGET;
}

constexpr SimdLevel all_levels[] = {SimdLevel::scalar, SimdLevel::sse4, SimdLevel::avx2, SimdLevel::avx512};

/// The levels of a set of targets.
std::vector<SimdLevel> levels_in(std::int64_t targets) {
  std::vector<SimdLevel> levels;
  for (const SimdLevel level : all_levels)
    if (level == SimdLevel::scalar || (targets & HWY_TARGETS & target_of(level)) != 0) levels.push_back(level);
  return levels;
}

/// What the machine can do, read before anything else was asked for.
std::int64_t machine_targets() {
  static const std::int64_t targets = hwy::SupportedTargets();
  return targets;
}

}  // namespace

std::string_view name_of(SimdLevel level) {
  switch (level) {
    case SimdLevel::sse4:
      return "sse4";
    case SimdLevel::avx2:
      return "avx2";
    case SimdLevel::avx512:
      return "avx512";
    case SimdLevel::scalar:
      break;
  }
  return "scalar";
}

std::vector<SimdLevel> simd_levels() { return levels_in(machine_targets()); }

SimdLevel simd_level() {
  static_cast<void>(machine_targets());
  return levels_in(hwy::SupportedTargets()).back();
}

void use_simd_level(SimdLevel level) {
  const std::vector<SimdLevel> levels = simd_levels();
  if (std::find(levels.begin(), levels.end(), level) == levels.end()) {
    std::vector<std::string_view> names;
    for (const SimdLevel known : levels) names.push_back(name_of(known));
    throw Error(fmt::format("this machine has no {} instructions; it has {}", name_of(level), fmt::join(names, ", ")));
  }
  hwy::SetSupportedTargetsForTest(target_of(level));
  hwy::GetChosenTarget().Update(hwy::SupportedTargets());
}

}  // namespace toccata
