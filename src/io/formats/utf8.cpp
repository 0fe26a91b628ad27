#include "io/formats/utf8.hpp"

#include <fmt/format.h>

#include <cstddef>

namespace toccata::io {
namespace {

/// A first byte of a character, how many bytes follow, and the range of the first of those (RFC 3629, section 4).
struct Lead {
  unsigned char first, last;
  unsigned char followers;
  unsigned char second_first, second_last;
};

constexpr Lead leads[] = {
    {0x00, 0x7f, 0, 0, 0},       {0xc2, 0xdf, 1, 0x80, 0xbf}, {0xe0, 0xe0, 2, 0xa0, 0xbf},
    {0xe1, 0xec, 2, 0x80, 0xbf}, {0xed, 0xed, 2, 0x80, 0x9f}, {0xee, 0xef, 2, 0x80, 0xbf},
    {0xf0, 0xf0, 3, 0x90, 0xbf}, {0xf1, 0xf3, 3, 0x80, 0xbf}, {0xf4, 0xf4, 3, 0x80, 0x8f},
};

bool is_within(char byte, unsigned char first, unsigned char last) {
  const auto value = static_cast<unsigned char>(byte);
  return value >= first && value <= last;
}

/// Bytes of the character that `bytes` begins with; 0 when it begins with none.
std::size_t character_length(std::string_view bytes) {
  for (const Lead& lead : leads) {
    if (!is_within(bytes[0], lead.first, lead.last)) continue;
    if (bytes.size() <= lead.followers) return 0;
    for (std::size_t i = 1; i <= lead.followers; ++i)
      if (!is_within(bytes[i], i == 1 ? lead.second_first : 0x80, i == 1 ? lead.second_last : 0xbf)) return 0;
    return 1 + lead.followers;
  }
  return 0;
}

}  // namespace

bool is_utf8(std::string_view bytes) {
  while (!bytes.empty()) {
    const std::size_t length = character_length(bytes);
    if (length == 0) return false;
    bytes.remove_prefix(length);
  }
  return true;
}

std::string as_utf8(std::string_view bytes) {
  std::string result;
  while (!bytes.empty()) {
    const std::size_t length = character_length(bytes);
    if (length == 0)
      result += fmt::format("\\x{:02x}", static_cast<unsigned char>(bytes[0]));
    else
      result += bytes.substr(0, length);
    bytes.remove_prefix(length == 0 ? 1 : length);
  }
  return result;
}

}  // namespace toccata::io
