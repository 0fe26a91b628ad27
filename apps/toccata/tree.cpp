#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "arguments.hpp"
#include "load.hpp"
#include "output.hpp"
#include "toccata/core/error.hpp"
#include "toccata/io/model_file.hpp"
#include "words.hpp"

namespace toccata::command {
namespace {

/// The one mesh of all objects; its numbers are the file's.
std::shared_ptr<const TriangleMesh> only_mesh(const Scene& scene, const std::string& file) {
  std::shared_ptr<const TriangleMesh> mesh;
  for (const SceneObject& object : scene.objects) {
    const auto* own = std::get_if<std::shared_ptr<const TriangleMesh>>(&object.shape);
    if (own == nullptr || (mesh && *own != mesh))
      throw Error(fmt::format("{}: a tree file is of one mesh, and here is {}; name a file with one mesh", file,
                              own == nullptr ? "a shape that is no mesh" : "more than one"));
    mesh = *own;
  }
  return mesh;
}

int depth_of(const WideBvh& tree) {
  std::vector<int> depths(tree.blocks.size(), 1);
  for (std::size_t i = 0; i < tree.blocks.size(); ++i)
    for (std::size_t lane = 0; lane < tree.blocks[i].count; ++lane)
      if (!tree.blocks[i].is_item(lane)) depths[static_cast<std::size_t>(tree.blocks[i].child[lane])] = depths[i] + 1;
  return *std::max_element(depths.begin(), depths.end());
}

std::string tree_text(const Model& model, const std::string& file, bool saved) {
  const WideBvh& tree = model.wide_bvh();
  return fmt::format("{}: {} tree of {}, {} in {}, {}\n", printable(file), saved ? "saved a" : "the",
                     counted(model.mesh().triangle_count(), "triangle"), counted(tree.blocks.size(), "block"),
                     counted(static_cast<std::size_t>(depth_of(tree)), "level"),
                     counted(std::filesystem::file_size(file), "byte"));
}

}  // namespace

int run_tree(const TreeArguments& arguments) {
  const bool saves = !arguments.save.empty();
  if (saves == !arguments.check.empty())
    throw Error("say what to do: --save FILE writes the mesh's tree, --check FILE looks whether a tree is of it");
  InputArguments input;
  input.files = {arguments.file};
  const auto mesh = only_mesh(load(input).scene, arguments.file);
  if (saves) {
    const Model model(mesh, arguments.threads);
    const UninterruptedWriting writing;
    save_tree(model, arguments.save);
    print_answer(tree_text(model, arguments.save, true));
  } else {
    print_answer(tree_text(load_model(mesh, arguments.check), arguments.check, false));
  }
  return 0;
}

}  // namespace toccata::command
