#include "query/relation/relation_arrangement.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include "math/constants.hpp"
#include "query/meshes/posed_mesh.hpp"
#include "shapes/union_find.hpp"
#include "toccata/narrow/triangle_triangle.hpp"
#include "toccata/trees/builders.hpp"
#include "toccata/trees/walk.hpp"

namespace toccata {
namespace {

/// The vertices in ascending order: the same for all triangles that are the same set.
Triangle sorted_vertices(Triangle t) {
  std::sort(t.vertex.begin(), t.vertex.end(), lexicographically_less);
  return t;
}

bool before(const Triangle& s, const Triangle& t) {
  return std::lexicographical_compare(s.vertex.begin(), s.vertex.end(), t.vertex.begin(), t.vertex.end(),
                                      lexicographically_less);
}

std::vector<Triangle> different_sheets(std::vector<Triangle> triangles) {
  for (Triangle& t : triangles) t = sorted_vertices(t);
  std::sort(triangles.begin(), triangles.end(), before);
  triangles.erase(std::unique(triangles.begin(), triangles.end()), triangles.end());
  std::erase_if(triangles, [](const Triangle& t) { return !has_area(t); });
  return triangles;
}

/// The sheets of interest and, of the others, those that are none of them.
std::vector<Triangle> sheets_and_others(std::vector<Triangle> sheets, std::vector<Triangle> others) {
  std::vector<Triangle> added;
  others = different_sheets(std::move(others));
  std::set_difference(others.begin(), others.end(), sheets.begin(), sheets.end(), std::back_inserter(added), before);
  sheets.insert(sheets.end(), added.begin(), added.end());
  return sheets;
}

int shared_vertex_count(const Triangle& s, const Triangle& t) {
  return static_cast<int>(std::count_if(s.vertex.begin(), s.vertex.end(), [&](const Vec3& p) {
    return std::find(t.vertex.begin(), t.vertex.end(), p) != t.vertex.end();
  }));
}

/// Calls `see(i, j)` for each two sheets whose boxes meet.
template <class See>
class BoxIntersections {
 public:
  BoxIntersections(std::span<const Aabb> boxes, const See& see) : boxes_(boxes), see_(see) {}
  double bound(const Aabb& a, const Aabb& b) const { return overlap(a, b) ? 0 : infinity; }
  double limit() const { return 0; }
  void visit(std::span<const ItemPair> pairs) {
    for (const ItemPair& pair : pairs)
      if (overlap(boxes_[pair.first], boxes_[pair.second])) see_(pair.first, pair.second);
  }

 private:
  std::span<const Aabb> boxes_;
  const See& see_;
};

}  // namespace

Arrangement::Arrangement(std::vector<Triangle> of_interest, std::vector<Triangle> beside)
    : sheets_(different_sheets(std::move(of_interest))), interest_count_(sheets_.size()) {
  sheets_ = sheets_and_others(std::move(sheets_), std::move(beside));
  cuts_.resize(sheets_.size());
  edge_blocked_.resize(sheets_.size());
  find_cuts();
}

void Arrangement::find_cuts() {
  std::vector<Aabb> boxes;
  boxes.reserve(sheets_.size());
  for (const Triangle& t : sheets_) boxes.push_back(box_of(t));
  const auto see = [&](Index i, Index j) { note_intersection(i, j); };
  BoxIntersections question(std::span<const Aabb>(boxes), see);
  walk_self(build_bvh(boxes), question);
}

void Arrangement::note_intersection(Index i, Index j) {
  if (i >= interest_count_ && j >= interest_count_) return;
  const Intersection common = intersect(sheets_[i], sheets_[j]);
  if (common.kind == IntersectionKind::none || common.kind == IntersectionKind::point) return;
  // A segment that contains a whole edge of both is that edge.
  if (common.kind == IntersectionKind::segment && shared_vertex_count(sheets_[i], sheets_[j]) == 2) return;
  note_side(i, j, common.on_a);
  note_side(j, i, common.on_b);
}

void Arrangement::note_side(Index sheet, Index other, const Feature& on_sheet) {
  if (on_sheet.kind == FeatureKind::face)
    cuts_[sheet].push_back(other);
  else
    edge_blocked_[sheet][on_sheet.index] = true;
}

std::vector<Arrangement::Edge> Arrangement::sorted_edges() const {
  std::vector<Edge> edges;
  edges.reserve(3 * sheets_.size());
  for (std::size_t i = 0; i < sheets_.size(); ++i)
    for (int k = 0; k < 3; ++k) {
      const Vec3 &p = sheets_[i][k], &q = sheets_[i][(k + 1) % 3];
      edges.push_back(
          {lexicographically_less(p, q) ? p : q, lexicographically_less(p, q) ? q : p, static_cast<Index>(i), k});
    }
  std::sort(edges.begin(), edges.end(), [](const Edge& d, const Edge& e) {
    return d.from == e.from ? lexicographically_less(d.to, e.to) : lexicographically_less(d.from, e.from);
  });
  return edges;
}

std::vector<Index> Arrangement::patch_leaders() const {
  UnionFind patches(sheets_.size());
  const auto is_open = [&](const Edge& e) {
    return e.sheet < interest_count_ && cuts_[e.sheet].empty() &&
           !edge_blocked_[e.sheet][static_cast<std::size_t>(e.number)];
  };
  const std::vector<Edge> edges = sorted_edges();
  for (std::size_t first = 0, last = 0; first < edges.size(); first = last) {
    while (last < edges.size() && edges[last].from == edges[first].from && edges[last].to == edges[first].to) ++last;
    if (last - first == 2 && is_open(edges[first]) && is_open(edges[first + 1]))
      patches.unite(edges[first].sheet, edges[first + 1].sheet);
  }
  std::vector<Index> leaders;
  for (Index i = 0; i < interest_count_; ++i)
    if (patches.leader(i) == i) leaders.push_back(i);
  return leaders;
}

std::vector<Triangle> Arrangement::cuts_of(Index sheet) const {
  std::vector<Triangle> cuts;
  for (const Index other : cuts_[sheet]) cuts.push_back(sheets_[other]);
  return cuts;
}

void Arrangement::visit_patches(const std::function<CellVisit(const ExactPoint&, const Triangle&)>& visit) const {
  for (const Index leader : patch_leaders()) {
    const Triangle& sheet = sheets_[leader];
    if (!visit_cells(sheet, cuts_of(leader), [&](const ExactPoint& p) { return visit(p, sheet); })) return;
  }
}

}  // namespace toccata
