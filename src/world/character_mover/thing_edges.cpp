#include "world/character_mover/thing_edges.hpp"

#include <algorithm>
#include <cmath>

#include "math/constants.hpp"
#include "world/character_mover/rounded_box.hpp"

namespace toccata {
namespace {

/// How many slacks of heights the width of the slab between two things may be less than the way between two points of
/// them: then the one is the distance, and the other the shortest way, but for rounding.
constexpr double slacks_of_slab = 4;

/// Below this square of the sine between them two segments are taken as parallel.
constexpr double parallel_square = 0x1p-40;

/// So many times the square of a way is more than it, however points are rounded that are told to be farther apart than
/// 2⁻²⁰ of their coordinates.
constexpr double clearly_more = 1 + 0x1p-20;

struct FromTo {
  Vec3 start, along;
  [[nodiscard]] Vec3 at(double time) const { return start + time * along; }
};

/// The part of a segment at which it is nearest to a point.
double nearest_time(const FromTo& segment, const Vec3& point) {
  const double square = dot(segment.along, segment.along);
  return square > 0 ? std::clamp(dot(point - segment.start, segment.along) / square, 0.0, 1.0) : 0;
}

/// The shortest way that was found, from the edge of a thing to the core.
struct ShortestWay {
  double square = infinity;
  Vec3 from{}, to{};

  void see(const Vec3& edge_point, const Vec3& core_point) {
    const Vec3 way = core_point - edge_point;
    const double way_square = dot(way, way);
    if (!(way_square < square)) return;
    *this = {way_square, edge_point, core_point};
  }
};

/// Between the insides of two segments, or from an end of one (C. Ericson, "Real-Time Collision Detection", 2005,
/// section 5.1.9, whose cases are here tried one by one).
void see_segments(ShortestWay& way, const FromTo& core, const FromTo& edge) {
  for (const double end : {0.0, 1.0}) way.see(edge.at(nearest_time(edge, core.at(end))), core.at(end));
  for (const double end : {0.0, 1.0}) way.see(edge.at(end), core.at(nearest_time(core, edge.at(end))));
  const double a = dot(core.along, core.along), e = dot(edge.along, edge.along), b = dot(core.along, edge.along);
  const double squares = a * e - b * b;
  if (!(squares > parallel_square * a * e)) return;
  const Vec3 between = core.start - edge.start;
  const double time = (b * dot(edge.along, between) - e * dot(core.along, between)) / squares;
  if (!(time > 0 && time < 1)) return;
  const Vec3 point = core.at(time);
  way.see(edge.at(nearest_time(edge, point)), point);
}

}  // namespace

ThingEdges edges_of(const LevelSet& set) {
  ThingEdges thing;
  const auto* polytope = std::get_if<PosedPolytope>(&set);
  if (polytope == nullptr || polytope->vertex_count() > thing.corners.corners.size()) return thing;
  for (Index i = 0; i < polytope->vertex_count(); ++i) thing.corners.add(polytope->vertex(i));
  const HullTopology topology = polytope->topology();
  for (Index edge = 0; edge < topology.origin.size(); ++edge) {
    const Index from = topology.origin[edge], to = topology.target(edge);
    if (from < to) thing.edges[thing.count++] = {static_cast<std::uint8_t>(from), static_cast<std::uint8_t>(to)};
  }
  return thing;
}

ThingEdges edges_of(const Triangle& triangle) {
  ThingEdges thing;
  for (const Vec3& corner : triangle.vertex) thing.corners.add(corner);
  thing.edges = {{{0, 1}, {1, 2}, {2, 0}}};
  thing.count = 3;
  return thing;
}

std::optional<EdgeGap> edge_gap(const FewCorners& core, const ThingEdges& thing) {
  if (core.count == 0 || core.count > 2 || thing.count == 0) return {};
  const FewCorners& corners = thing.corners;
  // From a corner of the core, where differences of coordinates lose the least.
  const Vec3 origin = core.corners[0];
  const FromTo middle{{}, core.corners[core.count - 1] - origin};
  ShortestWay way;
  const RoundedBox around(merge(Aabb{{}, {}}, middle.along), 0);
  for (std::size_t i = 0; i < thing.count; ++i) {
    const Vec3 start = corners.corners[thing.edges[i].from] - origin;
    const Vec3 end = corners.corners[thing.edges[i].to] - origin;
    if (around.square_of_distance(merge(Aabb{start, start}, end)) > clearly_more * way.square) continue;
    see_segments(way, middle, {start, end - start});
  }
  const double length_of_way = std::sqrt(way.square), slack = height_slack(core.extent, corners.extent);
  if (!(length_of_way > 0x1p-20 * std::max(core.extent, corners.extent))) return {};
  const Vec3 normal = (1 / length_of_way) * (way.to - way.from);
  double top = -infinity;
  for (std::size_t i = 0; i < corners.count; ++i) top = std::max(top, dot(normal, corners.corners[i] - origin));
  const double width = std::min(0.0, dot(normal, middle.along)) - top;
  if (!(width >= length_of_way - slacks_of_slab * slack)) return {};
  return EdgeGap{width - slack, normal, origin + way.from};
}

}  // namespace toccata
