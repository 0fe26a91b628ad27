#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "toccata/core/index.hpp"
#include "toccata/core/parallel.hpp"
#include "toccata/core/status.hpp"
#include "toccata/math/pose.hpp"
#include "toccata/query/model.hpp"
#include "toccata/query/pair_query.hpp"
#include "toccata/shapes/triangle_mesh.hpp"

namespace toccata {

/// How a cage is refined.
enum class SubdivisionScheme : std::uint8_t {
  loop,           ///< triangles (C. T. Loop, "Smooth subdivision surfaces based on triangles", 1987)
  catmull_clark,  ///< faces of any number of corners (E. Catmull, J. Clark, "Recursively generated B-spline surfaces on
                  ///< arbitrary topological meshes", 1978)
};

/// An edge of the cage that is to stay sharp: for ever where the sharpness is `sharp_for_ever` or more, else for as
/// many levels, and blended in the last where it is no whole number (T. DeRose, M. Kass, T. Truong, "Subdivision
/// surfaces in character animation", 1998; uniform, as OpenSubdiv has it). Where one edge has several, the sharpest
/// counts.
struct CageCrease {
  Index first = 0;
  Index second = 0;
  double sharpness = std::numeric_limits<double>::infinity();

  friend constexpr bool operator==(const CageCrease&, const CageCrease&) = default;
};

/// A vertex of the cage that is to stay where it is, likewise.
struct CageCorner {
  Index vertex = 0;
  double sharpness = std::numeric_limits<double>::infinity();

  friend constexpr bool operator==(const CageCorner&, const CageCorner&) = default;
};

/// What is as sharp as this is so at every level.
inline constexpr double sharp_for_ever = 10;

/// What becomes of the border of an open cage. Its edges are always sharp.
enum class CageBorder : std::uint8_t {
  smooth,        ///< a cubic B-spline of its vertices, all of them
  sharp_corner,  ///< the same, but a vertex of one face only stays where it is
};

struct CageFeatures {
  std::vector<CageCrease> creases{};
  std::vector<CageCorner> corners{};
  CageBorder border = CageBorder::smooth;

  friend bool operator==(const CageFeatures&, const CageFeatures&) = default;
};

/// The faces of a mesh as a cage has them.
struct CagePolygons {
  PolygonMesh polygons;
  /// For each vertex of the mesh, its number in the cage; the greatest Index for one that no triangle uses, which the
  /// cage does not have.
  std::vector<Index> vertex_of;
};

/// The polygons that were cut into the mesh's triangles, as they are in the file, beginning at another corner perhaps.
/// Where sides of faces that have no neighbour in the mesh have the same ends in space, these become one vertex each,
/// as in STL files each triangle has vertices of its own, and at seams of textures. What only touches is not joined.
/// Throws Error naming a face that is no polygon without holes.
[[nodiscard]] CagePolygons cage_polygons(const TriangleMesh& mesh);

/// The edges whose two faces turn by more than the angle, in degrees, sharp for ever: 0 … 180. Throws Error as
/// SubdivisionCage does, and for another angle.
[[nodiscard]] std::vector<CageCrease> creases_by_angle(const PolygonMesh& polygons, double degrees);

/// A control cage, which stands for its limit surface.
class SubdivisionCage {
 public:
  /// Throws Error naming the element when a coordinate is not finite or beyond 10¹⁵⁰, a face has fewer than three
  /// corners (of Loop, other than three) or one of them twice, an index is out of range, a vertex is of no face, three
  /// faces share an edge or two use it in the same direction, two triangles of Loop are the same from two sides, a
  /// crease is no edge of the cage, or a sharpness is negative or no number.
  ///
  /// Where faces meet in a vertex only, each group of them gets one of its own, which stays where it is, as OpenSubdiv
  /// has it: these follow the others, and are corners of the features.
  SubdivisionCage(PolygonMesh polygons, SubdivisionScheme scheme, CageFeatures features = {});

  /// A cage of the polygons that `cage_polygons` finds. Features name vertices of the mesh, and so do errors, with
  /// their coordinates. Throws Error as both do.
  [[nodiscard]] static SubdivisionCage of_mesh(const TriangleMesh& mesh, SubdivisionScheme scheme,
                                               CageFeatures features = {});

  [[nodiscard]] const PolygonMesh& polygons() const { return polygons_; }
  [[nodiscard]] SubdivisionScheme scheme() const { return scheme_; }
  [[nodiscard]] const CageFeatures& features() const { return features_; }
  [[nodiscard]] bool closed() const { return closed_; }  ///< it has no border

  /// The same with its vertices in the world (`transform`). Throws Error as the constructor does.
  [[nodiscard]] SubdivisionCage posed(const Pose& pose) const;

