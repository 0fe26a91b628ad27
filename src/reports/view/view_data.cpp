#include "reports/view/view_data.hpp"

#include <bit>
#include <cstring>

namespace toccata::io {

static_assert(std::endian::native == std::endian::little, "numbers are copied as they are in memory");

template <class Number>
Json ViewData::add_numbers(std::span<const Number> numbers) {
  bytes_.resize((bytes_.size() + 3) / 4 * 4);
  const std::size_t at = bytes_.size();
  bytes_.resize(at + numbers.size_bytes());
  if (!numbers.empty()) std::memcpy(bytes_.data() + at, numbers.data(), numbers.size_bytes());
  return {{"at", at}, {"count", numbers.size()}};
}

Json ViewData::add(std::span<const std::uint16_t> numbers) { return add_numbers(numbers); }
Json ViewData::add(std::span<const std::uint32_t> numbers) { return add_numbers(numbers); }
Json ViewData::add(std::span<const float> numbers) { return add_numbers(numbers); }

}  // namespace toccata::io
