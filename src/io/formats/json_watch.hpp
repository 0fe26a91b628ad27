#pragma once

#include <cstdint>
#include <string>

#include "io/formats/json.hpp"

namespace toccata::io {

/// Is told of everything in a JSON text in turn, and cares for nothing: what cares overrides what it cares for. A
/// function that gives false ends the reading.
class JsonWatch : public nlohmann::json_sax<nlohmann::json> {
 public:
  bool null() override { return value(); }
  bool boolean(bool) override { return value(); }
  bool number_integer(std::int64_t) override { return value(); }
  bool number_unsigned(std::uint64_t) override { return value(); }
  bool number_float(double, const std::string&) override { return value(); }
  bool string(std::string&) override { return value(); }
  bool binary(nlohmann::json::binary_t&) override { return value(); }
  bool start_object(std::size_t) override { return true; }
  bool key(std::string&) override { return true; }
  bool end_object() override { return value(); }
  bool start_array(std::size_t) override { return true; }
  bool end_array() override { return value(); }
  bool parse_error(std::size_t, const std::string&, const nlohmann::json::exception&) override { return false; }

 protected:
  /// A value has ended.
  virtual bool value() { return true; }
};

}  // namespace toccata::io
