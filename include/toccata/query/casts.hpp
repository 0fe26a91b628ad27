#pragma once

#include <optional>

#include "toccata/narrow/casts.hpp"
#include "toccata/query/model.hpp"
#include "toccata/query/pair_query.hpp"
#include "toccata/query/pairs.hpp"

namespace toccata {

/// A ray's first meeting with a model, and with what of it: the element (the triangle of a mesh) and the face of the
/// file. Both are 0 where the ray starts inside.
struct RayHit : Cast {
  Index element = 0;
  Index face = 0;
  friend constexpr bool operator==(const RayHit&, const RayHit&) = default;
};

/// The first meeting of the ray from `origin` to `origin + motion` (world) with the posed model; the time is the
/// fraction of the way; none where it meets nothing, which is proved. For meshes, height fields and compounds it is the
/// earliest of their elements, by (upper, element). A solid is met at once by a ray that starts inside; `solid` says
/// whether a closed mesh is one, and with Solid::none its surface alone is met. No ray passes between two triangles
/// that share an edge or a corner. Throws Error when a number is not finite or the motion is zero, and for poses as
/// `overlap` does.
[[nodiscard]] std::optional<RayHit> cast_ray(const Vec3& origin, const Vec3& motion, const Model& target,
                                             const Pose& pose = {}, Solid solid = Solid::automatic);

/// The first meeting of a model that moves with one that stands, and with what of either: the element (the triangle of
/// a mesh) and the face of the file. All are 0 of a solid mesh that holds the other, or a
/// part of it, at the start. Elements that meet at the start have a normal too: across the contact where they touch,
/// and the way in which they part soonest where they are deeper in each other; it is zero where a solid mesh holds the
/// other, and where a quadric is undecided.
struct ShapeHit : Cast {
  Index element_a = 0;
  Index element_b = 0;
  Index face_a = 0;
  Index face_b = 0;
  friend constexpr bool operator==(const ShapeHit&, const ShapeHit&) = default;
};

/// The first meeting of A, moved from its pose by `motion` (world) without turning, with B, which stands; none where
/// they do not meet, which is proved. For meshes,
/// height fields and compounds it is the earliest of their elements, by (upper, element of A, element of B). Where some
/// elements meet at the start, two of those that do are named, always the same; a solid that holds the other, or a part
/// of it, at the start is met at once. What is to leave a contact, or to stop a distance before one, is asked of
/// `sweep` along RigidMotion::straight, with `stop_before`. Throws like `overlap`, Error when the motion is not finite,
/// and Error for what the table of pairs.hpp does not define.
[[nodiscard]] std::optional<ShapeHit> cast_shape(const Model& a, const Vec3& motion, const Model& b,
                                                 const PairQuery& query = {});

/// The same, for a caller who asks often.
[[nodiscard]] std::optional<ShapeHit> cast_shape(const Model& a, const Vec3& motion, const Model& b,
                                                 const PairQuery& query, Workspace& workspace);

/// Make a Model of it, once: `Model(mesh)`.
template <class A, class B>
requires NeedAModel<A, B> std::optional<ShapeHit> cast_shape(const A&, const Vec3&, const B&, const PairQuery& = {})
= delete;

/// Shapes of types for which it is not defined are refused by the compiler.
template <PlainShape A, PlainShape B>
requires(!Answered<ShapeQuestion::cast_shape, A, B>) std::optional<ShapeHit> cast_shape(const A&, const Vec3&, const B&,
                                                                                        const PairQuery& = {})
= delete;

}  // namespace toccata
