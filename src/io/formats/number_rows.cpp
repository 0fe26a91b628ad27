#include "io/formats/number_rows.hpp"

#include <fmt/format.h>

#include <bit>
#include <cmath>
#include <limits>
#include <type_traits>

#include "io/formats/base64.hpp"
#include "io/formats/binary_values.hpp"

namespace toccata::io {
namespace {

static_assert(std::endian::native == std::endian::little, "numbers are written as they are in memory");

constexpr std::size_t most_readable = 1000;

template <class Number>
Number number_of(const JsonValue& value) {
  if constexpr (std::is_same_v<Number, double>)
    return value.number();
  else
    return static_cast<Number>(value.whole(std::numeric_limits<Number>::max()));
}

/// What a text of so many bytes holds.
template <class Number>
std::vector<Number> decoded(const JsonValue& list, std::size_t width, const std::string& row) {
  const std::string text = list.text();
  const std::vector<char> bytes = decode_base64(list, text);
  if (bytes.size() % (width * sizeof(Number)) != 0)
    list.fail(fmt::format("the text holds {} bytes, and a {} is {}", bytes.size(), row, width * sizeof(Number)),
              "it was cut short or changed: write the file again");
  std::vector<Number> numbers;
  numbers.reserve(bytes.size() / sizeof(Number));
  for (std::size_t at = 0; at < bytes.size(); at += sizeof(Number)) {
    numbers.push_back(stored_value<Number>(std::span(bytes).subspan(at), std::endian::little));
    if constexpr (std::is_same_v<Number, double>)
      if (!std::isfinite(numbers.back()))
        list.fail(fmt::format("{} {} has a number that is not finite", row, (numbers.size() - 1) / width),
                  "write finite numbers");
  }
  return numbers;
}

template <class Number>
std::vector<Number> read_rows(const JsonValue& list, std::size_t width, const std::string& row) {
  if (list.is_string()) return decoded<Number>(list, width, row);
  std::vector<Number> numbers;
  for (const JsonValue& one : list.elements()) {
    if (width == 1) {
      numbers.push_back(number_of<Number>(one));
      continue;
    }
    const std::vector<JsonValue> columns = one.elements();
    if (columns.size() != width)
      one.fail(fmt::format("here are {} numbers, not {}", columns.size(), width), "correct the list");
    for (const JsonValue& column : columns) numbers.push_back(number_of<Number>(column));
  }
  return numbers;
}

template <class Number>
Json written(std::span<const Number> numbers, std::size_t width) {
  if (numbers.size() > most_readable)
    return base64_of({reinterpret_cast<const char*>(numbers.data()), numbers.size_bytes()});
  Json list = Json::array();
  for (std::size_t i = 0; i < numbers.size(); i += width) {
    if (width == 1) {
      list.push_back(numbers[i]);
      continue;
    }
    Json row = Json::array();
    for (std::size_t column = 0; column < width; ++column) row.push_back(numbers[i + column]);
    list.push_back(std::move(row));
  }
  return list;
}

}  // namespace

std::vector<double> rows_of_numbers(const JsonValue& list, std::size_t width, const std::string& row) {
  return read_rows<double>(list, width, row);
}

std::vector<std::uint32_t> rows_of_whole_numbers(const JsonValue& list, std::size_t width, const std::string& row) {
  return read_rows<std::uint32_t>(list, width, row);
}

Json json_of_rows(std::span<const double> numbers, std::size_t width) { return written(numbers, width); }

Json json_of_rows(std::span<const std::uint32_t> numbers, std::size_t width) { return written(numbers, width); }

}  // namespace toccata::io
