#include "table_names.hpp"

#include <algorithm>
#include <cstddef>
#include <map>
#include <set>
#include <string_view>

#include "words.hpp"

namespace toccata::command {
namespace {

constexpr std::size_t most_characters = 40;

/// Where each character of UTF-8 begins, and the end.
std::vector<std::size_t> character_places(const std::string& text) {
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < text.size(); ++i)
    if ((static_cast<unsigned char>(text[i]) & 0xC0U) != 0x80U) places.push_back(i);
  places.push_back(text.size());
  return places;
}

std::string without_middle(const std::string& text, std::size_t most) {
  const std::vector<std::size_t> places = character_places(text);
  const std::size_t count = places.size() - 1;
  if (count <= most) return text;
  const std::size_t kept = most - 1, end = (kept + 1) / 2;  // ends tell more: parts are numbered there
  return text.substr(0, places[kept - end]) + "…" + text.substr(places[count - end]);
}

}  // namespace

std::vector<std::string> table_names(std::span<const SceneObject> objects) {
  std::vector<std::string> names;
  for (const SceneObject& object : objects) names.push_back(printable(object.name));
  std::vector<std::string> shown(names.size());
  std::vector<std::size_t> most(names.size(), most_characters);
  for (bool all_differ = false; !all_differ;) {
    std::map<std::string_view, std::set<std::string_view>> names_shown_as;
    for (std::size_t i = 0; i < names.size(); ++i) shown[i] = without_middle(names[i], most[i]);
    for (std::size_t i = 0; i < names.size(); ++i) names_shown_as[shown[i]].insert(names[i]);
    all_differ = true;
    for (std::size_t i = 0; i < names.size(); ++i)
      if (names_shown_as[shown[i]].size() > 1) {
        most[i] *= 2;
        all_differ = false;
      }
  }
  return shown;
}

}  // namespace toccata::command
