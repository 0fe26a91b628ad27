#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <cstring>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace toccata::test {

/// What a page holds (docs/reference/view-page.md), read from its text.
struct Page {
  using Json = nlohmann::json;

  Page() = default;
  explicit Page(const std::string& html);

  /// The numbers of an array that the header names.
  template <class Number>
  [[nodiscard]] std::vector<Number> numbers(const Json& place) const {
    std::vector<Number> all(place.at("count").get<std::size_t>());
    const std::size_t at = place.at("at").get<std::size_t>();
    EXPECT_EQ(at % 4, 0U);
    EXPECT_LE(at + all.size() * sizeof(Number), data.size());
    std::memcpy(all.data(), data.data() + at, all.size() * sizeof(Number));
    return all;
  }

  Json header;
  Json report;
  std::string data;
};

/// The header and the report of a page in a file, one after the other.
[[nodiscard]] std::string page_text(const std::filesystem::path& file);

}  // namespace toccata::test
