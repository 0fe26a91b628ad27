#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "toccata/core/index.hpp"
#include "toccata/math/pose.hpp"
#include "toccata/shapes/shape.hpp"
#include "toccata/shapes/triangle_mesh.hpp"

namespace toccata {

/// Whether a mesh is taken as the solid it encloses or as the surface it is. Of other shapes it follows from the shape:
/// a ball or a hull is a solid, also with `none`.
enum class Solid {
  automatic,  ///< closed meshes are solids, open ones surfaces
  all,        ///< must be a solid: an open mesh or a height field is an error
  none,       ///< a mesh is a surface
};

/// A named, posed shape. Objects may share one mesh, hull, height field or compound. World units are the scene's.
struct SceneObject {
  std::string name;  ///< unique in its scene
  Shape shape;
  Pose pose;  ///< the 12 numbers of the query: node chain and unit composed once (docs/reference/scene-file.md)
  Solid solid = Solid::automatic;
  std::string group;          ///< objects of one non-empty group are not checked against each other
  std::optional<Index> node;  ///< the node of the tree that carries it
  std::string source;         ///< where the shape came from, for messages: a file, or "generated: …"

  /// Its triangles, when it is a mesh or a height field; else null.
  [[nodiscard]] std::shared_ptr<const TriangleMesh> mesh() const { return mesh_of(shape); }
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
