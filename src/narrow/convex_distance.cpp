#include "narrow/exact_distance.hpp"
#include "narrow/exact_nearest.hpp"
#include "toccata/narrow/convex_convex.hpp"

namespace toccata {
namespace {

VertexPairs first_vertices() {
  VertexPairs pairs;
  pairs.append(0, 0);
  return pairs;
}

}  // namespace

bool overlap(const PosedConvex& a, const PosedConvex& b, ConvexWorkspace* workspace) {
  if (workspace != nullptr) ++workspace->counts.exact;
  return grown_meet(exact_nearest(a, b, first_vertices()), a.radius(), b.radius());
}

Distance distance(const PosedConvex& a, const PosedConvex& b, ConvexWorkspace* workspace) {
  if (workspace != nullptr) ++workspace->counts.exact;
  return rounded_distance(exact_nearest(a, b, first_vertices()), a.radius(), b.radius());
}

}  // namespace toccata
