#include "query/subdivision/difference_growth.hpp"

#include <algorithm>
#include <cmath>

#include "math/constants.hpp"

namespace toccata {
namespace {

constexpr std::size_t by_edges = 0, by_faces = 1, by_creases = 2;

DifferenceGrowth loop_smooth(double n, double weight, bool is_dart) {
  // An edge of a dart may be sharp, and then its share of an eighth is missing.
  const double beside = is_dart ? std::max(weight, std::fabs(0.125 - weight)) : std::fabs(0.125 - weight);
  const double own = is_dart ? std::fabs(0.5 - weight) : std::fabs(0.375 - weight);
  const double half_edge = own + 2 * beside + (n - 3) * weight;
  const double inner_edge = 2 * beside + (n - 2) * weight + 0.125;
  DifferenceGrowth growth;
  growth.shift = {n * weight, 0, 0};
  growth.rows[by_edges] = {std::max(half_edge, inner_edge), 0, 0};
  if (is_dart) growth.rows[by_creases] = {2 * n * weight, 0, 0.25};
  return growth;
}

DifferenceGrowth loop_growth(const VertexKind& kind) {
  DifferenceGrowth growth;
  switch (kind.rule) {
    case VertexRule::smooth:
    case VertexRule::dart:
      return loop_smooth(kind.valence, loop_weight(kind.valence), kind.rule == VertexRule::dart);
    case VertexRule::crease:
      growth.shift = {0, 0, 0.125};
      growth.rows = {{{0.625, 0, 0.125}, {}, {0, 0, 0.25}}};
      return growth;
    case VertexRule::corner:
      growth.rows = {{{0.625, 0, 0}, {}, {0, 0, 0.25}}};
      return growth;
  }
  return growth;
}

/// Opposite edges of a smooth vertex of four have the same difference across, so shares of both add up before they are
/// bounded.
DifferenceGrowth catmull_clark_of_four(bool is_dart) {
  DifferenceGrowth growth;
  growth.shift = {0.25, 0.0625, 0};
  growth.rows = {{{0.5, 0.125, 0}, {0.25, 0.3125, 0}, {}}};
  if (is_dart) growth.rows = {{{0.625, 0.125, 0}, {0.375, 0.3125, 0}, {0.5, 0.125, 0.25}}};
  return growth;
}

DifferenceGrowth catmull_clark_smooth(double n, bool is_dart) {
  const double q = 1 / (n * n);
  const auto beside = [&](double share, double of) {
    return is_dart ? std::max(of, std::fabs(share - of)) : std::fabs(share - of);
  };
  const double at_vertex = std::fabs(0.5 - 2 * q) + 2 * beside(0.0625, 2 * q) + (n - 3) * 2 * q + 0.125;
  const double at_edge = 2 * (std::fabs(q - 0.125) + (n - 1) * q);
  const double of_face = 2 * beside(0.0625, q) + (n - 2) * q + 0.125;
  DifferenceGrowth growth;
  growth.shift = {1 / n, 0.25 / n, 0};
  growth.rows[by_edges] = {std::max(at_vertex, at_edge), 0.5 / n, 0};
  growth.rows[by_faces] = {of_face, 0.25 + 0.25 / n, 0};
  if (is_dart) {
    growth.rows[by_edges][by_edges] = std::max(growth.rows[by_edges][by_edges], 2 / n);
    growth.rows[by_creases] = {2 / n, 0.5 / n, 0.25};
  }
  return growth;
}

DifferenceGrowth catmull_clark_growth(const VertexKind& kind) {
  const bool is_dart = kind.rule == VertexRule::dart;
  if (kind.rule == VertexRule::smooth || is_dart)
    return kind.valence == 4 ? catmull_clark_of_four(is_dart) : catmull_clark_smooth(kind.valence, is_dart);
  DifferenceGrowth growth;
  if (kind.rule == VertexRule::crease) {
    growth.shift = {0, 0, 0.125};
    growth.rows = {{{0.75, 0, 0.25}, {0.25, 0.25, 0.125}, {0, 0, 0.25}}};
    if (kind.is_even) growth.rows = {{{0, 0, 0.25}, {0.0625, 0.25, 0.125}, {0, 0, 0.25}}};
    return growth;
  }
  growth.rows = {{{0.75, 0, 0}, {0.25, 0.25, 0}, {0, 0, 0.25}}};
  if (!kind.has_smooth_edge) growth.rows = {{{}, {0, 0.25, 0}, {0, 0, 0.25}}};
  return growth;
}

/// g (1 − rows) = shift by elimination, where all stays positive; nothing is proved here.
std::array<double, 3> fixed_point(const DifferenceGrowth& growth, const SecondDifferences& shift) {
  std::array<std::array<double, 4>, 3> m{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) m[i][j] = (i == j ? 1 : 0) - growth.rows[j][i];
    m[i][3] = shift[i];
  }
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < 3; ++k) {
      if (k == i) continue;
      const double factor = m[k][i] / m[i][i];
      for (std::size_t j = i; j < 4; ++j) m[k][j] -= factor * m[i][j];
    }
  return {m[0][3] / m[0][0], m[1][3] / m[1][1], m[2][3] / m[2][2]};
}

/// Up by more than the roundings of the sums below.
constexpr double up_by_sums = 1 + 0x1p-48;

}  // namespace

void DifferenceGrowth::include(const DifferenceGrowth& other) {
  for (std::size_t i = 0; i < 3; ++i) {
    shift[i] = std::max(shift[i], other.shift[i]);
    for (std::size_t j = 0; j < 3; ++j) rows[i][j] = std::max(rows[i][j], other.rows[i][j]);
  }
}

DifferenceGrowth growth_at(SubdivisionScheme scheme, const VertexKind& kind) {
  return scheme == SubdivisionScheme::loop ? loop_growth(kind) : catmull_clark_growth(kind);
}

DifferenceGrowth growth_at_new_vertices(SubdivisionScheme scheme, bool has_creases) {
  const Index regular = scheme == SubdivisionScheme::loop ? 6 : 4;
  DifferenceGrowth growth = growth_at(scheme, {.rule = VertexRule::smooth, .valence = regular});
  if (has_creases) growth.include(growth_at(scheme, {.rule = VertexRule::crease, .valence = regular, .is_even = true}));
  growth.shift[by_edges] = std::max(growth.shift[by_edges], 0.125);  // points of edges
  return growth;
}

double moved_by_all_levels(const DifferenceGrowth& growth, const SecondDifferences& differences) {
  // A little more than the shift, so that the inequality has room for rounding.
  SecondDifferences shift = growth.shift;
  for (double& s : shift) s += 0x1p-20;
  const std::array<double, 3> gain = fixed_point(growth, shift);
  double moved = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    double needed = growth.shift[i];
    for (std::size_t j = 0; j < 3; ++j) needed += gain[j] * growth.rows[j][i];
    if (!(gain[i] >= 0 && gain[i] >= needed * up_by_sums)) return infinity;
    moved += gain[i] * differences[i];
  }
  return moved * up_by_sums;
}

}  // namespace toccata
