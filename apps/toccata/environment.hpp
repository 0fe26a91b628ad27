#pragma once

#include <chrono>

namespace toccata::command {

using Seconds = std::chrono::duration<double>;

/// What the environment says in the variable of this name; where it says nothing, `otherwise`. Throws Error where that
/// is no number of seconds above 0, or more than `longest`, which `longest_words` names ("a day").
[[nodiscard]] Seconds seconds_of_environment(const char* name, Seconds otherwise, Seconds longest,
                                             const char* longest_words);

}  // namespace toccata::command
