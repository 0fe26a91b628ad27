#pragma once

#include <fmt/format.h>

#include <bit>
#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

// What the programs that write scene files share (docs/reference/scene-file.md).
namespace toccata::formats {

static_assert(std::endian::native == std::endian::little, "numbers are written as they are in memory");

/// Numbers as they are in memory, in base64 (RFC 4648).
template <class Number>
std::string base64_of(const std::vector<Number>& numbers) {
  constexpr std::string_view letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  const std::string_view bytes(reinterpret_cast<const char*>(numbers.data()), numbers.size() * sizeof(Number));
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t three = 0;
    for (std::size_t k = 0; k < 3; ++k)
      three = three << 8U | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0U);
    for (std::size_t k = 0; k < 4; ++k) text += i + k > bytes.size() ? '=' : letters[three >> (18 - 6 * k) & 63U];
  }
  return text;
}

/// Tells the frames and objects of one scene apart.
class PartNames {
 public:
  /// The name, or the name with a number behind where it is taken. It is taken then.
  std::string take(const std::string& name) {
    std::string free = name;
    for (int& number = next_number_.try_emplace(name, 2).first->second; !taken_.insert(free).second; ++number)
      free = fmt::format("{} #{}", name, number);
    return free;
  }

 private:
  std::set<std::string> taken_;
  std::map<std::string, int> next_number_;
};

}  // namespace toccata::formats
