#pragma once

#include <nanobind/nanobind.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <new>
#include <optional>
#include <span>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include "arrays.hpp"
#include "values.hpp"

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

template <class Answer>
concept IsDescribed = requires {
  Described<Answer>::fields;
};

template <class Answer>
nb::object dtype_of();

/// "f8"
[[nodiscard]] nb::object format_of_number(char kind, std::size_t size);

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
    return format_of_number('f', sizeof(Value));
  else if constexpr (std::is_enum_v<Value>)
    return format_of_number(std::is_signed_v<std::underlying_type_t<Value>> ? 'i' : 'u', sizeof(Value));
  else if constexpr (std::is_integral_v<Value>)
    return format_of_number(std::is_signed_v<Value> ? 'i' : 'u', sizeof(Value));
  else
    return nb::none();  // of any length: in no array
}

/// A field of whatever answer, so that what is done with all fields is compiled once: where it lies in the answer, and
/// what is done with a value of its type there.
struct Member {
  const char* name;
  std::size_t offset;
  nb::object (*format)();
  nb::object (*plain)(const std::byte* value) = nullptr;
  nb::object (*text)(const std::byte* value) = nullptr;
  void (*set)(std::byte* value, nb::handle told) = nullptr;
};

/// What a single answer needs, and a row of an array does not.
template <class Value>
void tell_alone(Member& member) {
  member.plain = [](const std::byte* value) { return plain_value(*reinterpret_cast<const Value*>(value)); };
  member.text = [](const std::byte* value) { return plain_text(*reinterpret_cast<const Value*>(value)); };
  member.set = [](std::byte* value, nb::handle told) { *reinterpret_cast<Value*>(value) = from_plain<Value>(told); };
}

template <class Answer, class Value>
Member member_at(const char* name, const Answer& answer, const Value& value) {
  const auto address = [](const auto& thing) { return reinterpret_cast<const std::byte*>(&thing); };
  return {name, static_cast<std::size_t>(address(value) - address(answer)), &format_of<Value>};
}

template <class Answer>
std::vector<Member> members_of() {
  Answer example{};
  return std::apply(
      [&](const auto&... field) { return std::vector{member_at(field.name, example, field.of(example))...}; },
      Described<Answer>::fields);
}

/// "Distance(lower=1.0, …)"
[[nodiscard]] std::string text_of(const char* name, std::span<const Member> members, const std::byte* answer);
[[nodiscard]] nb::tuple state_of(std::span<const Member> members, const std::byte* answer);
/// Throws Error where the state has another number of members.
void set_state(const char* name, std::span<const Member> members, std::byte* answer, const nb::tuple& state);
/// The numpy.dtype over the memory of an answer.
[[nodiscard]] nb::object dtype_of(std::span<const Member> members, std::size_t size);

/// All members of one type are read by one function, which is told where they lie.
template <class Value, class Answer>
void bind_reading(nb::class_<Answer>& bound, const char* name, std::size_t offset, const char* doc) {
  const auto of = [offset](Answer& answer) -> Value& {
    return *reinterpret_cast<Value*>(reinterpret_cast<std::byte*>(&answer) + offset);
  };
  if constexpr (std::is_same_v<Value, Vec3> || std::is_same_v<Value, std::vector<double>>)
    bound.def_prop_ro(
        name, [of](Answer& answer) { return array_of(of(answer)); }, doc);
  else
    bound.def_prop_ro(
        name, [of](Answer& answer) -> Value { return of(answer); }, doc);
}

template <class Answer, class Field>
void bind_member(nb::class_<Answer>& bound, const Field& field, Member& member) {
  using Value = typename Field::Value;
  tell_alone<Value>(member);
  bind_reading<Value>(bound, field.name, member.offset, field.doc);
}

