#pragma once

#include <functional>
#include <string>

#include "arguments.hpp"
#include "toccata/shapes/scene.hpp"
#include "toccata/shapes/triangle_mesh.hpp"

// What a subcommand makes and writes with -o: OBJ, OFF, STL or PLY, or GLB for Blender.
namespace toccata::command {

bool is_glb(const std::string& file);

/// Before anything is computed: throws Error where `file` is no format that is written or exists already, and as
/// `require_view` does. An empty one is not asked for.
void require_mesh_output(const PosedArguments& arguments, const std::string& file);

/// What was made, as a mesh and as an object; only the one that the file needs is asked for.
struct MadeMesh {
  std::function<TriangleMesh()> mesh;
  std::function<SceneObject()> object;
};

void write_mesh_output(const MadeMesh& made, const std::string& unit, const std::string& file);

}  // namespace toccata::command
