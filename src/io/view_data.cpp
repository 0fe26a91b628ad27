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
  const auto byte = [&](std::size_t i) {
    return i < bytes_.size() ? std::uint32_t{static_cast<unsigned char>(bytes_[i])} : 0U;
  };
  std::string text;
  text.reserve((bytes_.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes_.size(); i += 3) {
    const std::uint32_t bits = byte(i) << 16U | byte(i + 1) << 8U | byte(i + 2);
    for (const unsigned shift : {18U, 12U, 6U, 0U}) text += letters[bits >> shift & 63U];
  }
  for (std::size_t missing = (3 - bytes_.size() % 3) % 3; missing > 0; --missing) text[text.size() - missing] = '=';
  return text;
}

}  // namespace toccata::io
