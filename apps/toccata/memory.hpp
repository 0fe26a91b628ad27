#pragma once

#include <cstddef>
#include <filesystem>
#include <vector>

namespace toccata::command {

/// What a run may take, in bytes.
struct Memory {
  double most = 0;       ///< the machine's, or what `ulimit -v` or a control group leaves of it
  double available = 0;  ///< without taking any from other programs; at most the same
};

[[nodiscard]] Memory memory_of_machine();

/// Roughly how much it takes at its peak to read these files and build the trees (docs/reference/mesh-formats.md): a
/// multiple of their sizes. Files that are not there take none.
[[nodiscard]] double memory_for(const std::vector<std::filesystem::path>& files);

/// Throws Error when the files need more than there is, and prints a warning when they need more than is available.
void require_memory(const std::vector<std::filesystem::path>& files);

}  // namespace toccata::command
