#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <new>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "toccata/core/error.hpp"

namespace toccata {

/// What one rank sends to another. All ranks have the same kind of machine: numbers are sent as they are in memory.
using Bytes = std::vector<std::byte>;

class MessageWriter {
 public:
  template <class T>
  requires std::is_trivially_copyable_v<T>
  void put(const T& value) { append(&value, sizeof(T)); }

  /// A whole number that is small as a rule: a byte for each seven bits that it has.
  void put_number(std::uint64_t number) {
    for (; number >= 0x80; number >>= 7) put(static_cast<std::uint8_t>(number | 0x80));
    put(static_cast<std::uint8_t>(number));
  }

  template <class T>
  requires std::is_trivially_copyable_v<T>
  void put_all(std::span<const T> values) {
    put_number(values.size());
    append(values.data(), values.size_bytes());
  }

  void put_text(std::string_view text) { put_all(std::span<const char>(text)); }

  [[nodiscard]] bool is_empty() const { return bytes_.empty(); }
  [[nodiscard]] Bytes take() { return std::exchange(bytes_, {}); }

 private:
  void append(const void* from, std::size_t count) {
    if (count == 0) return;
    const std::size_t before = bytes_.size();
    bytes_.resize(before + count);
    std::memcpy(bytes_.data() + before, from, count);
  }

  Bytes bytes_;
};

/// Reads what a MessageWriter wrote, in the same order. Throws Error where there is less.
class MessageReader {
 public:
  explicit MessageReader(std::span<const std::byte> bytes) : rest_(bytes) {}

  template <class T>
  requires std::is_trivially_copyable_v<T>
  [[nodiscard]] T get() {
    alignas(T) std::byte place[sizeof(T)];
    std::memcpy(place, take(sizeof(T)), sizeof(T));
    return *std::launder(reinterpret_cast<T*>(place));
  }

  [[nodiscard]] std::uint64_t get_number() {
    std::uint64_t number = 0;
    for (int shift = 0; shift < 64; shift += 7) {
      const auto byte = get<std::uint8_t>();
      number |= std::uint64_t{byte & 0x7fU} << shift;
      if (byte < 0x80) return number;
    }
    throw Error("a message between ranks has a number of more than 64 bits");
  }

  template <class T>
  requires std::is_trivially_copyable_v<T>
  [[nodiscard]] std::vector<T> get_all() {
    const std::uint64_t count = get_number();
    if (count > rest_.size() / sizeof(T)) throw Error("a message between ranks ends too early");
    std::vector<T> values(count);
    if (count > 0) std::memcpy(values.data(), take(count * sizeof(T)), count * sizeof(T));
    return values;
  }

  [[nodiscard]] std::string get_text() {
    const std::vector<char> text = get_all<char>();
    return {text.begin(), text.end()};
  }

  [[nodiscard]] bool is_at_end() const { return rest_.empty(); }

 private:
  const std::byte* take(std::size_t count) {
    if (count > rest_.size()) throw Error("a message between ranks ends too early");
    const std::byte* begin = rest_.data();
    rest_ = rest_.subspan(count);
    return begin;
  }

  std::span<const std::byte> rest_;
};

}  // namespace toccata
