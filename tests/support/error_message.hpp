#pragma once

#include <functional>
#include <string>

#include "toccata/core/error.hpp"

namespace toccata::test {

/// The message of the Error that `action` throws, empty when it throws none.
inline std::string message_of(const std::function<void()>& action) {
  try {
    action();
  } catch (const Error& error) {
    return error.what();
  }
  return {};
}

}  // namespace toccata::test
