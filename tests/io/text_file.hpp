#pragma once

#include <span>
#include <string_view>

#include "support/error_message.hpp"
#include "support/temporary_folder.hpp"

namespace toccata::test {

inline std::span<const char> bytes_of(std::string_view text) { return {text.data(), text.size()}; }

}  // namespace toccata::test