/// The class of a single answer.
template <class Answer>
nb::class_<Answer> bind_answer(nb::module_& module) {
  static std::vector<Member> members = members_of<Answer>();
  nb::class_<Answer> bound(module, Described<Answer>::name, Described<Answer>::doc, nb::is_final());
  std::size_t i = 0;
  std::apply([&](const auto&... field) { (bind_member(bound, field, members[i++]), ...); }, Described<Answer>::fields);
  const auto bytes = [](const Answer& answer) { return reinterpret_cast<const std::byte*>(&answer); };
  bound
      .def("__repr__",
           [bytes](const Answer& answer) { return text_of(Described<Answer>::name, members, bytes(answer)); })
      .def(
          "__eq__",
          [bytes](const Answer& answer, const nb::object& other) {
            return nb::isinstance<Answer>(other) &&
                   state_of(members, bytes(answer)).equal(state_of(members, bytes(nb::cast<const Answer&>(other))));
          },
          nb::arg("other").none(), nb::sig("def __eq__(self, other: object, /) -> bool"));
  bind_state(
      bound, [bytes](const Answer& answer) { return state_of(members, bytes(answer)); },
      [](const nb::tuple& state) {
        Answer told{};
        set_state(Described<Answer>::name, members, reinterpret_cast<std::byte*>(&told), state);
        return told;
      });
  bound.attr("__hash__") = nb::none();
  return bound;
}

/// The numpy.dtype over the memory of an answer, made once and kept for ever. The interpreter's lock guards it; numpy
/// may let another thread make it too.
template <class Answer>
nb::object dtype_of() {
  static PyObject* kept = nullptr;
  if (kept == nullptr) {
    nb::object made = dtype_of(members_of<Answer>(), sizeof(Answer));
    if (kept == nullptr) kept = made.release().ptr();
  }
  return nb::borrow(kept);
}

/// The memory of an array's rows. Throws Error, beginning with `what`, where they are of another type.
[[nodiscard]] nb::object bytes_of_rows(nb::handle rows, const nb::object& dtype, const char* what);

/// Answers told back by a structured array, as `structured` tells them.
template <class Answer>
std::vector<Answer> answers_of(nb::handle rows, const char* what) {
  static_assert(std::is_trivially_copyable_v<Answer>);
  const nb::object memory = bytes_of_rows(rows, dtype_of<Answer>(), what);
  const auto bytes = nb::cast<nb::ndarray<const std::uint8_t, nb::ro, nb::c_contig, nb::device::cpu>>(memory);
  std::vector<Answer> answers(bytes.size() / sizeof(Answer));
  if (!answers.empty()) std::memcpy(static_cast<void*>(answers.data()), bytes.data(), bytes.size());
  return answers;
}

/// Memory that holds answers, as a structured array.
[[nodiscard]] Answers structured(const nb::capsule& owner, std::byte* data, std::size_t bytes, const nb::object& dtype);

/// The answers themselves, not copied, as a structured array.
template <class Answer>
Answers structured(std::vector<Answer> answers) {
  static_assert(std::is_trivially_copyable_v<Answer>);
  const nb::capsule owner = capsule_of(std::move(answers));
  auto& kept = *static_cast<std::vector<Answer>*>(owner.data());
  return structured(owner, reinterpret_cast<std::byte*>(kept.data()), kept.size() * sizeof(Answer), dtype_of<Answer>());
}

/// An answer that there may be: a row of an array has nothing to say where there is none.
template <class Answer>
struct MaybeFound {
  bool found = false;
  Answer answer{};
};

template <class Answer>
struct Described<MaybeFound<Answer>> {
  using Row = MaybeFound<Answer>;
  static constexpr const char* name = Described<Answer>::name;
  static constexpr const char* doc = Described<Answer>::doc;
  static constexpr auto fields =
      std::tuple_cat(std::tuple{field<Row, &Row::found>("found", "There is one; else the others say nothing.")},
                     fields_within<Row, &Row::answer>(Described<Answer>::fields));
};

/// Rows with `found` before the members of an answer.
template <class Answer>
Answers structured(const std::vector<std::optional<Answer>>& answers) {
  std::vector<MaybeFound<Answer>> rows(answers.size());
  for (std::size_t i = 0; i < rows.size(); ++i)
    if (answers[i]) rows[i] = {true, *answers[i]};
  return structured(std::move(rows));
}

}  // namespace toccata::python
