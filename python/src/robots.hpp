#pragma once

#include <nanobind/nanobind.h>

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <toccata/robots/allowed_pairs.hpp>
#include <toccata/robots/robot.hpp>

#include "arrays.hpp"

// Configurations of a robot in Python: arrays of a number for each position.
namespace toccata::python {

struct Configurations {
  Doubles given;

  [[nodiscard]] std::span<const double> numbers() const;
};

/// One, of the shape (P,). Throws Error, beginning with `what`, for another shape.
[[nodiscard]] Configurations configuration_of(nb::handle given, const Robot& robot, std::string_view what);

/// Many, of the shape (N, P).
[[nodiscard]] Configurations configurations_of(nb::handle given, const Robot& robot, std::string_view what);

/// The numbers themselves, not copied, as an array of this shape.
[[nodiscard]] Floats numbers_told(std::vector<double> numbers, const std::vector<std::size_t>& shape);

/// A str of Python. Throws Error, beginning with `what`, where it has lone surrogates, which are no text.
[[nodiscard]] std::string text_given(nb::handle given, std::string_view what);

/// Takes a list of pairs of names, each with a reason or without.
[[nodiscard]] std::vector<AllowedPair> allowed_pairs_of(nb::handle given, std::string_view what);

/// RobotScene and its answers; of what bind_robots binds, what is asked.
void bind_robot_scenes(nb::module_& module);

}  // namespace toccata::python
