#pragma once

#include <nanobind/nanobind.h>

#include <utility>

#include <toccata/core/error.hpp>

// Values of Python: how they are compared, copied and pickled, once for all classes. What a user derives from one of
// them keeps its class and what it has beside (python/toccata/_values.py).
namespace toccata::python {

namespace nb = nanobind;

/// The arguments by which the class of a value makes it again.
struct Making {
  // Implicit: most have no arguments that are named.
  Making(nb::tuple given) : arguments(std::move(given)) {}
  Making(nb::tuple given, nb::dict by_name) : arguments(std::move(given)), named(std::move(by_name)) {}

  nb::tuple arguments;
  nb::dict named{};
};

[[nodiscard]] bool equal(const Making& a, const Making& b);

/// What pickle is told of a value that the class `kind` makes so.
[[nodiscard]] nb::object reduced(nb::handle self, nb::handle kind, const Making& making);

/// What pickle is told of an answer, which no user makes: its state.
[[nodiscard]] nb::object reduced_to_state(nb::handle self);

/// A copy of what is held, in an object of the same class, which `copy` makes at a place; it may throw. A memo is that
/// of copy.deepcopy; none: copy.copy asks.
[[nodiscard]] nb::object copied(nb::handle self, nb::handle memo, void (*copy)(void* place, nb::handle of));

template <class Value>
void copy_value(void* place, nb::handle of) {
  new (place) Value(nb::cast<const Value&>(of));
}

/// Raises TypeError.
[[noreturn]] void refuse_pickling(nb::handle self, const char* instead);

/// Raises TypeError for an object that was never made: by __new__ alone.
void require_made(nb::handle self);

template <class Value>
const Value& made_value(nb::handle self) {
  require_made(self);
  return nb::cast<const Value&>(self);
}

/// `making(value)` tells the arguments of its class.
template <class Value, class... Rest, class Make>
void bind_pickling(nb::class_<Value, Rest...>& bound, const Make& making) {
  bound.def("__reduce__", [making](nb::handle_t<Value> self) {
    return reduced(self, nb::type<Value>(), Making(making(made_value<Value>(self))));
  });
}

/// Two are equal where the same arguments make them.
template <class Value, class... Rest, class Make>
void bind_equality(nb::class_<Value, Rest...>& bound, const Make& making) {
  bound.def(
      "__eq__",
      [making](const Value& value, const nb::object& other) {
        return nb::isinstance<Value>(other) &&
               equal(Making(making(value)), Making(making(nb::cast<const Value&>(other))));
      },
      nb::arg("other").none(), nb::sig("def __eq__(self, other: object, /) -> bool"));
  bound.attr("__hash__") = nb::none();
}

template <class Value, class... Rest, class Make>
void bind_value(nb::class_<Value, Rest...>& bound, const Make& making) {
  bind_pickling(bound, making);
  bind_equality(bound, making);
}

/// Copies share what is large.
template <class Value, class... Rest>
void bind_copying(nb::class_<Value, Rest...>& bound) {
  bound
      .def("__copy__",
           [](nb::handle_t<Value> self) {
             return nb::borrow<nb::typed<nb::object, Value>>(copied(self, {}, &copy_value<Value>));
           })
      .def(
          "__deepcopy__",
          [](nb::handle_t<Value> self, const nb::typed<nb::dict, int, nb::object>& memo) {
            return nb::borrow<nb::typed<nb::object, Value>>(copied(self, memo, &copy_value<Value>));
          },
          nb::arg("memo"));
}

/// An answer that no user makes: `state(answer)` tells it as a tuple, and `made(tuple)` makes it again.
template <class Answer, class... Rest, class State, class Made>
void bind_state(nb::class_<Answer, Rest...>& bound, const State& state, const Made& made) {
  bound.def("__getstate__", state)
      .def("__setstate__",
           [made](Answer& place, const nb::tuple& told) {
             try {
               new (&place) Answer(made(told));
             } catch (const nb::cast_error&) {
               throw Error("a pickled answer: its state is of another class or version");
             }
           })
      .def("__reduce__", [](nb::handle_t<Answer> self) { return reduced_to_state(self); });
}

/// The same of one that compares by its state.
template <class Answer, class... Rest, class State, class Made>
void bind_answer_value(nb::class_<Answer, Rest...>& bound, const State& state, const Made& made) {
  bind_state(bound, state, made);
  bind_equality(bound, state);
}

/// What lives on and is no value: `instead` says what to pickle.
template <class Live, class... Rest>
void bind_refusal(nb::class_<Live, Rest...>& bound, const char* instead) {
  bound.def("__reduce__", [instead](nb::handle_t<Live> self) -> nb::object { refuse_pickling(self, instead); });
}

}  // namespace toccata::python
