#include <algorithm>
#include <optional>
#include <utility>

#include "methods/bsp/bsp_choice.hpp"
#include "methods/msp/msp_parts.hpp"

namespace toccata {
namespace {

/// A part of a plane, of a line, or a point, and what of the surface lies in it: of a triangle in whose plane it is a
/// polygon, of others segments and points.
struct FlatCell {
  std::vector<PooledFragment> fragments;
  std::vector<BspPlane> planes;       ///< in which it lies: that of a node of space, and up to two that have cut it
  std::optional<std::size_t> parent;  ///< none where that is the node of space
  Sign side = Sign::zero;             ///< of the parent's plane
  std::size_t depth = 0;              ///< nodes above it
  std::size_t mark = 0;               ///< of the pool, behind its fragments

  [[nodiscard]] bool is_planar() const { return planes.size() == 1; }
  [[nodiscard]] bool is_point() const { return planes.size() == 3; }
};

Feature feature_of(const PooledFragment& fragment, const BspCorner& first) {
  const auto& [p, q] = first.on;
  const BspLine line = fragment.count == 1 ? p : first.next;
  if (fragment.count == 1 && is_edge(p) && is_edge(q)) return {FeatureKind::vertex, static_cast<std::uint8_t>(q)};
  if (fragment.count <= 2 && is_edge(line)) return {FeatureKind::edge, static_cast<std::uint8_t>(line)};
  return {FeatureKind::face, 0};
}

/// Partitions the plane of a node of space, within its cell.
class PlanePartition {
 public:
  PlanePartition(MspTree::Parts& parts, const BspOptions& options, BspFragments& fragments, BspChoice& choice)
      : parts_(parts), planes_(parts.space.planes), options_(options), fragments_(fragments), choice_(choice) {}

  void run(const CutBspCell& cell);

 private:
  void cut(FlatCell cell);
  void append_children(FlatCell& parent, BspPlane plane);
  void attach(const FlatCell& cell, MspChild child);
  [[nodiscard]] MspChild region(const FlatCell& cell);
  [[nodiscard]] std::vector<PooledFragment> asking(const FlatCell& cell) const;
  [[nodiscard]] bool asks(const PooledFragment& fragment, const FlatCell& cell) const;
  [[nodiscard]] BspPlane line_for(const PooledFragment& fragment) const;
  [[nodiscard]] BspPlane point_for(const PooledFragment& fragment, const FlatCell& cell);

