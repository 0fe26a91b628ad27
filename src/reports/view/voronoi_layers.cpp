#include "reports/view/voronoi_layers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "io/formats/utf8.hpp"
#include "math/vec3_measures.hpp"
#include "toccata/core/error.hpp"
#include "toccata/methods/voronoi.hpp"
#include "toccata/shapes/convex_hull.hpp"

namespace toccata::io {
namespace {

constexpr Index most_vertices = 2000;
constexpr int arc_parts = 5;

/// The vertices in the shape's own frame.
std::vector<Vec3> corners_of(const SceneInstance& posed) {
  const Model& model = posed.model;
  if (model.has_mesh()) {
    const ConvexHull hull = hull_of_convex_mesh(model.mesh());
    std::vector<Vec3> corners;
    for (Index i = 0; i < hull.vertex_count(); ++i) corners.push_back(hull.vertex(i));
    return corners;
  }
  const Shape& shape = model.shape();
  if (const auto* point = std::get_if<Point>(&shape)) return {point->position()};
  if (const auto* segment = std::get_if<Segment>(&shape)) return {segment->start(), segment->end()};
  if (const auto* triangle = std::get_if<Triangle>(&shape)) return {triangle->vertex.begin(), triangle->vertex.end()};
  std::vector<Vec3> corners;
  if (const auto* box = std::get_if<Box>(&shape))
    for (int i = 0; i < 8; ++i) corners.push_back(box->corner(i));
  if (const auto* hull = std::get_if<ConvexHull>(&shape))
    for (Index i = 0; i < hull->vertex_count(); ++i) corners.push_back(hull->vertex(i));
  if (corners.empty())
    throw Error(
        fmt::format("a {} has no vertices, edges and faces: --voronoi is for boxes, triangles, convex hulls and "
                    "convex meshes",
                    name_of(shape)));
  return corners;
}

/// VoronoiCells in the world, up to a distance from the shape. A pose may change angles, so they are those of the world
/// hull.
class VoronoiCells {
 public:
  VoronoiCells(const ConvexHull& hull, double reach) : regions_(hull), t_(regions_.topology()), reach_(reach) {}

  /// Three corners of each triangle.
  [[nodiscard]] std::vector<Vec3> of_faces() {
    corners_.clear();
    for (Index h = 0; has_faces() && h < t_.origin.size(); ++h) {
      const Vec3 n = normal(h), p = at(t_.origin[h]), q = at(t_.target(h));
      add_square(p, q, out(q, n), out(p, n));
      const Vec3 first = at(t_.origin[t_.face_start[t_.face[h]]]);
      add(out(first, n), out(p, n), out(q, n));
    }
    return std::move(corners_);
  }

  [[nodiscard]] std::vector<Vec3> of_edges() {
    corners_.clear();
    for (Index h = 0; has_faces() && h < t_.origin.size(); ++h) {
      if (h > t_.twin[h]) continue;
      const Vec3 p = at(t_.origin[h]), q = at(t_.target(h));
      for (int i = 0; i < arc_parts; ++i) {
        const Vec3 from = arc(h, i), to = arc(h, i + 1);
        add_square(out(p, from), out(q, from), out(q, to), out(p, to));
        add(p, out(p, from), out(p, to));
        add(q, out(q, from), out(q, to));
      }
      add_square(p, q, out(q, arc(h, 0)), out(p, arc(h, 0)));
      add_square(p, q, out(q, arc(h, arc_parts)), out(p, arc(h, arc_parts)));
    }
    return std::move(corners_);
  }

  [[nodiscard]] std::vector<Vec3> of_vertices() {
    corners_.clear();
    for (Index h = 0; has_faces() && h < t_.origin.size(); ++h) {
      const Vec3 p = at(t_.origin[h]), middle = middle_of_normals(t_.origin[h]);
      for (int i = 0; i < arc_parts; ++i) {
        const Vec3 from = arc(h, i), to = arc(h, i + 1);
        add(p, out(p, from), out(p, to));
        add_patch(p, middle, from, to);
      }
    }
    return std::move(corners_);
  }

 private:
  [[nodiscard]] bool has_faces() const { return regions_.dimension() >= 2; }
  [[nodiscard]] Vec3 at(Index vertex) const { return regions_.vertex(vertex); }
  [[nodiscard]] Vec3 normal(Index half_edge) const { return regions_.face_plane(t_.face[half_edge]).normal; }
  [[nodiscard]] Vec3 out(const Vec3& from, const Vec3& direction) const { return from + reach_ * direction; }

