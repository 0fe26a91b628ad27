#include "clearance.hpp"

#include <fmt/format.h>

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

[[noreturn]] void refuse(std::string_view option, std::string_view text) {
  throw Error(fmt::format("{} {}: a length is 0 or more, in units of the scene (0.5) or with its own (2mm, 0.1in)",
                          option, text));
}

/// What a length of 1 in the named unit is in the world's.
double world_units(std::string_view option, std::string_view unit, const Scene& scene) {
  if (scene.unit == "unit")
    throw Error(
        fmt::format("{} is given in {}, and the files do not say what their numbers mean: add --unit, or leave the "
                    "unit out",
                    option, unit));
  std::string_view world = scene.unit;
  if (world.ends_with(" m")) world.remove_suffix(2);  // metres per unit, as a number
  return metres_per_unit(unit) / metres_per_unit(world);
}

double length_of(std::string_view option, std::string_view text, const Scene& scene) {
  if (text == "all") return std::numeric_limits<double>::infinity();
  double number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  const std::string_view unit(end, static_cast<std::size_t>(text.data() + text.size() - end));
  if (error != std::errc() || !std::isfinite(number) || number < 0) refuse(option, text);
  if (unit.empty()) return number;
  if (unit != "mm" && unit != "cm" && unit != "m" && unit != "km" && unit != "in" && unit != "ft") refuse(option, text);
  return number * world_units(option, unit, scene);
}

std::optional<Index> object_named(const Scene& scene, std::string_view name) {
  for (std::size_t i = 0; i < scene.objects.size(); ++i)
    if (scene.objects[i].name == name) return static_cast<Index>(i);
  return std::nullopt;
}

/// The names may have commas in them: the first that leaves two objects counts.
PairClearance pair_clearance(const std::string& text, const Scene& scene) {
  constexpr std::string_view option = "--clearance-of";
  const std::size_t equals = text.rfind('=');
  if (equals == std::string::npos) throw Error(fmt::format("{} {}: write NAME,NAME=LENGTH", option, text));
  const std::string_view names = std::string_view(text).substr(0, equals);
  for (std::size_t comma = names.find(','); comma != std::string_view::npos; comma = names.find(',', comma + 1)) {
    const auto a = object_named(scene, names.substr(0, comma)), b = object_named(scene, names.substr(comma + 1));
    if (a && b && *a != *b) return {*a, *b, length_of(option, std::string_view(text).substr(equals + 1), scene)};
  }
  throw Error(fmt::format("{} {}: there are no two objects of these names; `{} inspect FILE` tells the names", option,
                          text, called_as()));
}

}  // namespace

ClearanceQuestion read_clearances(const CheckArguments& arguments, const Scene& scene) {
  ClearanceQuestion question;
  question.asked = !arguments.clearance.empty() || !arguments.clearances_of.empty();
  if (!arguments.clearance.empty()) question.common = length_of("--clearance", arguments.clearance, scene);
  for (const std::string& text : arguments.clearances_of) question.of_pairs.push_back(pair_clearance(text, scene));
  return question;
}

}  // namespace toccata::command