 private:
  PolygonMesh polygons_;
  SubdivisionScheme scheme_;
  CageFeatures features_;
  bool closed_ = false;
};

struct RefinementOptions {
  /// How far mesh and limit surface may be from each other, in units of the cage. Positive, or infinite.
  double tolerance = std::numeric_limits<double>::infinity();
  /// Every face is refined at least so often. 0 … 30; of Catmull–Clark 0 counts as 1.
  int levels = 0;
  /// Refining ends before there were more, not counting what faces beside finer ones are cut into for their sake.
  std::size_t max_triangles = std::size_t{1} << 22;
  Progress progress{};  ///< is called with how many of these there are, level by level
};

/// A mesh in place of a limit surface, and how far from each other they are.
struct SubdividedMesh {
  /// The mesh has no cracks, and is closed where the cage is and turned as the cage is; also where neighbours are of
  /// different levels. Faces are those of the cage.
  TriangleMesh mesh;
  /// Proved: no point of the limit surface is farther than this from the mesh, and no point of the mesh is farther
  /// than this from the limit surface. In units of the cage; rounding is counted.
  double distance_to_limit = 0;
  /// The same for each triangle: all its points are so near the limit surface of its face, and the triangles together
  /// reach all of that.
  std::vector<double> triangle_distances;
  int deepest_level = 0;  ///< how often the smallest triangles were refined
  /// not_converged: `max_triangles` ended it before the tolerance or the levels were reached.
  Status status = Status::exact;
};

/// No mesh of the cage is ever proved to be nearer its limit than this, because of rounding: some 10⁻¹⁴ times its
/// largest coordinate. In units of the cage.
[[nodiscard]] double least_tolerance(const SubdivisionCage& cage);

/// Refines a cage, and where the bound is above the tolerance further: near extraordinary vertices and strong
/// curvature. The bound comes from second differences of the control points and from how fast they fall
/// (docs/methods/subdivision-surfaces.md has the proof). Throws Error when an option is out of range or the
/// tolerance below `least_tolerance`.
[[nodiscard]] SubdividedMesh refine(const SubdivisionCage& cage, const RefinementOptions& options = {});

/// How a question about a limit surface and a model, or another limit surface, is asked. A surface is that of the
/// cage's world vertices.
struct LimitQuery {
  /// Where each is, and what it is taken for. A closed cage may be a solid.
  PairQuery pair{};
  /// In world units; positive. The interval of a distance is at most so wide; what is no farther than this apart may be
  /// undecided.
  double tolerance = 1e-6;
  std::size_t max_faces = std::size_t{1} << 20;  ///< of one level, near the other; the search ends before it has more
  /// The most comparisons, in all levels, of faces with the model or of the faces of two cages with each other: the
  /// search ends there. Where surfaces coincide or are parallel over an area, all faces stay near.
  std::size_t max_comparisons = std::size_t{1} << 20;
  Progress progress{};  ///< is called with how many of them there were
};

/// The distance of a limit surface from a model or another limit surface.
struct LimitDistance {
  /// Proved: the distance of the limit surface, not of a mesh, lies in [lower, upper].
  double lower = 0;
  double upper = 0;
  /// The nearest points, on the mesh in place of the limit surface, which is within `distance_to_limit` of it, and on
  /// the model or the mesh in place of the other. They mean nothing where one lies within the other as a solid.
  Vec3 on_mesh{};
  Vec3 on_model{};
  double distance_to_limit = 0;
  Index cage_face = 0;
  Index element = 0;  ///< of the model, or the face of the other cage
  int level = 0;      ///< how often the cage was refined there
  /// not_converged: the interval is wider than the tolerance, because `max_faces` or `max_comparisons` ended the
  /// search.
  Status status = Status::exact;
};

/// Only where the surface may be nearest it is refined, until the interval is no wider than the tolerance. What lies
/// within a closed cage that is taken as a solid, or the surface within a solid, is at distance 0. Throws Error as
/// `overlap` of models does, when the tolerance is not positive, and when a cage is asked about as a solid that is
/// open.
[[nodiscard]] LimitDistance distance(const SubdivisionCage& surface, const Model& model, const LimitQuery& query = {});

/// The same of two limit surfaces, both of which are refined only where they may be nearest.
[[nodiscard]] LimitDistance distance(const SubdivisionCage& a, const SubdivisionCage& b, const LimitQuery& query = {});

/// Whether a limit surface and a model or another limit surface have a point in common.
struct LimitOverlap {
  bool overlap = false;  ///< also where it is undecided
  /// exact: proved, a no always, a yes where some of the surface lies deep enough within a solid or the other way
  /// round. undecided: they are no farther than `distance` apart, which is at most the tolerance. not_converged:
  /// likewise, but `max_faces` or `max_comparisons` ended the search before.
  Status status = Status::exact;
  double distance = 0;  ///< the two are no farther apart than this; for a no an upper bound too
  int level = 0;        ///< how often the cage was refined to know it
};

/// Only where they may meet the surface is refined. Throws Error as `distance` does.
[[nodiscard]] LimitOverlap overlap(const SubdivisionCage& surface, const Model& model, const LimitQuery& query = {});
[[nodiscard]] LimitOverlap overlap(const SubdivisionCage& a, const SubdivisionCage& b, const LimitQuery& query = {});

}  // namespace toccata
