#include "toccata/io/tree_file.hpp"

#include <string>
#include <utility>

#include <fmt/format.h>

#include "io/file_bytes.hpp"
#include "io/file_error.hpp"
#include "io/tree_bytes.hpp"
#include "toccata/core/error.hpp"

namespace toccata {

void save_tree(const Model& model, const std::filesystem::path& path) {
  if (!std::holds_alternative<std::shared_ptr<const TriangleMesh>>(model.shape()))
    throw Error(
        fmt::format("{}: the tree of a mesh is saved, and the model is a {}", path.string(), name_of(model.shape())));
  io::write_file(path, io::tree_bytes(model.wide_tree(), model.mesh()));
}

Model load_model(std::shared_ptr<const TriangleMesh> mesh, const std::filesystem::path& tree) {
  if (!mesh) throw Error("a model needs a mesh, and the pointer given is null");
  const io::FileBytes bytes = io::read_file(tree);
  WideTree parsed = io::parse_tree(bytes.span(), *mesh, tree.string());
  try {
    return Model(std::move(mesh), std::move(parsed));
  } catch (const Error& error) {
    io::fail_in_file(tree.string(), {"the tree file is damaged", error.what()});
  }
}

}  // namespace toccata
