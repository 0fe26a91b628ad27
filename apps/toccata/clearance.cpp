#include "clearance.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <limits>
#include <optional>
#include <string_view>

#include "toccata/core/error.hpp"
#include "toccata/io/scene_file.hpp"
#include "words.hpp"

namespace toccata::command {
namespace {

/// An option and what was written behind it, for messages.
struct Typed {
  std::string_view option;
  std::string_view text;
  std::string_view form;      ///< how it is written
  std::string_view number{};  ///< the unit of a number alone, where that is not the scene's
  Longest longest = Longest::infinite;
};

constexpr std::string_view pair_form = "NAME,NAME=LENGTH";

[[noreturn]] void refuse(const Typed& typed) {
  throw Error(fmt::format("{} {}: write {}, where a length is 0 or more, in {} (0.5) or with its own (2mm, 0.1in){}",
                          typed.option, typed.text, typed.form,
                          typed.number.empty() ? "units of the scene" : typed.number,
                          typed.longest == Longest::infinite ? ", or all" : ""));
}

/// Of what is no word nothing is known but that the whole is wrong.
[[noreturn]] void refuse_unit(const Typed& typed, std::string_view unit) {
  const bool is_word = std::all_of(unit.begin(), unit.end(), [](unsigned char c) { return std::isalpha(c) != 0; });
  if (!is_word) refuse(typed);
  throw Error(
      fmt::format("{} {}: '{}' is no unit of length; write mm, cm, m, km, in or ft behind the number, or the "
                  "number alone",
                  typed.option, typed.text, unit));
}

/// What a length of 1 in the named unit is in the world's.
double world_units(const Typed& typed, std::string_view unit, std::string_view world) {
  if (world == "unit")
    throw Error(
        fmt::format("{} {} is given in {}, and the files do not say what their numbers mean: add --unit, or leave the "
                    "unit out",
                    typed.option, typed.text, unit));
  if (world.ends_with(" m")) world.remove_suffix(2);  // metres per unit, as a number
  return metres_per_unit(unit) / metres_per_unit(world);
}

double length_of(std::string_view text, const Typed& typed, const LengthUnits& units) {
  if (text == "all" && typed.longest == Longest::infinite) return std::numeric_limits<double>::infinity();
  double number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  const std::string_view unit(end, static_cast<std::size_t>(text.data() + text.size() - end));
  if (error != std::errc() || !std::isfinite(number) || number < 0) refuse(typed);
  if (unit.empty()) return units.number.empty() ? number : number * world_units(typed, units.number, units.world);
  if (unit != "mm" && unit != "cm" && unit != "m" && unit != "km" && unit != "in" && unit != "ft")
    refuse_unit(typed, unit);
  return number * world_units(typed, unit, units.world);
}

std::optional<Index> object_named(const Scene& scene, std::string_view name) {
  for (std::size_t i = 0; i < scene.objects.size(); ++i)
    if (scene.objects[i].name == name) return static_cast<Index>(i);
  return std::nullopt;
}

/// The names may have commas in them: the first that leaves two objects counts.
PairClearance pair_clearance(const std::string& text, const Scene& scene, const LengthUnits& units) {
  const Typed typed{"--clearance-of", text, pair_form, units.number};
  const std::size_t equals = text.rfind('=');
  if (equals == std::string::npos) refuse(typed);
  const std::string_view names = std::string_view(text).substr(0, equals);
  for (std::size_t comma = names.find(','); comma != std::string_view::npos; comma = names.find(',', comma + 1)) {
    const auto a = object_named(scene, names.substr(0, comma)), b = object_named(scene, names.substr(comma + 1));
    if (a && b && *a != *b) return {*a, *b, length_of(std::string_view(text).substr(equals + 1), typed, units)};
  }
  throw Error(fmt::format("{} {}: there are no two objects of these names; `{} inspect FILE` tells the names",
                          typed.option, text, called_as()));
}

bool asks_clearance(const CheckArguments& arguments) {
  return !arguments.clearance.empty() || !arguments.clearances_of.empty();
}

}  // namespace

LengthUnits length_units(const Scene& scene, const InputArguments& input) { return {scene.unit, input.unit}; }

double read_length(std::string_view option, std::string_view text, const LengthUnits& units, Longest longest) {
  return length_of(text, {option, text, "LENGTH", units.number, longest}, units);
}

ClearanceQuestion read_clearances(const CheckArguments& arguments, const Scene& scene) {
  const LengthUnits units = length_units(scene, arguments.input);
  ClearanceQuestion question;
  if (asks_clearance(arguments)) question.common = 0;
  if (!arguments.clearance.empty()) question.common = read_length("--clearance", arguments.clearance, units);
  for (const std::string& text : arguments.clearances_of)
    question.of_pairs.push_back(pair_clearance(text, scene, units));
  return question;
}

}  // namespace toccata::command
