#include "toccata/reports/pages.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "io/formats/json.hpp"
#include "io/formats/utf8.hpp"
#include "reports/report_parts.hpp"
#include "reports/view/counted.hpp"
#include "reports/view/filled_page.hpp"
#include "reports/view/recorded_bodies.hpp"
#include "reports/view/recorded_motion.hpp"
#include "reports/view/view_data.hpp"
#include "reports/view/view_meshes.hpp"
#include "toccata/core/error.hpp"
#include "toccata/reports/report.hpp"

namespace toccata {

using io::Json;

namespace {

using Change = WorldRecording::Change;
using RecordedFrame = WorldRecording::Frame;
using RecordedPair = WorldRecording::Pair;

constexpr std::array<const char*, 3> change_names{"begin", "persist", "end"};

const char* name_of(Change change) { return change_names[static_cast<std::size_t>(change)]; }

std::size_t count_of(const RecordedFrame& frame, Change change) {
  std::size_t count = 0;
  for (const RecordedPair& pair : frame.pairs) count += pair.change == change ? 1U : 0U;
  return count;
}

Json json_of(const RecordedPair& pair) {
  Json json = {
      {"a_index", pair.a}, {"b_index", pair.b}, {"change", name_of(pair.change)}, {"in_contact", pair.in_contact}};
  if (!pair.details) return json;
  const PairDetails& details = *pair.details;
  if (details.relation) {
    json["verb"] = verb_of(*details.relation);
    json["remark"] = remark_on(*details.relation);
  }
  if (details.distance) io::add(json["distance"] = Json::object(), *details.distance);
  if (details.penetration) json["penetration"] = io::json_of(*details.penetration);
  if (details.manifold || !details.manifolds.empty()) {
    int count = 0;
    for (const ModelManifold& manifold : details.manifolds) count += manifold.count;
    json["points"] = count;
  }
  return json;
}

std::string report_of(const WorldRecording& recording, const io::RecordedBodies& bodies) {
  Json json = io::report_head("toccata/world/2", bodies.scene, io::objects_json(bodies.scene, bodies.models), {});
  Json& steps = json["steps"] = Json::array();
  for (const RecordedFrame& frame : recording.frames()) {
    Json pairs = Json::array();
    for (const RecordedPair& pair : frame.pairs) pairs.push_back(json_of(pair));
    steps.push_back({{"pairs", std::move(pairs)}});
  }
  return io::line_of(json);
}

/// A layer with items of every moment.
class MomentLayer {
 public:
  MomentLayer(const char* kind, const char* role, const std::string& name, std::size_t width)
      : layer_{{"kind", kind}, {"role", role}, {"name", name}}, width_(width) {}

  /// What is too far away for the floats of a graphics card is left out.
  void add(const io::DisplayFrame& frame, std::initializer_list<Vec3> points) {
    std::vector<float> numbers;
    for (const Vec3& point : points)
      for (const float number : frame.shown(point)) {
        if (!std::isfinite(number)) return;
        numbers.push_back(number);
      }
    numbers_.insert(numbers_.end(), numbers.begin(), numbers.end());
  }
  /// A point and a direction, which is shown as it is.
  void add_arrow(const io::DisplayFrame& frame, const Vec3& point, const Vec3& direction) {
    const std::size_t before = numbers_.size();
    add(frame, {point});
    if (numbers_.size() == before) return;
    for (int axis = 0; axis < 3; ++axis) numbers_.push_back(static_cast<float>(direction[axis]));
  }
  void end_moment() {
    const std::size_t end = numbers_.size() / width_;
    moments_.push_back({first_, end - first_});
    first_ = end;
  }
  /// What was added is there at so many moments.
  void end_moments(std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) moments_.push_back({0, numbers_.size() / width_});
  }
  void write(Json& layers, io::ViewData& data) {
    if (numbers_.empty()) return;
    layer_["data"] = data.add(numbers_);
    layer_["moments"] = std::move(moments_);
    layers.push_back(std::move(layer_));
  }

