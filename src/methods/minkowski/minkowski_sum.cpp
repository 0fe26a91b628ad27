#include <algorithm>
#include <bit>
#include <cstdint>
#include <memory>
#include <utility>

#include "methods/minkowski/general_overlay.hpp"
#include "methods/minkowski/sum_parts.hpp"
#include "methods/minkowski/sum_side.hpp"
#include "shapes/hull_links.hpp"
#include "toccata/core/error.hpp"

namespace toccata {
namespace {

constexpr std::size_t large_table = 1U << 16;

/// Numbers those of some keys that were added, ascending.
class KeyNumbers {
 public:
  explicit KeyNumbers(std::size_t keys)
      : used_(keys / bits + 1), number_(std::make_unique_for_overwrite<Index[]>(keys)) {}

  void add(std::size_t key) { used_[key / bits] |= std::uint64_t{1} << key % bits; }

  /// Once all are there; tells each.
  template <class Tell>
  void count(const Tell& tell) {
    Index total = 0;
    for (std::size_t w = 0; w < used_.size(); ++w)
      for (std::uint64_t left = used_[w]; left != 0; left &= left - 1) {
        const std::size_t key = w * bits + static_cast<std::size_t>(std::countr_zero(left));
        number_[key] = total++;
        tell(key);
      }
  }

  /// The number of a key that was added.
  [[nodiscard]] Index of(std::size_t key) const { return number_[key]; }

