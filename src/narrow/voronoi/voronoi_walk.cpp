#include "toccata/narrow/voronoi_walk.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <span>

#include "narrow/convex/kept_simplex.hpp"
#include "narrow/exact/nearest_formula.hpp"
#include "narrow/voronoi/feature_walk.hpp"
#include "narrow/voronoi/others_clear.hpp"
#include "toccata/core/error.hpp"
#include "toccata/narrow/gjk.hpp"

namespace toccata {
namespace {

using Parts = VoronoiRegions::Parts;
using Kind = ConvexFeature::Kind;

[[noreturn]] void refuse_regions(Index vertices, Index vertices_of_regions, const char* which) {
  throw Error(
      fmt::format("the Voronoi regions given for {} are those of a shape of {} vertices, and it has {}: build "
                  "them from the same shape",
                  which, vertices_of_regions, vertices));
}

void require_regions_of(const PosedConvex& shape, const VoronoiRegions& regions, const char* which) {
  const auto vertices = static_cast<Index>(regions.parts().vertices.size());
  if (shape.vertex_count() != vertices) refuse_regions(shape.vertex_count(), vertices, which);
}

/// Those of a hull share its coordinates; else the vertices tell.
bool are_regions_of(const WalkBody& body, const PosedConvex& shape) {
  if (body.parts->stored == shape.along(0)) return true;
  for (Index i = 0; i < shape.vertex_count(); ++i)
    if (!(body.vertex(i) == shape.vertex(i))) return false;
  return true;
}

bool has(const Parts& parts, const ConvexFeature& feature) {
  const HullTopology& t = parts.topology;
  if (feature.kind == Kind::vertex) return feature.index < parts.vertices.size();
  if (feature.kind == Kind::edge) return feature.index < t.origin.size();
  return parts.has_faces() && feature.index < t.face_count();
}

/// Not two faces, nor a face and an edge: these are never needed, as an end of theirs is as near.
bool is_walked(const ConvexFeature& a, const ConvexFeature& b) {
  return (a.kind != Kind::face || b.kind == Kind::vertex) && (b.kind != Kind::face || a.kind == Kind::vertex);
}

/// A point within a face is within one of the triangles that its first corner makes with the others.
Index corner_before(const WalkBody& body, Index face, const Vec3& on) {
  const HullTopology& t = body.parts->topology;
  const Index begin = t.face_start[face], last = t.face_start[face + 1] - 2;
  const auto corner = [&](Index h) { return body.vertex(t.origin[h]); };
  const Vec3 first = corner(begin), to_it = on - first;
  const Vec3 normal = cross(corner(begin + 1) - first, corner(last + 1) - first);
  Index h = begin + 1;
  while (h < last && dot(cross(corner(h + 1) - first, to_it), normal) > 0) ++h;
  return h;
}

/// Up to three vertices of a feature, ascending, with the point within.
struct Corners {
  std::array<Index, 3> vertex{};
  std::size_t count = 0;
};

Corners corners_of(const WalkBody& body, const ConvexFeature& feature, const Vec3& on) {
  const HullTopology& t = body.parts->topology;
  if (feature.kind == Kind::vertex) return {{feature.index}, 1};
  if (feature.kind == Kind::edge) {
    const Index start = t.origin[feature.index], end = t.target(feature.index);
    return {{std::min(start, end), std::max(start, end)}, 2};
  }
  if (!has_more_corners(*body.parts, feature)) return {body.parts->sides[feature.index].triangle, 3};
  const Index h = corner_before(body, feature.index, on);
  Corners corners{{t.origin[t.face_start[feature.index]], t.origin[h], t.origin[h + 1]}, 3};
  std::ranges::sort(corners.vertex);
  return corners;
}

/// The feature that has some vertices, or, where rounding has made up one that has them, the first.
ConvexFeature feature_of(const Parts& parts, std::span<const Index> vertices) {
  const HullTopology& t = parts.topology;
  const ConvexFeature first{Kind::vertex, vertices[0]};
  if (vertices.size() == 1) return first;
  for (const Parts::Spoke& spoke : parts.spokes_at(vertices[0]))
    if (vertices.size() == 2 && t.target(spoke.half_edge) == vertices[1])
      return {Kind::edge, parts.edge_of(spoke.half_edge)};
  for (const Parts::Spoke& spoke : parts.spokes_at(vertices[0])) {
    const Index face = t.face[spoke.half_edge];
    const auto corners = corners_of_face(t, face);
    if (parts.has_faces() &&
        std::ranges::all_of(vertices, [&](Index v) { return std::ranges::find(corners, v) != corners.end(); }))
      return {Kind::face, face};
  }
  return first;
}

/// One question about a tracked pair.
class TrackedQuestion {
 public:
  TrackedQuestion(const PosedConvex& a, const VoronoiRegions& regions_a, const PosedConvex& b,
                  const VoronoiRegions& regions_b, TrackedPair& tracked, VoronoiPath* path)
      : a_(a),
        b_(b),
        body_a_{&regions_a.parts(), &a.pose()},
        body_b_{&regions_b.parts(), &b.pose()},
        tracked_(tracked),
        path_(path) {}

  Distance distance() {
    ++tracked_.counts.questions;
    const bool is_known = tracked_.state != TrackedPair::State::unknown && has(*body_a_.parts, tracked_.on_a) &&
                          has(*body_b_.parts, tracked_.on_b) && is_walked(tracked_.on_a, tracked_.on_b);
    if (!is_known) forget();
    // A walk from anywhere is a long way through memory that nobody has read of late: GJK is nearer.
    if (is_known ? tracked_.cores_meet : path_ == nullptr) return searched();
    if (!are_regions_of(body_a_, a_) || !are_regions_of(body_b_, b_)) return searched();
    if (path_ == nullptr && !has_more_corners(*body_a_.parts, tracked_.on_a) &&
        !has_more_corners(*body_b_.parts, tracked_.on_b))
      if (const auto distance = proved({tracked_.on_a, tracked_.on_b}, {})) return kept(*distance);
    return walk();
  }

