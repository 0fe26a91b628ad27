#pragma once

#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "io/formats/json.hpp"
#include "toccata/math/vec3.hpp"

namespace toccata::io {

enum class RepeatedKeys { refused, last_counts };

/// A parsed JSON text. Throws Error naming the file and line when it is not JSON, arrays and objects are nested more
/// than 1,000 deep, a number is too large for a double, or an object has a key twice and that is refused.
[[nodiscard]] nlohmann::json parse_json(std::span<const char> text, std::string_view file, RepeatedKeys repeated);

/// A key in a path by RFC 6901.
[[nodiscard]] std::string escaped_key(const std::string& key);

/// A value within a JSON file that knows where it stands, so that what is wrong with it can be said: "<file>: at
/// /objects/3/pose: <what>; <advice>". A view: the document and the name of the file must outlive it.
class JsonValue {
 public:
  JsonValue(const nlohmann::json& value, std::string_view file, std::string path = "")
      : value_(&value), file_(file), path_(std::move(path)) {}

  [[noreturn]] void fail(const std::string& what, const std::string& advice) const;

  /// Throws Error unless every key of this object is one of `known`.
  void expect_keys(const std::vector<std::string>& known) const;

  [[nodiscard]] bool is_object() const { return value_->is_object(); }
  [[nodiscard]] bool is_array() const { return value_->is_array(); }
  [[nodiscard]] bool is_number() const { return value_->is_number(); }
  [[nodiscard]] bool is_string() const { return value_->is_string(); }
  /// Error where this is no object: what is of another type than it has to be is not taken for left out.
  [[nodiscard]] bool has(const char* key) const;
  [[nodiscard]] std::vector<std::string> keys() const;

  /// The member `key` of this object; Error when there is none.
  [[nodiscard]] JsonValue at(const std::string& key) const;
  /// The elements of this array; of the array `key`, or none when there is no such member.
  [[nodiscard]] std::vector<JsonValue> elements() const;
  [[nodiscard]] std::vector<JsonValue> elements(const char* key) const;

  [[nodiscard]] double number() const;                          ///< finite
  [[nodiscard]] std::size_t whole(std::size_t greatest) const;  ///< a whole number from 0 to `greatest`
  [[nodiscard]] std::string text() const;
  [[nodiscard]] std::vector<double> numbers(std::size_t count) const;  ///< exactly so many
  [[nodiscard]] Vec3 vector() const;

  [[nodiscard]] std::size_t whole_or(const char* key, std::size_t greatest, std::size_t otherwise) const;
  [[nodiscard]] bool flag_or(const char* key, bool otherwise) const;
  [[nodiscard]] std::string text_or(const char* key, const std::string& otherwise) const;

 private:
  void require_object() const;

  const nlohmann::json* value_;
  std::string_view file_;
  std::string path_;
};

}  // namespace toccata::io
