#pragma once

#include <nlohmann/json.hpp>

namespace toccata::io {

/// What is written: its members stay in the order in which they were added.
using Json = nlohmann::ordered_json;

}  // namespace toccata::io

// What many files need of JSON, and what is large, is compiled once, in json.cpp. Not the whole class: most of it reads
// and writes formats that nobody asks for, and took a tenth of the first build.
extern template nlohmann::basic_json<nlohmann::ordered_map>::basic_json(const nlohmann::ordered_json&);
extern template std::string nlohmann::basic_json<nlohmann::ordered_map>::dump(int, char, bool, error_handler_t) const;
extern template void nlohmann::basic_json<nlohmann::ordered_map>::json_value::destroy(nlohmann::detail::value_t);
