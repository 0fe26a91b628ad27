#pragma once

#include "toccata/narrow/convex_convex.hpp"
#include "toccata/query/contacts.hpp"
#include "toccata/query/model.hpp"
#include "toccata/query/pair_query.hpp"
#include "toccata/query/pairs.hpp"

namespace toccata {

/// Where two convex shapes, or one and a half-space, touch or overlap: up to four points and a normal. Empty exactly
/// when they are apart. Throws like `overlap`, and Error for what the table of pairs.hpp does not define.
[[nodiscard]] Manifold manifold(const Model& a, const Model& b, const PairQuery& query = {});

/// The same, for a caller who asks often.
[[nodiscard]] Manifold manifold(const Model& a, const Model& b, const PairQuery& query, Workspace& workspace);

/// The manifold of one of their `contacts`: of two elements, of which a triangle counts as a convex shape. Throws like
/// `overlap`; and Error when an element is not there, or both are half-spaces. A template, so that `manifold(a, b, {})`
/// is the first.
template <std::same_as<Contact> C>
[[nodiscard]] Manifold manifold(const Model& a, const Model& b, const C& contact, const PairQuery& query = {});

/// Shapes of types for which it is not defined are refused by the compiler.
template <PlainShape A, PlainShape B>
requires(!Answered<ShapeQuestion::manifold, A, B>) Manifold manifold(const A&, const B&, const PairQuery& = {})
= delete;

/// Make a Model of it, once: `Model(mesh)`.
template <class A, class B>
requires NeedAModel<A, B> Manifold manifold(const A&, const B&, const PairQuery& = {})
= delete;

}  // namespace toccata