 private:
  static constexpr std::size_t bits = 64;
  std::vector<std::uint64_t> used_;
  std::unique_ptr<Index[]> number_;  ///< of those used alone
};

/// The pairs that are corners, each once and in order, and in `corners` their numbers.
std::vector<SumVertex> number_pairs(const SumFacets& facets, std::size_t points_of_a, std::size_t points_of_b,
                                    std::vector<Index>& corners) {
  const auto key = [&](const SumVertex& v) { return std::size_t{v.on_a} * points_of_b + v.on_b; };
  std::vector<SumVertex> vertices;
  corners.resize(facets.corners.size());
  if (points_of_a * points_of_b <= large_table) {
    KeyNumbers numbers(points_of_a * points_of_b);
    for (const SumVertex& v : facets.corners) numbers.add(key(v));
    numbers.count([&](std::size_t k) {
      vertices.push_back({static_cast<Index>(k / points_of_b), static_cast<Index>(k % points_of_b)});
    });
    for (std::size_t c = 0; c < corners.size(); ++c) corners[c] = numbers.of(key(facets.corners[c]));
    return vertices;
  }
  const auto before = [&](const SumVertex& v, const SumVertex& w) { return key(v) < key(w); };
  vertices = facets.corners;
  std::ranges::sort(vertices, before);
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  for (std::size_t c = 0; c < corners.size(); ++c)
    corners[c] = static_cast<Index>(std::ranges::lower_bound(vertices, facets.corners[c], before) - vertices.begin());
  return vertices;
}

/// The ends of a sum without facets: of a point, or of parallel segments.
SumVertex end_of_line(const SumOperand& a, const SumOperand& b, bool least) {
  const auto end = [&](const SumOperand& operand) {
    const auto points = operand.points();
    const auto at = least ? std::ranges::min_element(points, lexicographically_less)
                          : std::ranges::max_element(points, lexicographically_less);
    return static_cast<Index>(at - points.begin());
  };
  return {end(a), end(b)};
}

/// The facets of a line as HullTopology describes points and segments.
SumFacets facets_of_line(const SumOperand& a, const SumOperand& b) {
  SumFacets line;
  line.corners = {end_of_line(a, b, true), end_of_line(a, b, false)};
  const auto key = [](const SumVertex& v) { return std::pair(v.on_a, v.on_b); };
  if (key(line.corners[1]) < key(line.corners[0])) std::swap(line.corners[0], line.corners[1]);
  if (line.corners[0] == line.corners[1]) {
    line.corners.pop_back();
  } else {
    line.close(a.dimension() == 0   ? SumFaceKind::of_b
               : b.dimension() == 0 ? SumFaceKind::of_a
                                    : SumFaceKind::of_both,
               {}, {});
  }
  return line;
}

void take_facets(SumParts& parts, SumFacets&& facets) {
  parts.kinds = std::move(facets.kinds);
  parts.planes = std::move(facets.planes);
  parts.face_start = std::move(facets.first);
  parts.vertices = number_pairs(facets, parts.a.points().size(), parts.b.points().size(), parts.origin);
  if (parts.kinds.empty()) {
    parts.origin.clear();
    parts.leaving.assign(1, 0);
    return;
  }
  if (!facets.twins.empty()) {
    parts.twin = std::move(facets.twins);
    parts.leaving.resize(parts.vertices.size());
    parts.face.resize(parts.origin.size());
    for (Index f = static_cast<Index>(parts.kinds.size()); f-- > 0;)
      for (Index h = parts.face_start[f + 1]; h-- > parts.face_start[f];) {
        parts.face[h] = f;
        parts.leaving[parts.origin[h]] = h;
      }
    return;
  }
  HullFaces faces{parts.dimension, std::move(parts.origin), std::move(parts.face_start)};
  parts.twin.resize(faces.corners.size());
  parts.face.resize(faces.corners.size());
  parts.leaving.resize(parts.vertices.size());
  link_faces(faces, {parts.leaving, parts.twin, parts.face});
  parts.origin = std::move(faces.corners);
  parts.face_start = std::move(faces.first);
}

void require_finite(const SumParts& parts, bool negated) {
  for (Index i = 0; i < parts.vertices.size(); ++i)
    if (!is_finite(parts.rounded_vertex(i)))
      throw Error(std::string(negated ? "the difference" : "the sum") + " of vertex " +
                  std::to_string(parts.a.source(parts.vertices[i].on_a)) + " of A and vertex " +
                  std::to_string(parts.b.source(parts.vertices[i].on_b)) +
                  " of B is not finite; use smaller coordinates or a smaller scale");
}

std::vector<Vec3> rounded_vertices(const SumParts& parts) {
  std::vector<Vec3> result;
  result.reserve(parts.vertices.size());
  for (Index i = 0; i < parts.vertices.size(); ++i) result.push_back(parts.rounded_vertex(i));
  return result;
}

MinkowskiSum combine(const PosedPolytope& a, const PosedPolytope& b, bool negated) {
  auto parts = std::make_shared<SumParts>(a, b, negated);
  std::optional<SumFacets> general = general_overlay(parts->a, parts->b);
  SumFacets facets = general ? *std::move(general) : overlay(parts->a, parts->b);
  if (facets.kinds.empty()) {
    facets = facets_of_line(parts->a, parts->b);
    parts->dimension = facets.kinds.empty() ? 0 : 1;
  } else {
    parts->dimension = facets.kinds.size() == 2 ? 2 : 3;
  }
  take_facets(*parts, std::move(facets));
  require_finite(*parts, negated);
  if (parts->radius_a + parts->radius_b > 0) parts->rounded_core = ConvexHull(rounded_vertices(*parts));
  return MinkowskiSum(std::move(parts));
}

}  // namespace

MinkowskiSum minkowski_sum(const PosedPolytope& a, const PosedPolytope& b) { return combine(a, b, false); }
MinkowskiSum minkowski_difference(const PosedPolytope& a, const PosedPolytope& b) { return combine(a, b, true); }

MinkowskiSum::MinkowskiSum(std::shared_ptr<const SumParts> parts) : parts_(std::move(parts)) {}

Index MinkowskiSum::vertex_count() const { return static_cast<Index>(parts_->vertices.size()); }
SumVertex MinkowskiSum::pair(Index vertex) const {
  const SumVertex& v = parts_->vertices[vertex];
  return {parts_->a.source(v.on_a), parts_->b.source(v.on_b)};
}
Vec3 MinkowskiSum::vertex(Index i) const { return parts_->rounded_vertex(i); }
int MinkowskiSum::dimension() const { return parts_->dimension; }
HullTopology MinkowskiSum::topology() const { return parts_->topology(); }
SumFaceKind MinkowskiSum::face_kind(Index face) const { return parts_->kinds[face]; }
double MinkowskiSum::radius() const { return parts_->radius_a + parts_->radius_b; }

ConvexHull MinkowskiSum::as_hull() const { return ConvexHull(rounded_vertices(*parts_)); }

Shape MinkowskiSum::as_shape() const {
  Rounded::Core core = as_hull();
  if (dimension() == 0) core = Point{vertex(0)};
  if (dimension() == 1) core = Segment{vertex(0), vertex(1)};
  if (radius() > 0) return Rounded(std::move(core), radius());
  return std::visit([](auto& shape) -> Shape { return std::move(shape); }, core);
}

TriangleMesh MinkowskiSum::as_mesh() const {
  if (parts_->dimension < 2)
    throw Error("the sum is a point or a segment, which has no faces; give it an operand with an area");
  std::vector<std::array<Index, 3>> triangles;
  std::vector<Index> face_of;
  const HullTopology t = topology();
  for (Index f = 0; f < t.face_count(); ++f)
    for (Index h = t.face_start[f] + 1; h + 1 < t.face_start[f + 1]; ++h) {
      triangles.push_back({t.origin[t.face_start[f]], t.origin[h], t.origin[h + 1]});
      face_of.push_back(f);
    }
  return {rounded_vertices(*parts_), std::move(triangles), std::move(face_of)};
}

}  // namespace toccata
