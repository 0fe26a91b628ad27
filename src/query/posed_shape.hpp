#pragma once

#include <algorithm>
#include <concepts>
#include <string_view>
#include <variant>
#include <vector>

#include "query/meshes/posed_mesh.hpp"
#include "toccata/narrow/convex_convex.hpp"
#include "toccata/narrow/posed_polytope.hpp"
#include "toccata/narrow/quadrics.hpp"
#include "toccata/query/model.hpp"
#include "toccata/query/pairs.hpp"

namespace toccata {

/// A mesh or height field at its place, and what it is taken for.
struct PosedTriangles {
  PosedMesh mesh;
  bool solid;
};

/// A shape at its place, as the pair questions see it: everything but a compound.
using PosedShape = std::variant<PosedPolytope, PosedHalfSpace, PosedTriangles, PosedQuadric>;

/// Convex sets, of whatever class.
template <class S>
concept PosedConvexSet =
    std::same_as<S, PosedPolytope> || std::same_as<S, PosedHalfSpace> || std::same_as<S, PosedQuadric>;

/// A shape within a posed model, and where its elements and faces begin to be counted.
struct PosedPart {
  PosedShape shape;
  ShapeKind kind;
  Index first_element = 0;
  Index first_face = 0;
};

/// A posed model as the shapes that it is the union of: one, or the parts of a compound and of those in it.
struct PosedModel {
  std::vector<PosedPart> parts;
  bool solid;
};

/// What must not be a compound. It refers to the model, which has to outlive it. Throws Error, naming `who`, for a pose
/// that the shape may not have, and where Solid::all is asked of a surface.
[[nodiscard]] PosedShape pose_shape(const Model& model, const Pose& pose, Solid solid, std::string_view who);

/// The same of a shape of which it is known that it is posed as S, and what it may be taken for: nothing is copied.
template <PosedConvexSet S>
[[nodiscard]] S pose_convex(const Model& model, const Pose& pose, std::string_view who);

/// The pose of a part is composed after the compound's, once (docs/truth.md). Throws as `pose_shape` does. The parts
/// take the place of what is in `memory`.
[[nodiscard]] PosedModel pose_model(const Model& model, const Pose& pose, Solid solid, std::string_view who,
                                    std::vector<PosedPart> memory = {});

/// Contains the shape; of a half-space all space. Finite otherwise.
[[nodiscard]] Aabb world_box(const PosedShape& shape);
[[nodiscard]] Aabb world_box(const PosedPolytope& shape);
[[nodiscard]] Aabb world_box(const PosedQuadric& shape);
[[nodiscard]] Aabb world_box(const PosedModel& model);

/// The box with all that is as near to it along every axis, and a little more where that is no double; an empty box
/// stays empty, and what has no end has none.
[[nodiscard]] Aabb widened(Aabb box, double by);

/// Half of a length that is not negative, rounded up.
[[nodiscard]] inline double half_rounded_up(double length) { return std::max(0.5 * length, length - 0.5 * length); }

[[nodiscard]] bool is_solid(const PosedShape& shape);

}  // namespace toccata
