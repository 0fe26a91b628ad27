#include "check_rules.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <map>
#include <optional>
#include <span>
#include <string_view>
#include <system_error>

#include "option_kinds.hpp"
#include "toccata/core/error.hpp"
#include "toccata/reports/scene_question.hpp"
#include "words.hpp"

namespace toccata::command {
namespace {

constexpr std::string_view blanks = " \t\r";

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(blanks);
  if (first == std::string_view::npos) return {};
  std::size_t end = text.find_last_not_of(blanks) + 1;
  if (text[end - 1] == '\\' && end < text.size()) ++end;  // "\ " is a blank of the name
  return text.substr(first, end - first);
}

/// Where the sign is for the first time that no backslash is before it.
std::size_t find_plain(std::string_view text, char sign) {
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == sign) return i;
    if (text[i] == '\\') ++i;
  }
  return std::string_view::npos;
}

/// The words between commas.
std::vector<std::string> listed(std::string_view text) {
  std::vector<std::string> words;
  for (;;) {
    const std::size_t comma = find_plain(text, ',');
    words.emplace_back(trimmed(text.substr(0, comma)));
    if (comma == std::string_view::npos) return words;
    text.remove_prefix(comma + 1);
  }
}

/// The whole file, which may be empty.
std::string text_in(const std::string& file) {
  const auto refuse = [&](int error) {
    throw Error(fmt::format("{}: the rules cannot be read: {}", file, std::generic_category().message(error)));
  };
  if (std::filesystem::is_directory(file)) refuse(EISDIR);
  std::ifstream stream(file, std::ios::binary);
  if (!stream) refuse(errno);
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// Reads rules, and warns of what is about no object.
class RuleReader {
 public:
  RuleReader(std::span<const SceneInstance> models, const LengthUnits& units, std::vector<std::string>& warnings)
      : units_(units), warnings_(warnings) {
    for (const SceneInstance& model : models) {
      places_.emplace(model.name, names_.size());
      names_.push_back(model.name);
    }
  }

  void read_file(const std::string& file) {
    const std::string text = text_in(file);
    std::string_view rest = text;
    if (rest.starts_with("\xEF\xBB\xBF")) rest.remove_prefix(3);
    bool holds_any = false;
    for (std::size_t line = 1; !rest.empty(); ++line) {
      const std::string_view whole = rest.substr(0, rest.find('\n'));
      rest.remove_prefix(std::min(rest.size(), whole.size() + 1));
      const std::string_view content = trimmed(whole);
      if (content.empty() || content[0] == '#') continue;
      holds_any = true;
      read_line(content, fmt::format("{}:{}", file, line));
    }
    if (!holds_any) warnings_.push_back(file + " holds no rule");
  }

  /// `text` is what follows the word "ignore" or "between".
  void add_rule(std::vector<NameRule>& rules, std::string_view text, const std::string& place) {
    rules.push_back(rule_of(text, place));
  }

  NameRules& rules() { return rules_; }

 private:
  NameRule rule_of(std::string_view text, const std::string& place) {
    const std::vector<std::string> words = listed(text);
    const bool is_empty = std::find(words.begin(), words.end(), "") != words.end();
    if (words.size() > 2 || is_empty)
      throw Error(
          fmt::format("{}: a rule is about one pattern or set, or two with a comma between them, and here is '{}'; a "
                      "comma of a name is written \\,",
                      place, text));
    const std::string &first = words[0], second = words.size() == 2 ? words[1] : "*";
    NameRule rule{patterns_of(first), patterns_of(second)};
    const Members a = members_of(first, rule.a, place), b = first == second ? a : members_of(second, rule.b, place);
    if (a.one && a.is_single && b.is_single && a.one == b.one)
      warnings_.push_back(fmt::format("{}: '{}' is a single object, and no pair", place, names_[*a.one]));
    return rule;
  }

  /// `text` is what follows the word "tolerance" or "clearance": PATTERN, PATTERN = LENGTH.
  void add_length_rule(std::string_view word, std::string_view text, const std::string& place) {
    const std::size_t equals = find_plain(text, '=');
    if (equals == std::string_view::npos || equals == 0)
      throw Error(fmt::format("{0}: the {1} is of no pairs or has no length; write `{1} PATTERN, PATTERN = 0.1mm`",
                              place, word));
    const double length =
        read_length(fmt::format("{}: {}", place, word), trimmed(text.substr(equals + 1)), units_, Longest::finite);
    std::vector<LengthRule>& rules = word == "tolerance" ? rules_.tolerances : rules_.clearances;
    rules.push_back({rule_of(trimmed(text.substr(0, equals)), place), length});
  }

  static bool is_of_lengths(std::string_view word) { return word == "tolerance" || word == "clearance"; }
  static bool is_of_pairs(std::string_view word) { return word == "ignore" || word == "between"; }

  struct Set {
    std::vector<std::string> patterns;
    std::string place;
  };

  /// The objects that some patterns are about.
  struct Members {
    std::optional<std::size_t> one{};  ///< some one of them
    bool is_single = true;             ///< it is the only one

    void add(std::size_t object) {
      if (!one) one = object;
      is_single = is_single && object == *one;
    }
  };

  void read_line(std::string_view line, const std::string& place) {
    const std::string_view word = line.substr(0, line.find_first_of(" \t"));
    if (is_of_lengths(word) || is_of_pairs(word)) {
      const std::string_view rest = trimmed(line.substr(word.size()));
      if (rest.starts_with('=')) refuse(place, fmt::format("no set is called '{}'", word));
      if (is_of_lengths(word)) return add_length_rule(word, rest, place);
      if (rest.empty()) refuse(place, "the rule says nothing");
      return add_rule(word == "ignore" ? rules_.ignored : rules_.between, rest, place);
    }
    const std::size_t equals = find_plain(line, '=');
    if (equals == std::string_view::npos) refuse(place, fmt::format("'{}' is no rule", line));
    define(std::string(trimmed(line.substr(0, equals))), line.substr(equals + 1), place);
  }

  [[noreturn]] static void refuse(const std::string& place, const std::string& what) {
    throw Error(fmt::format(
        "{}: {}; write `ignore PATTERN`, `ignore PATTERN, PATTERN`, `between PATTERN, PATTERN`, "
        "`tolerance PATTERN, PATTERN = LENGTH`, `clearance PATTERN, PATTERN = LENGTH`, or `SET = PATTERN, …`",
        place, what));
  }

  void define(const std::string& name, std::string_view list, const std::string& place) {
    if (is_of_pairs(name) || is_of_lengths(name)) refuse(place, fmt::format("no set is called '{}'", name));
    if (name.empty() || name.find_first_of("*?,\\") != std::string::npos)
      throw Error(fmt::format(
          "{}: '{}' is no name of a set; write one without * ? , and \\, and = in a pattern as \\=", place, name));
    Set set{{}, place};
    for (const std::string& word : listed(list)) {
      if (word.empty())
        throw Error(
            fmt::format("{}: a pattern of the set '{}' is empty; write one, or leave out a comma", place, name));
      const std::vector<std::string> patterns = patterns_of(word);
      members_of(word, patterns, place);
      set.patterns.insert(set.patterns.end(), patterns.begin(), patterns.end());
    }
    const auto [other, is_new] = sets_.emplace(name, std::move(set));
    if (!is_new)
      throw Error(fmt::format("{}: there is a set '{}' already, from {}; give this another name", place, name,
                              other->second.place));
    if (places_.contains(name))
      warnings_.push_back(
          fmt::format("{}: an object is called '{}' too; in rules that name is the set from here on", place, name));
  }

  /// The patterns of a set that was defined before, else the word itself.
  [[nodiscard]] std::vector<std::string> patterns_of(const std::string& word) const {
    const auto set = sets_.find(word);
    return set == sets_.end() ? std::vector<std::string>{word} : set->second.patterns;
  }

  Members members_of(const std::string& word, std::span<const std::string> patterns, const std::string& place) {
    Members members;
    for (const std::string& pattern : patterns) add_members(pattern, members);
    if (!members.one && place.starts_with("--")) refuse_file(word, place);
    if (!members.one)
      warnings_.push_back(sets_.contains(word) ? fmt::format("{}: the set '{}' has no object in it", place, word)
                                               : fmt::format("{}: no object is called '{}', and no set above{}", place,
                                                             word, suggestion(word, names_)));
    return members;
  }

  /// Whoever hands a file to an option of one rule would have all of its rules passed over.
  static void refuse_file(const std::string& word, const std::string& place) {
    std::error_code unknown;
    if (std::filesystem::is_regular_file(word, unknown))
      throw Error(
          fmt::format("{}: {} is a file, and no object is called so: give a file of rules and sets as --rules {}, and "
                      "objects by their names",
                      place, word, word));
  }

  /// A name that means itself is looked up: there may be very many.
  void add_members(const std::string& pattern, Members& members) const {
    if (pattern.find_first_of("*?\\") == std::string::npos) {
      if (const auto found = places_.find(pattern); found != places_.end()) members.add(found->second);
      return;
    }
    for (std::size_t i = 0; i < names_.size() && members.is_single; ++i)
      if (matches_pattern(pattern, names_[i])) members.add(i);
  }

  const LengthUnits& units_;
  std::vector<std::string>& warnings_;
  std::vector<std::string> names_;
  std::map<std::string, std::size_t, std::less<>> places_;  ///< of the names
  std::map<std::string, Set> sets_;
  NameRules rules_;
};

void require_pairs(const NameRules& rules, std::span<const SceneInstance> models,
                   std::span<const std::string> warnings) {
  if (rules.empty() || leave_a_pair(rules, models)) return;
  throw Error(fmt::format("nothing would be checked: {}{}; `{} inspect FILE` tells the names of the objects",
                          warnings.empty() ? "" : fmt::format("{}; ", fmt::join(warnings, "; ")),
                          rules.ignored.empty() ? "no two objects are a pair of a rule `between`"
                                                : "the rules leave no pair of two objects",
                          called_as()));
}

}  // namespace

