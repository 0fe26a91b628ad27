#include "crowd_view.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <utility>

#include "output.hpp"
#include "progress_bar.hpp"
#include "toccata/core/error.hpp"
#include "toccata/io/crowd_page.hpp"
#include "toccata/io/output_file.hpp"
#include "tracked_cells.hpp"
#include "view.hpp"
#include "words.hpp"

namespace toccata::command {
namespace {

CrowdRecording recorded(const CrowdQuestion& question, const std::string& cells) {
  ProgressBar bar("frames for the page");
  std::optional<TrackedCells> tracked;
  const auto tracked_cells = [&](const std::vector<Aabb>& boxes) {
    if (!tracked) tracked.emplace(boxes);
    return tracked->frame(boxes);
  };
  return record_crowd(question, bar.callback(), cells == "tracked" ? CrowdCells(tracked_cells) : CrowdCells());
}

std::string told_of(const CrowdRecording& recording) {
  std::string text = counted(recording.frames().size(), "frame");
  if (recording.stride() > 1)
    text += fmt::format(", one in {} of {}, as a page holds {:.0f} MB of them", recording.stride(), recording.seen(),
                        static_cast<double>(CrowdRecording::most_bytes) / 1e6);
  return text;
}

}  // namespace

CrowdView::CrowdView(const CrowdArguments& arguments, CrowdQuestion question)
    : arguments_(arguments), question_(std::move(question)) {
  picture_ = target_of(arguments).picture;
  if (arguments.html.empty() && arguments.png.empty()) {
    if (arguments.cells != "method")
      throw Error("--cells is of a page: say where it shall be written with --html FILE.html");
    return;
  }
  if (arguments.compare) throw Error("a page shows one method: name it with --method, or leave --compare out");
  if (arguments.count > CrowdRecording::most_boxes)
    throw Error(fmt::format("a page holds at most {}, not {}: say a smaller --count, or leave --html and --png out",
                            counted(CrowdRecording::most_boxes, "box", "boxes"), grouped(arguments.count)));
  require_distinct({{"--html", arguments.html}, {"--png", arguments.png}, {"--save-case", arguments.save_case}}, {});
  if (!arguments.html.empty()) require_output(arguments.html, OutputKind::page);
  if (picture_) require_picture(*picture_);
}

bool CrowdView::draws() const { return !arguments_.html.empty() || picture_.has_value(); }

std::string CrowdView::write() const {
  if (!draws()) return {};
  const CrowdRecording recording = recorded(question_, arguments_.cells);
  const std::string title = fmt::format("{}, {}", counted(arguments_.count, "box", "boxes"), arguments_.scene);
  return write(crowd_page(recording, {.title = title}), told_of(recording));
}

std::string CrowdView::write(const std::string& page, const std::string& holds) const {
  if (picture_) write_picture(page, *picture_);
  const UninterruptedWriting writing;
  std::string told;
  if (!arguments_.html.empty()) {
    write_view_page(page, arguments_.html);
    told += fmt::format("{}: {}, {:.1f} MB; open it in a browser.\n", printable(arguments_.html), holds,
                        static_cast<double>(std::filesystem::file_size(arguments_.html)) / 1e6);
  }
  if (picture_) told += fmt::format("{}: a picture of {}.\n", printable(picture_->path), holds);
  return told;
}

}  // namespace toccata::command
