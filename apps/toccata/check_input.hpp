#pragma once

#include <span>
#include <string>
#include <vector>

#include "arguments.hpp"
#include "load.hpp"
#include "toccata/query/check_all.hpp"
#include "toccata/query/pair_query.hpp"

namespace toccata::command {

/// Everything that is asked about, ready for questions.
struct CheckInput {
  LoadedScene loaded;
  std::vector<SceneInstance> models;  ///< of the scene's objects, in their order
};

/// Reads the files and applies what the options say about poses and solids.
CheckInput read_check_input(const PosedArguments& arguments);

/// What the file --poses asks about two models, which keep the poses that their own files give them. Throws Error when
/// there are not two.
std::vector<PairQuery> read_queries(const CheckInput& input, const PosedArguments& arguments);

/// What open meshes are taken for.
enum class OpenMeshes { surfaces, by_winding };

/// Of so many open meshes it is told what is wrong with them.
inline constexpr std::size_t most_told_open_meshes = 5;

/// An open mesh among solids contains nothing, or only by its winding number: whoever did not know that it is open
/// should. Adds a warning then, and one for each of the first few, of what keeps it from being closed.
void warn_of_open_meshes(CheckInput& input, int threads, OpenMeshes taken_for = OpenMeshes::surfaces);

/// Whether it is such a mesh: one that nobody has said is a surface.
[[nodiscard]] bool is_open_mesh(const SceneInstance& posed);

/// The same of those that are known to be open, one or more; `told` are the first of them, as many as are told.
void warn_of_open_meshes(LoadedScene& loaded, std::span<const std::string> open, std::span<const SceneInstance> told,
                         OpenMeshes taken_for = OpenMeshes::surfaces);

/// Adds warnings in front of the others and prints them at once: before long work what is left out of it.
void warn_at_once(LoadedScene& loaded, const std::vector<std::string>& warnings);
[[nodiscard]] std::vector<std::string> untold_warnings(const LoadedScene& loaded);

}  // namespace toccata::command