  MspTree::Parts& parts_;
  const BspPlanes& planes_;
  const BspOptions& options_;
  BspFragments& fragments_;
  BspChoice& choice_;
  std::vector<FlatCell> waiting_;
};

void PlanePartition::run(const CutBspCell& cell) {
  parts_.within.push_back(off_surface);
  if (cell.within.empty()) return;
  const std::size_t mark = fragments_.mark();
  FlatCell all;
  all.fragments.assign(cell.within.begin(), cell.within.end());
  all.planes = {parts_.space.nodes[cell.node].plane};
  all.depth = cell.depth + 1;
  all.mark = mark;
  waiting_.push_back(std::move(all));
  while (!waiting_.empty()) {
    FlatCell next = std::move(waiting_.back());
    waiting_.pop_back();
    fragments_.forget_after(next.mark);
    cut(std::move(next));
  }
  fragments_.forget_after(mark);
}

void PlanePartition::cut(FlatCell cell) {
  const std::vector<PooledFragment> open = asking(cell);
  if (open.empty()) return attach(cell, region(cell));
  const BspPlane plane = choice_.of(open, [&](const PooledFragment& fragment) {
    return cell.is_planar() ? line_for(fragment) : point_for(fragment, cell);
  });
  attach(cell, static_cast<MspChild>(parts_.nodes.size()));
  parts_.nodes.push_back({plane, {off_surface, off_surface, off_surface}});
  ++(cell.is_planar() ? parts_.statistics.lines : parts_.statistics.points);
  parts_.statistics.depth = std::max(parts_.statistics.depth, cell.depth + 1);
  append_children(cell, plane);
}

void PlanePartition::append_children(FlatCell& parent, BspPlane plane) {
  std::vector<PooledFragment> back, within, front;
  const RoundedBspPlane rounded = planes_.rounded(plane);
  for (const PooledFragment& fragment : parent.fragments) {
    const SplitFragment split = fragments_.split(fragment, plane, rounded);
    if (split.back.count != 0) back.push_back(split.back);
    if (split.within.count != 0) within.push_back(split.within);
    if (split.front.count != 0) front.push_back(split.front);
    parts_.statistics.splits += split.back.count != 0 && split.front.count != 0;
  }
  const std::size_t triangles = planes_.triangle_count();
  const std::size_t splits = parts_.statistics.splits + parts_.space.statistics.splits;
  require_growth_allowed(static_cast<double>(triangles + splits), planes_.triangle_count(), options_);
  const std::size_t node = parts_.nodes.size() - 1, mark = fragments_.mark();
  const auto append = [&](std::vector<PooledFragment>& inside, Sign side) {
    if (!inside.empty()) waiting_.push_back({std::move(inside), parent.planes, node, side, parent.depth + 1, mark});
  };
  append(back, Sign::negative);
  append(front, Sign::positive);
  parent.planes.push_back(plane);
  append(within, Sign::zero);
}

void PlanePartition::attach(const FlatCell& cell, MspChild child) {
  (cell.parent ? parts_.nodes[*cell.parent].beside(cell.side) : parts_.within.back()) = child;
}

/// All of the cell is on the same triangles, in each on one feature.
MspChild PlanePartition::region(const FlatCell& cell) {
  const PooledFragment& least =
      *std::min_element(cell.fragments.begin(), cell.fragments.end(),
                        [](const PooledFragment& a, const PooledFragment& b) { return a.triangle < b.triangle; });
  const Feature feature = feature_of(least, fragments_.corner(least, 0));
  MspStatistics& counts = parts_.statistics;
  ++(feature.kind == FeatureKind::vertex ? counts.vertices
     : feature.kind == FeatureKind::edge ? counts.edges
                                         : counts.faces);
  return region_on({least.triangle, feature});
}

std::vector<PooledFragment> PlanePartition::asking(const FlatCell& cell) const {
  std::vector<PooledFragment> result;
  for (const PooledFragment& fragment : cell.fragments)
    if (asks(fragment, cell)) result.push_back(fragment);
  return result;
}

/// A polygon asks for a cut along an edge within the cell, what else is in a plane for one through it, and what is on a
/// line for one at an end within the cell. What asks for none fills the cell.
bool PlanePartition::asks(const PooledFragment& fragment, const FlatCell& cell) const {
  if (cell.is_point()) return false;
  if (cell.is_planar() && fragment.count < 3) return true;
  for (std::size_t i = 0; i < fragment.count; ++i) {
    const BspCorner& corner = fragments_.corner(fragment, i);
    if (!(cell.is_planar() ? corner.next_on_border : corner.on_border)) return true;
  }
  return false;
}

/// A triangle that has a segment or a point in the plane, no more, has a plane that cuts this one along it. An edge of
/// a polygon within the cell is no cut, so it is an edge of the triangle.
BspPlane PlanePartition::line_for(const PooledFragment& fragment) const {
  if (fragment.count < 3) return fragment.triangle;
  std::size_t i = 0;
  while (fragments_.corner(fragment, i).next_on_border) ++i;
  return planes_.through_edge(fragment.triangle, fragments_.corner(fragment, i).next);
}

/// The end of a segment within the cell is no cut, so an edge of the triangle is there that leads away from the line.
/// An edge that meets the line in its inside is of a triangle that crosses the line. A triangle that has no more than a
/// vertex on the line crosses it, or has the line in its plane: then both its edges there lead away from it.
BspPlane PlanePartition::point_for(const PooledFragment& fragment, const FlatCell& cell) {
  std::size_t end = 0;
  while (fragments_.corner(fragment, end).on_border) ++end;
  const auto& [p, q] = fragments_.corner(fragment, end).on;
  const Index triangle = fragment.triangle;
  if (fragment.count == 2) return planes_.through_edge(triangle, p == fragments_.corner(fragment, 0).next ? q : p);
  if (!is_edge(q) || fragments_.meet_in_a_point(cell.planes[0], cell.planes[1], triangle)) return triangle;
  return planes_.through_edge(triangle, p);
}

/// What paints fragments is not wanted of this tree.
void finish(MspTree::Parts& parts) {
  BspTree::Parts& space = parts.space;
  space.first_fragment = {};
  space.fragments = {};
  space.corners = {};
  parts.nodes.shrink_to_fit();
  parts.within.shrink_to_fit();
  MspStatistics& statistics = parts.statistics;
  statistics.triangles = space.statistics.triangles;
  statistics.planes = space.statistics.nodes;
  statistics.splits += space.statistics.splits;
  statistics.depth = std::max(statistics.depth, space.statistics.depth);
  statistics.bytes = space.nodes.size() * (sizeof(BspNode) + sizeof(MspChild)) + parts.nodes.size() * sizeof(MspNode) +
                     space.planes.bytes();
}

}  // namespace

void build_msp(MspTree::Parts& parts, const BspOptions& options) {
  build_bsp(parts.space, options, [&](const CutBspCell& cell, BspFragments& fragments, BspChoice& choice) {
    PlanePartition(parts, options, fragments, choice).run(cell);
  });
  finish(parts);
}

}  // namespace toccata
