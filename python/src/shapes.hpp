#pragma once

#include <nanobind/nanobind.h>

#include <cstddef>
#include <string_view>
#include <utility>
#include <vector>

#include <toccata/query/model.hpp>

namespace toccata::python {

namespace nb = nanobind;

/// What every shape of Python holds: the shape, ready for questions.
struct AnyShape {
  Model model;
};

/// One shape, or many of which each has its number.
struct Models {
  std::vector<Model> each;
  bool single = false;

  [[nodiscard]] const Model& operator[](std::size_t i) const { return single ? each.front() : each[i]; }
};
[[nodiscard]] Models models_of(nb::handle given, std::string_view what);
/// For the message about what is no shape: how it becomes one, or nothing.
[[nodiscard]] std::string_view how_made(nb::handle given);

/// The class of one kind of shapes in Python.
template <class Kind>
struct ShapeOf : AnyShape {};

/// Its class tells which shape it is.
[[nodiscard]] nb::object shape_object(const Model& model);

void bind_poses(nb::module_& module);
void bind_shapes(nb::module_& module);
void bind_pair_questions(nb::module_& module);
void bind_point_questions(nb::module_& module);
void bind_contact_questions(nb::module_& module);
void bind_depths(nb::module_& module);
void bind_regions(nb::module_& module);
void bind_mover_options(nb::module_& module);
void bind_deforming(nb::module_& module);
void bind_meshes(nb::module_& module);
void bind_scenes(nb::module_& module);
void bind_motions(nb::module_& module);
void bind_worlds(nb::module_& module);
void bind_boxes(nb::module_& module);
void bind_parts(nb::module_& module);
void bind_robots(nb::module_& module);
void bind_caches(nb::module_& module);
void bind_pages(nb::module_& module);

}  // namespace toccata::python
