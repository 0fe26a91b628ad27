#include "values.hpp"

#include <string>

#include <fmt/format.h>

namespace toccata::python {
namespace {

/// Of the package's part that is written in Python.
nb::object helper(const char* name) { return nb::module_::import_("toccata._values").attr(name); }

/// It is of a class that a user derived, which may have attributes or slots.
bool has_more(nb::handle self) { return nb::hasattr(self, "__dict__") || nb::hasattr(self.type(), "__slots__"); }

}  // namespace

bool equal(const Making& a, const Making& b) {
  return a.named.equal(b.named) && nb::cast<bool>(helper("equal")(a.arguments, b.arguments));
}

nb::object reduced(nb::handle self, nb::handle kind, const Making& making) {
  return helper("reduced")(self, kind, making.arguments, making.named);
}

nb::object reduced_to_state(nb::handle self) {
  const nb::object made = nb::module_::import_("copyreg").attr("__newobj__");
  return nb::make_tuple(made, nb::make_tuple(self.type()), self.attr("__getstate__")());
}

void require_made(nb::handle self) {
  if (nb::inst_ready(self)) return;
  const auto name = nb::cast<std::string>(self.type().attr("__name__"));
  throw nb::type_error(fmt::format("this {} was never made: its class's __init__ was not called", name).c_str());
}

nb::object copied(nb::handle self, nb::handle memo, void (*copy)(void* place, nb::handle of)) {
  require_made(self);
  nb::object made = nb::inst_alloc(self.type());
  copy(nb::inst_ptr<void>(made), self);  // what is not ready is freed without its destructor
  nb::inst_mark_ready(made);
  if (has_more(self)) helper("give_added")(made, self, memo.is_valid() ? nb::borrow(memo) : nb::none());
  return made;
}

void refuse_pickling(nb::handle self, const char* instead) {
  const auto name = nb::cast<std::string>(self.type().attr("__name__"));
  const char* copied_too = nb::hasattr(self.type(), "__copy__") ? "" : " or copied";
  throw nb::type_error(fmt::format("a {} cannot be pickled{}: {}", name, copied_too, instead).c_str());
}

}  // namespace toccata::python
