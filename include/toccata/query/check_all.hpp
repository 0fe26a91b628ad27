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
    overlap,   ///< of two solids, of which it was not asked, or not found out, whether one passes through the other
    protrude,  ///< one goes into the other, and not through it
    pierce,    ///< one goes into the other at one place and out at another: around one common part they cross along two
               ///< closed curves or more
    contains,  ///< one lies wholly inside the other
    equal
  };

  /// How an overlap stands to the tolerance.
  enum class Tolerance {
    none,      ///< none was asked for the pair, or the two do not overlap
    within,    ///< certainly no deeper
    beyond,    ///< certainly deeper
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
  std::vector<ContactRegion> regions{};   ///< with the penetration, of two meshes
  std::optional<Distance> distance{};     ///< wherever a clearance is asked for: 0 where they have a common point
  Kind kind = Kind::touching;             ///< of meshes `protrude` and `pierce` with the penetration or the volume
  Tolerance tolerance = Tolerance::none;  ///< by the penetration, which is told then
  std::optional<OverlapVolume> volume{};  ///< when asked for, of two solids
  std::optional<Vec3> common_point{};     ///< with it: a point that certainly both have, if one was found
  Aabb common_box{};                      ///< what the boxes around both have in common: they meet nowhere else
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
  /// World units: overlaps that are certainly no deeper are told to be within it. Where the bracket of a depth holds
  /// it, that is asked more precisely.
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
