#pragma once

#include <nanobind/nanobind.h>
#include <nanobind/stl/array.h>
#include <nanobind/stl/tuple.h>

#include <array>
#include <cstddef>
#include <tuple>
#include <type_traits>

#include <toccata/query/manifolds.hpp>

#include "values.hpp"

// Manifolds are values: they compare, and are pickled and copied.
namespace toccata::python {

/// A vector, a depth, and the two features, each of a kind and a number.
using PointState = std::tuple<std::array<double, 3>, double, int, Index, int, Index>;
using ManifoldState =
    std::tuple<int, std::array<double, 3>, std::array<PointState, 4>, std::array<Index, 4>, std::array<Index, 4>>;

template <class M>
ManifoldState state_of_manifold(const M& manifold) {
  const auto numbers = [](const Vec3& v) { return std::array{v.x, v.y, v.z}; };
  ManifoldState state{manifold.count, numbers(manifold.normal), {}, {}, {}};
  for (std::size_t i = 0; i < manifold.points.size(); ++i) {
    const ManifoldPoint& point = manifold.points[i];
    std::get<2>(state)[i] = {numbers(point.position),           point.depth,
                             static_cast<int>(point.on_a.kind), point.on_a.index,
                             static_cast<int>(point.on_b.kind), point.on_b.index};
  }
  if constexpr (std::is_same_v<M, ModelManifold>) {
    std::get<3>(state) = manifold.elements_a;
    std::get<4>(state) = manifold.elements_b;
  }
  return state;
}

/// Throws Error where the state has more points than there can be.
template <class M>
M manifold_of_state(const ManifoldState& state) {
  const auto& [count, normal, points, elements_a, elements_b] = state;
  M manifold;
  if (count < 0 || static_cast<std::size_t>(count) > manifold.points.size())
    throw Error("a pickled manifold has up to four points");
  manifold.count = count;
  manifold.normal = {normal[0], normal[1], normal[2]};
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto& [at, depth, kind_a, index_a, kind_b, index_b] = points[i];
    manifold.points[i] = {{at[0], at[1], at[2]},
                          depth,
                          {static_cast<ConvexFeature::Kind>(kind_a), index_a},
                          {static_cast<ConvexFeature::Kind>(kind_b), index_b}};
  }
  if constexpr (std::is_same_v<M, ModelManifold>) {
    manifold.elements_a = elements_a;
    manifold.elements_b = elements_b;
  }
  return manifold;
}

template <class Bound>
void bind_manifold_values(Bound& bound) {
  using M = typename Bound::Type;
  bound.def(
      "__eq__",
      [](const M& manifold, const nb::object& other) {
        return nb::isinstance<M>(other) && manifold == nb::cast<const M&>(other);
      },
      nb::arg("other").none(), nb::sig("def __eq__(self, other: object, /) -> bool"));
  bind_state(
      bound, [](const M& manifold) { return nb::borrow<nb::tuple>(nb::cast(state_of_manifold(manifold))); },
      [](const nb::tuple& state) { return manifold_of_state<M>(nb::cast<ManifoldState>(state)); });
}

}  // namespace toccata::python
