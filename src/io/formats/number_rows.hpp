#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "io/formats/json.hpp"
#include "io/formats/json_value.hpp"

namespace toccata::io {

// Lists of rows of equally many numbers, as scene files have them: an array of arrays, or of numbers where a row is one
// number; or, for many, a text that holds the numbers in base64, little endian. Both keep every bit.

/// Doubles, row after row, of 8 bytes in base64. `row` is what a row is called in messages, which name it by its
/// number. Throws Error for another number of them in a row, and for one that is not finite.
[[nodiscard]] std::vector<double> rows_of_numbers(const JsonValue& list, std::size_t width, const std::string& row);

/// Whole numbers from 0 to 2³² − 1, of 4 bytes in base64.
[[nodiscard]] std::vector<std::uint32_t> rows_of_whole_numbers(const JsonValue& list, std::size_t width,
                                                               const std::string& row);

/// An array of rows that people can read; base64 where there are more than a thousand numbers.
[[nodiscard]] Json json_of_rows(std::span<const double> numbers, std::size_t width);
[[nodiscard]] Json json_of_rows(std::span<const std::uint32_t> numbers, std::size_t width);

}  // namespace toccata::io
