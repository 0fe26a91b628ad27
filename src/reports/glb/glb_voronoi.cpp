#include <array>
#include <utility>

#include "reports/glb/glb_scene.hpp"
#include "reports/view/voronoi_layers.hpp"
#include "reports/view/voronoi_walk_layers.hpp"

namespace toccata::io {
namespace {

constexpr double seen_through = 0.2;
const std::array paints{GlbPaint{"nearest to faces", 0x0072b2, seen_through},
                        GlbPaint{"nearest to edges", 0xe69f00, seen_through},
                        GlbPaint{"nearest to vertices", 0x009e73, seen_through}};
const GlbPaint walk_paint{"walks", 0xcc79a7};

std::size_t add_visit(GlbScene& glb, const DrawnVisit& visit) {
  const GlbFrame frame = GlbFrame::around(visit.ends);
  const std::string name = "visit " + visit.label;
  Json parts = Json::array();
  parts.push_back(glb.part(joined_part(visit.ends, frame), GlbMode::lines, walk_paint));
  return glb.add_node(name, {}, frame,
                      {{"mesh", glb.add_mesh(name, std::move(parts))},
                       {"extras", {{"found", visit.note}, {"distance", visit.distance}}}});
}

}  // namespace

void add_voronoi(GlbScene& glb) {
  std::vector<std::size_t> objects;
  for (const DrawnVoronoi& regions : drawn_voronoi(glb.models())) {
    std::vector<std::size_t> kinds;
    for (std::size_t i = 0; i < regions.kinds.size(); ++i) {
      const auto& [label, corners] = regions.kinds[i];
      if (corners.empty()) continue;  // a point and a segment have no faces
      const GlbFrame frame = GlbFrame::around(corners);
      Json parts = Json::array();
      parts.push_back(glb.part(joined_part(corners, frame), GlbMode::triangles, paints[i]));
      kinds.push_back(glb.add_node(label, {}, frame, {{"mesh", glb.add_mesh(label, std::move(parts))}}));
    }
    if (!kinds.empty()) objects.push_back(glb.add_parent("Voronoi regions of " + regions.object, kinds));
  }
  glb.add_group("Voronoi regions", objects);
}

void add_voronoi_walks(GlbScene& glb) {
  std::vector<std::size_t> walks;
  for (const DrawnWalk& walk : drawn_voronoi_walks(glb.models())) {
    std::vector<std::size_t> visits;
    for (const DrawnVisit& visit : walk.visits) visits.push_back(add_visit(glb, visit));
    if (!visits.empty()) walks.push_back(glb.add_parent("Voronoi walk of " + walk.a + " and " + walk.b, visits));
  }
  glb.add_group("Voronoi walks", walks);
}

}  // namespace toccata::io
