#pragma once

#include <cstddef>
#include <functional>

namespace toccata {

/// Told now and then how much of a long task is done: `done` of `total` steps. May be called from any thread, never
/// from two at once. An exception that it throws ends the task (the way to cancel).
using Progress = std::function<void(std::size_t done, std::size_t total)>;

}  // namespace toccata
