#include <fmt/format.h>

#include <array>

#include "reports/glb/glb_recordings.hpp"
#include "reports/view/recorded_bodies.hpp"
#include "toccata/reports/pages.hpp"

namespace toccata {

using io::Json;

namespace {

using WorldFrame = WorldRecording::Frame;
using Change = WorldRecording::Change;

const std::array pairs_paints{io::GlbPaint{"pairs begun", 0xd55e00}, io::GlbPaint{"pairs kept", 0x0072b2},
                              io::GlbPaint{"pairs ended", 0x999999}};
constexpr std::array pairs_names{"begin", "persist", "end"};
const io::GlbPaint points_paint{"contact points", 0x000000};
const io::GlbPaint surfaces_paint{"surfaces", 0x56b4e9, 0.35};
const io::GlbPaint paths_paint{"paths", 0x0072b2};
const io::GlbPaint lengths_paint{"depths, distances and rays", 0xcc79a7};

std::vector<std::vector<io::GlbKey>> keys_of(const WorldRecording& recording) {
  std::vector<std::vector<io::GlbKey>> keys(recording.objects().size());
  for (std::size_t i = 0; i < recording.frames().size(); ++i) {
    const WorldFrame& frame = recording.frames()[i];
    for (const WorldRecording::Place& place : frame.placed) {
      if (i > 0 && keys[place.object].empty()) io::add_key(keys[place.object], 0, std::nullopt);
      io::add_key(keys[place.object], i, place.pose);
    }
    for (const Index object : frame.gone) io::add_key(keys[object], i, std::nullopt);
  }
  return keys;
}

std::vector<bool> are_in_pairs(const WorldRecording& recording) {
  std::vector<bool> are(recording.objects().size());
  for (const WorldFrame& frame : recording.frames())
    for (const WorldRecording::Pair& pair : frame.pairs) are[pair.a] = are[pair.b] = true;
  return are;
}

/// What is drawn of the pairs of a frame.
struct DrawnPairs {
  std::array<std::vector<Vec3>, 3> middles;  ///< begin, persist, end
  std::vector<Vec3> points, distances;

  explicit DrawnPairs(const WorldFrame& frame) {
    for (const WorldRecording::Touched& touched : frame.touched) points.push_back(touched.point);
    for (const WorldRecording::Pair& pair : frame.pairs) {
      std::vector<Vec3>& ends = middles[static_cast<std::size_t>(pair.change)];
      ends.insert(ends.end(), {pair.middle_a, pair.middle_b});
      if (pair.change != Change::end && pair.details) add(*pair.details);
    }
  }

 private:
  void add(const PairDetails& details) {
    for (const ModelManifold& manifold : details.manifolds)
      for (int i = 0; i < manifold.count; ++i) points.push_back(manifold.points[static_cast<std::size_t>(i)].position);
    if (details.distance && details.distance->upper > 0)
      distances.insert(distances.end(), {details.distance->on_a, details.distance->on_b});
  }
};

void add_steps(io::GlbScene& glb, const WorldRecording& recording) {
  io::GlbFrames pairs(glb, "pairs", recording.frames().size());
  for (std::size_t i = 0; i < recording.frames().size(); ++i) {
    const DrawnPairs drawn(recording.frames()[i]);
    io::Json extras = io::Json::object();
    for (std::size_t change = 0; change < pairs_names.size(); ++change) {
      pairs.add(pairs_names[change], drawn.middles[change], io::GlbMode::lines, pairs_paints[change]);
      extras[pairs_names[change]] = drawn.middles[change].size() / 2;
    }
    pairs.add("contact points", drawn.points, io::GlbMode::points, points_paint);
    pairs.add("distances", drawn.distances, io::GlbMode::lines, lengths_paint);
    pairs.end_frame(fmt::format("step {}", i), std::move(extras));
  }
  pairs.write();
}

void add_surfaces(io::GlbScene& glb, const WorldRecording& recording) {
  std::vector<std::size_t> nodes;
  for (const WorldRecording::Surface& surface : recording.surfaces()) {
    if (surface.corners.empty()) continue;
    const io::GlbFrame frame = io::GlbFrame::around(surface.corners);
    Json parts = Json::array();
    parts.push_back(glb.part(io::joined_part(surface.corners, frame), io::GlbMode::triangles, surfaces_paint));
    nodes.push_back(glb.add_node(surface.name, {}, frame, {{"mesh", glb.add_mesh(surface.name, std::move(parts))}}));
  }
  if (!nodes.empty()) glb.add_group("surfaces", nodes);
}

void add_paths(io::GlbScene& glb, const WorldRecording& recording) {
  std::vector<std::size_t> nodes;
  for (const WorldRecording::Path& path : recording.paths()) {
    std::vector<Vec3> ends;
    for (std::size_t i = 0; i + 1 < path.points.size(); ++i)
      ends.insert(ends.end(), {path.points[i], path.points[i + 1]});
    if (ends.empty()) continue;
    const io::GlbFrame frame = io::GlbFrame::around(ends);
    Json parts = Json::array();
    parts.push_back(glb.part(io::joined_part(ends, frame), io::GlbMode::lines, paths_paint));
    nodes.push_back(glb.add_node(path.name, {}, frame, {{"mesh", glb.add_mesh(path.name, std::move(parts))}}));
  }
  if (!nodes.empty()) glb.add_group("paths", nodes);
}

}  // namespace

std::string recording_glb(const WorldRecording& recording, const ViewOptions& options) {
  io::require_recorded(recording.frames().size(), recording.objects().size());
  io::RecordedBodies bodies(recording.objects());
  for (SceneInstance& posed : bodies.models) posed.pose = {};  // as their nodes move
  const auto keys = keys_of(recording);
  const io::ViewMeshes meshes(bodies.models, io::places_of(keys));
  io::GlbScene glb(bodies.models, meshes);
  io::add_moving_objects(glb, keys, are_in_pairs(recording));
  add_steps(glb, recording);
  add_surfaces(glb, recording);
  add_paths(glb, recording);
  return glb.file(options, bodies.scene.unit);
}

}  // namespace toccata
