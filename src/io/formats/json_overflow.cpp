#include "io/formats/json_overflow.hpp"

#include <algorithm>
#include <vector>

#include "io/formats/json_value.hpp"
#include "io/formats/json_watch.hpp"

namespace toccata::io {
namespace {

using nlohmann::json;

/// Remembers the way from the top to the value that is next.
class PlaceWatch final : public JsonWatch {
 public:
  bool start_object(std::size_t) override {
    open_.push_back({false, 0, {}, {}});
    return true;
  }
  bool start_array(std::size_t) override {
    open_.push_back({true, 0, {}, {}});
    return true;
  }
  bool end_object() override { return close(); }
  bool end_array() override { return close(); }
  bool key(std::string& name) override {
    open_.back().key = name;
    return true;
  }
  bool string(std::string& text) override {
    if (!open_.empty() && open_.back().key == "name") open_.back().name = text;
    return value();
  }
  bool parse_error(std::size_t byte, const std::string& token, const json::exception&) override {
    found_ = {token, path(), name(), byte};
    return false;
  }

  [[nodiscard]] const JsonOverflow& found() const { return found_; }

 private:
  struct Level {
    bool is_array = false;
    std::size_t index = 0;
    std::string key;
    std::string name;
  };

  bool value() override {
    if (!open_.empty() && open_.back().is_array) ++open_.back().index;
    return true;
  }
  bool close() {
    open_.pop_back();
    return value();
  }
  [[nodiscard]] std::string path() const {
    std::string result;
    for (const Level& level : open_)
      result += "/" + (level.is_array ? std::to_string(level.index) : escaped_key(level.key));
    return result;
  }
  [[nodiscard]] std::string name() const {
    const auto named =
        std::find_if(open_.rbegin(), open_.rend(), [](const Level& level) { return !level.name.empty(); });
    return named == open_.rend() ? "" : named->name;
  }

  std::vector<Level> open_;
  JsonOverflow found_;
};

}  // namespace

JsonOverflow overflow_of(std::span<const char> text) {
  PlaceWatch watch;
  json::sax_parse(text.data(), text.data() + text.size(), &watch);
  return watch.found();
}

}  // namespace toccata::io
