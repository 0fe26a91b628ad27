#pragma once

#include <nanobind/nanobind.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <new>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include <toccata/core/error.hpp>

#include "arrays.hpp"

// Answers are described once, member by member: from that follow their class in Python, how they print, compare and
// pickle, and, of many, the structured array over their memory.
namespace toccata::python {

/// A member of an answer: what it is called, what it means, and the way to it, member by member.
template <class Answer, auto... path>
struct Field {
  using Value = std::remove_reference_t<decltype((std::declval<Answer&>().*....*path))>;

  const char* name;
  const char* doc;

  static Value& of(Answer& answer) { return (answer.*....*path); }
};

template <class Answer, auto... path>
constexpr Field<Answer, path...> field(const char* name, const char* doc) {
  return {name, doc};
}

/// The fields of an answer that another holds, or begins with: `way` leads to it.
template <class Whole, auto... way, class Answer, auto... path>
constexpr Field<Whole, way..., path...> field_within(const Field<Answer, path...>& inner) {
  return {inner.name, inner.doc};
}
template <class Whole, auto... way, class... Fields>
constexpr auto fields_within(const std::tuple<Fields...>& inner) {
  return std::apply([](const auto&... each) { return std::tuple{field_within<Whole, way...>(each)...}; }, inner);
}

/// Specialised for every answer: `name`, `doc` and `fields`, a tuple of Field.
template <class Answer>
struct Described;

template <class Answer, class Use>
void for_each_field(const Use& use) {
  std::apply([&](const auto&... fields) { (use(fields), ...); }, Described<Answer>::fields);
}

// How a value is told to Python, and told back when it was pickled.

template <class Value>
nb::object plain_value(const Value& value) {
  if constexpr (std::is_same_v<Value, Vec3> || std::is_same_v<Value, std::vector<double>>)
    return tuple_of(value);
  else if constexpr (std::is_enum_v<Value>)
    return nb::cast(static_cast<int>(value));
  else
    return nb::cast(value);
}

template <class Value>
Value from_plain(nb::handle told) {
  if constexpr (std::is_same_v<Value, Vec3>)
    return vector_of(told, "a pickled answer");
  else if constexpr (std::is_same_v<Value, std::vector<double>>)
    return numbers_of(told, "a pickled answer");
  else if constexpr (std::is_enum_v<Value>)
    return static_cast<Value>(nb::cast<int>(told));
  else
    return nb::cast<Value>(told);
}

/// As it is printed: tuples for vectors, and names for enumerations.
template <class Value>
nb::object plain_text(const Value& value) {
  if constexpr (std::is_same_v<Value, Vec3> || std::is_same_v<Value, std::vector<double>>)
    return tuple_of(value);
  else
    return nb::cast(value);
}

/// "Distance(lower=1.0, …)"
template <class Answer>
std::string text_of(Answer answer) {
  std::string text;
  for_each_field<Answer>([&](const auto& field) {
    text += fmt::format("{}{}={}", text.empty() ? "" : ", ", field.name,
                        nb::cast<std::string>(nb::repr(plain_text(field.of(answer)))));
  });
  return fmt::format("{}({})", Described<Answer>::name, text);
}

template <class Answer>
nb::tuple state_of(Answer answer) {
  nb::list state;
  for_each_field<Answer>([&](const auto& field) { state.append(plain_value(field.of(answer))); });
  return nb::tuple(state);
}

template <class Answer>
Answer from_state(const nb::tuple& state) {
  Answer answer{};
  if (state.size() != std::tuple_size_v<std::remove_cvref_t<decltype(Described<Answer>::fields)>>)
    throw Error(fmt::format("a pickled {} of another version", Described<Answer>::name));
  std::size_t i = 0;
  for_each_field<Answer>([&](const auto& field) {
    auto& value = field.of(answer);
    value = from_plain<std::remove_cvref_t<decltype(value)>>(state[i++]);
  });
  return answer;
}

/// The class of a single answer.
template <class Answer>
nb::class_<Answer> bind_answer(nb::module_& module) {
  nb::class_<Answer> bound(module, Described<Answer>::name, Described<Answer>::doc, nb::is_final());
  for_each_field<Answer>([&]<class Field>(const Field& field) {
    using Value = typename Field::Value;
    const auto of = &Field::of;
    if constexpr (std::is_same_v<Value, Vec3> || std::is_same_v<Value, std::vector<double>>)
      bound.def_prop_ro(
          field.name, [of](Answer& answer) { return array_of(of(answer)); }, field.doc);
    else
      bound.def_prop_ro(
          field.name, [of](Answer& answer) -> Value { return of(answer); }, field.doc);
  });
  bound.def("__repr__", [](const Answer& answer) { return text_of(answer); })
      .def(
          "__eq__",
          [](const Answer& answer, const nb::object& other) {
            return nb::isinstance<Answer>(other) && state_of(answer).equal(state_of(nb::cast<const Answer&>(other)));
          },
          nb::sig("def __eq__(self, other: object, /) -> bool"))
      .def("__getstate__", [](const Answer& answer) { return state_of(answer); })
      .def("__setstate__",
           [](Answer& answer, const nb::tuple& state) { new (&answer) Answer(from_state<Answer>(state)); });
  bound.attr("__hash__") = nb::none();
  return bound;
}

template <class Answer>
concept IsDescribed = requires {
  Described<Answer>::fields;
};

template <class Answer>
nb::object dtype_of();

/// What numpy calls the type of a member.
template <class Value>
nb::object format_of() {
  if constexpr (IsDescribed<Value>)
    return dtype_of<Value>();
  else if constexpr (std::is_same_v<Value, Vec3>)
    return nb::make_tuple("f8", nb::make_tuple(3));
  else if constexpr (std::is_same_v<Value, std::array<Vec3, 6>>)
    return nb::make_tuple("f8", nb::make_tuple(6, 3));
  else if constexpr (std::is_same_v<Value, bool>)
    return nb::str("?");
  else if constexpr (std::is_floating_point_v<Value>)
    return nb::str(fmt::format("f{}", sizeof(Value)).c_str());
  else if constexpr (std::is_enum_v<Value>)
    return nb::str(
        fmt::format("{}{}", std::is_signed_v<std::underlying_type_t<Value>> ? "i" : "u", sizeof(Value)).c_str());
  else
    return nb::str(fmt::format("{}{}", std::is_signed_v<Value> ? "i" : "u", sizeof(Value)).c_str());
}

/// The numpy.dtype over the memory of an answer.
template <class Answer>
nb::object made_dtype() {
  nb::list names, formats, offsets;
  Answer example{};
  for_each_field<Answer>([&](const auto& field) {
    auto& value = field.of(example);
    names.append(field.name);
    formats.append(format_of<std::remove_reference_t<decltype(value)>>());
    offsets.append(reinterpret_cast<const std::byte*>(&value) - reinterpret_cast<const std::byte*>(&example));
  });
  nb::dict told;
  told["names"] = names;
  told["formats"] = formats;
  told["offsets"] = offsets;
  told["itemsize"] = sizeof(Answer);
  return nb::module_::import_("numpy").attr("dtype")(told);
}

/// The same, made once and kept for ever. The interpreter's lock guards it; numpy may let another thread make it too.
template <class Answer>
nb::object dtype_of() {
  static PyObject* kept = nullptr;
  if (kept == nullptr) {
    nb::object made = made_dtype<Answer>();
    if (kept == nullptr) kept = made.release().ptr();
  }
  return nb::borrow(kept);
}

/// The answers themselves, not copied, as a structured array.
template <class Answer>
Answers structured(std::vector<Answer> answers) {
  static_assert(std::is_trivially_copyable_v<Answer>);
  const nb::capsule owner = capsule_of(std::move(answers));
  auto& kept = *static_cast<std::vector<Answer>*>(owner.data());
  const nb::object numpy = nb::module_::import_("numpy");
  if (kept.empty()) return nb::borrow<Answers>(numpy.attr("zeros")(0, dtype_of<Answer>()));
  const std::size_t bytes = kept.size() * sizeof(Answer);
  const nb::object memory =
      nb::cast(nb::ndarray<nb::numpy, std::uint8_t>(reinterpret_cast<std::uint8_t*>(kept.data()), {bytes}, owner),
               nb::rv_policy::reference);
  return nb::borrow<Answers>(memory.attr("view")(dtype_of<Answer>()));
}

}  // namespace toccata::python
