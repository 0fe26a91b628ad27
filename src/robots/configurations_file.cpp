#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string_view>

#include "io/formats/file_bytes.hpp"
#include "io/formats/file_error.hpp"
#include "io/formats/number.hpp"
#include "toccata/core/error.hpp"
#include "toccata/robots/robot_files.hpp"

namespace toccata {
namespace {

/// Reads one file.
class ConfigurationsFile {
 public:
  ConfigurationsFile(const std::string& path, const Robot& robot) : path_(path), robot_(robot) {
    for (Index i = 0; i < robot.positions().size(); ++i) columns_.push_back(i);
  }

  std::vector<double> read() {
    const io::FileBytes bytes = io::read_file(path_);
    const std::string_view text(bytes.data.get(), bytes.size);
    constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
    std::size_t line = 1, begin = text.starts_with(byte_order_mark) ? byte_order_mark.size() : 0;
    bool is_first = true;
    while (begin < text.size()) {
      const std::size_t end = std::min(text.find('\n', begin), text.size());
      const std::vector<std::string_view> words = words_of(text.substr(begin, end - begin));
      if (!words.empty()) {
        if (is_first && !starts_a_number(words[0]))
          take_names(words, line);
        else
          take_numbers(words, line);
        is_first = false;
      }
      begin = end + 1;
      ++line;
    }
    if (numbers_.empty())
      io::fail_in_file(path_, {"the file holds no configuration",
                               fmt::format("write a line of {} numbers for each", robot_.positions().size())});
    return std::move(numbers_);
  }

 private:
  static std::vector<std::string_view> words_of(std::string_view line) {
    line = line.substr(0, line.find('#'));
    if (line.find(',') != std::string_view::npos) return fields_of(line);
    constexpr std::string_view blanks = " ;\t\r\"";
    std::vector<std::string_view> words;
    for (std::size_t at = line.find_first_not_of(blanks); at != std::string_view::npos;) {
      const std::size_t end = std::min(line.find_first_of(blanks, at), line.size());
      words.push_back(line.substr(at, end - at));
      at = line.find_first_not_of(blanks, end);
    }
    return words;
  }

  /// Between commas, where names may have blanks; what is left out is an empty word.
  static std::vector<std::string_view> fields_of(std::string_view line) {
    constexpr std::string_view around = " \t\r\"";
    std::vector<std::string_view> fields;
    for (std::size_t begin = 0; begin <= line.size();) {
      const std::size_t end = std::min(line.find(',', begin), line.size());
      std::string_view field = line.substr(begin, end - begin);
      field.remove_prefix(std::min(field.find_first_not_of(around), field.size()));
      fields.push_back(field.substr(0, field.find_last_not_of(around) + 1));
      begin = end + 1;
    }
    return fields;
  }

  static bool starts_a_number(std::string_view word) { return word.find_first_of("+-.0123456789") == 0; }

  void take_names(const std::vector<std::string_view>& names, std::size_t line) {
    std::vector<std::string> known;
    for (const RobotPosition& position : robot_.positions()) known.push_back(position.name);
    columns_.clear();
    for (const std::string_view name : names) {
      const auto found = std::find(known.begin(), known.end(), name);
      if (found == known.end())
        io::fail_at_line(path_, line,
                         {fmt::format("the robot has no position {}{}", io::in_quotes(name), suggestion(name, known)),
                          "name its positions, or leave the line of names out"});
      const auto column = static_cast<Index>(found - known.begin());
      if (std::find(columns_.begin(), columns_.end(), column) != columns_.end())
        io::fail_at_line(path_, line,
                         {fmt::format("the position {} is named twice", io::in_quotes(name)), "name each once"});
      columns_.push_back(column);
    }
    for (Index i = 0; i < known.size(); ++i)
      if (std::find(columns_.begin(), columns_.end(), i) == columns_.end())
        io::fail_at_line(path_, line, {fmt::format("the position '{}' is not named", known[i]), "name them all"});
  }

  void take_numbers(const std::vector<std::string_view>& words, std::size_t line) {
    if (words.size() != columns_.size())
      io::fail_at_line(path_, line,
                       {fmt::format("a line of {} numbers has {}", columns_.size(), words.size()),
                        "give one for each position of the robot"});
    const std::size_t first = numbers_.size();
    numbers_.resize(first + words.size());
    for (std::size_t i = 0; i < words.size(); ++i) numbers_[first + columns_[i]] = number_of(words[i], line);
    const auto configuration = std::span(numbers_).subspan(first);
    if (const std::optional<Index> beyond = robot_.beyond_limits(configuration)) {
      const RobotPosition& position = robot_.positions()[*beyond];
      io::fail_at_line(path_, line,
                       {fmt::format("the position of '{}' is {}, beyond its limits {} to {}", position.name,
                                    configuration[*beyond], position.limits->lower, position.limits->upper),
                        "positions are in radians and metres"});
    }
  }

  [[nodiscard]] double number_of(std::string_view word, std::size_t line) const {
    const char* const end = word.data() + word.size();
    const io::ParsedNumber number = io::parse_number(word.data(), end);
    if (number.fault != io::NumberFault::none || number.end != end)
      io::fail_at_line(path_, line,
                       {fmt::format("{} is no number that a position can have", io::in_quotes(word)),
                        "write a finite decimal number"});
    return number.value;
  }

  const std::string& path_;
  const Robot& robot_;
  std::vector<Index> columns_;  ///< which position each is
  std::vector<double> numbers_;
};

}  // namespace

std::vector<double> read_configurations(const std::string& path, const Robot& robot) {
  return ConfigurationsFile(path, robot).read();
}

}  // namespace toccata
