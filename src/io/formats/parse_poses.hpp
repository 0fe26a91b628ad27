#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "toccata/query/pair_query.hpp"

namespace toccata::io {

/// `read_poses` over bytes in memory; `name` is what messages call the file.
[[nodiscard]] std::vector<PairQuery> parse_poses(std::span<const char> bytes, std::string_view name);

}  // namespace toccata::io
