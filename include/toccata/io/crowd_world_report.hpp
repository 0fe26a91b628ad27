#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "toccata/broad/broad_phase.hpp"
#include "toccata/core/progress.hpp"
#include "toccata/generate/crowd_frames.hpp"

namespace toccata {

/// How fast a World steps bodies of many shapes that fly (BodyCrowd, one in twenty in contact), and which are in
/// contact: `crowd --world`.
struct CrowdWorldQuestion {
  std::size_t count = 100'000;  ///< bodies, at least one
  std::size_t frames = 60;      ///< steps that are timed, at least one
  BroadPhaseMethod method = BroadPhaseMethod::automatic;
  std::uint64_t seed = 1;
  int threads = 1;  ///< times compare with each other so; 0: as many as there are. From 0 to 1024
};

struct CrowdWorldReport {
  CrowdWorldQuestion question;
  CrowdFrames frames;       ///< of each step its time, and its pairs in contact by the bodies' indices
  std::size_t begin = 0;    ///< in all steps together
  std::size_t end = 0;      ///< the same
  BroadPhaseMethod used{};  ///< in the last step; where the method is `automatic`, what it chose by times

  [[nodiscard]] std::size_t pairs() const { return frames.pairs.back().count; }  ///< in the last step
};

/// Steps the bodies. Throws Error where there is no body or no step, and for threads out of their range.
[[nodiscard]] CrowdWorldReport run_crowd_world(const CrowdWorldQuestion& question, const Progress& progress = {});

/// JSON by the schema toccata/crowd-world/2 of docs/reference/crowd.md.
[[nodiscard]] std::string crowd_world_report_json(const CrowdWorldReport& report);

}  // namespace toccata
