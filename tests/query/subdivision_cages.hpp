#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <set>
#include <utility>
#include <vector>

#include "toccata/core/random.hpp"
#include "toccata/query/subdivision.hpp"

namespace toccata::test {

inline PolygonMesh polygons_of(std::vector<Vec3> vertices, const std::vector<std::vector<Index>>& faces) {
  PolygonMesh mesh{std::move(vertices), {}, {0}};
  for (const std::vector<Index>& face : faces) {
    mesh.corners.insert(mesh.corners.end(), face.begin(), face.end());
    mesh.first.push_back(static_cast<Index>(mesh.corners.size()));
  }
  return mesh;
}

inline PolygonMesh cube_cage() {
  return polygons_of(
      {{-1, -1, -1}, {1, -1, -1}, {1, 1, -1}, {-1, 1, -1}, {-1, -1, 1}, {1, -1, 1}, {1, 1, 1}, {-1, 1, 1}},
      {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}});
}

/// With a vertex that lies between two faces and nothing else.
inline PolygonMesh cage_with_a_vertex_of_two() {
  PolygonMesh cube = cube_cage();
  cube.vertices.push_back({0.1, -0.2, 1.1});
  return polygons_of(
      cube.vertices,
      {{0, 3, 2, 1}, {4, 5, 6, 8}, {4, 8, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}});
}

/// Two squares, or twice two triangles, that meet in vertex 2 only.
inline PolygonMesh pinched_sheet(bool triangles) {
  const std::vector<Vec3> vertices{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0.5}, {2, 1, 0}, {2, 2, 0.5}, {1, 2, 0}};
  if (triangles) return polygons_of(vertices, {{0, 1, 2}, {0, 2, 3}, {2, 4, 5}, {2, 5, 6}});
  return polygons_of(vertices, {{0, 1, 2, 3}, {2, 4, 5, 6}});
}

/// Two poles with `valence` triangles each.
inline PolygonMesh bipyramid_cage(int valence) {
  std::vector<Vec3> vertices{{0, 0, 1}, {0, 0, -1}};
  std::vector<std::vector<Index>> faces;
  const auto n = static_cast<Index>(valence);
  for (Index i = 0; i < n; ++i) {
    const double angle = 2 * std::numbers::pi * i / n;
    vertices.push_back({std::cos(angle), std::sin(angle), 0});
    const Index here = 2 + i, next = 2 + (i + 1) % n;
    faces.push_back({0, here, next});
    faces.push_back({1, next, here});
  }
  return polygons_of(std::move(vertices), faces);
}

/// All vertices regular: quadrangles, or triangles cut from them.
inline PolygonMesh torus_cage(Index around, Index across, bool triangles) {
  std::vector<Vec3> vertices;
  std::vector<std::vector<Index>> faces;
  for (Index i = 0; i < around; ++i)
    for (Index j = 0; j < across; ++j) {
      const double u = 2 * std::numbers::pi * i / around, v = 2 * std::numbers::pi * j / across;
      const double r = 2 + 0.7 * std::cos(v);
      vertices.push_back({r * std::cos(u), r * std::sin(u), 0.7 * std::sin(v)});
      const auto at = [&](Index a, Index b) { return (a % around) * across + b % across; };
      const Index p = at(i, j), q = at(i + 1, j), s = at(i + 1, j + 1), t = at(i, j + 1);
      if (triangles) {
        faces.push_back({p, q, s});
        faces.push_back({p, s, t});
      } else {
        faces.push_back({p, q, s, t});
      }
    }
  return polygons_of(std::move(vertices), faces);
}

/// Open, over the plane, of `count` times `count` quadrangles or twice as many triangles.
inline PolygonMesh sheet_cage(Index count, bool triangles) {
  std::vector<Vec3> vertices;
  std::vector<std::vector<Index>> faces;
  for (Index i = 0; i <= count; ++i)
    for (Index j = 0; j <= count; ++j) vertices.push_back({double(i), double(j), 0});
  for (Index i = 0; i < count; ++i)
    for (Index j = 0; j < count; ++j) {
      const Index p = i * (count + 1) + j, q = p + count + 1;
      if (triangles) {
        faces.push_back({p, q, q + 1});
        faces.push_back({p, q + 1, p + 1});
      } else {
        faces.push_back({p, q, q + 1, p + 1});
      }
    }
  return polygons_of(std::move(vertices), faces);
}

inline PolygonMesh shaken(PolygonMesh mesh, double by, Random& random) {
  for (Vec3& v : mesh.vertices) v += {random.between(-by, by), random.between(-by, by), random.between(-by, by)};
  return mesh;
}

/// Some edges and vertices, sharp for ever or not.
inline CageFeatures random_features(const PolygonMesh& mesh, bool for_ever, Random& random) {
  const auto sharpness = [&] {
    constexpr std::array<double, 4> some{0.375, 1, 2.25, 3};
    return for_ever ? std::numeric_limits<double>::infinity() : some[random.below(4)];
  };
  std::set<std::pair<Index, Index>> seen;
  CageFeatures features{.border = random.below(2) == 0 ? CageBorder::smooth : CageBorder::sharp_corner};
  for (std::size_t f = 0; f + 1 < mesh.first.size(); ++f)
    for (Index i = mesh.first[f]; i < mesh.first[f + 1]; ++i) {
      const Index next = i + 1 == mesh.first[f + 1] ? mesh.first[f] : i + 1;
      const bool is_seen = !seen.insert(std::minmax(mesh.corners[i], mesh.corners[next])).second;
      if (!is_seen && random.below(5) == 0)
        features.creases.push_back({mesh.corners[i], mesh.corners[next], sharpness()});
    }
  for (Index v = 0; v < mesh.vertices.size(); ++v)
    if (random.below(12) == 0) features.corners.push_back({v, sharpness()});
  return features;
}

struct CageCase {
  PolygonMesh polygons;
  SubdivisionScheme scheme;
};

/// Cages of both schemes: regular, extraordinary of valences from two to twelve, open, and of two that meet in a vertex
/// only.
inline std::vector<CageCase> cage_cases(Random& random) {
  std::vector<CageCase> cases{{cube_cage(), SubdivisionScheme::catmull_clark},
                              {cage_with_a_vertex_of_two(), SubdivisionScheme::catmull_clark}};
  for (const SubdivisionScheme scheme : {SubdivisionScheme::loop, SubdivisionScheme::catmull_clark}) {
    const bool triangles = scheme == SubdivisionScheme::loop;
    cases.push_back({torus_cage(5, 4, triangles), scheme});
    cases.push_back({pinched_sheet(triangles), scheme});
    cases.push_back({shaken(sheet_cage(3, triangles), 0.3, random), scheme});
    for (const int valence : {3, 4, 5, 6, 7, 9, 12})
      cases.push_back({shaken(bipyramid_cage(valence), 0.2, random), scheme});
  }
  return cases;
}

}  // namespace toccata::test
