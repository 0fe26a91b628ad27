#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "toccata/core/index.hpp"
#include "toccata/math/pose.hpp"
#include "toccata/shapes/triangle_mesh.hpp"

namespace toccata {

/// Whether a mesh is taken as the solid it encloses or as the surface it is.
enum class Solid {
  automatic,  ///< closed meshes are solids, open ones surfaces
  all,        ///< must be a solid: an open mesh is an error
  none,       ///< a surface
};

/// A named, posed mesh. Objects may share one mesh. World units are the scene's.
struct SceneObject {
  std::string name;  ///< unique in its scene
  std::shared_ptr<const TriangleMesh> mesh;
  Pose pose;  ///< the 12 numbers of the query: node chain and unit composed once (docs/reference/scene-file.md)
  Solid solid = Solid::automatic;
  std::string group;          ///< objects of one non-empty group are not checked against each other
  std::optional<Index> node;  ///< the node of the tree that carries it
  std::string source;         ///< where the mesh came from, for messages: a file, or "generated: …"
};

/// A node of the tree the scene came from; its pose is relative to its parent.
struct SceneNode {
  std::string name;
  std::optional<Index> parent;  ///< always an earlier node
  Pose pose;
};

struct Scene {
  std::vector<SceneObject> objects;
  std::vector<SceneNode> nodes;
  std::string unit = "m";  ///< what one world unit is called; only for people
};

}  // namespace toccata
