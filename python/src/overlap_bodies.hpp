#pragma once

#include <nanobind/nanobind.h>

namespace toccata::python {

void bind_overlap_bodies(nanobind::module_& module);

}  // namespace toccata::python