bool has_rules(const RuleArguments& arguments) {
  return !arguments.files.empty() || !arguments.ignored.empty() || !arguments.between.empty();
}

void add_rules(CLI::App& app, RuleArguments& arguments) {
  const auto repeated = [&](const char* name, std::vector<std::string>& texts, const char* help, const char* type) {
    app.add_option(name, texts, help)->type_name(type)->expected(1)->allow_extra_args(false)->take_all();
  };
  repeated("--rules", arguments.files,
           "which pairs are checked, and with which tolerances and clearances: a file of rules and sets "
           "(docs/reference/check-rules.md); may be repeated",
           "FILE");
  repeated(
      "--ignore", arguments.ignored,
      "a rule: no pairs of these, or none of this one; * and ? in names stand for any text and any character; may be "
      "repeated",
      "PATTERN[,PATTERN]");
  repeated("--between", arguments.between,
           "a rule: only pairs of these, or only those of this one; also of sets of --rules; may be repeated",
           "PATTERN[,PATTERN]");
}

NameRules read_rules(const RuleArguments& arguments, std::span<const SceneInstance> models, const LengthUnits& units,
                     std::vector<std::string>& warnings) {
  const std::size_t known = warnings.size();
  RuleReader reader(models, units, warnings);
  for (const std::string& file : arguments.files) reader.read_file(file);
  for (const std::string& text : arguments.ignored)
    reader.add_rule(reader.rules().ignored, trimmed(text), "--ignore " + text);
  for (const std::string& text : arguments.between)
    reader.add_rule(reader.rules().between, trimmed(text), "--between " + text);
  require_pairs(reader.rules(), models, std::span<const std::string>(warnings).subspan(known));
  return reader.rules();
}

}  // namespace toccata::command
