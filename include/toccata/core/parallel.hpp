#pragma once

#include <cstddef>
#include <functional>

#include "toccata/core/function_ref.hpp"

namespace toccata {

/// What is called `threads` means the same everywhere: a call uses up to so many, of which its caller's is one; 0: as
/// many as the machine has. No answer depends on it, to the bit. What answers many questions in one call uses all
/// unless asked otherwise; what is mostly one call of many itself (a question about one pair, a model, a step) its
/// caller's alone, because to wake others may cost it more than they save.
inline constexpr int all_threads = 0;
inline constexpr int own_thread = 1;

/// The number of threads on which a call runs that may use up to `threads`.
[[nodiscard]] int thread_count(int threads);

/// Calls `work` where several calls of `parallel_for` on so many threads can follow each other at once: between them
/// the threads stay awake for a while.
void on_threads(int threads, FunctionRef<void()> work);

/// Calls `body(i)` once for every i in [0, count), on up to `threads` threads; on one thread in order. Work is split
/// by index and never by thread, so a body that writes only its own slot gives the same result for any thread count.
/// When bodies throw, the exception of the least index among those thrown is rethrown at the end; other indices may
/// then not be called.
void parallel_for(std::size_t count, int threads, FunctionRef<void(std::size_t)> body);

/// It is called now and then with how much of a long task is done: `done` of `total` steps. May be called from any
/// thread, never from two at once. An exception that it throws ends the task (the way to cancel).
using Progress = std::function<void(std::size_t done, std::size_t total)>;

}  // namespace toccata
