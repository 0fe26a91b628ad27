#pragma once

#include <vector>

#include "toccata/core/status.hpp"
#include "toccata/query/model.hpp"
#include "toccata/query/pair_query.hpp"
#include "toccata/shapes/triangle_mesh.hpp"

namespace toccata {

/// Do the two posed models have a point in common? Touching counts; a model wholly inside a solid counts. Exact;
/// of cylinders, cones and ellipsoids a no is proved, and what is undecided (docs/truth.md) counts as yes. Shapes that
/// need no tree may be given as they are: overlap(bunny, Sphere{1}). Throws Error when a world vertex is not finite, a
/// model is asked about as a solid that is open, a surface or singularly posed, or the pose deforms a ball.
[[nodiscard]] bool overlap(const Model& a, const Model& b, const PairQuery& query = {});

/// The same, for a caller who asks often.
[[nodiscard]] bool overlap(const Model& a, const Model& b, const PairQuery& query, Workspace& workspace);

/// Make a Model of it, once: `Model(mesh)`.
template <class A, class B>
requires NeedAModel<A, B>
bool overlap(const A&, const B&, const PairQuery& = {}) = delete;

/// How much volume two solids have in common: the exact number lies in [lower, upper], in cubed world units.
struct OverlapVolume {
  double lower = 0;
  double upper = 0;
  /// exact: the bracket holds the rounding of a sum and nothing else, or upper − lower is at most 10⁻⁹ · upper.
  /// not_converged: it is wider.
  Status status = Status::exact;
  friend constexpr bool operator==(const OverlapVolume&, const OverlapVolume&) = default;
};

/// The volume that both models share. For two closed meshes, boxes and hulls it is an integral over their surfaces,
/// whose pieces are exact. Where a mesh passes through itself there, or winds otherwise than once, it is bracketed by
/// the cells that are certainly in both and those that may be; for round shapes by polyhedra within them and around
/// them, a bracket some thousandths wide; for compounds it is found by their parts (docs/methods/overlap-volume.md).
/// All brackets hold. Exchanging the models changes nothing.
///
/// Throws Error where one is taken as a surface, for two half-spaces, and as `overlap` does.
[[nodiscard]] OverlapVolume overlap_volume(const Model& a, const Model& b, const PairQuery& query = {});

/// The same, for a caller who asks often.
[[nodiscard]] OverlapVolume overlap_volume(const Model& a, const Model& b, const PairQuery& query,
                                           Workspace& workspace);

/// Make a Model of it, once: `Model(mesh)`.
template <class A, class B>
requires NeedAModel<A, B> OverlapVolume overlap_volume(const A&, const B&, const PairQuery& = {})
= delete;

/// What two solids have in common, as closed meshes in the world: one of each two parts that overlap, none where they
/// are apart or merely touch. The boundary of a body consists of the parts of each surface that lie in the other solid,
/// cut into triangles; which these are is exact, and corners at which surfaces cross are rounded. For round shapes
/// stand polyhedra within them. Bodies of compounds whose parts overlap may overlap too. Where the two touch beside a
/// body, it may have a sheet without thickness.
///
/// Throws Error as overlap_volume does, and with the reason where a body is not proved to be right but for that
/// rounding: a mesh passes through itself there, or what they have in common is thinner than coordinates can tell.
[[nodiscard]] std::vector<TriangleMesh> overlap_bodies(const Model& a, const Model& b, const PairQuery& query = {});

/// Make a Model of it, once: `Model(mesh)`.
template <class A, class B>
requires NeedAModel<A, B> std::vector<TriangleMesh> overlap_bodies(const A&, const B&, const PairQuery& = {})
= delete;

}  // namespace toccata