  /// From the normal of one face at an edge to that of the other, turning about the edge.
  [[nodiscard]] Vec3 arc(Index half_edge, int part) const {
    const Vec3 from = normal(half_edge), to = normal(t_.twin[half_edge]);
    const Vec3 across = -regions_.edge_face_plane(half_edge).normal;  // out of the first face
    const double angle = std::atan2(std::max(dot(to, across), 0.0), dot(to, from)), turned = part * angle / arc_parts;
    return std::cos(turned) * from + std::sin(turned) * across;
  }

  [[nodiscard]] Vec3 middle_of_normals(Index vertex) const {
    Vec3 sum;
    Index h = t_.leaving[vertex];
    do {
      sum = sum + normal(h) - regions_.vertex_edge_plane(h).normal;
      h = t_.next(t_.twin[h]);
    } while (h != t_.leaving[vertex]);
    return unit_or_zero(sum);
  }

  /// Adds a patch of a ball, between a direction in the middle and two on the rim.
  void add_patch(const Vec3& p, const Vec3& middle, const Vec3& from, const Vec3& to) {
    const auto between = [&](const Vec3& rim, int part) {
      const double share = static_cast<double>(part) / arc_parts;
      return out(p, unit_or_zero((1 - share) * middle + share * rim));
    };
    for (int i = 0; i < arc_parts; ++i)
      add_square(between(from, i), between(from, i + 1), between(to, i + 1), between(to, i));
  }

  void add(const Vec3& a, const Vec3& b, const Vec3& c) { corners_.insert(corners_.end(), {a, b, c}); }
  void add_square(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
    add(a, b, c);
    add(a, c, d);
  }

  VoronoiRegions regions_;
  HullTopology t_;
  double reach_;
  std::vector<Vec3> corners_;
};

/// How far cells are drawn: a share of the size.
double reach_of(const ConvexHull& hull) {
  Vec3 lower = hull.vertex(0), upper = lower;
  for (Index i = 1; i < hull.vertex_count(); ++i)
    for (int axis = 0; axis < 3; ++axis) {
      lower[axis] = std::min(lower[axis], hull.vertex(i)[axis]);
      upper[axis] = std::max(upper[axis], hull.vertex(i)[axis]);
    }
  return 0.2 * plain_length(upper - lower);
}

DrawnVoronoi drawn_of(const SceneInstance& posed) {
  const ConvexHull hull = world_polytope(posed);
  VoronoiCells cells(hull, reach_of(hull));
  return {as_utf8(posed.name),
          {{"nearest to a face", cells.of_faces()},
           {"nearest to an edge", cells.of_edges()},
           {"nearest to a vertex", cells.of_vertices()}}};
}

}  // namespace

ConvexHull world_polytope(const SceneInstance& posed) {
  const std::string name = as_utf8(posed.name);
  std::vector<Vec3> vertices;
  try {
    vertices = transform(posed.pose, corners_of(posed));
  } catch (const Error& error) {
    throw Error(fmt::format("{} has no Voronoi regions to draw: {}", name, error.what()));
  }
  ConvexHull hull(vertices);
  if (hull.vertex_count() > most_vertices)
    throw Error(fmt::format("{} has {} vertices: the Voronoi regions of more than {} are too many to look at", name,
                            hull.vertex_count(), most_vertices));
  return hull;
}

std::vector<DrawnVoronoi> drawn_voronoi(std::span<const SceneInstance> models) {
  std::vector<DrawnVoronoi> drawn;
  for (const SceneInstance& posed : models) drawn.push_back(drawn_of(posed));
  return drawn;
}

std::vector<Json> voronoi_layers(std::span<const SceneInstance> models, const ViewMeshes& meshes, ViewData& data) {
  std::vector<Json> layers;
  for (const DrawnVoronoi& regions : drawn_voronoi(models)) {
    Json steps = Json::array();
    std::vector<float> numbers;
    for (const auto& [label, corners] : regions.kinds) {
      steps.push_back({{"label", label}, {"first", numbers.size() / 9}, {"count", corners.size() / 3}});
      for (const Vec3& corner : corners)
        for (const float number : meshes.frame().shown(corner)) numbers.push_back(number);
    }
    layers.push_back({{"kind", "triangles"},
                      {"role", "voronoi"},
                      {"data", data.add(numbers)},
                      {"steps", steps},
                      {"name", fmt::format("{}: Voronoi regions", regions.object)}});
  }
  return layers;
}

}  // namespace toccata::io
