#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "toccata/broad/broad_phase.hpp"
#include "toccata/core/parallel.hpp"
#include "toccata/generate/crowds.hpp"

namespace toccata::io {
struct QuestionKind;
}

namespace toccata {

/// What bounds the bodies of a crowd, of which each fills a box.
enum class CrowdBounds {
  boxes,     ///< these boxes, along the axes
  balls,     ///< the balls around them
  oriented,  ///< the boxes themselves, turned about z, each by an angle of its own
};

/// "boxes", "balls", "oriented".
[[nodiscard]] std::string_view name_of(CrowdBounds bounds);

inline constexpr std::array all_crowd_bounds{CrowdBounds::boxes, CrowdBounds::balls, CrowdBounds::oriented};

/// How fast which methods find the pairs of a crowd of moving boxes, and whether all find the same: `crowd`.
struct CrowdQuestion {
  static const io::QuestionKind kind;                                  ///< scene_question.hpp
  std::string scene = "uniform";                                       ///< one of crowd_scenes
  std::size_t count = 100'000;                                         ///< boxes, at least one
  std::size_t frames = 60;                                             ///< at least one
  std::vector<BroadPhaseMethod> methods{BroadPhaseMethod::automatic};  ///< one after the other; at least one
  std::uint64_t seed = 1;
  int threads = own_thread;  ///< times compare with each other so. From 0 to 1024
  CrowdBounds bounds = CrowdBounds::boxes;
};

/// A method's way through all frames.
struct CrowdRun {
  BroadPhaseMethod method{};
  CrowdFrames frames;
  std::size_t begin = 0;  ///< in all frames together
  std::size_t end = 0;
  double bytes_per_body = 0;
  std::string reason;  ///< why `automatic` chose as it did

  [[nodiscard]] std::size_t pairs() const { return frames.pairs.back().count; }  ///< in the last frame
};

struct CrowdReport {
  CrowdQuestion question;
  std::vector<CrowdRun> runs;  ///< of its methods, in their order
};

/// Runs the crowd for every method. Throws Error where two find different pairs, naming the frame, for a scene that is
/// not there, for threads out of their range, and where there is no box, frame or method.
[[nodiscard]] CrowdReport run_crowd(const CrowdQuestion& question, const Progress& progress = {});

/// How fast a World steps bodies of many shapes that fly, or lie, roll and fall (BodyCrowd), and which are in contact:
/// `crowd --world`.
struct CrowdWorldQuestion {
  static const io::QuestionKind kind;  ///< scene_question.hpp
  std::size_t count = 100'000;         ///< bodies, at least one, besides the ground
  std::size_t frames = 60;             ///< steps that are timed, at least one
  BroadPhaseMethod method = BroadPhaseMethod::automatic;
  std::uint64_t seed = 1;
  int threads = own_thread;   ///< times compare with each other so. From 0 to 1024
  std::string scene = "fly";  ///< one of body_crowd_scenes
};

struct CrowdWorldReport {
  CrowdWorldQuestion question;
  CrowdFrames frames;       ///< the time of each step, and its pairs in contact by the bodies' indices
  std::size_t begin = 0;    ///< in all steps together
  std::size_t end = 0;      ///< the same
  BroadPhaseMethod used{};  ///< in the last step; where the method is `automatic`, what it chose by times

  [[nodiscard]] std::size_t pairs() const { return frames.pairs.back().count; }  ///< in the last step
};

/// Steps the bodies. Throws Error where there is no body or no step, for threads out of their range, and for a scene
/// that is not there.
[[nodiscard]] CrowdWorldReport run_crowd_world(const CrowdWorldQuestion& question, const Progress& progress = {});

}  // namespace toccata
