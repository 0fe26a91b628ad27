#include "io/formats/base64.hpp"

#include <cstdint>

namespace toccata::io {
namespace {

int digit_of(char c) {
  if (c >= 'A' && c <= 'Z') return c - 'A';
  if (c >= 'a' && c <= 'z') return c - 'a' + 26;
  if (c >= '0' && c <= '9') return c - '0' + 52;
  return c == '+' ? 62 : c == '/' ? 63 : -1;
}

}  // namespace

std::string base64_of(std::string_view bytes) {
  static constexpr std::string_view letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  const std::size_t whole = bytes.size() / 3;
  std::string text((bytes.size() + 2) / 3 * 4, '=');
  const auto write = [&](std::size_t i, std::string_view some) {
    const auto byte = [&](std::size_t k) {
      return k < some.size() ? std::uint32_t{static_cast<unsigned char>(some[k])} : 0U;
    };
    const std::uint32_t bits = byte(0) << 16U | byte(1) << 8U | byte(2);
    for (std::size_t k = 0; k <= some.size(); ++k) text[4 * i + k] = letters[bits >> (18U - 6U * k) & 63U];
  };
  for (std::size_t i = 0; i < whole; ++i) write(i, bytes.substr(3 * i, 3));
  if (bytes.size() % 3 != 0) write(whole, bytes.substr(3 * whole));
  return text;
}

std::vector<char> decode_base64(const JsonValue& place, std::string_view text) {
  while (text.ends_with('=')) text.remove_suffix(1);
  std::vector<char> bytes;
  bytes.reserve(text.size() / 4 * 3 + 2);
  unsigned bits = 0;
  int held = 0;
  for (const char c : text) {
    const int digit = digit_of(c);
    if (digit < 0) place.fail("the data is not base64", "export the file again");
    bits = (bits << 6 | static_cast<unsigned>(digit)) & 0xffffU;
    held += 6;
    if (held >= 8) bytes.push_back(static_cast<char>(bits >> (held -= 8) & 0xffU));
  }
  return bytes;
}

}  // namespace toccata::io
