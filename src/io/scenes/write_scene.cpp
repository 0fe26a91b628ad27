#include <fmt/format.h>

#include <map>
#include <set>
#include <system_error>
#include <utility>

#include "io/formats/file_bytes.hpp"
#include "io/formats/file_error.hpp"
#include "io/formats/json.hpp"
#include "io/scenes/scene_json.hpp"
#include "toccata/core/error.hpp"
#include "toccata/io/model_file.hpp"
#include "toccata/io/scene_file.hpp"

namespace toccata {

using io::Json;

namespace {

namespace fs = std::filesystem;

/// A folder that is filled beside its place and takes it when complete; gone when it never was.
class FolderInTheMaking {
 public:
  explicit FolderInTheMaking(fs::path target) : target_(std::move(target)) {
    std::error_code code;
    if (fs::exists(target_, code) && !(fs::is_directory(target_, code) && fs::is_empty(target_, code)))
      io::fail_in_file(target_.string(), {"there is something already", "choose another folder or remove this one"});
    if (target_.has_parent_path()) fs::create_directories(target_.parent_path(), code);
    for (int attempt = 0; attempt < 1000; ++attempt) {
      path_ = target_;
      path_ += fmt::format(".part{}", attempt);
      if (fs::create_directory(path_, code)) return;
      if (code) break;
    }
    path_.clear();
    io::fail_in_file(target_.string(), {"the folder cannot be made: " + code.message(), "check the permissions"});
  }
  FolderInTheMaking(const FolderInTheMaking&) = delete;
  FolderInTheMaking& operator=(const FolderInTheMaking&) = delete;
  ~FolderInTheMaking() {
    if (std::error_code code; !path_.empty()) fs::remove_all(path_, code);
  }

  [[nodiscard]] const fs::path& path() const { return path_; }

  void complete() {
    std::error_code code;
    fs::remove(target_, code);  // an empty folder, or nothing
    fs::rename(path_, target_, code);
    if (code)
      io::fail_in_file(target_.string(), {"the folder cannot be made: " + code.message(), "choose another name"});
    path_.clear();
  }

 private:
  fs::path target_, path_;
};

/// Letters, digits, '-' and '_' of the name: good on every file system.
std::string file_stem(const std::string& name) {
  std::string stem;
  for (const char c : name) {
    const bool plain =
        (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' || c == '_';
    if (plain)
      stem += c;
    else if (!stem.empty() && stem.back() != '-')
      stem += '-';
  }
  constexpr std::size_t longest = 60;
  return stem.empty() ? "mesh" : stem.substr(0, longest);
}

std::string lower_case(std::string text) {
  for (char& c : text) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return text;
}

/// Writes each mesh once, named after the first object that has it.
class MeshFiles {
 public:
  explicit MeshFiles(const fs::path& folder) : folder_(folder) {}

  /// `owner`: the name of the object that has it.
  const std::string& file_of(const TriangleMesh& mesh, const std::string& owner) {
    const auto [found, is_new] = file_of_.try_emplace(&mesh);
    if (is_new) {
      std::string name = file_stem(owner) + ".obj";
      for (int number = 2; !taken_.insert(lower_case(name)).second; ++number)
        name = fmt::format("{}-{}.obj", file_stem(owner), number);
      write_mesh(mesh, folder_ / name);
      found->second = name;
    }
    return found->second;
  }

 private:
  fs::path folder_;
  std::map<const TriangleMesh*, std::string> file_of_;
  std::set<std::string> taken_;  ///< in lower case: some file systems do not tell A from a
};

}  // namespace

void write_scene(const Scene& scene, const std::string& folder) {
  io::require_writable(scene);
  const fs::path path(folder);
  FolderInTheMaking making(path.has_filename() ? path : path.parent_path());
  MeshFiles files(making.path());
  Json json = io::scene_head(scene);
  json["objects"] = Json::array();
  for (const SceneObject& object : scene.objects)
    json["objects"].push_back(io::json_of(object, [&](const auto& mesh) {
      return Json{{"file", files.file_of(*mesh, object.name)}};
    }));
  io::write_file(making.path() / "scene.json", json.dump(1) + "\n");
  making.complete();
}

}  // namespace toccata
