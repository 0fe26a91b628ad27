#include "demo_readme.hpp"

#include <fmt/format.h>

#include "toccata/generate/scenes.hpp"

namespace toccata::command {

std::string demo_readme() {
  std::string text =
      "# Scenes to play with\n\n"
      "Written by `toccata demo --write`. Everything here was generated; change it as you like. In a clone of the "
      "repository\n"
      "the command is `path/to/clone/toccata`.\n\n"
      "Two meshes, `a.obj` and `b.stl`:\n\n"
      "```sh\n"
      "toccata check a.obj b.stl                  # do they touch? exit code 1: yes\n"
      "toccata check a.obj b.stl --faces          # which faces, and where\n"
      "toccata check a.obj b.stl --json --faces   # the same for a program\n"
      "toccata check a.obj b.stl --pose-b 1 0 0  0 1 0  0 0 1  9 0 0   # b moved by 9 along x\n"
      "toccata inspect a.obj                      # is it watertight? how large?\n"
      "```\n\n"
      "Whole scenes, each a folder with a `scene.json` and its meshes:\n\n"
      "| command | what it shows |\n|---|---|\n";
  for (const NamedScene& named : demo_scenes())
    text += fmt::format("| `toccata check {}/scene.json` | {} |\n", named.name, named.description);
  return text + "\nPairs that merely touch are reported too; `--touching=ignore` leaves them out.\n";
}

}  // namespace toccata::command
