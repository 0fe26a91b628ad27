#pragma once

#include <optional>
#include <string>

namespace toccata::command {

/// The file of a program of that name that belongs to this one: beside it, or on the path. None where there is none.
[[nodiscard]] std::optional<std::string> installed_program(const std::string& name);

}  // namespace toccata::command
