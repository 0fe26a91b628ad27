#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "toccata/bounds/aabb.hpp"
#include "toccata/core/parallel.hpp"
#include "toccata/shapes/scene.hpp"
#include "toccata/shapes/shape.hpp"
#include "toccata/shapes/triangle_mesh.hpp"
#include "toccata/trees/bvh.hpp"
#include "toccata/trees/wide_bvh.hpp"

namespace toccata {

class VertexFans;
struct LeafTriangles;
struct OrientedBlock;
struct WindingMoments;

/// A shape that needs no tree: questions take it as it is, typed, or as a Model that costs nothing to make.
template <class S>
concept PlainShape = std::same_as<S, Point> || std::same_as<S, Segment> || std::same_as<S, Triangle> ||
    std::same_as<S, HalfSpace> || std::same_as<S, Sphere> || std::same_as<S, Box> || std::same_as<S, Capsule> ||
    std::same_as<S, ConvexHull> || std::same_as<S, Rounded> || QuadricShape<S>;

/// A shape with a tree to build, or any. Questions take a Model of it, made once: `Model(mesh)`.
template <class S>
concept ShapeOfAModel = std::same_as<S, TriangleMesh> || std::same_as<S, std::shared_ptr<const TriangleMesh>> ||
    std::same_as<S, HeightField> || std::same_as<S, Compound> || std::same_as<S, Shape>;

template <class A, class B>
concept NeedAModel = ShapeOfAModel<A> || ShapeOfAModel<B>;

/// What some questions need of a mesh besides its tree. It is made when a question first needs it, and kept; or before,
/// by Model::prepare.
enum class ModelPart : std::uint8_t {
  solidity,        ///< whether it is closed, and its connected parts: all questions that may take it as a solid
  leaf_triangles,  ///< triangles side by side: overlap, contacts and casts, asked often
  turned_boxes,    ///< distance, within_distance and nearest
  winding,         ///< what is inside: winding numbers and signed distances
  neighbours,      ///< which triangles meet at a vertex: manifolds
};

inline constexpr std::array all_model_parts{ModelPart::solidity, ModelPart::leaf_triangles, ModelPart::turned_boxes,
                                            ModelPart::winding, ModelPart::neighbours};

/// What the first question that needs a part waits for.
struct PartCost {
  ModelPart part{};
  bool is_made = false;    ///< nothing is to be waited for any more
  std::size_t bytes = 0;   ///< of memory, when it is made; about
  double of_building = 0;  ///< time to make it, on one thread, as a share of that to build the tree; about
};

/// A shape made ready for questions: the shape and the trees over it. Copies share all, until one is deformed. Build
/// one per shape and pose it as often as needed; questions from many threads may share one.
///
/// Answers count its elements from 0: the triangles of a mesh or height field; of a compound those of its parts, one
/// part after the other; any other shape is one element, of number 0. Faces are counted likewise.
class Model {
 public:
  /// The tree is built on up to `threads` threads (core/parallel.hpp). Throws Error when the mesh has more triangles
  /// than a tree holds (2²⁸).
  explicit Model(TriangleMesh mesh, int threads = own_thread);
  explicit Model(std::shared_ptr<const TriangleMesh> mesh, int threads = own_thread);
  /// Takes a tree that was built before (`save_tree`, `load_model`). Throws Error saying why when it is no tree over
  /// the mesh's triangles, which it looks through once.
  explicit Model(std::shared_ptr<const TriangleMesh> mesh, WideBvh tree);
  explicit Model(HeightField field, int threads = own_thread);
  explicit Model(Compound compound, int threads = own_thread);
  template <std::same_as<Shape> S>
  explicit Model(const S& shape, int threads = own_thread) : Model(of_any(shape, threads)) {}

  /// Implicit: there is nothing to build.
  template <PlainShape S>
  Model(const S& shape) : plain_(shape) {}

