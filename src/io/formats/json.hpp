#pragma once

#include <nlohmann/json.hpp>

// JSON for all of the room. The two kinds of value are compiled once, in json.cpp, and not again in each file.
extern template class nlohmann::basic_json<>;
extern template class nlohmann::basic_json<nlohmann::ordered_map>;

namespace toccata::io {

/// What is written: its members stay in the order in which they were added.
using Json = nlohmann::ordered_json;

}  // namespace toccata::io
