#include "support/data.hpp"

#include <cstdlib>

namespace toccata::test {

std::optional<std::filesystem::path> data_folder() {
  const char* folder = std::getenv("TOCCATA_DATA");
  if (folder == nullptr || *folder == '\0') return std::nullopt;
  return folder;
}

}  // namespace toccata::test
