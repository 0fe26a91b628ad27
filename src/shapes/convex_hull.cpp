#include "toccata/shapes/convex_hull.hpp"
#include "core/no_index.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "shapes/hull_faces.hpp"
#include "shapes/hull_guide.hpp"
#include "shapes/hull_links.hpp"
#include "toccata/core/error.hpp"

namespace toccata {

/// All index arrays lie in one, one after the other, so that a small hull is two allocations.
struct ConvexHull::Parts {
  std::vector<double> coordinates;  // x of all, y of all, z of all, each padded
  std::vector<Index> indices;       // source, leaving, face_start, origin, twin, face, guide
  Index vertices = 0;
  Index faces = 0;
  Index half_edges = 0;
  Index guides = 0;
  int dimension = 0;
  double largest_coordinate = 0;

  [[nodiscard]] std::size_t padded_count() const { return coordinates.size() / 3; }
  [[nodiscard]] std::size_t face_start_offset() const { return std::size_t{2} * vertices; }
  [[nodiscard]] std::size_t origin_offset() const { return face_start_offset() + faces + 1; }
  [[nodiscard]] std::size_t guide_offset() const { return origin_offset() + std::size_t{3} * half_edges; }
  [[nodiscard]] std::size_t size() const { return guide_offset() + guides; }

