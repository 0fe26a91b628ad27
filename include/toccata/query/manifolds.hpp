#pragma once

#include <array>
#include <vector>

#include "toccata/core/index.hpp"
#include "toccata/narrow/convex_convex.hpp"
#include "toccata/query/model.hpp"
#include "toccata/query/pair_query.hpp"

namespace toccata {

/// Where two models touch or overlap along one normal: up to four points that stand for all of their contacts that have
/// it, and the two elements (see Model) at which each of them lies. Features of points are those of these elements.
struct ModelManifold : Manifold {
  std::array<Index, 4> elements_a{};
  std::array<Index, 4> elements_b{};
  friend constexpr bool operator==(const ModelManifold&, const ModelManifold&) = default;
};

/// Where any two models touch or overlap: of convex shapes and half-spaces their `manifold`; of meshes, height fields
/// and compounds one for each normal that their contacts have, in the order of the least elements. Normals that differ
/// by less than 10⁻⁶ are one.
///
/// What slides over a surface does not catch on its inner edges: a normal at a triangle is one along which the surface
/// does not rise beside the point of contact. Within a face it is the face's normal, at an edge between two faces that
/// fold away from each other one between theirs, at a vertex likewise (their Voronoi regions;
/// docs/methods/manifolds.md), and outwards of a solid. Where the shortest way to part two elements is no such
/// direction, the shortest among the normals of the triangles and of those beyond their convex edges takes its place,
/// or another triangle has the contact.
///
/// Empty exactly when the two are apart, but for two half-spaces, and for what lies wholly within the other where no
/// penetration is defined (pairs.hpp) or found (`depth_bracket`): an open mesh in a closed one. What lies wholly within
/// the other has one point along the direction of the penetration. Throws like `overlap`.
[[nodiscard]] std::vector<ModelManifold> manifolds(const Model& a, const Model& b, const PairQuery& query = {});

/// The same, for a caller who asks often.
[[nodiscard]] std::vector<ModelManifold> manifolds(const Model& a, const Model& b, const PairQuery& query,
                                                   Workspace& workspace);

/// Make a Model of it, once: `Model(mesh)`.
template <class A, class B>
requires NeedAModel<A, B> std::vector<ModelManifold> manifolds(const A&, const B&, const PairQuery& = {})
= delete;

}  // namespace toccata