 private:
  Json layer_;
  std::size_t width_;
  std::vector<float> numbers_;
  std::size_t first_ = 0;
  Json moments_ = Json::array();
};

/// What is there at all moments.
void add_lasting(const WorldRecording& recording, const io::DisplayFrame& frame, Json& written, io::ViewData& data) {
  const std::size_t moments = recording.frames().size();
  for (const WorldRecording::Surface& surface : recording.surfaces()) {
    MomentLayer layer("triangles", "surface", surface.name, 9);
    for (std::size_t i = 0; i + 2 < surface.corners.size(); i += 3)
      layer.add(frame, {surface.corners[i], surface.corners[i + 1], surface.corners[i + 2]});
    layer.end_moments(moments);
    layer.write(written, data);
  }
  for (const WorldRecording::Path& path : recording.paths()) {
    MomentLayer layer("segments", "path", path.name, 6);
    for (std::size_t i = 0; i + 1 < path.points.size(); ++i) layer.add(frame, {path.points[i], path.points[i + 1]});
    layer.end_moments(moments);
    layer.write(written, data);
  }
}

Json layers_of(const WorldRecording& recording, const io::DisplayFrame& frame, io::ViewData& data) {
  std::array<MomentLayer, 6> layers{MomentLayer{"segments", "begin", "Pairs that begin", 6},
                                    MomentLayer{"segments", "persist", "Pairs that persist", 6},
                                    MomentLayer{"segments", "end", "Pairs that end", 6},
                                    MomentLayer{"points", "contact", "Contact points", 3},
                                    MomentLayer{"segments", "distance", "Distance", 6},
                                    MomentLayer{"arrows", "normal", "Normals", 6}};
  for (const RecordedFrame& one : recording.frames()) {
    for (const RecordedPair& pair : one.pairs) {
      layers[static_cast<std::size_t>(pair.change)].add(frame, {pair.middle_a, pair.middle_b});
      if (pair.change == Change::end || !pair.details) continue;
      for (const ModelManifold& manifold : pair.details->manifolds)
        for (int i = 0; i < manifold.count; ++i)
          layers[3].add(frame, {manifold.points[static_cast<std::size_t>(i)].position});
      if (const auto& distance = pair.details->distance; distance && distance->upper > 0)
        layers[4].add(frame, {distance->on_a, distance->on_b});
    }
    for (const WorldRecording::Touched& touched : one.touched) {
      layers[3].add(frame, {touched.point});
      layers[5].add_arrow(frame, touched.point, touched.normal);
    }
    for (MomentLayer& layer : layers) layer.end_moment();
  }
  Json written = Json::array();
  for (MomentLayer& layer : layers) layer.write(written, data);
  add_lasting(recording, frame, written, data);
  return written;
}

Json time_of(const WorldRecording& recording) {
  Json moments = Json::array();
  for (std::size_t i = 0; i < recording.frames().size(); ++i) {
    const RecordedFrame& frame = recording.frames()[i];
    const std::size_t begin = count_of(frame, Change::begin), persist = count_of(frame, Change::persist);
    moments.push_back(
        {{"label", frame.label.empty() ? fmt::format("step {}", i) : frame.label},
         {"note", fmt::format("{}, {} begin, {} persist; {} end", io::counted(begin + persist, "pair", "pairs"), begin,
                              persist, count_of(frame, Change::end))}});
  }
  return {{"per_second", 12}, {"moments", std::move(moments)}};
}

}  // namespace

std::string world_page(const WorldRecording& recording, const ViewOptions& options) {
  if (recording.frames().empty()) throw Error("there is no step to be shown: record one first");
  const io::RecordedBodies bodies(recording.objects());
  const io::ViewMeshes meshes(bodies.models, io::places_of(recording));
  io::ViewData data;
  Json header = {{"format", "toccata/view/4"},
                 {"title", io::as_utf8(options.title)},
                 {"up", options.up == UpAxis::y ? "y" : "z"},
                 {"summary", io::counted(bodies.models.size(), "body", "bodies") + " · " +
                                 io::counted(recording.frames().size(), "step", "steps")}};
  meshes.write(header, data);
  header["words"] = Json::array();
  header["methods"] = Json::array();
  header["motion"] = io::motion_of(recording, meshes.frame(), data);
  header["layers"] = layers_of(recording, meshes.frame(), data);
  header["time"] = time_of(recording);
  return io::filled_page(header, report_of(recording, bodies), data);
}

}  // namespace toccata
