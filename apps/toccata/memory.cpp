#include "memory.hpp"

#include <fmt/format.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <fstream>
#include <limits>
#include <string>
#include <system_error>

#include "converted.hpp"
#include "output.hpp"
#include "toccata/core/error.hpp"
#include "words.hpp"

namespace toccata::command {
namespace {

namespace fs = std::filesystem;

constexpr double no_limit = std::numeric_limits<double>::infinity();

/// The number that a file of the system holds; no limit where there is none, or no such file.
double limit_in(const fs::path& file) {
  double bytes = 0;
  return std::ifstream(file) >> bytes ? bytes : no_limit;
}

/// The least memory limit of the control groups that the process is in.
double limit_of_groups() {
  double least = limit_in("/sys/fs/cgroup/memory/memory.limit_in_bytes");
  std::ifstream groups("/proc/self/cgroup");
  for (std::string line; std::getline(groups, line);) {
    if (!line.starts_with("0::/")) continue;
    for (fs::path group = line.substr(4);; group = group.parent_path()) {
      least = std::min(least, limit_in(fs::path("/sys/fs/cgroup") / group / "memory.max"));
      if (group.empty()) break;
    }
  }
  return least;
}

double limit_of_process() {
  rlimit limit{};
  if (getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY) return no_limit;
  return static_cast<double>(limit.rlim_cur);
}

/// A line of /proc/meminfo, in bytes.
double meminfo(const std::string& name) {
  std::ifstream lines("/proc/meminfo");
  for (std::string line; std::getline(lines, line);)
    if (line.starts_with(name + ":")) return 1024 * std::stod(line.substr(name.size() + 1));
  return no_limit;
}

/// Numbers as bytes, by what stands at its beginning: text has no zeros there, and a PLY file says so.
bool is_binary(const fs::path& file) {
  std::string start(512, ' ');
  std::ifstream(file, std::ios::binary).read(start.data(), static_cast<std::streamsize>(start.size()));
  return start.find('\0') != std::string::npos || start.find("format binary") != std::string::npos;
}

/// Bytes at the peak of the run for each byte of a file: some 120 a triangle, and the text beside what is read of it.
double factor_of(const fs::path& file) {
  std::string extension = file.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  const bool binary = is_binary(file);
  if (extension == ".stl") return binary ? 2.5 : 1.5;
  if (extension == ".ply") return binary ? 6.5 : 3;
  if (extension == ".obj" || extension == ".off") return 3;
  if (extension == ".3mf") return 40;  // the text that it unpacks to, and its tree
  if (is_converted(file.string())) return 20;
  return extension == ".glb" ? 6.5 : 1;
}

std::string gigabytes(double bytes) { return fmt::format("{:.3g} GB", 1e-9 * bytes); }

}  // namespace

Memory memory_of_machine() {
  const double most = std::min({meminfo("MemTotal") + meminfo("SwapTotal"), limit_of_groups(), limit_of_process()});
  return {most, std::min(most, meminfo("MemAvailable"))};
}

double memory_for(const std::vector<fs::path>& files) {
  double bytes = 0;
  for (const fs::path& file : files) {
    std::error_code code;
    const auto size = fs::file_size(file, code);
    if (!code) bytes += factor_of(file) * static_cast<double>(size);
  }
  return bytes;
}

void require_memory(const std::vector<fs::path>& files) {
  const double needed = memory_for(files);
  constexpr double always_there = 100e6;
  if (needed < always_there) return;
  const Memory memory = memory_of_machine();
  const std::string what = fmt::format("to read {} and build {} takes some {} of memory",
                                       files.size() == 1 ? files[0].string() : counted(files.size(), "file"),
                                       files.size() == 1 ? "its tree" : "their trees", gigabytes(needed));
  if (needed > memory.most)
    throw Error(
        fmt::format("{}, and this run has {}: cut the mesh into parts, make it coarser, or use a machine with "
                    "more memory",
                    what, gigabytes(memory.most)));
  if (needed > memory.available)
    print_warnings({fmt::format("{}, and {} is available: other programs may have to give some up", what,
                                gigabytes(memory.available))});
}

}  // namespace toccata::command
