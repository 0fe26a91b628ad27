#include "answers.hpp"

#include <fmt/format.h>

#include <toccata/core/error.hpp>

namespace toccata::python {

nb::object format_of_number(char kind, std::size_t size) { return nb::str(fmt::format("{}{}", kind, size).c_str()); }

std::string text_of(const char* name, std::span<const Member> members, const std::byte* answer) {
  std::string text;
  for (const Member& member : members)
    text += fmt::format("{}{}={}", text.empty() ? "" : ", ", member.name,
                        nb::cast<std::string>(nb::repr(member.text(answer + member.offset))));
  return fmt::format("{}({})", name, text);
}

nb::tuple state_of(std::span<const Member> members, const std::byte* answer) {
  nb::list state;
  for (const Member& member : members) state.append(member.plain(answer + member.offset));
  return nb::tuple(state);
}

void set_state(const char* name, std::span<const Member> members, std::byte* answer, const nb::tuple& state) {
  if (state.size() != members.size()) throw Error(fmt::format("a pickled {} of another version", name));
  for (std::size_t i = 0; i < members.size(); ++i) members[i].set(answer + members[i].offset, state[i]);
}

nb::object dtype_of(std::span<const Member> members, std::size_t size) {
  nb::list names, formats, offsets;
  for (const Member& member : members) {
    names.append(member.name);
    formats.append(member.format());
    offsets.append(member.offset);
  }
  nb::dict told;
  told["names"] = names;
  told["formats"] = formats;
  told["offsets"] = offsets;
  told["itemsize"] = size;
  return nb::module_::import_("numpy").attr("dtype")(told);
}

nb::object bytes_of_rows(nb::handle rows, const nb::object& dtype, const char* what) {
  if (!nb::ndarray_check(rows) || !rows.attr("dtype").equal(dtype) || nb::cast<int>(rows.attr("ndim")) != 1)
    throw Error(fmt::format("{}: these are no rows of the array that it is told by", what));
  return nb::module_::import_("numpy").attr("ascontiguousarray")(rows).attr("view")("u1");
}

Answers structured(const nb::capsule& owner, std::byte* data, std::size_t bytes, const nb::object& dtype) {
  if (bytes == 0) return nb::borrow<Answers>(nb::module_::import_("numpy").attr("zeros")(0, dtype));
  const nb::object memory =
      nb::cast(nb::ndarray<nb::numpy, std::uint8_t>(reinterpret_cast<std::uint8_t*>(data), {bytes}, owner),
               nb::rv_policy::reference);
  return nb::borrow<Answers>(memory.attr("view")(dtype));
}

}  // namespace toccata::python
