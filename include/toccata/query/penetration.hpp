#pragma once

#include <limits>

#include "toccata/narrow/convex_convex.hpp"
#include "toccata/query/model.hpp"
#include "toccata/query/pair_query.hpp"
#include "toccata/query/pairs.hpp"

namespace toccata {

/// How deep two solids overlap, and a short way to part them. For two convex shapes, or one and a half-space, it is as
/// in convex_convex.hpp. For closed meshes and compounds the bracket holds as well, and is wider: `lower` is proved by
/// convex bodies within the two, `upper · direction` by a distance that is not 0 after it, in the world doubles and in
/// exact arithmetic (docs/methods/penetration.md). Then `status` is `not_converged` where upper > 1.5 · lower; on_a and
/// on_b are where the two come apart last. When they do not overlap, both bounds are 0 and the points those of
/// `distance`.
///
/// Throws like `overlap`, and Error for what the table of pairs.hpp does not define: surfaces, flat hulls, two
/// half-spaces; also for an open mesh, which the message names, and for compounds that have half-spaces among others.
[[nodiscard]] Penetration penetration(const Model& a, const Model& b, const PairQuery& query = {});

/// The same, for a caller who asks often.
[[nodiscard]] Penetration penetration(const Model& a, const Model& b, const PairQuery& query, Workspace& workspace);

/// How narrow a bracket of the depth of meshes and compounds is wanted, and how long may be looked for it.
struct DepthOptions {
  /// The search ends where upper <= (1 + precision) · lower. Finite and more than 0; it is rarely met below 0.02.
  double precision = 0.02;
  /// In seconds, more than 0: after it nothing new is begun, and the bracket so far is the answer. It depends on the
  /// machine then, as nothing else does; what is begun first (convex hulls of both) takes up to some tenths of a second
  /// of a hundred thousand triangles.
  double time_limit = std::numeric_limits<double>::infinity();
};

/// Why the search for a depth ended.
enum class DepthEnd {
  precise,      ///< the bracket is as narrow as asked, or exact as of convex shapes
  exhausted,    ///< nothing that is looked for makes it narrower
  out_of_time,  ///< the time limit
};

/// A bracket, which holds in every case, and why it is no narrower.
struct DepthBracket {
  Penetration penetration;
  DepthEnd end = DepthEnd::precise;
  friend constexpr bool operator==(const DepthBracket&, const DepthBracket&) = default;
};

/// The penetration, as narrow as asked. Where more than 2 % is enough, the place at which two solids are deepest in
/// each other is looked at first, which takes a few milliseconds and mostly is enough where they are not deep. Throws
/// like it, and Error for options that are not as described.
[[nodiscard]] DepthBracket depth_bracket(const Model& a, const Model& b, const PairQuery& query,
                                         const DepthOptions& options);

/// The same, for a caller who asks often.
[[nodiscard]] DepthBracket depth_bracket(const Model& a, const Model& b, const PairQuery& query,
                                         const DepthOptions& options, Workspace& workspace);

/// Shapes of types for which it is not defined are refused by the compiler.
template <PlainShape A, PlainShape B>
requires(!Answered<ShapeQuestion::penetration, A, B>) Penetration penetration(const A&, const B&, const PairQuery& = {})
= delete;

/// Make a Model of it, once: `Model(mesh)`.
template <class A, class B>
requires NeedAModel<A, B> Penetration penetration(const A&, const B&, const PairQuery& = {})
= delete;

}  // namespace toccata
