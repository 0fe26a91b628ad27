#include <fast_float/fast_float.h>
#include <fmt/format.h>

#include <algorithm>

#include "toccata/core/error.hpp"
#include "toccata/generate/meshes.hpp"

namespace toccata {
namespace {

constexpr std::string_view prefix = "gen:";

double parse_value(std::string_view whole, std::string_view text) {
  double value = 0;
  const auto [end, problem] = fast_float::from_chars(text.data(), text.data() + text.size(), value);
  if (problem != std::errc() || end != text.data() + text.size())
    throw Error(fmt::format("{}: '{}' is not a number", whole, text));
  return value;
}

}  // namespace

bool is_generator_specification(std::string_view text) { return text.starts_with(prefix); }

GeneratorSpecification parse_generator(std::string_view text) {
  if (!is_generator_specification(text))
    throw Error(fmt::format("'{}' does not start with 'gen:'; write gen:<name>?<parameter>=<number>&…", text));
  const std::size_t question = std::min(text.find('?'), text.size());
  GeneratorSpecification result{std::string(text.substr(prefix.size(), question - prefix.size())), {}};
  for (std::size_t begin = question + 1; begin < text.size();) {
    const std::size_t end = std::min(text.find('&', begin), text.size());
    const std::string_view assignment = text.substr(begin, end - begin);
    const std::size_t equals = assignment.find('=');
    if (equals == std::string_view::npos)
      throw Error(fmt::format("{}: '{}' is not of the form <parameter>=<number>", text, assignment));
    const std::string name(assignment.substr(0, equals));
    if (!result.parameters.emplace(name, parse_value(text, assignment.substr(equals + 1))).second)
      throw Error(fmt::format("{}: the parameter '{}' is given twice", text, name));
    begin = end + 1;
  }
  return result;
}

}  // namespace toccata
