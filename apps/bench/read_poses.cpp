#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <sstream>

#include "poses.hpp"
#include "toccata/core/error.hpp"

namespace toccata::bench {
namespace {

std::vector<double> numbers_of(std::string line, const std::string& where) {
  std::replace(line.begin(), line.end(), ',', ' ');
  std::istringstream words(line);
  std::vector<double> numbers;
  for (std::string word; words >> word;) {
    char* end = nullptr;
    numbers.push_back(std::strtod(word.c_str(), &end));
    if (*end != '\0' || !std::isfinite(numbers.back()))
      throw Error(fmt::format("{}: '{}' is not a finite number", where, word));
  }
  return numbers;
}

Pose pose_of(const std::vector<double>& numbers, std::size_t first) {
  std::array<double, 12> twelve{};
  std::copy_n(numbers.begin() + static_cast<std::ptrdiff_t>(first), twelve.size(), twelve.begin());
  return Pose::from_numbers(twelve);
}

}  // namespace

std::vector<PosePair> read_poses(const std::filesystem::path& file) {
  std::ifstream stream(file);
  if (!stream) throw Error(fmt::format("{}: cannot be read", file.string()));
  std::vector<PosePair> poses;
  std::size_t line_number = 0;
  for (std::string line; std::getline(stream, line);) {
    const std::string where = fmt::format("{}:{}", file.string(), ++line_number);
    if (!line.empty() && line.back() == '\r') line.pop_back();
    if (line.find_first_not_of(" \t") == std::string::npos || line[0] == '#') continue;
    const std::vector<double> numbers = numbers_of(line, where);
    if (numbers.size() != 12 && numbers.size() != 24)
      throw Error(fmt::format("{}: a line has 12 or 24 numbers; here are {}", where, numbers.size()));
    const bool both = numbers.size() == 24;
    poses.push_back({both ? pose_of(numbers, 0) : Pose{}, pose_of(numbers, both ? 12 : 0)});
  }
  if (poses.empty()) throw Error(fmt::format("{}: holds no pose", file.string()));
  return poses;
}

}  // namespace toccata::bench
