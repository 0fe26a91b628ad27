#pragma once

#include <memory>
#include <span>
#include <vector>

#include "library.hpp"
#include "toccata/shapes/primitives.hpp"

namespace toccata::bench {

/// What a refitted tree is asked, to see whether it holds the mesh: does the surface meet each of these?
struct Probes {
  std::vector<Segment> segments;
  std::vector<std::pair<Vec3, double>> balls;  ///< centre and radius
};

/// Empty where a library has no such question.
struct ProbeAnswers {
  std::vector<bool> segments;
  std::vector<bool> balls;
};

/// A library that keeps its tree over a mesh whose vertices move: Toccata, or a peer.
class RefitLibrary {
 public:
  virtual ~RefitLibrary() = default;
  [[nodiscard]] virtual Description description() const = 0;
  virtual void build(const TriangleMesh& mesh) = 0;
  /// Takes the next vertices over in the library's own types; not measured.
  virtual void give(const TriangleMesh& mesh) = 0;
  /// Makes the tree hold them; measured.
  virtual void refit() = 0;
  [[nodiscard]] virtual ProbeAnswers answers(const Probes& probes) = 0;
};

using RefitLibraries = std::vector<std::unique_ptr<RefitLibrary>>;

RefitLibraries toccata_refit_libraries(int threads);
RefitLibraries embree_refit_libraries(int threads);
RefitLibraries fcl_refit_libraries();

}  // namespace toccata::bench
