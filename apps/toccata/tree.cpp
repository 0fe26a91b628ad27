#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <memory>

#include "arguments.hpp"
#include "load.hpp"
#include "option_kinds.hpp"
#include "output.hpp"
#include "subcommands.hpp"
#include "toccata/core/error.hpp"
#include "toccata/io/model_file.hpp"
#include "words.hpp"

namespace toccata::command {
namespace {

struct TreeArguments {
  std::string file;
  std::string save;   ///< where the tree is written
  std::string check;  ///< a tree file; one of the two is given
  int threads = 0;
};

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

}  // namespace

Subcommand add_tree(CLI::App& app) {
  const auto arguments = std::make_shared<TreeArguments>();
  CLI::App* tree = app.add_subcommand("tree", "save the tree over a mesh, or look whether one belongs to it");
  tree->add_option("file", arguments->file, "a file with one mesh")->required();
  CLI::Option* save = add_file(*tree, "--save", arguments->save, "write the tree here");
  add_file(*tree, "--check", arguments->check, "look through this tree")->excludes(save);
  add_threads(*tree, arguments->threads, "tree");
  tree->footer(
      with_name("Programs read it with load_model (docs/reference/tree-file.md).\n\n"
                "Exit code: 0 saved, or right; 2 trouble: damaged, or of another mesh.\n\n"
                "Example:\n  {0} tree part.stl --save part.tree\n  {0} tree part.stl --check part.tree"));
  return {tree, [arguments] { return run_tree(*arguments); }};
}

}  // namespace toccata::command
