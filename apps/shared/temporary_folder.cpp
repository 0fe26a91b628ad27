#include "temporary_folder.hpp"

#include <cstdlib>
#include <string>
#include <system_error>

#include "toccata/core/error.hpp"

namespace toccata {
namespace fs = std::filesystem;

TemporaryFolder::TemporaryFolder() {
  std::string name = (fs::temp_directory_path() / "toccata-XXXXXX").string();
  if (mkdtemp(name.data()) == nullptr) throw Error("no temporary folder could be made in " + name);
  path_ = name;
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
}

}  // namespace toccata