  /// Gives the mesh other vertices, as many as it has, as a simulation does step by step: the tree keeps its shape, its
  /// boxes are put around the moved triangles, and it is built anew once they have grown too much
  /// (Refit::should_rebuild; the answer is what was found before that). No answer depends on which was done, but two
  /// that the tree decides: which triangles a distance of meshes that meet names, and generalised winding numbers,
  /// within the same bounds. Other copies of the model stay as they are; a model of which there are none gives its tree
  /// up instead of copying it. Throws Error when it is no mesh, for another number of vertices, and when one is not
  /// finite; it then stays as it was.
  Refit deform(std::vector<Vec3> vertices, int threads = own_thread);

  /// Makes what is not made yet of these, of the parts of a compound too, on up to `threads` threads
  /// (core/parallel.hpp): then no question waits for it. Other shapes have nothing to make. Questions may be asked
  /// meanwhile.
  void prepare(std::span<const ModelPart> parts = all_model_parts, int threads = all_threads) const;

  /// What there is to make, or was made, of each of `all_model_parts`, in their order; of a compound that of its parts
  /// together, and `is_made` where all is. Empty of shapes that have nothing to make.
  [[nodiscard]] std::vector<PartCost> part_costs() const;

  [[nodiscard]] const Shape& shape() const;

  /// Whether it is a mesh or a height field.
  [[nodiscard]] bool has_mesh() const;

  /// The parts of a compound, in its order; empty for any other model.
  [[nodiscard]] std::span<const Model> parts() const;

  /// How many elements and faces it has.
  [[nodiscard]] Index element_count() const;
  [[nodiscard]] Index face_count() const;

  // What follows is asked of meshes and height fields only.

  /// Throws Error for other shapes.
  [[nodiscard]] const TriangleMesh& mesh() const;

  /// Over the triangles: the tree that questions use.
  [[nodiscard]] const WideBvh& wide_bvh() const;

  /// Turned boxes for the lanes of its blocks, for questions of distance; made when first asked for. Some 75 bytes a
  /// triangle. For the library itself.
  [[nodiscard]] std::span<const OrientedBlock> oriented_boxes() const;

  /// What its blocks are as sources of solid angles, for winding numbers; made when first asked for. Some 80 bytes a
  /// triangle. For the library itself.
  [[nodiscard]] std::span<const WindingMoments> winding_moments() const;

  /// Its triangles side by side at the tree's blocks, in its units, as floats; made when first asked for. Some 53 bytes
  /// a triangle. For the library itself.
  [[nodiscard]] const LeafTriangles& leaf_triangles() const;

  /// The same once it has been made or, with so many questions more that would gain by it, is worth the time of making
  /// it: they are counted. Else null. For the library itself.
  [[nodiscard]] const LeafTriangles* leaf_triangles_for(std::size_t questions) const;

  /// The plain binary tree over the triangles, for comparison; built when first asked for.
  [[nodiscard]] const Bvh<Aabb>& tree() const;

  /// The box around all vertices, also those that no triangle uses; in the mesh's own frame, exact.
  [[nodiscard]] const Aabb& bounds() const;

  /// The connected parts of the mesh; found out when first asked for.
  [[nodiscard]] const MeshParts& mesh_parts() const;

  /// Which triangles meet at a vertex; made when first asked for. For the library itself.
  [[nodiscard]] const VertexFans& vertex_fans() const;

  /// Closed: a mesh may be taken as a solid. Found out when first asked for.
  [[nodiscard]] bool closed() const;

 private:
  struct Parts;
  static Model of_any(const Shape& shape, int threads);

  std::shared_ptr<Parts> parts_;  ///< none for plain shapes; changed by `deform` alone, and then by its only owner
  Shape plain_ = Point{};
};

/// What a question takes the model for: solid or surface. `all` means solid and `none` surface for meshes, `automatic`
/// solid when the mesh is closed; of other shapes it depends on the shape alone. A compound is solid if all parts are.
[[nodiscard]] bool taken_as_solid(const Model& model, Solid solid);

}  // namespace toccata
