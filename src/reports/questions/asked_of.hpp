#pragma once

#include <string>

#include "toccata/core/error.hpp"

namespace toccata::io {

/// What `ask` answers about the object of that name, which its errors begin with.
template <class Ask>
auto asked_of(const std::string& name, const Ask& ask) {
  try {
    return ask();
  } catch (const Error& error) {
    throw Error("'" + name + "': " + error.what());
  }
}

}  // namespace toccata::io