  [[nodiscard]] std::span<Index> at(std::size_t offset, std::size_t count) {
    return std::span(indices).subspan(offset, count);
  }
  [[nodiscard]] std::span<const Index> at(std::size_t offset, std::size_t count) const {
    return std::span(indices).subspan(offset, count);
  }
};

namespace {

void check(std::span<const Vec3> points) {
  if (points.empty()) throw Error("a convex hull needs at least one point");
  if (points.size() > most_hull_points)
    throw Error("a convex hull is made of at most " + std::to_string(most_hull_points) + " points, not of " +
                std::to_string(points.size()) + "; leave out points that lie inside, or split the shape");
  for (std::size_t i = 0; i < points.size(); ++i)
    if (!is_finite(points[i]))
      throw Error("point " + std::to_string(i) + " of the hull has a coordinate that is not finite");
}

/// The corners' points in ascending order, each once.
std::vector<Index> distinct_corners(const HullFaces& faces, std::size_t point_count) {
  std::vector<bool> used(point_count, false);
  for (const Index corner : faces.corners) used[corner] = true;
  std::vector<Index> result;
  for (Index p = 0; p < point_count; ++p)
    if (used[p]) result.push_back(p);
  return result;
}

/// The same faces with vertices for points; every face begins at its least vertex, and they are sorted by their
/// first two. (A directed edge belongs to one face alone.) So the faces do not depend on how they were found.
HullFaces canonical(const HullFaces& faces, const std::vector<Index>& sources, std::size_t point_count) {
  std::vector<Index> number(point_count, no_index);
  for (Index v = 0; v < sources.size(); ++v) number[sources[v]] = v;

  struct Order {
    Index least, second, face, start;
  };
  std::vector<Order> order;
  order.reserve(faces.first.size() - 1);
  for (Index f = 0; f + 1 < faces.first.size(); ++f) {
    const Index begin = faces.first[f], end = faces.first[f + 1];
    Index start = begin;
    for (Index c = begin; c < end; ++c)
      if (faces.corners[c] < faces.corners[start]) start = c;
    const Index after = start + 1 == end ? begin : start + 1;
    order.push_back({faces.corners[start], faces.corners[after], f, start});
  }
  std::ranges::sort(order, [](const Order& p, const Order& q) {
    return p.least != q.least ? p.least < q.least : p.second < q.second;
  });

  HullFaces result{faces.dimension, {}, {0}};
  result.corners.reserve(faces.corners.size());
  for (const Order& o : order) {
    const Index begin = faces.first[o.face], end = faces.first[o.face + 1];
    for (Index c = o.start; c < end; ++c) result.corners.push_back(number[faces.corners[c]]);
    for (Index c = begin; c < o.start; ++c) result.corners.push_back(number[faces.corners[c]]);
    result.close_face();
  }
  return result;
}

std::vector<double> padded(std::span<const Vec3> points, const std::vector<Index>& sources) {
  const std::size_t count = sources.size(), padded_count = (count + 7) / 8 * 8;
  std::vector<double> result;
  result.reserve(3 * padded_count);
  for (int axis = 0; axis < 3; ++axis)
    for (std::size_t i = 0; i < padded_count; ++i) result.push_back(points[sources[std::min(i, count - 1)]][axis]);
  return result;
}

}  // namespace

ConvexHull::ConvexHull(std::span<const Vec3> points) {
  check(points);
  HullFaces faces = hull_faces(points);
  const std::vector<Index> sources = distinct_corners(faces, points.size());
  if (faces.dimension == 0) faces.corners.clear();
  faces = canonical(faces, sources, points.size());

  const auto parts = std::make_shared<Parts>();
  parts->coordinates = padded(points, sources);
  parts->vertices = static_cast<Index>(sources.size());
  parts->faces = static_cast<Index>(faces.first.size() - 1);
  parts->half_edges = static_cast<Index>(faces.corners.size());
  parts->guides = guide_size(parts->vertices);
  parts->dimension = faces.dimension;
  for (const double c : parts->coordinates)
    parts->largest_coordinate = std::max(parts->largest_coordinate, std::fabs(c));
  parts->indices.resize(parts->size());
  std::ranges::copy(sources, parts->indices.begin());
  std::ranges::copy(faces.first, parts->at(parts->face_start_offset(), parts->faces + std::size_t{1}).begin());
  std::ranges::copy(faces.corners, parts->at(parts->origin_offset(), parts->half_edges).begin());
  link_faces(faces, {parts->at(parts->vertices, parts->vertices),
                     parts->at(parts->origin_offset() + parts->half_edges, parts->half_edges),
                     parts->at(parts->origin_offset() + std::size_t{2} * parts->half_edges, parts->half_edges)});
  parts_ = parts;
  fill_guide(*this, parts->at(parts->guide_offset(), parts->guides));
}

ConvexHull::ConvexHull(std::initializer_list<Vec3> points) : ConvexHull(std::span(points.begin(), points.size())) {}

Index ConvexHull::vertex_count() const { return parts_->vertices; }

Vec3 ConvexHull::vertex(Index i) const {
  const std::size_t stride = parts_->padded_count();
  return {parts_->coordinates[i], parts_->coordinates[stride + i], parts_->coordinates[2 * stride + i]};
}

Index ConvexHull::source_of(Index vertex) const { return parts_->indices[vertex]; }

int ConvexHull::dimension() const { return parts_->dimension; }

HullTopology ConvexHull::topology() const {
  const Parts& p = *parts_;
  return {.face_start = p.at(p.face_start_offset(), p.faces + std::size_t{1}),
          .origin = p.at(p.origin_offset(), p.half_edges),
          .twin = p.at(p.origin_offset() + p.half_edges, p.half_edges),
          .face = p.at(p.origin_offset() + std::size_t{2} * p.half_edges, p.half_edges),
          .leaving = p.at(p.vertices, p.vertices),
          .guide = p.at(p.guide_offset(), p.guides)};
}

std::span<const double> ConvexHull::padded_coordinates(int axis) const {
  const std::size_t stride = parts_->padded_count();
  return std::span(parts_->coordinates).subspan(static_cast<std::size_t>(axis) * stride, stride);
}

double ConvexHull::largest_coordinate() const { return parts_->largest_coordinate; }

std::size_t ConvexHull::memory() const {
  return sizeof(ConvexHull) + sizeof(Parts) + parts_->coordinates.capacity() * sizeof(double) +
         parts_->indices.capacity() * sizeof(Index);
}

}  // namespace toccata
