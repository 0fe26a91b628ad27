#include "io/view_data.hpp"

#include <bit>
#include <cstring>
#include <string_view>

namespace toccata::io {

static_assert(std::endian::native == std::endian::little, "numbers are copied as they are in memory");

template <class Number>
ViewData::Json ViewData::add_numbers(std::span<const Number> numbers) {
  bytes_.resize((bytes_.size() + 3) / 4 * 4);
  const std::size_t at = bytes_.size();
  bytes_.resize(at + numbers.size_bytes());
  if (!numbers.empty()) std::memcpy(bytes_.data() + at, numbers.data(), numbers.size_bytes());
  return {{"at", at}, {"count", numbers.size()}};
}

ViewData::Json ViewData::add(std::span<const std::uint16_t> numbers) { return add_numbers(numbers); }
ViewData::Json ViewData::add(std::span<const std::uint32_t> numbers) { return add_numbers(numbers); }
ViewData::Json ViewData::add(std::span<const float> numbers) { return add_numbers(numbers); }

std::string ViewData::base64() const {
  static constexpr std::string_view letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  const std::size_t whole = bytes_.size() / 3;
  std::string text((bytes_.size() + 2) / 3 * 4, '=');
  const auto write = [&](std::size_t i, std::string_view bytes) {
    const auto byte = [&](std::size_t k) {
      return k < bytes.size() ? std::uint32_t{static_cast<unsigned char>(bytes[k])} : 0U;
    };
    const std::uint32_t bits = byte(0) << 16U | byte(1) << 8U | byte(2);
    for (std::size_t k = 0; k <= bytes.size(); ++k) text[4 * i + k] = letters[bits >> (18U - 6U * k) & 63U];
  };
  const std::string_view all(bytes_);
  for (std::size_t i = 0; i < whole; ++i) write(i, all.substr(3 * i, 3));
  if (bytes_.size() % 3 != 0) write(whole, all.substr(3 * whole));
  return text;
}

}  // namespace toccata::io