 private:
  Distance walk() {
    const FeatureWalk walk = walk_features(body_a_, body_b_, tracked_.on_a, tracked_.on_b, path_);
    tracked_.counts.steps += walk.steps;
    tracked_.on_a = walk.near.feature[0];
    tracked_.on_b = walk.near.feature[1];
    if (walk.end != WalkEnd::below)
      if (const auto distance = proved(walk.near.feature, walk.near.on)) return walked(*distance);
    keep_simplex(walk.near);
    return searched();
  }

  void forget() {
    tracked_.on_a = {Kind::vertex, body_a_.parts->any_vertex()};
    tracked_.on_b = {Kind::vertex, body_b_.parts->any_vertex()};
  }

  [[nodiscard]] NearestFeatures corners(const std::array<ConvexFeature, 2>& features,
                                        const std::array<Vec3, 2>& on) const {
    const Corners of_a = corners_of(body_a_, features[0], on[0]), of_b = corners_of(body_b_, features[1], on[1]);
    return {of_a.vertex, of_b.vertex, of_a.count, of_b.count};
  }

  [[nodiscard]] FeaturePoints points(const NearestFeatures& corners) const {
    FeaturePoints points;
    for (std::size_t i = 0; i < corners.count_a; ++i) points.a[i] = body_a_.vertex(corners.a[i]);
    for (std::size_t i = 0; i < corners.count_b; ++i) points.b[i] = body_b_.vertex(corners.b[i]);
    return points;
  }

  /// The answer, if the features are proved to be the only nearest ones. Which corners of a face with more than three
  /// are meant, the points tell.
  [[nodiscard]] std::optional<Distance> proved(const std::array<ConvexFeature, 2>& features,
                                               const std::array<Vec3, 2>& on) const {
    const NearestFeatures vertices = corners(features, on);
    const FeaturePoints corners_in_world = points(vertices);
    NearestFormula formula(vertices, corners_in_world);
    if (!formula.solve()) return {};
    const Others of_a = other_vertices(body_a_, features[0], formula.across(), formula.slack());
    if (of_a == Others::lower) return {};
    const Others of_b = other_vertices(body_b_, features[1], -formula.across(), formula.slack());
    if (of_b == Others::lower) return {};
    if (!(of_a == Others::clear && of_b == Others::clear) && !looked_at(formula)) return {};
    return formula.distance(a_.radius(), b_.radius());
  }

  /// All vertices, which is seldom needed.
  bool looked_at(NearestFormula& formula) const {
    const SupportKernels kernels = support_kernels();
    return formula.others_beyond(SupportSearch(a_, kernels), SupportSearch(b_, kernels));
  }

  Distance kept(const Distance& distance) {
    ++tracked_.counts.kept;
    return told(distance);
  }

  Distance walked(const Distance& distance) {
    ++tracked_.counts.walked;
    return told(distance);
  }

  Distance told(const Distance& distance) {
    tracked_.state = distance.upper > 0 ? TrackedPair::State::apart : TrackedPair::State::meeting;
    return distance;
  }

  void keep_simplex(const FeaturesNear& near) {
    const VertexPairs pairs = pairs_of(corners(near.feature, near.on));
    tracked_.workspace.vertex_a = pairs.a;
    tracked_.workspace.vertex_b = pairs.b;
    tracked_.workspace.simplex_size = static_cast<int>(pairs.size);
  }

  /// By GJK, from what is kept of the last search or walk.
  Distance searched() {
    ++tracked_.counts.searched;
    const Distance distance = distance_by_gjk(a_, b_, {}, &tracked_.workspace);
    const VertexPairs simplex = kept_simplex(tracked_.workspace, a_, b_);
    const std::optional<NearestFeatures> features = canonical_features(simplex);
    tracked_.cores_meet = !features;
    if (features) {
      tracked_.on_a = feature_of(*body_a_.parts, std::span(features->a).first(features->count_a));
      tracked_.on_b = feature_of(*body_b_.parts, std::span(features->b).first(features->count_b));
      if (!is_walked(tracked_.on_a, tracked_.on_b)) forget();
    }
    return told(distance);
  }

  const PosedConvex& a_;
  const PosedConvex& b_;
  WalkBody body_a_, body_b_;
  TrackedPair& tracked_;
  VoronoiPath* path_;
};

Distance answered(const PosedConvex& a, const VoronoiRegions& regions_a, const PosedConvex& b,
                  const VoronoiRegions& regions_b, TrackedPair& tracked, VoronoiPath* path) {
  require_regions_of(a, regions_a, "A");
  require_regions_of(b, regions_b, "B");
  return TrackedQuestion(a, regions_a, b, regions_b, tracked, path).distance();
}

}  // namespace

Distance distance_by_voronoi_walk(const PosedConvex& a, const VoronoiRegions& regions_a, const PosedConvex& b,
                                  const VoronoiRegions& regions_b, TrackedPair& tracked) {
  return answered(a, regions_a, b, regions_b, tracked, nullptr);
}

Distance distance_by_voronoi_walk(const PosedConvex& a, const VoronoiRegions& regions_a, const PosedConvex& b,
                                  const VoronoiRegions& regions_b, TrackedPair& tracked, VoronoiPath& path) {
  path = {};
  return answered(a, regions_a, b, regions_b, tracked, &path);
}

}  // namespace toccata
