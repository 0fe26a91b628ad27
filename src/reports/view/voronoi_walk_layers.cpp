#include "reports/view/voronoi_walk_layers.hpp"

#include <fmt/format.h>

#include <cmath>

#include "io/formats/utf8.hpp"
#include "reports/view/voronoi_layers.hpp"
#include "toccata/core/error.hpp"
#include "toccata/methods/voronoi.hpp"

namespace toccata::io {
namespace {

using Kind = ConvexFeature::Kind;

constexpr std::size_t most_pairs = 32;

/// A polytope in the world.
struct Walked {
  std::string name;
  ConvexHull hull;
  VoronoiRegions regions;
};

std::string name_of(const ConvexFeature& feature) {
  const char* kind = feature.kind == Kind::vertex ? "vertex" : feature.kind == Kind::edge ? "edge" : "face";
  return fmt::format("{} {}", kind, feature.index);
}

const char* words_of(WalkEnd end) {
  if (end == WalkEnd::nearest) return "the nearest";
  return end == WalkEnd::tie ? "the nearest, but for rounding"
                             : "the walk has come behind a face, so GJK tells the rest";
}

/// Ends of segments: the edges of a feature.
void add_edges(const VoronoiRegions& regions, const ConvexFeature& feature, std::vector<Vec3>& ends) {
  const HullTopology& t = regions.topology();
  const auto add = [&](Index half_edge) {
    ends.push_back(regions.vertex(t.origin[half_edge]));
    ends.push_back(regions.vertex(t.target(half_edge)));
  };
  if (feature.kind == Kind::edge) add(feature.index);
  if (feature.kind == Kind::face)
    for (Index h = t.face_start[feature.index]; h < t.face_start[feature.index + 1]; ++h) add(h);
}

/// What is drawn at a visit.
std::vector<Vec3> ends_at(const Walked& a, const Walked& b, const std::vector<VoronoiVisit>& visits, std::size_t i) {
  std::vector<Vec3> ends{visits[i].point_a, visits[i].point_b};
  add_edges(a.regions, visits[i].on_a, ends);
  add_edges(b.regions, visits[i].on_b, ends);
  for (std::size_t k = 0; k < i; ++k) {
    ends.insert(ends.end(), {visits[k].point_a, visits[k + 1].point_a});
    ends.insert(ends.end(), {visits[k].point_b, visits[k + 1].point_b});
  }
  return ends;
}

std::string note_of(const VoronoiPath& path, std::size_t i) {
  const VoronoiVisit& visit = path.visits[i];
  const std::string apart =
      fmt::format("{}, {}; {:.6g} apart", name_of(visit.on_a), name_of(visit.on_b), std::sqrt(visit.distance_squared));
  return i + 1 < path.visits.size() ? apart : fmt::format("{}: {}", apart, words_of(path.end));
}

DrawnWalk walk_of(const Walked& a, const Walked& b) {
  TrackedPair tracked;
  VoronoiPath path;
  (void)distance_by_voronoi_walk(PosedPolytope(a.hull), a.regions, PosedPolytope(b.hull), b.regions, tracked, path);
  DrawnWalk walk{a.name, b.name, {}};
  for (std::size_t i = 0; i < path.visits.size(); ++i)
    walk.visits.push_back({ends_at(a, b, path.visits, i), fmt::format("{} of {}", i + 1, path.visits.size()),
                           note_of(path, i), std::sqrt(path.visits[i].distance_squared)});
  return walk;
}

Json layer_of(const DrawnWalk& walk, const ViewMeshes& meshes, ViewData& data) {
  Json steps = Json::array();
  std::vector<float> numbers;
  for (const DrawnVisit& visit : walk.visits) {
    const std::size_t first = numbers.size() / 6;
    for (const Vec3& end : visit.ends)
      for (const float number : meshes.frame().shown(end)) numbers.push_back(number);
    steps.push_back(
        {{"label", visit.label}, {"note", visit.note}, {"first", first}, {"count", numbers.size() / 6 - first}});
  }
  return {{"kind", "segments"},
          {"role", "voronoi-walk"},
          {"name", fmt::format("{} and {}: Voronoi walk", walk.a, walk.b)},
          {"data", data.add(numbers)},
          {"steps", steps}};
}

}  // namespace

std::vector<DrawnWalk> drawn_voronoi_walks(std::span<const SceneInstance> models) {
  const std::size_t pairs = models.size() * (models.size() - 1) / 2;
  if (models.size() < 2 || pairs > most_pairs)
    throw Error(fmt::format("--voronoi-walk is about 1 to {} pairs of objects, and here are {}: give two objects",
                            most_pairs, models.size() < 2 ? 0 : pairs));
  std::vector<Walked> walked;
  for (const SceneInstance& posed : models) {
    const ConvexHull hull = world_polytope(posed);
    walked.push_back({as_utf8(posed.name), hull, VoronoiRegions(hull)});
  }
  std::vector<DrawnWalk> walks;
  for (std::size_t a = 0; a < walked.size(); ++a)
    for (std::size_t b = a + 1; b < walked.size(); ++b) walks.push_back(walk_of(walked[a], walked[b]));
  return walks;
}

std::vector<Json> voronoi_walk_layers(std::span<const SceneInstance> models, const ViewMeshes& meshes, ViewData& data) {
  std::vector<Json> layers;
  for (const DrawnWalk& walk : drawn_voronoi_walks(models)) layers.push_back(layer_of(walk, meshes, data));
  return layers;
}

}  // namespace toccata::io
