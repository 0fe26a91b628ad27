#include "crowd_view.hpp"

#include <fmt/format.h>

#include <optional>
#include <utility>

#include "progress_bar.hpp"
#include "toccata/core/error.hpp"
#include "toccata/reports/pages.hpp"
#include "tracked_cells.hpp"
#include "words.hpp"

namespace toccata::command {
namespace {

std::string title_of(const CrowdQuestion& question) { return crowd_words(question) + ", " + question.scene; }
std::string title_of(const CrowdWorldQuestion& question) { return crowd_words(question); }

CrowdRecording recorded(const CrowdQuestion& question, bool is_tracked) {
  ProgressBar bar("frames to be shown");
  std::optional<TrackedCells> tracked;
  const auto tracked_cells = [&](const std::vector<Aabb>& boxes) {
    if (!tracked) tracked.emplace(boxes);
    return tracked->frame(boxes);
  };
  return record_crowd(question, bar.callback(), is_tracked ? CrowdCells(tracked_cells) : CrowdCells());
}

WorldRecording recorded(const CrowdWorldQuestion& question, bool) {
  ProgressBar bar("steps to be shown");
  return record_crowd_world(question, bar.callback());
}

std::string page_of(const CrowdRecording& recording, const ViewOptions& options) {
  return crowd_page(recording, options);
}
std::string page_of(const WorldRecording& recording, const ViewOptions& options) {
  return world_page(recording, options);
}

std::string told_of(const CrowdRecording& recording) {
  std::string text = counted(recording.frames().size(), "frame");
  if (recording.stride() > 1)
    text += fmt::format(", one in {} of {}, as a page holds {:.0f} MB of them", recording.stride(), recording.seen(),
                        static_cast<double>(CrowdRecording::most_bytes) / 1e6);
  return text;
}
std::string told_of(const WorldRecording& recording) { return counted(recording.frames().size(), "step"); }

void require_one_method(const SceneQuestion& question) {
  const auto* crowd = std::get_if<CrowdQuestion>(&question);
  if (crowd == nullptr) return;
  if (crowd->methods.size() > 1) throw Error("a page shows one method: name it with --method, or leave --compare out");
  if (crowd->count > CrowdRecording::most_boxes)
    throw Error(fmt::format("a page holds at most {}, not {}: say a smaller --count, or write no page",
                            counted(CrowdRecording::most_boxes, "box", "boxes"), grouped(crowd->count)));
}

}  // namespace

CrowdView::CrowdView(const CrowdArguments& arguments, SceneQuestion question)
    : question_(std::move(question)), target_(target_of(arguments)), is_tracked_(arguments.cells == "tracked") {
  require_view(target_, arguments);
  if (draws_something(target_))
    require_one_method(question_);
  else if (is_tracked_)
    throw Error("--cells is of a page: say where it shall be written with --html FILE.html");
}

std::string CrowdView::write() const {
  if (!draws_something(target_)) return {};
  const auto written = [&](const auto& question) {
    const auto recording = recorded(question, is_tracked_);
    ViewOptions options = target_.options;
    options.title = title_of(question);
    const bool has_page = !target_.path.empty() || target_.picture;
    write_files(target_, has_page ? page_of(recording, options) : "",
                target_.glb.empty() ? "" : recording_glb(recording, options));
    return written_lines(target_, told_of(recording));
  };
  if (const auto* world = std::get_if<CrowdWorldQuestion>(&question_)) return written(*world);
  return written(std::get<CrowdQuestion>(question_));
}

}  // namespace toccata::command
