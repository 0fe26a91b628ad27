#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "toccata/core/parallel.hpp"
#include "toccata/query/contacts.hpp"
#include "toccata/query/distance.hpp"
#include "toccata/query/manifold.hpp"
#include "toccata/query/overlap.hpp"
#include "toccata/query/penetration.hpp"
#include "toccata/query/relation.hpp"
#include "toccata/shapes/scene.hpp"

namespace toccata {

/// A model at a place, as part of many.
struct SceneInstance {
  Model model;
  Pose pose{};
  Solid solid = Solid::automatic;
  std::string name{};   ///< for messages
  std::string group{};  ///< posed models of one non-empty group are not checked against each other
};

/// The points of contact of two elements that meet.
struct ContactManifold {
  Contact contact;
  Manifold manifold;
};

struct PairAnswer {
  /// What a clash is in the field's words.
  enum class Kind {
    clearance,  ///< near, and not in contact
    touching,
    crossing,  ///< a surface takes part
    overlap,   ///< of two solids, of which it was not asked, or not found out, whether one passes through the other:
               ///< compounds, and meshes that intersect themselves or lie within themselves where they meet the other
    protrude,  ///< one goes into the other, and not through it
    pierce,    ///< one goes into the other at one place and out at another: around one common part they cross along two
               ///< closed curves or more
    contains,  ///< one lies wholly inside the other
    equal
  };

  /// Where one passes through the other: which does. Its surface leads through the other from curve to curve.
  enum class Piercing {
    none,         ///< it is no `pierce`
    unknown,      ///< as of a hollow pipe through a slab, or of what goes through here and is gone through there
    a_through_b,  ///< as a rod A through a plate B
    b_through_a
  };

  /// How an overlap stands to the tolerance.
  enum class Tolerance {
    none,      ///< none was asked for the pair, or the two do not overlap
    within,    ///< certainly no deeper, by `local_depth` where it is there, else by the penetration
    beyond,    ///< certainly deeper, by the same
    undecided  ///< its bracket holds the tolerance, however narrow it was asked; or there is no depth
  };

  Index a = 0;  ///< index in the span, a < b
  Index b = 0;
  Relation relation;                         ///< apart: no farther than its clearance, or `undecided` whether
  std::vector<Contact> contacts;             ///< filled when asked for
  std::optional<Penetration> penetration{};  ///< when asked for and defined for the pair (pairs.hpp): of two solids
  DepthEnd depth_end = DepthEnd::precise;    ///< why its bracket is no narrower
  std::optional<Manifold> manifold{};        ///< of two convex shapes or one and a half-space
  /// With the penetration, where one is a mesh, a height field or a compound and not both have a mesh: of each two
  /// elements that meet, ascending.
  std::vector<ContactManifold> manifolds{};
  std::vector<ContactRegion> regions{};  ///< with the penetration, of two meshes
  std::optional<Distance> distance{};    ///< wherever a clearance is asked for: 0 where they have a common point
  double clearance = 0;                  ///< the one that was asked of them; +∞ demands none
  Kind kind = Kind::touching;            ///< `protrude` and `pierce` with the volume alone
  Piercing piercing = Piercing::none;
  Tolerance tolerance = Tolerance::none;  ///< by `local_depth`, else by the penetration; what decided it is told
  /// Of two meshes whose stand to the tolerance it decided: how deep they are in each other where they are deepest
  /// (docs/methods/penetration.md#how-deep-is-a-place). Known no better than was needed: beyond it `upper` may be +∞.
  std::optional<ContactRegion::Depth> local_depth{};
  std::optional<OverlapVolume> volume{};  ///< when asked for, of two solids
  /// With it: a point that certainly both have, if one was found. Where both are meshes it lies off their surfaces.
  std::optional<Vec3> common_point{};
  Aabb common_box{};  ///< what the boxes around both have in common: they meet nowhere else
};

/// How far two of the models should be from each other. They are not of one group.
struct PairClearance {
  Index a = 0;  ///< indices in the span, in either order
  Index b = 0;
  double clearance = 0;
};

struct CheckOptions {
  bool contacts = false;     ///< list the intersecting triangles of every pair
  bool penetration = false;  ///< tell how deep they overlap and their contact points, where these are defined
  DepthOptions depth{.precision = 0.1};  ///< how narrow its bracket is to be; a time limit is that of each pair
  bool volume = false;                   ///< tell how much volume they have in common, and a point of it
  /// World units: overlaps that are certainly no deeper are told to be within it. Two meshes of which neither holds the
  /// other are as deep as they are at their deepest place; what that leaves open, and other solids, as the shortest
  /// translation that parts them is long. Where its bracket holds the tolerance, it is asked more precisely.
  std::optional<double> tolerance{};
  /// World units. Where one is asked for, pairs are told that are at most so far apart, decided exactly
  /// (within_distance), and the distance of every pair that is told. 0: those in contact. +∞: all pairs.
  std::optional<double> clearance{};
  std::vector<PairClearance> pair_clearances{};  ///< instead of it (or of 0), for some pairs; one length for each
  int threads = all_threads;
  Progress progress{};  ///< told the pairs of overlapping boxes that are done
};

struct CheckAnswer {
  std::vector<PairAnswer> pairs;  ///< those that are not apart by more than their clearance, ascending by (a, b)
  /// Pairs that were looked at: whose boxes overlap, each of them grown by half the clearance of that pair (rounded
  /// up).
  std::size_t candidate_pairs = 0;
};

/// Every two of the posed models that are not apart, or nearer than their clearance, and their relation. Only pairs
/// whose boxes overlap, or are as near, are looked at. Throws Error naming the model when one is asked about wrongly,
/// and for a clearance that is no length or of models that are not there, of two models of one group, or of a pair that
/// has another one.
[[nodiscard]] CheckAnswer check_all(std::span<const SceneInstance> models, const CheckOptions& options = {});

/// The scene's objects ready for `check_all`, in the scene's order. Objects that share a mesh share one Model.
[[nodiscard]] std::vector<SceneInstance> scene_models(const Scene& scene, int threads = all_threads);

}  // namespace toccata
