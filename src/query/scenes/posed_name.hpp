#pragma once

#include <cstddef>
#include <string>

#include "toccata/query/check_all.hpp"

namespace toccata {

/// What messages call the i-th of the models, whose name may be empty.
[[nodiscard]] inline std::string name_for_messages(const std::string& name, std::size_t i) {
  return name.empty() ? "object " + std::to_string(i) : "object \"" + name + "\"";
}
[[nodiscard]] inline std::string name_for_messages(const SceneInstance& posed, std::size_t i) {
  return name_for_messages(posed.name, i);
}

}  // namespace toccata
