#pragma once

#include <string>

#include "io/formats/json.hpp"
#include "reports/view/view_data.hpp"

namespace toccata::io {

/// The empty page with what is to be shown. `report` is JSON. Names in both JSON texts may hold anything.
[[nodiscard]] std::string filled_page(const Json& header, const std::string& report, const ViewData& data);

}  // namespace toccata::io
