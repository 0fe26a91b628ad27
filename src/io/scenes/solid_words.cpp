#include "io/scenes/solid_words.hpp"

#include <map>

namespace toccata::io {

const char* word_of(Solid solid) { return solid == Solid::automatic ? "auto" : solid == Solid::all ? "all" : "none"; }

Solid solid_of(const JsonValue& value) {
  const std::map<std::string, Solid> known = {{"auto", Solid::automatic}, {"all", Solid::all}, {"none", Solid::none}};
  const auto found = known.find(value.text());
  if (found == known.end()) value.fail("this is not a way to take a mesh", "write \"auto\", \"all\" or \"none\"");
  return found->second;
}

}  // namespace toccata::io
