#include "toccata/reports/pages.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <span>

#include "io/formats/json.hpp"
#include "io/formats/utf8.hpp"
#include "reports/view/counted.hpp"
#include "reports/view/display_frame.hpp"
#include "reports/view/drawn_cells.hpp"
#include "reports/view/filled_page.hpp"
#include "reports/view/quantised_boxes.hpp"
#include "reports/view/recorded_boxes.hpp"
#include "reports/view/view_data.hpp"
#include "toccata/core/error.hpp"
#include "toccata/reports/report.hpp"

namespace toccata {

using io::Json;

namespace {

using Frame = CrowdRecording::Frame;

/// Which items of a layer are of each moment: the first and how many.
class LayerMoments {
 public:
  void add(std::size_t end) {
    moments_.push_back({first_, end - first_});
    first_ = end;
  }
  [[nodiscard]] const Json& json() const { return moments_; }

 private:
  std::size_t first_ = 0;
  Json moments_ = Json::array();
};

class CrowdLayers {
 public:
  CrowdLayers(const CrowdRecording& recording, io::ViewData& data)
      : recording_(recording),
        data_(data),
        scene_(io::bounds_of(recording)),
        frame_(io::DisplayFrame::around(scene_)) {}

  void write(Json& header) {
    header["frame"] = {{"centre", {frame_.centre.x, frame_.centre.y, frame_.centre.z}}, {"size", frame_.size}};
    Json& layers = header["layers"] = Json::array();
    layers.push_back(bodies());
    layers.push_back(links());
    if (Json layer = cells(); !layer.is_null()) layers.push_back(std::move(layer));
  }

 private:
  Json bodies() {
    io::QuantisedBoxes boxes(scene_);
    LayerMoments moments;
    std::vector<bool> is_in_pair;
    for (const Frame& frame : recording_.frames()) {
      is_in_pair.assign(frame.boxes.size(), false);
      for (const IndexPair& pair : frame.pairs) is_in_pair[pair.first] = is_in_pair[pair.second] = true;
      for (Index i = 0; i < frame.boxes.size(); ++i)
        boxes.add(frame.boxes[i], !recording_.has_moved(i) ? 0 : is_in_pair[i] ? 2 : 1);
      moments.add(boxes.size());
    }
    return {{"kind", "bodies"},
            {"role", "bodies"},
            {"name", "Boxes"},
            {"data", boxes.written(frame_, data_)},
            {"classes", {"at rest", "moving", "moving, in a pair"}},
            {"moments", moments.json()}};
  }

