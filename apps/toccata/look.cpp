#include "look.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

#include "toccata/core/error.hpp"
#include "words.hpp"

namespace toccata::command {
namespace {

/// As apps/viewer/src/link.ts reads them.
const std::vector<std::string>& known_keys() {
  static const std::vector<std::string> keys = {"finding", "only",   "hidden", "ghosts", "rest",  "through",
                                                "grid",    "labels", "panels", "card",   "theme", "order",
                                                "off",     "steps",  "camera", "moment"};
  return keys;
}

/// The key of each word of the link; empty words have none.
std::vector<std::string> keys_of(std::string_view look) {
  if (look.starts_with('#')) look.remove_prefix(1);
  std::vector<std::string> keys;
  while (!look.empty()) {
    const std::string_view word = look.substr(0, look.find('&'));
    look.remove_prefix(std::min(look.size(), word.size() + 1));
    if (!word.empty()) keys.emplace_back(word.substr(0, word.find('=')));
  }
  return keys;
}

bool contains(const std::vector<std::string>& keys, std::string_view key) {
  return std::find(keys.begin(), keys.end(), key) != keys.end();
}

}  // namespace

void require_known_keys(std::string_view look) {
  std::vector<std::string> seen;
  for (const std::string& key : keys_of(look)) {
    if (!contains(known_keys(), key))
      throw Error(
          fmt::format("--look: '{}' is nothing that a link can say{}", printable(key), suggestion(key, known_keys())));
    if (contains(seen, key)) throw Error(fmt::format("--look: '{}' is said twice", key));
    seen.push_back(key);
  }
}

std::string link_of_picture(std::string_view look) {
  const std::vector<std::string> keys = keys_of(look);
  std::string link = look.starts_with('#') ? std::string(look) : "#" + std::string(look);
  if (!contains(keys, "panels")) link += "&panels=0";
  if (!contains(keys, "theme")) link += "&theme=light";
  return link;
}

}  // namespace toccata::command
