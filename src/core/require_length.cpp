#include "core/require_length.hpp"

#include <fmt/format.h>

#include "toccata/core/error.hpp"

namespace toccata {

void require_length(double length, std::string_view name) {
  if (!(length >= 0)) throw Error(fmt::format("{} is {}; it has to be a length of 0 or more", name, length));
}

}  // namespace toccata
