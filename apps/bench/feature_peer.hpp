#pragma once

#include <string>
#include <vector>

#include "toccata/motion/time_of_impact.hpp"

namespace toccata::bench {

/// The one that is asked about features.
inline const std::string feature_peer = "ipctk";

/// What a method of a peer answers of all questions, in their order.
struct FeaturePeerMethod {
  struct Answer {
    bool hit = false;
    double nanoseconds = 0;
  };
  std::string name;
  double floor_nanoseconds = 0;  ///< of a call for a vertex and a face that rest apart
  std::vector<Answer> answers;
};

struct FeaturePeer {
  std::string version;
  std::string missing;  ///< why there are no methods
  std::vector<FeaturePeerMethod> methods;
};

/// What the Python package ipctk answers (Tight Inclusion and additive CCD), asked by a script beside this program that
/// `python3` runs, or what TOCCATA_PYTHON names.
[[nodiscard]] FeaturePeer ask_ipctk(const std::vector<VertexFace>& vertex_faces,
                                    const std::vector<EdgeEdge>& edge_edges, int rounds);

}  // namespace toccata::bench
