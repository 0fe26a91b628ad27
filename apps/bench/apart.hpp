#pragma once

#include <functional>
#include <optional>
#include <string>

namespace toccata::bench {

/// What `work` returns, in a process of its own, which is ended after so many `seconds` of the processor. Its memory is
/// gone afterwards. None where it was ended, or died. `work` must not use the threads of this process.
std::optional<std::string> result_apart(const std::function<std::string()>& work, double seconds);

}  // namespace toccata::bench
