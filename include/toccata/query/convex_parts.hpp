#pragma once

#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

#include "toccata/core/index.hpp"
#include "toccata/core/parallel.hpp"
#include "toccata/query/model.hpp"
#include "toccata/query/pair_query.hpp"
#include "toccata/shapes/convex_hull.hpp"
#include "toccata/shapes/shape.hpp"
#include "toccata/shapes/triangle_mesh.hpp"

namespace toccata {

/// When `decompose` stops cutting: at whichever of the two limits it comes to first.
struct DecompositionOptions {
  std::size_t max_parts = 32;  ///< at least 1
  /// In units of the mesh, at least 0. A part is not cut further, and two are made one, while no point of the hull is
  /// farther than this from the solid. 0: only parts that are convex are left as they are.
  double concavity = 0;
  int threads = own_thread;
  Progress progress{};
};

/// A convex part. It contains what of the solid lies between the planes that cut it out.
struct ConvexPart {
  ConvexHull hull;
  double volume = 0;  ///< of the hull, in units of the mesh cubed, rounded
  /// No point of the hull is farther than this from the solid: a bound that is proved, in units of the mesh. 0 only
  /// where the hull lies within the solid.
  double concavity = 0;
  double concavity_found = 0;  ///< some point of the hull is as far as this, at least
  std::vector<Index> faces;    ///< faces of the mesh that the part has more than the border of, ascending
};

/// Convex parts whose union contains a solid.
struct ConvexParts {
  std::vector<ConvexPart> parts;  ///< by falling volume
  double mesh_volume = 0;         ///< of the solid, rounded; where the mesh winds twice, that counts twice
  double hull_volume = 0;         ///< of all hulls; where hulls overlap, that counts for each
  /// hull_volume − mesh_volume: at least what the union of the hulls has more than the solid, but for rounding.
  double excess = 0;
  double concavity = 0;  ///< the greatest of all parts

  /// The parts as one shape, for queries that are to be about them and not about the mesh.
  [[nodiscard]] Compound compound() const;
};

/// Cuts the solid that a closed mesh encloses by planes, and puts a convex hull around each piece: approximate convex
/// decomposition (J.-M. Lien, N. M. Amato, "Approximate convex decomposition of polyhedra", 2007; planes are chosen
/// greedily by the volume that the hulls of both sides exceed the solid by, and parts are merged while a limit allows
/// it). docs/methods/convex-decomposition.md has the proof that nothing of the solid is outside all hulls.
///
/// Exact: that every part is convex; that the union of the parts contains the solid and its surface. A corner that a
/// cut makes and that is no double is replaced by the doubles around it, so a hull is larger there by a unit in the
/// last place. Bounds: the concavities. Rounded: the volumes. The choice of planes is a heuristic, so neither the
/// number of parts nor the excess is the least possible. The same bits on every number of threads.
///
/// The mesh may be inside out, have several components, cavities, degenerate or crossing triangles. Throws Error when
/// it is open, or a limit is out of range.
[[nodiscard]] ConvexParts decompose(const TriangleMesh& mesh, const DecompositionOptions& options = {});

/// The same of a model, whose trees it uses. Throws Error also where it is no mesh.
[[nodiscard]] ConvexParts decompose(const Model& model, const DecompositionOptions& options = {});

/// A model and convex parts that contain it: the parts are asked first, and what they cannot rule out is asked of the
/// model, so no answer depends on them. Copies share all.
class ModelWithParts {
 public:
  /// `parts` must be those of the model (`decompose`).
  ModelWithParts(Model model, const ConvexParts& parts) : model_(std::move(model)), parts_(parts.compound()) {}

  /// A model that is its own only part.
  ModelWithParts(const Model& model) : model_(model), parts_(model) {}

  [[nodiscard]] const Model& model() const { return model_; }
  [[nodiscard]] const Model& parts() const { return parts_; }

 private:
  Model model_;
  Model parts_;
};

/// Are the posed models apart for certain, as their parts are farther apart than what rounding can move? Posed vertices
/// are rounded, so a posed hull may be left of what it contains by some units in the last place; that is made up for.
/// False says nothing.
[[nodiscard]] bool parts_are_apart(const ModelWithParts& a, const ModelWithParts& b, const PairQuery& query = {});

/// What `overlap` of the two models answers, always, and where the parts are apart without asking about the models.
/// Throws as that does.
[[nodiscard]] bool overlap(const ModelWithParts& a, const ModelWithParts& b, const PairQuery& query = {});

}  // namespace toccata
