#pragma once

#include <nanobind/nanobind.h>

#include <string_view>
#include <vector>

#include <toccata/query/check_all.hpp>

#include "arrays.hpp"

namespace toccata::python {

/// Takes a list of SceneInstances, shapes, and pairs (shape, pose). Throws Error naming the entry that is none.
[[nodiscard]] std::vector<SceneInstance> instances_of(nb::handle given, std::string_view what);

/// Shapes at poses: so many as there are of one of them; one stands for all.
[[nodiscard]] std::vector<SceneInstance> instances_of(const ShapesLike& shapes, const PosesLike& poses, Solid solid);

}  // namespace toccata::python
