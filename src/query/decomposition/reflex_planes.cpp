#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include "math/vec3_measures.hpp"
#include "query/decomposition/cut_search.hpp"
#include "shapes/welded_mesh.hpp"

namespace toccata {
namespace {

constexpr std::size_t most_edges = 4096;

struct SharedEdge {
  Index triangle = 0;
  Index other = 0;
  Index from = 0;  ///< corners of `triangle`, as numbers 0 to 2
  Index apex = 0;  ///< the corner of `other` that is not on the edge
  double weight = 0;
};

class EdgeReader {
 public:
  EdgeReader(const TriangleMesh& mesh, const SolidFrame& frame, double outward)
      : mesh_(mesh), frame_(frame), outward_(outward) {}

  [[nodiscard]] Vec3 corner(Index triangle, Index i) const {
    return mesh_.vertices()[mesh_.triangles()[triangle][i % 3]];
  }
  [[nodiscard]] Vec3 local(Index triangle, Index i) const { return frame_.local(corner(triangle, i)); }
  [[nodiscard]] Vec3 normal(Index t) const {
    return outward_ * plain_unit_or_zero(cross(local(t, 1) - local(t, 0), local(t, 2) - local(t, 0)));
  }

  /// Its length times the sine of the angle by which the faces turn inward; at most 0 where the solid is convex.
  [[nodiscard]] double weight(const SharedEdge& e) const {
    const Vec3 way = local(e.triangle, e.from + 1) - local(e.triangle, e.from);
    const Vec3 to_apex = local(e.other, e.apex) - local(e.triangle, e.from);
    const double turned = dot(normal(e.triangle), plain_unit_or_zero(to_apex));
    return turned <= 1e-9 ? 0 : turned * std::sqrt(dot(way, way));
  }

 private:
  const TriangleMesh& mesh_;
  const SolidFrame& frame_;
  double outward_;
};

/// Edges of two triangles that run along it against each other.
std::vector<SharedEdge> shared_edges(const TriangleMesh& mesh) {
  const std::vector<WeldedEdge> uses = edges_of_triangles(weld(mesh));
  std::vector<SharedEdge> edges;
  for (std::size_t i = 0; i + 1 < uses.size(); ++i) {
    const WeldedEdge &a = uses[i], &b = uses[i + 1];
    if (a.low == b.low && a.high == b.high && a.upward != b.upward)
      edges.push_back({a.triangle, b.triangle, a.corner, (b.corner + 2) % 3, 0});
  }
  return edges;
}

/// Planes that are nearly one are taken as one.
class PlaneNumbers {
 public:
  explicit PlaneNumbers(const SolidFrame& frame) : frame_(frame) {}

  Index number_of(const PlaneChoice& choice) {
    RoundedPlane plane = frame_.plane(choice);
    const Vec3& n = plane.normal;
    const double sign =
        n.x < -1e-7 || (std::fabs(n.x) <= 1e-7 && (n.y < -1e-7 || (std::fabs(n.y) <= 1e-7 && n.z < 0))) ? -1 : 1;
    const auto step = [&](double value) { return std::llround(sign * value * 0x1p24); };
    const auto key = std::tuple(step(n.x), step(n.y), step(n.z), step(plane.offset));
    const auto [at, is_new] = numbers_.try_emplace(key, static_cast<Index>(planes.size()));
    if (is_new) planes.push_back({choice, plane});
    return at->second;
  }

  std::vector<WeightedPlane> planes;

 private:
  const SolidFrame& frame_;
  std::map<std::tuple<long long, long long, long long, long long>, Index> numbers_;
};

}  // namespace

ReflexPlanes reflex_planes(const TriangleMesh& mesh, const SolidFrame& frame, double outward) {
  const EdgeReader reader(mesh, frame, outward);
  std::vector<SharedEdge> edges = shared_edges(mesh);
  for (SharedEdge& e : edges) e.weight = reader.weight(e);
  std::erase_if(edges, [](const SharedEdge& e) { return e.weight <= 0; });
  std::ranges::stable_sort(edges, [](const SharedEdge& a, const SharedEdge& b) { return a.weight > b.weight; });
  if (edges.size() > most_edges) edges.resize(most_edges);

  ReflexPlanes result;
  PlaneNumbers numbers(frame);
  const auto of_triangle = [&](Index t) {
    return PlaneChoice{reader.corner(t, 0), reader.normal(t), true, {reader.corner(t, 1), reader.corner(t, 2)}};
  };
  for (const SharedEdge& e : edges) {
    const Vec3 p = reader.local(e.triangle, e.from), q = reader.local(e.triangle, e.from + 1);
    const Vec3 other = reader.normal(e.other);
    if (dot(other, other) == 0) continue;
    result.edges.push_back(
        {{p, q}, e.weight, {numbers.number_of(of_triangle(e.triangle)), numbers.number_of(of_triangle(e.other))}});
  }
  result.planes = std::move(numbers.planes);
  return result;
}

}  // namespace toccata
