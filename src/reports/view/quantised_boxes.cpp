#include "reports/view/quantised_boxes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "math/vec3_coordinates.hpp"

namespace toccata::io {
namespace {

constexpr double most_steps = 65535;

}  // namespace

void QuantisedBoxes::add(const Aabb& box, std::size_t its_class) {
  for (const auto coordinate : vec3_coordinates) numbers_.push_back(step_of(box.lower.*coordinate, coordinate));
  for (const auto coordinate : vec3_coordinates) numbers_.push_back(step_of(box.upper.*coordinate, coordinate));
  numbers_.push_back(static_cast<std::uint16_t>(its_class));
}

std::uint16_t QuantisedBoxes::step_of(double value, double Vec3::*coordinate) const {
  const double lower = around_.lower.*coordinate, upper = around_.upper.*coordinate;
  // A quarter, so that no difference overflows.
  const double share = upper > lower ? (0.25 * value - 0.25 * lower) / (0.25 * upper - 0.25 * lower) : 0;
  return static_cast<std::uint16_t>(share > 0 ? std::round(most_steps * std::min(share, 1.0)) : 0);
}

Json QuantisedBoxes::written(const DisplayFrame& frame, ViewData& data) const {
  Json array = data.add(std::span<const std::uint16_t>(numbers_));
  const std::array<float, 3> lower = frame.shown(around_.lower), upper = frame.shown(around_.upper);
  array["bytes"] = 2;
  array["lower"] = lower;
  Json& step = array["step"] = Json::array();
  for (std::size_t axis = 0; axis < 3; ++axis) step.push_back((double{upper[axis]} - double{lower[axis]}) / most_steps);
  return array;
}

Json QuantisedBoxes::written(ViewData& data) const {
  Json array = data.add(std::span<const std::uint16_t>(numbers_));
  array["bytes"] = 2;
  Json lower = Json::array(), step = Json::array();
  for (const auto coordinate : vec3_coordinates) {
    const double from = around_.lower.*coordinate, to = around_.upper.*coordinate;
    lower.push_back(from);
    step.push_back(to > from ? to / most_steps - from / most_steps : 0.0);
  }
  array["lower"] = std::move(lower);
  array["step"] = std::move(step);
  return array;
}

}  // namespace toccata::io
