#pragma once

#include <string>

namespace toccata::test {

/// The bytes as base64 (RFC 4648), padded with what decodes to zeros.
inline std::string base64(const std::string& bytes) {
  const char* digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string result;
  unsigned bits = 0;
  int held = 0;
  for (const char c : bytes + std::string((3 - bytes.size() % 3) % 3, '\0')) {
    bits = bits << 8 | static_cast<unsigned char>(c);
    for (held += 8; held >= 6;) result += digits[bits >> (held -= 6) & 63];
  }
  return result;
}

}  // namespace toccata::test
