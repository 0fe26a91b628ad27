#include "narrow/convex/plain_topology.hpp"

#include <array>

namespace toccata {
namespace {

template <std::size_t Faces, std::size_t HalfEdges, std::size_t Vertices>
struct Tables {
  std::array<Index, Faces + 1> face_start{};
  std::array<Index, HalfEdges> origin{}, twin{}, face{};
  std::array<Index, Vertices> leaving{};

  [[nodiscard]] HullTopology view() const { return {face_start, origin, twin, face, leaving}; }
};

/// Faces of equally many corners: each a row of `origin`.
template <std::size_t Faces, std::size_t Vertices, std::size_t HalfEdges>
constexpr Tables<Faces, HalfEdges, Vertices> tables_of(const std::array<Index, HalfEdges>& origin) {
  constexpr std::size_t corners = HalfEdges / Faces;
  Tables<Faces, HalfEdges, Vertices> t;
  t.origin = origin;
  const auto target = [&](std::size_t h) { return origin[(h + 1) % corners == 0 ? h + 1 - corners : h + 1]; };
  for (std::size_t f = 0; f <= Faces; ++f) t.face_start[f] = static_cast<Index>(f * corners);
  for (std::size_t h = HalfEdges; h-- > 0;) {
    t.face[h] = static_cast<Index>(h / corners);
    t.leaving[origin[h]] = static_cast<Index>(h);
    for (std::size_t other = 0; other < HalfEdges; ++other)
      if (origin[other] == target(h) && target(other) == origin[h]) t.twin[h] = static_cast<Index>(other);
  }
  return t;
}

constexpr auto segment_of_two = tables_of<1, 2>(std::array<Index, 2>{0, 1});
constexpr std::array segments_of_three = {tables_of<1, 3>(std::array<Index, 2>{0, 1}),
                                          tables_of<1, 3>(std::array<Index, 2>{1, 2}),
                                          tables_of<1, 3>(std::array<Index, 2>{0, 2})};
constexpr auto triangle_of_three = tables_of<2, 3>(std::array<Index, 6>{0, 1, 2, 0, 2, 1});
constexpr auto box_of_eight = tables_of<6, 8>(std::array<Index, 24>{0, 4, 6, 2, 1, 3, 7, 5, 0, 1, 5, 4,  //
                                                                    2, 6, 7, 3, 0, 2, 3, 1, 4, 5, 7, 6});

HullTopology topology_of_collinear(const Triangle& t) {
  int least = 0, greatest = 0;
  for (int i = 1; i < 3; ++i) {
    if (lexicographically_less(t[i], t[least])) least = i;
    if (lexicographically_less(t[greatest], t[i])) greatest = i;
  }
  if (least == greatest) return point_topology();
  const int between = 3 - least - greatest;
  return segments_of_three[between == 2 ? 0 : between == 0 ? 1 : 2].view();
}

}  // namespace

HullTopology point_topology() { return {}; }
HullTopology segment_topology() { return segment_of_two.view(); }
HullTopology box_topology() { return box_of_eight.view(); }
HullTopology triangle_topology(const Triangle& triangle) {
  return has_area(triangle) ? triangle_of_three.view() : topology_of_collinear(triangle);
}

}  // namespace toccata
