#include "shapes/hull_links.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "core/no_index.hpp"

namespace toccata {

// The half-edge before one that leaves v ends at v, so the twins of all that end there are found by noting, for every
// vertex around, which half-edge goes there from v.
void link_faces(const HullFaces& faces, const HullLinks& links) {
  const std::size_t vertices = links.leaving.size();
  std::vector<Index> previous(faces.corners.size()), next_leaving(faces.corners.size()), towards(vertices, no_index);
  std::ranges::fill(links.leaving, 0);
  std::vector<Index> first_leaving(vertices, no_index);
  for (std::size_t f = faces.first.size() - 1; f-- > 0;)
    for (Index h = faces.first[f + 1]; h-- > faces.first[f];) {
      links.face[h] = static_cast<Index>(f);
      previous[h] = h == faces.first[f] ? faces.first[f + 1] - 1 : h - 1;
      next_leaving[h] = std::exchange(first_leaving[faces.corners[h]], h);
    }
  const auto target = [&](Index h) {
    const Index f = links.face[h];
    return faces.corners[h + 1 == faces.first[f + 1] ? faces.first[f] : h + 1];
  };
  for (std::size_t v = 0; v < vertices; ++v) {
    if (first_leaving[v] != no_index) links.leaving[v] = first_leaving[v];
    for (Index h = first_leaving[v]; h != no_index; h = next_leaving[h]) towards[target(h)] = h;
    for (Index h = first_leaving[v]; h != no_index; h = next_leaving[h])
      links.twin[previous[h]] = towards[faces.corners[previous[h]]];
  }
}

}  // namespace toccata
