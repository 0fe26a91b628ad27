#pragma once

#include <memory>
#include <span>
#include <string>
#include <type_traits>
#include <variant>
#include <vector>

#include "library.hpp"
#include "toccata/narrow/posed_polytope.hpp"
#include "toccata/narrow/quadrics.hpp"

// Questions about pairs of convex shapes, and who answers them.
namespace toccata::bench {

enum class ConvexTask { overlap, distance, penetration, manifold };

/// Around the origin of its own frame; capsules, cylinders and cones along z.
using ConvexBody = std::variant<Sphere, Box, Capsule, Triangle, ConvexHull, Cylinder, Cone, Ellipsoid>;

/// A cylinder, a cone or an ellipsoid.
template <class Shape>
concept Quadric = std::is_constructible_v<PosedQuadric, const Shape&, const Pose&>;

/// What the library takes a shape at its place as.
template <class Shape>
using PosedAs = std::conditional_t<Quadric<Shape>, PosedQuadric, PosedPolytope>;

struct ConvexPair {
  ConvexBody a;
  ConvexBody b;
};

struct ConvexQuestion {
  std::size_t pair = 0;
  Pose a{};
  Pose b{};
  bool follows = false;  ///< the question before is about the same pair, a small step earlier
};

struct ConvexWork {
  std::string pair;  ///< "hull", "box", "sphere-box", …: of all pairs
  ConvexTask task = ConvexTask::overlap;
  bool coherent = false;
  std::vector<ConvexPair> pairs{};
  std::vector<ConvexQuestion> questions{};
};

/// What a library said; what the task does not ask for stays as it is here.
struct ConvexAnswer {
  bool overlap = false;
  double lower = 0;  ///< of the distance or the depth; of one who gives a single number, that
  double upper = 0;
  Vec3 direction{};  ///< in which B is to be moved to part them
  int points = 0;    ///< of the manifold
};

/// Questions are asked, and times taken, by so many: one may take less time than a look at the clock.
inline constexpr std::size_t convex_block = 100;

/// A library that answers questions about two convex shapes.
class ConvexLibrary {
 public:
  virtual ~ConvexLibrary() = default;
  [[nodiscard]] virtual Description description() const = 0;
  /// Takes shapes and poses over in the library's own types; not measured. Called once.
  virtual void prepare(const ConvexWork& work) = 0;
  /// The bytes that it keeps for each vertex of a hull; 0 where that is not known, or there is no hull.
  [[nodiscard]] virtual double bytes_per_vertex() const { return 0; }
  /// Answers the questions from `first` on, a multiple of `convex_block`, one for each element of `answers`.
  virtual void answer(std::size_t first, std::span<ConvexAnswer> answers) = 0;
};

using ConvexLibraries = std::vector<std::unique_ptr<ConvexLibrary>>;

/// A library that cannot be asked this, and why.
struct Unasked {
  Description who;
  std::string reason;
};

struct ConvexOffer {
  ConvexLibraries libraries;
  std::vector<Unasked> unasked;
};

/// A shape of the pairs is a cylinder, a cone or an ellipsoid.
bool has_quadric(const std::string& pair);

/// The pairs that --pair takes.
std::vector<std::string> convex_pairs();

ConvexOffer toccata_convex(const ConvexWork& work);
/// The methods that can be called on their own; the peer "ways".
ConvexOffer toccata_ways(const ConvexWork& work);
/// For hulls that move by small steps: by Voronoi regions, by GJK from nothing, by the kept separating axis; the peer
/// "tracked".
ConvexOffer toccata_tracked(const ConvexWork& work);
/// A sphere and a k-DOP by region codes; the peer "dops".
ConvexOffer toccata_dops(const ConvexWork& work);
ConvexOffer fcl_convex(const ConvexWork& work);
ConvexOffer bullet_convex(const ConvexWork& work);
ConvexOffer ode_convex(const ConvexWork& work);

/// Toccata first, then the named peers.
ConvexOffer convex_libraries(const std::vector<std::string>& peers, const ConvexWork& work);
std::vector<std::string> convex_peers();

/// Calls `function` with the two types of shape of a pair as template arguments.
template <class Function>
auto with_types(const std::string& pair, Function function) {
  if (pair == "box") return function.template operator()<Box, Box>();
  if (pair == "sphere") return function.template operator()<Sphere, Sphere>();
  if (pair == "sphere-box") return function.template operator()<Sphere, Box>();
  if (pair == "sphere-triangle") return function.template operator()<Sphere, Triangle>();
  if (pair == "sphere-capsule") return function.template operator()<Sphere, Capsule>();
  if (pair == "capsule") return function.template operator()<Capsule, Capsule>();
  if (pair == "capsule-box") return function.template operator()<Capsule, Box>();
  if (pair == "cylinder-box") return function.template operator()<Cylinder, Box>();
  if (pair == "cone-box") return function.template operator()<Cone, Box>();
  if (pair == "ellipsoid") return function.template operator()<Ellipsoid, Ellipsoid>();
  if (pair.ends_with("-dop")) return function.template operator()<Sphere, ConvexHull>();
  return function.template operator()<ConvexHull, ConvexHull>();
}

}  // namespace toccata::bench
