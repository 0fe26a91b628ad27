#include "file_text.hpp"

#include <fstream>
#include <iterator>

namespace toccata::command {

std::string text_of_file(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

}  // namespace toccata::command
