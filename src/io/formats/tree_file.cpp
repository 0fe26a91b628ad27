#include "toccata/io/model_file.hpp"

#include <fstream>
#include <string>
#include <system_error>
#include <utility>

#include <fmt/format.h>

#include "io/formats/file_bytes.hpp"
#include "io/formats/file_error.hpp"
#include "io/formats/tree_bytes.hpp"
#include "toccata/core/error.hpp"

namespace toccata {
namespace {
namespace fs = std::filesystem;

/// What a tree may be written over: a tree, and nothing else that somebody has.
void require_tree_or_nothing(const fs::path& path) {
  std::error_code code;
  const fs::file_status status = fs::status(path, code);
  if (status.type() == fs::file_type::not_found) return;
  if (status.type() == fs::file_type::none)
    io::fail_in_file(path.string(), {"the file cannot be reached: " + code.message(), "choose another name"});
  if (!fs::is_regular_file(status))
    io::fail_in_file(path.string(), {"this exists and is no regular file", "choose another name"});
  std::string start(8, '\0');
  std::ifstream(path, std::ios::binary).read(start.data(), static_cast<std::streamsize>(start.size()));
  if (!io::begins_as_tree(start))
    io::fail_in_file(path.string(), {"the file exists and is no tree file", "choose another name"});
}

}  // namespace

void save_tree(const Model& model, const std::string& path) {
  if (!std::holds_alternative<std::shared_ptr<const TriangleMesh>>(model.shape()))
    throw Error(fmt::format("{}: the tree of a mesh is saved, and the model is a {}", path, name_of(model.shape())));
  require_tree_or_nothing(path);
  io::write_file(path, io::tree_bytes(model.wide_bvh(), model.mesh()));
}

Model load_model(std::shared_ptr<const TriangleMesh> mesh, const std::string& tree) {
  if (!mesh) throw Error("a model needs a mesh, and the pointer given is null");
  WideBvh parsed = io::parse_tree(io::read_file(tree).span(), *mesh, tree);
  try {
    return Model(std::move(mesh), std::move(parsed));
  } catch (const Error& error) {
    io::fail_in_file(tree, {"the tree file is damaged", error.what()});
  }
}

}  // namespace toccata
