#pragma once

#include <filesystem>
#include <optional>

namespace toccata::test {

/// The folder of real models and queries, where TOCCATA_DATA points; nothing when it is not set. Tests that need it
/// skip loudly: `const auto data = data_folder(); if (!data) GTEST_SKIP() << "set TOCCATA_DATA";`
std::optional<std::filesystem::path> data_folder();

}  // namespace toccata::test
