#pragma once

#include <charconv>
#include <cstdint>
#include <string>
#include <system_error>

#include <CLI/CLI.hpp>

namespace toccata {

/// That fits in 64 bits; CLI11 takes a negative one for a large one.
inline CLI::Validator whole_number() {
  return {[](const std::string& text) {
            std::uint64_t number = 0;
            const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
            const bool is_one = error == std::errc() && end == text.data() + text.size();
            return is_one ? std::string() : "give a whole number from 0 to 18446744073709551615, not " + text;
          },
          "", "whole number"};
}

}  // namespace toccata
