#include "crowd_view.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <vector>

#include "look.hpp"
#include "output.hpp"
#include "progress_bar.hpp"
#include "toccata/broad/broad_phase.hpp"
#include "toccata/core/error.hpp"
#include "toccata/generate/crowds.hpp"
#include "toccata/io/crowd_page.hpp"
#include "toccata/io/output_file.hpp"
#include "tracked_cells.hpp"
#include "words.hpp"

namespace toccata::command {
namespace {

/// The first frame is that before anything moves.
CrowdRecording recorded(const CrowdArguments& arguments) {
  ProgressBar bar("frames for the page");
  const Progress progress = bar.callback();
  Crowd crowd(arguments.scene, arguments.count, arguments.seed);
  BroadPhase phase({broad_phase_method(arguments.method), arguments.threads});
  phase.add(crowd.boxes());
  phase.update();
  CrowdRecording recording;
  std::optional<TrackedCells> tracked;
  if (arguments.cells == "tracked") tracked.emplace(crowd.boxes());
  const auto record = [&] {
    if (tracked)
      recording.add(phase, tracked->frame(crowd.boxes()));
    else
      recording.add(phase);
  };
  record();
  std::vector<Aabb> to;
  for (std::size_t frame = 0; frame < arguments.frames; ++frame) {
    const std::span<const Index> moved = crowd.step();
    to.clear();
    for (const Index number : moved) to.push_back(crowd.boxes()[number]);
    phase.move(moved, to);
    phase.update();
    record();
    if (progress) progress(frame + 1, arguments.frames);
  }
  return recording;
}

std::string told_of(const CrowdRecording& recording) {
  std::string text = counted(recording.frames().size(), "frame");
  if (recording.stride() > 1)
    text += fmt::format(", one in {} of {}, as a page holds {:.0f} MB of them", recording.stride(), recording.seen(),
                        static_cast<double>(CrowdRecording::most_bytes) / 1e6);
  return text;
}

}  // namespace

CrowdView::CrowdView(const CrowdArguments& arguments) : arguments_(arguments) {
  if (arguments.png.empty() && !(arguments.size.empty() && arguments.look.empty()))
    throw Error("--size and --look are of a picture: say where it shall be written with --png FILE.png");
  if (arguments.html.empty() && arguments.png.empty()) {
    if (arguments.cells != "method")
      throw Error("--cells is of a page: say where it shall be written with --html FILE.html");
    return;
  }
  if (arguments.compare) throw Error("a page shows one method: name it with --method, or leave --compare out");
  if (arguments.count > CrowdRecording::most_boxes)
    throw Error(fmt::format("a page holds at most {}, not {}: say a smaller --count, or leave --html and --png out",
                            counted(CrowdRecording::most_boxes, "box", "boxes"), grouped(arguments.count)));
  require_distinct({{"--html", arguments.html}, {"--png", arguments.png}}, {});
  if (!arguments.html.empty()) require_output(arguments.html, OutputKind::page);
  if (arguments.png.empty()) return;
  require_known_keys(arguments.look);
  picture_ = PictureTarget{arguments.png, arguments.look};
  if (!arguments.size.empty()) set_size(*picture_, arguments.size);
  require_picture(*picture_);
}

std::string CrowdView::write() const {
  if (arguments_.html.empty() && !picture_) return {};
  const CrowdRecording recording = recorded(arguments_);
  const std::string page = crowd_page(
      recording, {.title = fmt::format("{}, {}", counted(arguments_.count, "box", "boxes"), arguments_.scene)});
  if (picture_) write_picture(page, *picture_);
  const UninterruptedWriting writing;
  std::string told;
  if (!arguments_.html.empty()) {
    write_view_page(page, arguments_.html);
    told += fmt::format("{}: {}, {:.1f} MB; open it in a browser.\n", printable(arguments_.html), told_of(recording),
                        static_cast<double>(std::filesystem::file_size(arguments_.html)) / 1e6);
  }
  if (picture_) told += fmt::format("{}: a picture of {}.\n", printable(picture_->path), told_of(recording));
  return told;
}

}  // namespace toccata::command