  Json links() {
    std::size_t most_boxes = 0;
    for (const Frame& frame : recording_.frames()) most_boxes = std::max(most_boxes, frame.boxes.size());
    std::vector<std::uint32_t> numbers;
    LayerMoments moments;
    for (const Frame& frame : recording_.frames()) {
      for (const IndexPair& pair : frame.pairs) numbers.insert(numbers.end(), {pair.first, pair.second});
      moments.add(numbers.size() / 2);
    }
    return {{"kind", "links"},
            {"role", "pairs"},
            {"name", "Pairs"},
            {"of", 0},
            {"data", most_boxes > 65'536 ? in_four_bytes(numbers) : in_two_bytes(numbers)},
            {"moments", moments.json()}};
  }

  Json in_four_bytes(const std::vector<std::uint32_t>& numbers) {
    Json array = data_.add(std::span<const std::uint32_t>(numbers));
    array["bytes"] = 4;
    return array;
  }
  Json in_two_bytes(const std::vector<std::uint32_t>& numbers) {
    const std::vector<std::uint16_t> shorts(numbers.begin(), numbers.end());
    Json array = data_.add(std::span<const std::uint16_t>(shorts));
    array["bytes"] = 2;
    return array;
  }

  /// The groups of all frames: the same name is the same class.
  Json cells() {
    std::vector<std::string> classes;
    std::vector<std::vector<Aabb>> drawn;
    Aabb around;
    for (const Frame& frame : recording_.frames()) {
      drawn.push_back(io::drawn_cells(frame.space, scene_));
      for (const Aabb& cell : drawn.back()) io::widen(around, cell);
    }
    io::QuantisedBoxes boxes(around);
    LayerMoments moments;
    for (std::size_t i = 0; i < drawn.size(); ++i) {
      const BroadPhaseCells& space = recording_.frames()[i].space;
      std::vector<std::size_t> class_of;
      for (const CellGroup& group : space.groups) class_of.push_back(number_of(classes, group.name));
      for (std::size_t k = 0; k < drawn[i].size(); ++k) boxes.add(drawn[i][k], class_of[space.cells[k].group]);
      moments.add(boxes.size());
    }
    if (boxes.size() == 0) return nullptr;
    return {{"kind", "cells"},    {"role", "cells"},          {"name", "Cells"}, {"data", boxes.written(frame_, data_)},
            {"classes", classes}, {"moments", moments.json()}};
  }

  static std::size_t number_of(std::vector<std::string>& names, const std::string& name) {
    const auto found = std::find(names.begin(), names.end(), name);
    if (found != names.end()) return static_cast<std::size_t>(found - names.begin());
    names.push_back(name);
    return names.size() - 1;
  }

  const CrowdRecording& recording_;
  io::ViewData& data_;
  Aabb scene_;
  io::DisplayFrame frame_;
};

std::size_t count_without(const std::vector<IndexPair>& a, const std::vector<IndexPair>& b) {
  std::vector<IndexPair> rest;
  std::set_difference(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(rest));
  return rest.size();
}

/// What has begun and ended since the frame that is shown before; of the first, since the update before it.
std::string changes_of(std::span<const Frame> frames, std::size_t i) {
  const Frame& frame = frames[i];
  const std::size_t begin = i == 0 ? frame.begin : count_without(frame.pairs, frames[i - 1].pairs);
  const std::size_t end = i == 0 ? frame.end : count_without(frames[i - 1].pairs, frame.pairs);
  return fmt::format("{} begun, {} ended", begin, end);
}

Json time_of(const CrowdRecording& recording) {
  Json moments = Json::array();
  for (std::size_t i = 0; i < recording.frames().size(); ++i) {
    const Frame& frame = recording.frames()[i];
    moments.push_back({{"label", fmt::format("frame {}", frame.number)},
                       {"note", fmt::format("{}, {}; {}{}", io::counted(frame.pairs.size(), "pair", "pairs"),
                                            changes_of(recording.frames(), i), name_of(frame.method),
                                            frame.space.cells.empty()
                                                ? ""
                                                : ", " + io::counted(frame.space.cells.size(), "cell", "cells"))}});
  }
  return {{"per_second", 12}, {"moments", std::move(moments)}};
}

std::string summary_of(const CrowdRecording& recording) {
  const std::size_t boxes = recording.frames().front().boxes.size();
  std::string text = fmt::format("{} · {}", io::counted(boxes, "box", "boxes"),
                                 io::counted(recording.frames().size(), "frame", "frames"));
  if (recording.stride() > 1) text += fmt::format(" of {}: one in {}", recording.seen(), recording.stride());
  return text;
}

}  // namespace

std::string crowd_page(const CrowdRecording& recording, const ViewOptions& options) {
  if (recording.frames().empty()) throw Error("there is no frame to be shown: record an update first");
  io::ViewData data;
  Json header = {{"format", "toccata/view/4"},
                 {"title", io::as_utf8(options.title)},
                 {"up", options.up == UpAxis::y ? "y" : "z"},
                 {"summary", summary_of(recording)},
                 {"meshes", Json::array()},
                 {"objects", Json::array()},
                 {"words", Json::array()},
                 {"methods", Json::array()},
                 {"time", time_of(recording)}};
  CrowdLayers(recording, data).write(header);
  Scene no_objects;
  no_objects.unit = "unit";
  return io::filled_page(header, report_json(no_objects, {}, CheckReport{}), data);
}

}  // namespace toccata
