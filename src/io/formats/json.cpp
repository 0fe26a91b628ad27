#include "io/formats/json.hpp"

template nlohmann::ordered_json::basic_json(const nlohmann::ordered_json&);
template std::string nlohmann::ordered_json::dump(int, char, bool, error_handler_t) const;
template void nlohmann::ordered_json::json_value::destroy(nlohmann::detail::value_t);
