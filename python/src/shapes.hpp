#pragma once

#include <nanobind/nanobind.h>

#include <utility>

#include <toccata/query/model.hpp>

namespace toccata::python {

namespace nb = nanobind;

/// What every shape of Python holds: the shape, ready for questions.
struct AnyShape {
  Model model;
};

/// The class of one kind of shapes in Python.
template <class Kind>
struct ShapeOf : AnyShape {};

/// Its class tells which shape it is.
[[nodiscard]] nb::object shape_object(const Model& model);

void bind_poses(nb::module_& module);
void bind_shapes(nb::module_& module);
void bind_pair_questions(nb::module_& module);
void bind_point_questions(nb::module_& module);
void bind_scenes(nb::module_& module);
void bind_worlds(nb::module_& module);

}  // namespace toccata::python
