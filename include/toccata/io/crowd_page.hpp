#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "toccata/broad/broad_phase.hpp"
#include "toccata/io/view_page.hpp"

namespace toccata {

/// The updates of a broad phase, one after the other, for a page that shows them as time goes on. What a page can hold
/// is bounded: when there is more, every second frame is given up, and from then on as many are passed over.
class CrowdRecording {
 public:
  /// Bytes that the frames take in a page, before they are written as text (base64: four thirds of it). A box takes 14,
  /// a pair 4 (8 from 65,537 boxes on), a cell 14.
  static constexpr std::size_t most_bytes = 16'000'000;
  /// No frame of more boxes fits, however few their pairs and cells are.
  static constexpr std::size_t most_boxes = most_bytes / 14;

  struct Frame {
    std::size_t number = 0;     ///< of the update, from 0
    std::vector<Aabb> boxes{};  ///< by number; empty where a number is not in use
    std::vector<IndexPair> pairs{};
    std::size_t begin = 0, end = 0;  ///< pairs, since the update before, which may not be kept
    BroadPhaseMethod method{};
    BroadPhaseCells space{};
  };

  /// The boxes, pairs and cells of the last update. Throws Error when boxes have come, gone or moved since, and when
  /// this frame alone is more than a page may hold.
  void add(const BroadPhase& phase);
  /// With these cells in place of those of the method.
  void add(const BroadPhase& phase, BroadPhaseCells space);

  [[nodiscard]] const std::vector<Frame>& frames() const { return frames_; }  ///< those that are kept
  /// How many updates were shown to it, and each how many-th of them is kept.
  [[nodiscard]] std::size_t seen() const { return seen_; }
  [[nodiscard]] std::size_t stride() const { return stride_; }
  /// Whether a box has been seen at two places.
  [[nodiscard]] bool has_moved(Index number) const { return has_moved_[number]; }

 private:
  void give_up_every_second();
  void note_motion(const BroadPhase& phase);

  std::vector<Frame> frames_;
  std::vector<Aabb> last_;
  std::vector<bool> has_moved_;
  std::size_t seen_ = 0, stride_ = 1, bytes_ = 0;
};

/// What is shown as the cells of a frame, of its boxes.
using CrowdCells = std::function<BroadPhaseCells(const std::vector<Aabb>& boxes)>;

/// A crowd (run_crowd) once more by the first of the methods, kept frame by frame; the first is that before anything
/// moves. Throws Error as CrowdRecording does.
[[nodiscard]] CrowdRecording record_crowd(const CrowdQuestion& question, const Progress& progress = {},
                                          const CrowdCells& cells = {});

/// A self-contained page as that of `view_page`, which shows the boxes, their pairs and the cells of the method as
/// layers, with a slider over the frames. What is drawn is rounded to 1/65535 of what it lies in. Infinite sides end
/// where the finite boxes do; intervals and rectangles of sweeps are drawn beside the boxes. Of `options` it takes
/// `title` and `up`. Throws Error when nothing is recorded.
[[nodiscard]] std::string crowd_page(const CrowdRecording& recording, const ViewOptions& options = {});

}  // namespace toccata
