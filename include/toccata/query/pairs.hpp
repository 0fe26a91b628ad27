#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <type_traits>
#include <variant>

#include "toccata/shapes/shape.hpp"

// Which question is answered for which two shapes, how, and why not: the one table that the typed calls, the dispatch
// at run time, `toccata pairs` and docs/reference/pairs.md go by.
namespace toccata {

enum class ShapeQuestion : std::uint8_t {
  overlap,
  relation,
  contacts,
  manifold,
  distance,
  penetration,
  cast_ray,  ///< at the second shape; the first does not matter
  cast_shape,
};

inline constexpr std::size_t question_count = 8;

/// "overlap", "relation", … "cast-shape".
[[nodiscard]] std::string_view name_of(ShapeQuestion question);

/// What decides how a pair is answered.
enum class ShapeClass : std::uint8_t { convex, quadric, half_space, triangles, compound };

[[nodiscard]] constexpr ShapeClass class_of(ShapeKind kind) {
  if (is_quadric(kind)) return ShapeClass::quadric;
  switch (kind) {
    case ShapeKind::half_space:
      return ShapeClass::half_space;
    case ShapeKind::height_field:
    case ShapeKind::mesh:
      return ShapeClass::triangles;
    case ShapeKind::compound:
      return ShapeClass::compound;
    default:
      return ShapeClass::convex;
  }
}

/// A surface, whatever its numbers. A hull may be flat, and a mesh taken as surface, all the same.
[[nodiscard]] constexpr bool always_surface(ShapeKind kind) {
  return kind == ShapeKind::point || kind == ShapeKind::segment || kind == ShapeKind::triangle ||
         kind == ShapeKind::height_field;
}

enum class PairState : std::uint8_t { defined, not_defined };

struct PairCell {
  PairState state = PairState::defined;
  std::string_view text;  ///< how it is answered, or why not
};

namespace pair_cells {

// Every reason and every method is stated once.
inline constexpr PairCell surface{PairState::not_defined, "a surface has no interior that another could leave"};
inline constexpr PairCell endless{
    PairState::not_defined, "no translation ends the overlap of two half-spaces, unless their normals are opposite"};
inline constexpr PairCell boundless{PairState::not_defined, "what two half-spaces have in common has no end"};
inline constexpr PairCell always_met{
    PairState::not_defined, "two half-spaces meet wherever they are, unless their normals are opposite: ask overlap"};
inline constexpr PairCell many_manifolds{PairState::not_defined,
                                         "there is one for each contact: ask contacts, and the manifold of each"};
inline constexpr PairCell by_parts{PairState::defined, "as its parts"};
inline constexpr PairCell least_part{PairState::defined, "the least of its parts"};
inline constexpr PairCell earliest_part{PairState::defined, "the earliest of its parts"};
inline constexpr PairCell half_spaces{PairState::defined, "exact signs"};
inline constexpr PairCell by_gjk{PairState::defined, "GJK, certified, else exact arithmetic"};
inline constexpr PairCell by_expansion{PairState::defined, "expanding polytope, certified bracket"};
inline constexpr PairCell by_inner_parts{PairState::defined,
                                         "certified bracket: convex bodies within, a verified translation"};
inline constexpr PairCell by_features{PairState::defined, "clipped features"};
inline constexpr PairCell by_normals{PairState::defined, "exact signs of separating normals"};
inline constexpr PairCell by_tree{PairState::defined, "tree, exact pairs, winding numbers"};
inline constexpr PairCell by_tree_alone{PairState::defined, "tree, exact pairs"};
inline constexpr PairCell nearest_by_tree{PairState::defined, "turned boxes, nearest first; certified pairs"};
inline constexpr PairCell one_contact{PairState::defined, "one pair, by overlap; its points are the manifold"};
inline constexpr PairCell by_advance{PairState::defined, "certified interval, else exact arithmetic"};
inline constexpr PairCell first_by_tree{PairState::defined, "moving boxes, first met first; certified pairs"};

inline constexpr PairCell by_proof{PairState::defined, "proved apart or in contact, else undecided within 10⁻¹²"};
inline constexpr PairCell nearest_by_proof{PairState::defined, "Newton's method, proved interval"};
inline constexpr PairCell depth_by_proof{PairState::defined, "expanding polytope, proved bracket"};
inline constexpr PairCell by_planes{PairState::defined, "separating planes, proved interval"};
inline constexpr PairCell by_roots{PairState::defined,
                                   "roots of a quadratic equation, else separating planes; proved interval"};
inline constexpr PairCell proof_by_tree{PairState::defined, "tree, proved pairs, else undecided within 10⁻¹²"};
inline constexpr PairCell quadric_features{PairState::defined,
                                           "clipped faces, lines and rims along the direction of depth"};

constexpr bool has(ShapeClass wanted, ShapeClass a, ShapeClass b) { return a == wanted || b == wanted; }

constexpr PairCell yes_no(ShapeQuestion question, ShapeClass a, ShapeClass b) {
  if (has(ShapeClass::compound, a, b)) return by_parts;
  if (has(ShapeClass::quadric, a, b) && has(ShapeClass::triangles, a, b)) return proof_by_tree;
  if (has(ShapeClass::triangles, a, b)) return question == ShapeQuestion::contacts ? by_tree_alone : by_tree;
  if (question == ShapeQuestion::contacts) return one_contact;
  if (has(ShapeClass::quadric, a, b)) return by_proof;
  if (has(ShapeClass::half_space, a, b)) return half_spaces;
  return question == ShapeQuestion::relation ? by_normals : by_gjk;
}

constexpr PairCell distance(ShapeClass a, ShapeClass b) {
  if (has(ShapeClass::compound, a, b)) return least_part;
  if (has(ShapeClass::triangles, a, b)) return nearest_by_tree;
  if (has(ShapeClass::quadric, a, b)) return nearest_by_proof;
  return has(ShapeClass::half_space, a, b) ? half_spaces : by_gjk;
}

constexpr PairCell penetration(ShapeKind kind_a, ShapeKind kind_b, ShapeClass a, ShapeClass b) {
  if (always_surface(kind_a) || always_surface(kind_b)) return surface;
  if (a == ShapeClass::half_space && b == ShapeClass::half_space) return endless;
  if (has(ShapeClass::compound, a, b) || has(ShapeClass::triangles, a, b)) return by_inner_parts;
  if (has(ShapeClass::quadric, a, b)) return depth_by_proof;
  return has(ShapeClass::half_space, a, b) ? half_spaces : by_expansion;
}

constexpr PairCell manifold(ShapeClass a, ShapeClass b) {
  if (has(ShapeClass::compound, a, b) || has(ShapeClass::triangles, a, b)) return many_manifolds;
  if (a == ShapeClass::half_space && b == ShapeClass::half_space) return boundless;
  return has(ShapeClass::quadric, a, b) ? quadric_features : by_features;
}

constexpr PairCell cast(ShapeClass a, ShapeClass b) {
  if (has(ShapeClass::compound, a, b)) return earliest_part;
  if (has(ShapeClass::triangles, a, b)) return first_by_tree;
  if (a == ShapeClass::half_space && b == ShapeClass::half_space) return always_met;
  if (has(ShapeClass::quadric, a, b)) return by_planes;
  return has(ShapeClass::half_space, a, b) ? half_spaces : by_advance;
}

constexpr PairCell ray(ShapeClass target) {
  if (target == ShapeClass::quadric) return by_roots;
  return target == ShapeClass::triangles ? by_tree_alone : cast(ShapeClass::convex, target);
}

}  // namespace pair_cells

/// The same for (b, a).
[[nodiscard]] constexpr PairCell pair_cell(ShapeQuestion question, ShapeKind kind_a, ShapeKind kind_b) {
  const ShapeClass a = class_of(kind_a), b = class_of(kind_b);
  switch (question) {
    case ShapeQuestion::distance:
      return pair_cells::distance(a, b);
    case ShapeQuestion::penetration:
      return pair_cells::penetration(kind_a, kind_b, a, b);
    case ShapeQuestion::manifold:
      return pair_cells::manifold(a, b);
    case ShapeQuestion::cast_ray:
      return pair_cells::ray(b);
    case ShapeQuestion::cast_shape:
      return pair_cells::cast(a, b);
    default:
      return pair_cells::yes_no(question, a, b);
  }
}

namespace pair_cells {

template <class S, std::size_t i = 0>
constexpr ShapeKind kind_of_type() {
  if constexpr (std::is_same_v<S, std::variant_alternative_t<i, Shape>>)
    return static_cast<ShapeKind>(i);
  else
    return kind_of_type<S, i + 1>();
}

}  // namespace pair_cells

/// Whether the question is defined for two shapes of these types.
template <ShapeQuestion question, class A, class B>
concept Answered = pair_cell(question, pair_cells::kind_of_type<A>(), pair_cells::kind_of_type<B>())
.state == PairState::defined;

}  // namespace toccata
