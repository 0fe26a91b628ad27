#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "toccata/bounds/aabb.hpp"
#include "toccata/core/index.hpp"
#include "toccata/narrow/convex_convex.hpp"
#include "toccata/narrow/triangle_triangle.hpp"
#include "toccata/query/model.hpp"
#include "toccata/query/pair_query.hpp"

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

// Contacts of (A, B) as those of (B, A).
namespace toccata {

[[nodiscard]] inline Contact flipped(const Contact& c) {
  return {c.triangle_b, c.triangle_a, c.face_b, c.face_a, flipped(c.intersection)};
}

/// In their order; sort them anew.
[[nodiscard]] inline std::vector<Contact> flipped(std::vector<Contact> contacts) {
  for (Contact& contact : contacts) contact = flipped(contact);
  return contacts;
}

/// One connected piece of where two meshes meet: a curve along which their surfaces cross, or an area on which they
/// lie. In world units, every number rounded: only the counts and `closed` are exact.
struct ContactRegion {
  std::size_t triangle_pairs = 0;  ///< that meet in it
  std::size_t face_pairs = 0;      ///< of the files' faces
  Aabb box;                        ///< around its points
  std::size_t point_count = 0;     ///< distinct corners of the curve and of the area
  /// The curve consists of loops: as often as a crossing segment begins at one of its points, one ends there. Not so
  /// where a surface ends, and where a curve runs along an edge or through a vertex.
  bool closed = false;
  /// Of the shadow that what the curve bounds casts along the normal, and of the areas on which faces lie: the length
  /// of the vector area of A's surface within B, which the curve alone determines (Stokes), and that of the areas. It
  /// is not more than the true area, and that itself where the surface is flat. 0 of points and of curves that are not
  /// closed.
  double area = 0;
  /// Unit, from A to B: the direction of the vector area, else the mean of the faces' normals, else zero.
  Vec3 normal{};
  /// Of two solids, how far the two reach into each other here along the normal: from the farthest point of B, against
  /// it, to the farthest point of A, among the curve, the vertices of A inside B that are connected with it through
  /// such, and those of B inside A. Not a bound: ask `penetration`. None where one is a surface, or the area is 0.
  std::optional<double> depth{};
  Vec3 deepest{};  ///< that farthest point of A; where there is no depth, the mean of the points

  friend bool operator==(const ContactRegion&, const ContactRegion&) = default;
};

/// The regions of all contacts of two meshes or height fields. Two contacts are of one region when their triangles
/// share a vertex in both meshes, vertices of equal coordinates taken as one, and so on. The deepest first, then the
/// largest, then those of the least triangles. One solid inside the other without contact has none. Throws like
/// `contacts`, and Error for other shapes.
[[nodiscard]] std::vector<ContactRegion> contact_regions(const Model& a, const Model& b, const PairQuery& query = {});

/// The same, for a caller who asks often.
[[nodiscard]] std::vector<ContactRegion> contact_regions(const Model& a, const Model& b, const PairQuery& query,
                                                         Workspace& workspace);

}  // namespace toccata
