#pragma once

#include <cstdint>
#include <vector>

#include "io/formats/json.hpp"
#include "reports/view/display_frame.hpp"
#include "reports/view/view_data.hpp"
#include "toccata/bounds/aabb.hpp"

namespace toccata::io {

/// Boxes in 65,535 steps along each axis, each with the number of its class: the arrays of layers of the kinds `bodies`
/// and `cells`.
class QuantisedBoxes {
 public:
  /// What lies outside of `around` ends at its sides.
  explicit QuantisedBoxes(const Aabb& around) : around_(around) {}

  /// An empty box has its lower end above its upper one.
  void add(const Aabb& box, std::size_t its_class);
  [[nodiscard]] std::size_t size() const { return numbers_.size() / 7; }

  /// In shown coordinates.
  [[nodiscard]] Json written(const DisplayFrame& frame, ViewData& data) const;
  /// In the frame that the boxes are in, an object's.
  [[nodiscard]] Json written(ViewData& data) const;

 private:
  [[nodiscard]] std::uint16_t step_of(double value, double Vec3::*coordinate) const;

  Aabb around_;
  std::vector<std::uint16_t> numbers_;
};

}  // namespace toccata::io
