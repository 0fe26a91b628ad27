#pragma once

#include <nanobind/nanobind.h>

#include <string_view>
#include <vector>

#include <toccata/motion/rigid_motion.hpp>

#include "arrays.hpp"

namespace toccata::python {

/// A RigidMotion, or a pose at which something rests.
[[nodiscard]] RigidMotion motion_of(nb::handle given, std::string_view what);

/// One of them or a list.
[[nodiscard]] std::vector<RigidMotion> motions_of(nb::handle given, std::string_view what);

}  // namespace toccata::python
