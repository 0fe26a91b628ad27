#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "toccata/core/error.hpp"
#include "toccata/reports/pages.hpp"

namespace toccata {
namespace {

std::size_t bytes_of(std::size_t boxes, std::size_t pairs, std::size_t cells) {
  return 14 * (boxes + cells) + (boxes > 65'536 ? 8 : 4) * pairs;
}

std::size_t bytes_of(const CrowdRecording::Frame& frame) {
  return bytes_of(frame.boxes.size(), frame.pairs.size(), frame.space.cells.size());
}

void require_room(std::size_t boxes, std::size_t bytes) {
  constexpr std::size_t most = CrowdRecording::most_bytes;
  if (bytes <= most) return;
  throw Error(
      fmt::format("a frame of {} boxes takes {:.0f} MB in a page, which may hold {:.0f} MB: show fewer, at most about "
                  "{}",
                  boxes, static_cast<double>(bytes) / 1e6, static_cast<double>(most) / 1e6,
                  static_cast<std::size_t>(0.9 * static_cast<double>(boxes) * static_cast<double>(most) /
                                           static_cast<double>(bytes))));
}

CrowdRecording::Frame frame_of(const BroadPhase& phase, std::size_t number, BroadPhaseCells space) {
  const PairChanges changes = phase.changes();
  CrowdRecording::Frame frame{.number = number,
                              .begin = changes.begin.size(),
                              .end = changes.end.size(),
                              .method = phase.method(),
                              .space = std::move(space)};
  frame.boxes.reserve(phase.size());
  for (Index i = 0; i < phase.size(); ++i) frame.boxes.push_back(phase.box(i));
  frame.pairs.assign(phase.pairs().begin(), phase.pairs().end());
  return frame;
}

}  // namespace

void CrowdRecording::add(const BroadPhase& phase) { add(phase, phase.cells()); }

void CrowdRecording::add(const BroadPhase& phase, BroadPhaseCells space) {
  const bool is_kept = seen_ % stride_ == 0;
  if (is_kept) {
    require_room(phase.size(), bytes_of(phase.size(), phase.pairs().size(), 0));
    Frame frame = frame_of(phase, seen_, std::move(space));
    require_room(phase.size(), bytes_of(frame));
    bytes_ += bytes_of(frame);
    frames_.push_back(std::move(frame));
  }
  note_motion(phase);
  ++seen_;
  while (bytes_ > most_bytes) give_up_every_second();
}

void CrowdRecording::give_up_every_second() {
  stride_ *= 2;
  std::erase_if(frames_, [&](const Frame& frame) { return frame.number % stride_ != 0; });
  bytes_ = 0;
  for (const Frame& frame : frames_) bytes_ += bytes_of(frame);
}

void CrowdRecording::note_motion(const BroadPhase& phase) {
  last_.resize(phase.size());
  has_moved_.resize(phase.size(), false);
  for (Index i = 0; i < phase.size(); ++i) {
    const Aabb& box = phase.box(i);
    if (!is_empty(box) && !is_empty(last_[i]) && box != last_[i]) has_moved_[i] = true;
    last_[i] = box;
  }
}

}  // namespace toccata
