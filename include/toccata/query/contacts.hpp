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

/// Two triangles, one of each model, that have a point in common, and what they have in common. For models that are not
/// made of triangles, these are elements (see Model) instead.
struct Contact {
  Index element_a = 0;
  Index element_b = 0;
  Index face_a = 0;  ///< the file's own face, counted from 0
  Index face_b = 0;
  Intersection intersection;  ///< that of two triangles; else of kind none, and `manifold` finds points

  friend constexpr bool operator==(const Contact&, const Contact&) = default;
};

/// All pairs of elements that meet, ascending by (element_a, element_b). Exact, as `overlap` is; nothing is left out.
/// A model inside a solid mesh without touching its surface has no contacts: ask `relation`. (A triangle inside a box
/// or another solid that is one element meets it.)
[[nodiscard]] std::vector<Contact> contacts(const Model& a, const Model& b, const PairQuery& query = {});

/// The same, for a caller who asks often. The contacts lie in the workspace until it is used again.
[[nodiscard]] std::span<const Contact> contacts(const Model& a, const Model& b, const PairQuery& query,
                                                Workspace& workspace);

/// The least of them by (element_a, element_b).
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
  return {c.element_b, c.element_a, c.face_b, c.face_a, flipped(c.intersection)};
}

/// The contacts with A and B exchanged, in their old order; sort them anew.
[[nodiscard]] inline std::vector<Contact> flipped(std::vector<Contact> contacts) {
  for (Contact& contact : contacts) contact = flipped(contact);
  return contacts;
}

/// One place at which two meshes meet: of two solids one connected part that they have in common, or on which they
/// touch; else one connected curve along which their surfaces cross, or area on which they lie. In world units, every
/// number rounded: only the counts, `closed` and the bounds of the depth are exact.
struct ContactRegion {
  /// The exact number lies in [lower, upper].
  struct Depth {
    double lower = 0;
    double upper = 0;
    friend constexpr bool operator==(const Depth&, const Depth&) = default;
  };

  std::size_t triangle_pairs = 0;  ///< that meet in it
  std::size_t face_pairs = 0;      ///< pairs of the files' faces
  Aabb box;  ///< around its points and, of two solids, the vertices of each inside the other that hang on them
  std::size_t point_count = 0;  ///< distinct corners of the curves and of the areas
  /// The curves consist of loops: as often as a crossing segment begins at one of their points, one ends there. Not so
  /// where a surface ends, and where a curve runs along an edge or through a vertex.
  bool closed = false;
  /// Closed curves along which the two cross here, after one of them was moved by less than any length; where one is a
  /// surface that ends here, curves that are not closed count, too.
  std::size_t curve_count = 0;
  /// For two solids, the area of the shadow that the common part casts along the normal, counted as often as it folds
  /// (half the area of its surface, as seen along the normal), and of faces that touch from outside. Otherwise the area
  /// of the shadow of what the curve bounds, which the curve alone determines (Stokes), and of the areas; 0 for points
  /// and for curves that are not closed.
  double area = 0;
  /// Unit, from A to B. For two solids that overlap here it leads from the point of B's surface that is nearest to
  /// `deepest` to that of A's; else it is the direction of the vector area of A's surface within B, else the mean of
  /// the faces' normals, else zero.
  Vec3 normal{};
  /// For two solids, the greatest sum of the distances of a point from A's surface and from B's, over the points in
  /// `box` that lie in both. B moved by less than `lower`, in whichever direction, still overlaps A: it is a lower
  /// bound of their penetration. `upper` is at most 10 % more, where that is found in reasonable time, and both are 0,
  /// or `lower` is and `upper` some last places of the coordinates, where they touch. None where one is a surface.
  std::optional<Depth> depth{};
  /// A point of `box`. Where `lower` is not 0, it is one of both solids, up to rounding, whose sum is `lower` or more;
  /// else the mean of the points.
  Vec3 deepest{};

  friend bool operator==(const ContactRegion&, const ContactRegion&) = default;
};

/// The regions of all contacts of two meshes or height fields. Two contacts are of one region when their triangles
/// share a vertex in both meshes, vertices of equal coordinates taken as one, and so on; of two solids also when a part
/// of one's surface within the other joins them, so that a rod through a plate has one region. The deepest first, then
/// the largest, then those of the least triangles. One solid inside the other without contact has none. Throws like
/// `contacts`, and Error for other shapes.
[[nodiscard]] std::vector<ContactRegion> contact_regions(const Model& a, const Model& b, const PairQuery& query = {});

/// The same, for a caller who asks often.
[[nodiscard]] std::vector<ContactRegion> contact_regions(const Model& a, const Model& b, const PairQuery& query,
                                                         Workspace& workspace);

}  // namespace toccata
