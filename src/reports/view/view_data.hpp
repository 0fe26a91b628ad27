#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "io/formats/json.hpp"
#include "toccata/core/index.hpp"
#include "toccata/math/vec3.hpp"

namespace toccata::io {

/// The binary part of a page (docs/reference/view-page.md): arrays one after the other, little endian, each at a
/// multiple of four bytes. What `add` returns names an array in the header: where it begins and how many numbers it
/// has.
class ViewData {
 public:
  Json add(std::span<const std::uint16_t> numbers);
  Json add(std::span<const std::uint32_t> numbers);
  Json add(std::span<const float> numbers);

  [[nodiscard]] const std::string& bytes() const { return bytes_; }

 private:
  template <class Number>
  Json add_numbers(std::span<const Number> numbers);

  std::string bytes_;
};

}  // namespace toccata::io
