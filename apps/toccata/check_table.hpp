#pragma once

#include <string>

#include "toccata/io/report.hpp"

namespace toccata::command {

/// What was found, for people.
std::string check_table(const Scene& scene, const CheckReport& report);

}  // namespace toccata::command
