#pragma once

#include <nanobind/nanobind.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <exception>
#include <limits>
#include <mutex>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include <toccata/core/error.hpp>
#include <toccata/core/parallel.hpp>
#include <toccata/query/batch.hpp>
#include <toccata/query/model.hpp>

// How questions are asked from Python: without the interpreter's lock (GIL) where that pays, and so that Ctrl-C ends
// them.
namespace toccata::python {

namespace nb = nanobind;

/// A greatest distance, or time, that nothing exceeds.
inline constexpr double unlimited = std::numeric_limits<double>::infinity();

/// It has no tree: a question about two such takes less time than to give the lock away and to take it back.
inline bool is_quick(const Model& model) { return !model.has_mesh() && model.parts().empty(); }

/// `ask()` without the lock. Nothing of Python may be touched in it.
template <class Ask>
auto without_lock(const Ask& ask) {
  const nb::gil_scoped_release released;
  return ask();
}

/// `ask(a, b)`, mostly without the lock. Then it works on copies, which share what is large: so another thread may give
/// a mesh other vertices meanwhile.
template <class Ask>
auto asked_about(const Model& a, const Model& b, const Ask& ask) {
  if (is_quick(a) && is_quick(b)) return ask(a, b);
  return without_lock([&ask, copy_of_a = a, copy_of_b = b] { return ask(copy_of_a, copy_of_b); });
}

template <class Ask>
auto asked_about(const Model& model, const Ask& ask) {
  if (is_quick(model)) return ask(model);
  return without_lock([&ask, copy = model] { return ask(copy); });
}

/// One thread at a time. Whoever has the turn does not wait for it: a handler of a signal runs within the question that
/// looked for signals, and gets an Error.
class Turns {
 public:
  /// As long as it lives, this thread is within a function of Python that the library has called.
  class WithinFunction {
   public:
    WithinFunction() : before_(std::exchange(within_function(), true)) {}
    WithinFunction(const WithinFunction&) = delete;
    WithinFunction& operator=(const WithinFunction&) = delete;
    ~WithinFunction() { within_function() = before_; }

   private:
    bool before_;
  };

  void lock() {
    require_other();
    // Who waited within a function that the library called would wait for the one who waits for that function.
    if (within_function() && !mutex_.try_lock()) refuse();
    if (!within_function()) mutex_.lock();
    owner_ = std::this_thread::get_id();
  }
  bool try_lock() {
    require_other();
    if (!mutex_.try_lock()) return false;
    owner_ = std::this_thread::get_id();
    return true;
  }
  void unlock() {
    owner_ = std::thread::id();
    mutex_.unlock();
  }

 private:
  static bool& within_function() {
    thread_local bool is_within = false;
    return is_within;
  }
  [[noreturn]] static void refuse() {
    throw Error(
        "it is being asked: what a signal calls meanwhile, or the function of a motion, may not use it; let a signal "
        "set "
        "a flag, or raise");
  }
  void require_other() const {
    if (owner_ == std::this_thread::get_id()) refuse();
  }

  std::mutex mutex_;
  std::atomic<std::thread::id> owner_{};
};

/// What a batch is told so that Ctrl-C ends it: now and then the thread that asked looks whether a signal has come.
class Interruptible {
 public:
  explicit Interruptible(int threads);

  [[nodiscard]] const BatchOptions& options() const { return options_; }

  /// `ask(options)` without the lock. What a handler of Python raised comes out of it, as KeyboardInterrupt does.
  template <class Ask>
  auto ask(const Ask& ask) const {
    try {
      return without_lock([&] { return ask(options_); });
    } catch (const Interrupted&) {
      throw nb::python_error();
    }
  }

 private:
  /// The error itself stays with the thread of Python.
  struct Interrupted {};

  BatchOptions options_;
};

/// `answer(i)` for each of so many, in rows of `length` on several threads. Between rows Ctrl-C is looked for. An Error
/// begins with "<noun> i: ".
template <class Answer>
auto answer_each(std::size_t count, std::size_t length, const char* noun, int threads, const Answer& answer) {
  return Interruptible(threads).ask([&](const BatchOptions& options) {
    std::vector<decltype(answer(std::size_t{}))> answers(count);
    std::atomic<bool> ended = false;
    const auto look = [&](std::size_t done) {
      try {
        options.progress(done, count);
      } catch (...) {
        ended = true;
        throw;
      }
    };
    parallel_for((count + length - 1) / length, threads, [&](std::size_t row) {
      if (ended) return;
      look(row * length);
      for (std::size_t i = row * length; i < std::min(count, (row + 1) * length); ++i) try {
          answers[i] = answer(i);
        } catch (const Error& error) {
          throw Error(fmt::format("{} {}: {}", noun, i, error.what()));
        }
    });
    return answers;
  });
}

}  // namespace toccata::python
