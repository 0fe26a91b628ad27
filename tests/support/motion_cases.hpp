#pragma once

#include <array>
#include <string>
#include <vector>

#include "toccata/core/random.hpp"
#include "toccata/motion/time_of_impact.hpp"

namespace toccata::test {

/// Four points that move: a vertex and the corners of a face, or the ends of one edge and of another.
using MovingPoints = std::array<MovingPoint, 4>;

/// Hard and ordinary motions by name.
struct MotionFamily {
  std::string name;
  MovingPoints (*draw)(Random&);
};

const std::vector<MotionFamily>& feature_families();

VertexFace vertex_face(const MovingPoints& points);
EdgeEdge edge_edge(const MovingPoints& points);

}  // namespace toccata::test
