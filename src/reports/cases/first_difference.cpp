#include "reports/cases/first_difference.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "io/formats/json_value.hpp"

namespace toccata::io {
namespace {

using nlohmann::json;

/// The value as short as it still says something.
std::string shown(const json* value) {
  if (value == nullptr) return "nothing";
  constexpr std::size_t longest = 60;
  const std::string text = value->dump(-1, ' ', false, json::error_handler_t::replace);
  return text.size() <= longest ? text : text.substr(0, longest) + "…";
}

std::string told(const std::string& place, const json* recorded, const json* now) {
  return fmt::format("{}: recorded {}, now {}", place.empty() ? "the whole" : place, shown(recorded), shown(now));
}

const json* member(const json& object, const std::string& key) {
  const auto found = object.find(key);
  return found == object.end() ? nullptr : &*found;
}

/// What a clock told is another each time, and so is what follows from it, as a choice and its reason; memory depends
/// on what takes part in a process.
bool is_measured(std::string_view key) {
  return key.ends_with("_ns") || key.ends_with("_ms") || key == "bytes_per_body" || key == "reason" ||
         key == "used_method";
}

/// "rigid obb median 2".
std::string key_of_cost_row(const json& row) {
  std::string key;
  for (const char* name : {"workload", "volume", "builder", "arity"}) {
    const json value = row.is_object() ? row.value(name, json()) : json();
    key += (key.empty() ? "" : " ") + (value.is_string() ? value.get<std::string>() : value.dump());
  }
  return key;
}

/// The rows of a cost report are sorted by times, and its winners told by them: these go, and the rows are told apart
/// by what they are of.
json without_order_by_time(json report) {
  if (!report.is_object() || report.value("schema", json()) != "toccata/cost/1") return report;
  report.erase("winners");
  const auto found = report.find("rows");
  if (found == report.end() || !found->is_array()) return report;
  json rows = json::object();
  for (const json& row : *found) {
    std::string key = key_of_cost_row(row);
    while (rows.contains(key)) key += " again";  // no report of ours has two
    rows[key] = row;
  }
  *found = std::move(rows);
  return report;
}

std::string difference(const json& recorded, const json& now, const std::string& place, bool is_top);

std::string difference_of_objects(const json& recorded, const json& now, const std::string& place, bool is_top) {
  json keys = recorded;
  keys.update(now);
  for (const auto& item : keys.items()) {
    const std::string& key = item.key();
    if (is_top && (key == "version" || key == "warnings" || key == "asked")) continue;
    if (is_measured(key)) continue;
    const json *before = member(recorded, key), *after = member(now, key);
    const std::string here = fmt::format("{}/{}", place, key);
    if (before == nullptr || after == nullptr) return told(here, before, after);
    if (std::string found = difference(*before, *after, here, false); !found.empty()) return found;
  }
  return {};
}

/// Numbers are the same when they are written alike: every double has one shortest text, −0 another than 0.
std::string difference(const json& recorded, const json& now, const std::string& place, bool is_top) {
  if (recorded.is_object() && now.is_object()) return difference_of_objects(recorded, now, place, is_top);
  if (!recorded.is_array() || !now.is_array())
    return recorded.dump() == now.dump() ? std::string() : told(place, &recorded, &now);
  for (std::size_t i = 0; i < std::min(recorded.size(), now.size()); ++i)
    if (std::string found = difference(recorded[i], now[i], fmt::format("{}/{}", place, i), false); !found.empty())
      return found;
  if (recorded.size() == now.size()) return {};
  return fmt::format("{}: recorded {} entries, now {}", place, recorded.size(), now.size());
}

}  // namespace

std::string first_difference(std::string_view recorded, std::string_view now) {
  return difference(without_order_by_time(parse_json(recorded, "the recorded answer", RepeatedKeys::last_counts)),
                    without_order_by_time(parse_json(now, "the answer", RepeatedKeys::last_counts)), "", true);
}

}  // namespace toccata::io
