#include "robots/mesh_place.hpp"

#include <fmt/format.h>

#include <string_view>
#include <system_error>

#include "toccata/core/error.hpp"

namespace toccata {
namespace {

namespace fs = std::filesystem;

bool is_there(const fs::path& path) {
  std::error_code code;
  return fs::exists(path, code);
}

/// Without a slash at its end, which has no name.
fs::path without_last_slash(const fs::path& folder) { return folder.has_filename() ? folder : folder.parent_path(); }

class PackageSearch {
 public:
  explicit PackageSearch(std::string_view name) {
    const std::size_t slash = name.find('/');
    package_ = name.substr(0, slash);
    if (slash != std::string_view::npos) rest_ = name.substr(slash + 1);
    if (package_.empty() || rest_.empty())
      throw Error(fmt::format("'package://{}' names no file of a package; it has the form package://name/path", name));
  }

  /// Looks in a folder of packages, and in one that is the package.
  bool found_in(const fs::path& folder) {
    looked_in_.push_back(folder.string());
    const bool is_package = without_last_slash(folder).filename() == package_;
    for (const fs::path& place : {folder / package_ / rest_, is_package ? folder / rest_ : fs::path{}})
      if (!place.empty() && is_there(place)) {
        found_ = place;
        return true;
      }
    return false;
  }

  [[nodiscard]] const fs::path& found() const { return found_; }

  [[nodiscard]] Error failure() const {
    std::string folders;
    for (const std::string& folder : looked_in_) folders += fmt::format("{}'{}'", folders.empty() ? "" : ", ", folder);
    return Error(
        fmt::format("package://{}/{} is in none of the folders {}; name the folder that holds the package '{}'",
                    package_, rest_, folders, package_));
  }

 private:
  std::string package_, rest_;
  std::vector<std::string> looked_in_;
  fs::path found_;
};

fs::path place_in_package(std::string_view name, const fs::path& urdf_folder,
                          const std::vector<std::string>& package_folders) {
  PackageSearch search(name);
  for (const std::string& folder : package_folders)
    if (search.found_in(folder)) return search.found();
  std::error_code code;
  fs::path above = fs::weakly_canonical(urdf_folder.empty() ? fs::path(".") : urdf_folder, code);
  for (;; above = above.parent_path()) {
    if (search.found_in(above)) return search.found();
    if (above == above.parent_path()) throw search.failure();
  }
}

}  // namespace

fs::path mesh_place(const std::string& name, const fs::path& urdf_folder,
                    const std::vector<std::string>& package_folders) {
  const auto after = [&](std::string_view scheme) { return std::string_view(name).substr(scheme.size()); };
  if (name.empty()) throw Error("the mesh has no file name; write filename=\"…\"");
  if (name.starts_with("package://")) return place_in_package(after("package://"), urdf_folder, package_folders);
  const bool is_file = name.starts_with("file://");
  if (!is_file && name.find("://") != std::string::npos)
    throw Error(fmt::format("'{}' is neither a file nor in a package; meshes are read from disk alone", name));
  fs::path place = is_file ? fs::path(after("file://")) : urdf_folder / name;
  if (!is_there(place)) throw Error(fmt::format("there is no file '{}'", place.string()));
  return place;
}

}  // namespace toccata
