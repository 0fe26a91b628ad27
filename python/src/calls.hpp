#pragma once

#include <nanobind/nanobind.h>

#include <limits>
#include <utility>

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

}  // namespace toccata::python
