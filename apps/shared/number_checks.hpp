#pragma once

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <system_error>

// Which numbers an option takes. A word that is none of them is told with the option and what it takes.
namespace toccata {

/// The words behind the option's name, where `text` is not what it takes.
inline std::string number_refusal(const std::string& allowed, const std::string& text) {
  return fmt::format("give {}, not '{}'", allowed, text);
}

/// All of `text`, as a number of C++; none of what it cannot hold. CLI11 takes 010 for 8: it is none either.
template <class Number>
std::optional<Number> whole_text_as(const std::string& text) {
  Number number{};
  const bool has_plus = text.size() > 1 && text[0] == '+' && text[1] != '-';
  const char *const begin = text.data() + (has_plus ? 1 : 0), *const end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(begin, end, number);
  const bool is_octal = std::numeric_limits<Number>::is_integer && end - begin > 1 && *begin == '0';
  if (error != std::errc() || rest != end || is_octal) return std::nullopt;
  return number;
}

inline CLI::Validator whole_number(std::uint64_t least = 0,
                                   std::uint64_t most = std::numeric_limits<std::uint64_t>::max()) {
  return {[=](const std::string& text) {
            const auto number = whole_text_as<std::uint64_t>(text);
            return number && *number >= least && *number <= most
                       ? std::string()
                       : number_refusal(fmt::format("a whole number from {} to {}", least, most), text);
          },
          most == std::numeric_limits<std::uint64_t>::max() ? "" : fmt::format("{} to {}", least, most),
          "whole number"};
}

inline CLI::Validator number_between(double least, double most) {
  return {[=](const std::string& text) {
            const auto number = whole_text_as<double>(text);
            return number && *number >= least && *number <= most
                       ? std::string()
                       : number_refusal(fmt::format("a number from {} to {}", least, most), text);
          },
          fmt::format("{} to {}", least, most), "number"};
}

/// A finite one.
inline CLI::Validator number_above_0() {
  return {[](const std::string& text) {
            const auto number = whole_text_as<double>(text);
            return number && *number > 0 && std::isfinite(*number) ? std::string()
                                                                   : number_refusal("a finite number above 0", text);
          },
          "", "number"};
}

/// A finite one.
inline CLI::Validator number_from(double least) {
  return {[=](const std::string& text) {
            const auto number = whole_text_as<double>(text);
            return number && *number >= least && std::isfinite(*number)
                       ? std::string()
                       : number_refusal(fmt::format("a finite number of {} or more", least), text);
          },
          "", "number"};
}

}  // namespace toccata
