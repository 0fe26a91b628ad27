#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "io/view/view_data.hpp"

namespace toccata::io {

/// The empty page with what is to be shown. `report` is JSON. Names in both JSON texts may hold anything.
[[nodiscard]] std::string filled_page(const nlohmann::ordered_json& header, const std::string& report,
                                      const ViewData& data);

}  // namespace toccata::io
