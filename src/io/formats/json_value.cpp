#include "io/formats/json_value.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <set>
#include <utility>

#include "io/formats/file_error.hpp"
#include "io/formats/json_overflow.hpp"
#include "io/formats/json_watch.hpp"
#include "toccata/core/error.hpp"

namespace toccata::io {
namespace {

using nlohmann::json;

/// Told of every key of a text in turn; remembers those of the objects that are open. Building the document under such
/// a watch, with a callback of json::parse, takes time quadratic in the length of a list of objects.
class RepeatedKeyWatch final : public JsonWatch {
 public:
  bool start_object(std::size_t) override {
    open_.emplace_back();
    return true;
  }
  bool end_object() override {
    open_.pop_back();
    return true;
  }
  /// Stops at the first repetition.
  bool key(std::string& name) override {
    if (open_.back().insert(name).second) return true;
    found_ = name;
    return false;
  }

  [[nodiscard]] const std::optional<std::string>& found() const { return found_; }

 private:
  std::vector<std::set<std::string>> open_;
  std::optional<std::string> found_;
};

void refuse_repeated_keys(std::span<const char> text, std::string_view file) {
  RepeatedKeyWatch watch;
  json::sax_parse(text.data(), text.data() + text.size(), &watch);
  if (watch.found())
    fail_in_file(file,
                 {fmt::format("the key {} appears twice in one object", in_quotes(*watch.found())), "remove one"});
}

std::size_t line_of_byte(std::span<const char> text, std::size_t byte) {
  const auto end = text.begin() + static_cast<std::ptrdiff_t>(std::min(byte, text.size()));
  return 1 + static_cast<std::size_t>(std::count(text.begin(), end, '\n'));
}

/// The byte at which more arrays and objects are open than `most_levels`, if any. What walks a document calls itself
/// once a level, and the stack is finite. Any answer will do for what is no JSON.
std::optional<std::size_t> byte_of_deepest(std::span<const char> text, std::size_t most_levels) {
  std::size_t levels = 0;
  bool in_text = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (in_text && c == '\\') ++i;
    if (c == '"') in_text = !in_text;
    if (in_text) continue;
    if ((c == '[' || c == '{') && ++levels > most_levels) return i;
    if ((c == ']' || c == '}') && levels > 0) --levels;
  }
  return std::nullopt;
}

void refuse_deep_nesting(std::span<const char> text, std::string_view file) {
  constexpr std::size_t most_levels = 1000;
  if (const auto byte = byte_of_deepest(text, most_levels))
    fail_at_line(file, line_of_byte(text, *byte),
                 {fmt::format("arrays and objects are nested more than {} deep here", most_levels),
                  "write the document with fewer levels"});
}

[[noreturn]] void refuse_overflow(std::span<const char> text, std::string_view file) {
  const JsonOverflow found = overflow_of(text);
  const std::string who = found.name.empty() ? "" : " of " + in_quotes(found.name);
  fail_at_line(
      file, line_of_byte(text, found.byte),
      {fmt::format("at {}{}: the number {} is too large for a double", found.path, who, in_quotes(found.number)),
       "write numbers below 1.8e308"});
}

}  // namespace

std::string escaped_key(const std::string& key) {
  std::string result;
  for (const char c : key) result += c == '~' ? "~0" : c == '/' ? "~1" : std::string(1, c);
  return result;
}

json parse_json(std::span<const char> text, std::string_view file, RepeatedKeys repeated) {
  refuse_deep_nesting(text, file);
  json document;
  try {
    document = json::parse(text.data(), text.data() + text.size());
  } catch (const json::parse_error& error) {
    fail_at_line(file, line_of_byte(text, error.byte == 0 ? 0 : error.byte - 1),
                 {"this is not valid JSON", "look for a missing comma, quote or bracket just before"});
  } catch (const json::exception&) {
    refuse_overflow(text, file);
  }
  if (repeated == RepeatedKeys::refused) refuse_repeated_keys(text, file);
  return document;
}

void JsonValue::fail(const std::string& what, const std::string& advice) const {
  fail_in_file(fmt::format("{}: at {}", file_, path_.empty() ? "the top" : path_), {what, advice});
}

void JsonValue::require_object() const {
  if (!is_object()) fail("this is not an object", "write {…} here");
}

bool JsonValue::has(const char* key) const {
  require_object();
  return value_->contains(key);
}

void JsonValue::expect_keys(const std::vector<std::string>& known) const {
  require_object();
  for (const std::string& key : keys()) {
    if (std::find(known.begin(), known.end(), key) != known.end()) continue;
    const std::string hint = suggestion(key, known);
    fail(fmt::format("the key {} is not known", in_quotes(key)), hint.substr(2));
  }
}

std::vector<std::string> JsonValue::keys() const {
  std::vector<std::string> result;
  for (const auto& item : value_->items()) result.push_back(item.key());
  return result;
}

JsonValue JsonValue::at(const std::string& key) const {
  require_object();
  const auto found = value_->find(key);
  if (found == value_->end()) fail(fmt::format("the key {} is missing", in_quotes(key)), "add it");
  return {*found, file_, path_ + "/" + escaped_key(key)};
}

std::vector<JsonValue> JsonValue::elements() const {
  if (!is_array()) fail("this is not an array", "write […] here");
  std::vector<JsonValue> result;
  for (std::size_t i = 0; i < value_->size(); ++i)
    result.emplace_back((*value_)[i], file_, path_ + "/" + std::to_string(i));
  return result;
}

std::vector<JsonValue> JsonValue::elements(const char* key) const {
  return has(key) ? at(key).elements() : std::vector<JsonValue>{};
}

double JsonValue::number() const {
  if (!is_number()) fail("this is not a number", "write a number here");
  return value_->get<double>();
}

std::size_t JsonValue::whole(std::size_t greatest) const {
  const double value = number();
  // 2^53 and beyond, a double no longer tells whole numbers apart; nothing that is counted comes near.
  if (!(value >= 0 && value < 0x1p53) || std::floor(value) != value || static_cast<std::size_t>(value) > greatest)
    fail(fmt::format("{} is not a whole number from 0 to {}", value, greatest), "correct the number");
  return static_cast<std::size_t>(value);
}

std::string JsonValue::text() const {
  if (!is_string()) fail("this is not a text", "write \"…\" here");
  return value_->get<std::string>();
}

std::vector<double> JsonValue::numbers(std::size_t count) const {
  const std::vector<JsonValue> values = elements();
  if (values.size() != count)
    fail(fmt::format("here are {} numbers, not {}", values.size(), count), "correct the list");
  std::vector<double> result;
  for (const JsonValue& value : values) result.push_back(value.number());
  return result;
}

Vec3 JsonValue::vector() const {
  const std::vector<double> n = numbers(3);
  return {n[0], n[1], n[2]};
}

std::size_t JsonValue::whole_or(const char* key, std::size_t greatest, std::size_t otherwise) const {
  return has(key) ? at(key).whole(greatest) : otherwise;
}

bool JsonValue::flag_or(const char* key, bool otherwise) const {
  if (!has(key)) return otherwise;
  const JsonValue flag = at(key);
  if (!flag.value_->is_boolean()) flag.fail("this is neither true nor false", "write one of the two");
  return flag.value_->get<bool>();
}

std::string JsonValue::text_or(const char* key, const std::string& otherwise) const {
  return has(key) ? at(key).text() : otherwise;
}

}  // namespace toccata::io
