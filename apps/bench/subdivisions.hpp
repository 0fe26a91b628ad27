#pragma once

#include <memory>
#include <string>
#include <vector>

#include "library.hpp"
#include "toccata/query/subdivision.hpp"

namespace toccata::bench {

/// What is known of a distance: it lies in the interval, if that is proved.
struct LimitInterval {
  double lower = 0;
  double upper = 0;
};

/// A way to make a mesh of a limit surface, and to tell distances from it.
class LimitLibrary {
 public:
  virtual ~LimitLibrary() = default;
  [[nodiscard]] virtual Description description() const = 0;
  /// Makes the mesh anew, so near the limit: its vertices.
  virtual std::vector<Vec3> make(const SubdivisionCage& cage, double within) = 0;
  /// What is made once for many distances; the time is told as that of the build.
  virtual void make_ready(const SubdivisionCage& cage, double within) = 0;
  [[nodiscard]] virtual LimitInterval distance(const Model& other, const Pose& pose) = 0;
};

using LimitLibraries = std::vector<std::unique_ptr<LimitLibrary>>;

/// How often everything has to be refined for the bound: what the ways take that do not look where it is needed.
int levels_for(const SubdivisionCage& cage, double within);

/// Refining where it is needed first, then everything.
LimitLibraries toccata_limit_libraries();
LimitLibraries osd_limit_libraries();
std::vector<std::string> limit_peers();

}  // namespace toccata::bench
