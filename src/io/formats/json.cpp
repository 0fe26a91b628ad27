#include "io/formats/json.hpp"

template nlohmann::basic_json<nlohmann::ordered_map>::basic_json(const nlohmann::ordered_json&);
template std::string nlohmann::basic_json<nlohmann::ordered_map>::dump(int, char, bool, error_handler_t) const;
template void nlohmann::basic_json<nlohmann::ordered_map>::json_value::destroy(nlohmann::detail::value_t);
