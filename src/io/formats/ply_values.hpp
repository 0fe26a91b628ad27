#pragma once

#include <bit>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "io/formats/binary_values.hpp"
#include "io/formats/ply_header.hpp"
#include "io/formats/text_cursor.hpp"

namespace toccata::io {

/// The values of a PLY file one after the other, however they are written.
template <typename T>
concept PlyValues = requires(T values, PlyType type, const std::string& text) {
  values.begin_element();  // before each element of the file
  values.end_element();
  values.expect_end();                                    // throws when there is more than the header announced
  { values.number(type, text) } -> std::same_as<double>;  // always finite
  { values.integer(type, text) } -> std::same_as<std::int64_t>;
  values.skip(type, std::size_t{});
  { values.most_elements_left(std::size_t{}, std::size_t{}) } -> std::same_as<std::size_t>;
  values.fail(text, text);
};

/// Values as words. An element begins on a new line, may run over several, and ends at the end of one.
class PlyTextValues {
 public:
  PlyTextValues(std::span<const char> body, std::string_view name, std::size_t first_line)
      : cursor_(body, name, {}, first_line) {}

  void begin_element() { seek_word(); }
  void end_element() { cursor_.expect_line_end("the last value of an element"); }
  void expect_end();
  [[nodiscard]] double number(PlyType type, std::string_view what);
  [[nodiscard]] std::int64_t integer(PlyType type, std::string_view what);
  void skip(PlyType type, std::size_t values);
  /// How many elements of so many values have room in what is left.
  [[nodiscard]] std::size_t most_elements_left(std::size_t values, std::size_t bytes) const;
  [[noreturn]] void fail(const std::string& what, const std::string& advice) const { cursor_.fail(what, advice); }

 private:
  void seek_word();

  TextCursor cursor_;
};

/// The value of that type which is stored there.
template <typename T>
[[nodiscard]] T converted(std::span<const char> bytes, PlyType type, std::endian order) {
  switch (type) {
    case PlyType::int8:
      return static_cast<T>(stored_value<std::int8_t>(bytes, order));
    case PlyType::uint8:
      return static_cast<T>(stored_value<std::uint8_t>(bytes, order));
    case PlyType::int16:
      return static_cast<T>(stored_value<std::int16_t>(bytes, order));
    case PlyType::uint16:
      return static_cast<T>(stored_value<std::uint16_t>(bytes, order));
    case PlyType::int32:
      return static_cast<T>(stored_value<std::int32_t>(bytes, order));
    case PlyType::uint32:
      return static_cast<T>(stored_value<std::uint32_t>(bytes, order));
    case PlyType::float32:
      return static_cast<T>(stored_value<float>(bytes, order));
    default:
      return static_cast<T>(stored_value<double>(bytes, order));
  }
}

/// Values as bytes without anything between them.
class PlyBinaryValues {
 public:
  PlyBinaryValues(std::span<const char> file, std::size_t body_offset, std::string_view name, std::endian order)
      : file_(file), position_(body_offset), name_(name), order_(order) {}

  void begin_element() {}
  void end_element() {}
  void expect_end() const;
  [[nodiscard]] double number(PlyType type, std::string_view what) {
    const double value = converted<double>(take(size_of(type)), type, order_);
    if (!std::isfinite(value)) fail_before(size_of(type), what);
    return value;
  }
  [[nodiscard]] std::int64_t integer(PlyType type, std::string_view /*what*/) {
    return converted<std::int64_t>(take(size_of(type)), type, order_);
  }
  void skip(PlyType type, std::size_t values);
  [[nodiscard]] std::size_t most_elements_left(std::size_t values, std::size_t bytes) const;
  [[noreturn]] void fail(const std::string& what, const std::string& advice) const;

 private:
  /// The next bytes of the file; throws where it ends before.
  std::span<const char> take(std::size_t bytes) {
    if (bytes > file_.size() - position_) fail_truncated();
    const std::span<const char> taken = file_.subspan(position_, bytes);
    position_ += bytes;
    return taken;
  }
  [[noreturn]] void fail_truncated() const;
  /// A value that is stored in the last so many bytes is not finite.
  [[noreturn]] void fail_before(std::size_t bytes, std::string_view what) const;

  std::span<const char> file_;
  std::size_t position_;
  std::string_view name_;
  std::endian order_;
};

}  // namespace toccata::io
