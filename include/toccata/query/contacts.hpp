#pragma once

#include <optional>
#include <span>
#include <vector>

#include "toccata/core/index.hpp"
#include "toccata/narrow/triangle_triangle.hpp"
#include "toccata/query/model.hpp"
#include "toccata/query/pair_query.hpp"
#include "toccata/query/workspace.hpp"

namespace toccata {

/// Two triangles, one of each model, that have a point in common, and what they have in common. Of models that are not
/// made of triangles, the elements (see Model) instead.
struct Contact {
  Index triangle_a = 0;
  Index triangle_b = 0;
  Index face_a = 0;  ///< the file's own face, counted from 0
  Index face_b = 0;
  Intersection intersection;  ///< of two triangles; else of kind none, and `manifold` tells points
};

/// All pairs of elements that meet, ascending by (triangle_a, triangle_b). Exact, as `overlap` is; nothing is left out.
/// A model inside a solid mesh without touching its surface has no contacts: ask `relation`. (A triangle inside a box
/// or another solid that is one element meets it.)
[[nodiscard]] std::vector<Contact> contacts(const Model& a, const Model& b, const PairQuery& query = {});

/// The same, for a caller who asks often. The contacts lie in the workspace until it is used again.
[[nodiscard]] std::span<const Contact> contacts(const Model& a, const Model& b, const PairQuery& query,
                                                Workspace& workspace);

/// The least of them by (triangle_a, triangle_b).
[[nodiscard]] std::optional<Contact> first_contact(const Model& a, const Model& b, const PairQuery& query = {});

/// The same, for a caller who asks often.
[[nodiscard]] std::optional<Contact> first_contact(const Model& a, const Model& b, const PairQuery& query,
                                                   Workspace& workspace);

/// A world triangle of a contact, for intersection_points(contact.intersection, …). `triangle` is less than the model's
/// count of elements. Throws Error when the element is no triangle.
[[nodiscard]] Triangle world_triangle(const Model& model, const Pose& pose, Index triangle);

/// Make a Model of it, once: `Model(mesh)`.
template <class A, class B>
requires NeedAModel<A, B> std::vector<Contact> contacts(const A&, const B&, const PairQuery& = {})
= delete;

}  // namespace toccata
