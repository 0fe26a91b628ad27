#pragma once

#include <cstddef>
#include <string>

#include "toccata/query/check_all.hpp"

namespace toccata {

/// What messages call the i-th of the posed models.
[[nodiscard]] inline std::string name_for_messages(const SceneInstance& posed, std::size_t i) {
  return posed.name.empty() ? "object " + std::to_string(i) : "object \"" + posed.name + "\"";
}

}  // namespace toccata
