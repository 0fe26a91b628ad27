#include "toccata/methods/voronoi.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <span>

#include "methods/voronoi/feature_proof.hpp"
#include "methods/voronoi/walk_start.hpp"
#include "narrow/convex/cached_simplex.hpp"
#include "narrow/exact/nearest_formula.hpp"
#include "toccata/core/error.hpp"
#include "toccata/narrow/convex_convex.hpp"

namespace toccata {
namespace {

[[noreturn]] void refuse_regions(Index vertices, Index vertices_of_regions, const char* which) {
  throw Error(
      fmt::format("the Voronoi regions given for {} are those of a shape of {} vertices, and it has {}: build "
                  "them from the same shape",
                  which, vertices_of_regions, vertices));
}

void require_regions_of(const PosedPolytope& shape, const VoronoiRegions& regions, const char* which) {
  const auto vertices = regions.parts().vertex_count;
  if (shape.vertex_count() != vertices) refuse_regions(shape.vertex_count(), vertices, which);
}

/// Those of a hull share its coordinates; else the vertices tell.
bool are_regions_of(const WalkBody& body, const PosedPolytope& shape) {
  if (body.parts->stored == shape.along(0)) return true;
  for (Index i = 0; i < shape.vertex_count(); ++i)
    if (!(body.vertex(i) == shape.vertex(i))) return false;
  return true;
}

/// Not two faces, nor a face and an edge: these are never needed, as an end of theirs is as near.
bool is_walked(const ConvexFeature& a, const ConvexFeature& b) {
  return static_cast<int>(a.kind) + static_cast<int>(b.kind) <= static_cast<int>(ConvexFeature::Kind::face);
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

/// Corners of any feature, one point of which is given.
FeatureCorners corners_around(const WalkBody& body, const ConvexFeature& feature, const Vec3& on) {
  if (!has_more_corners(*body.parts, feature)) return corners_of(*body.parts, feature);
  const HullTopology& t = body.parts->topology;
  const Index h = corner_before(body, feature.index, on);
  FeatureCorners corners{{t.origin[t.face_start[feature.index]], t.origin[h], t.origin[h + 1]}, 3};
  std::ranges::sort(corners.vertex);
  return corners;
}

/// The feature that has some vertices, or, where rounding has made up one that has them, the first.
ConvexFeature feature_of(const RegionParts& parts, std::span<const Index> vertices) {
  const HullTopology& t = parts.topology;
  const ConvexFeature first{ConvexFeature::Kind::vertex, vertices[0]};
  if (vertices.size() == 1) return first;
  for (const RegionParts::Spoke& spoke : parts.spokes_at(vertices[0]))
    if (vertices.size() == 2 && spoke.vertex == vertices[1])
      return {ConvexFeature::Kind::edge, parts.edge_of(spoke.half_edge)};
  for (const RegionParts::Spoke& spoke : parts.spokes_at(vertices[0])) {
    const Index face = t.face[spoke.half_edge];
    const auto corners = corners_of_face(t, face);
    if (parts.has_faces() &&
        std::ranges::all_of(vertices, [&](Index v) { return std::ranges::find(corners, v) != corners.end(); }))
      return {ConvexFeature::Kind::face, face};
  }
  return first;
}

/// One question about a tracked pair.
class TrackedQuestion {
 public:
  TrackedQuestion(const PosedPolytope& a, const VoronoiRegions& regions_a, const PosedPolytope& b,
                  const VoronoiRegions& regions_b, TrackedPair& tracked, VoronoiPath* path)
      : a_(a),
        b_(b),
        body_a_{&regions_a.parts(), &a.pose()},
        body_b_{&regions_b.parts(), &b.pose()},
        tracked_(tracked),
        path_(path) {}

  Distance distance() {
    ++tracked_.counts.questions;
    const bool is_known = tracked_.state != TrackedPair::State::unknown && has_feature(*body_a_.parts, tracked_.on_a) &&
                          has_feature(*body_b_.parts, tracked_.on_b) && is_walked(tracked_.on_a, tracked_.on_b);
    if (is_known && tracked_.cores_meet) return searched();
    if (!are_regions_of(body_a_, a_) || !are_regions_of(body_b_, b_)) return searched();
    if (!is_known) {
      begin();
      return walk();
    }
    if (path_ == nullptr && !has_more_corners(*body_a_.parts, tracked_.on_a) &&
        !has_more_corners(*body_b_.parts, tracked_.on_b)) {
      const FeaturesAsked asked{{tracked_.on_a, tracked_.on_b},
                                {corners_of(*body_a_.parts, tracked_.on_a), corners_of(*body_b_.parts, tracked_.on_b)}};
      if (const auto distance = proved_distance(a_, body_a_, b_, body_b_, asked)) {
        ++tracked_.counts.kept;
        return told(*distance);
      }
    }
    return walk();
  }

 private:
  Distance walk() {
    const FeatureWalk walk = walk_features(body_a_, body_b_, tracked_.on_a, tracked_.on_b, path_);
    tracked_.counts.steps += walk.steps;
    tracked_.on_a = walk.near.feature[0];
    tracked_.on_b = walk.near.feature[1];
    const FeaturesAsked asked{walk.near.feature,
                              {corners_around(body_a_, walk.near.feature[0], walk.near.on[0]),
                               corners_around(body_b_, walk.near.feature[1], walk.near.on[1])}};
    if (walk.end != WalkEnd::below)
      if (const auto distance = proved_distance(a_, body_a_, b_, body_b_, asked)) {
        ++tracked_.counts.walked;
        tracked_.cores_meet = false;
        return told(*distance);
      }
    keep_simplex(asked);
    return searched();
  }

  /// A way that is told for teaching is a long one.
  void begin() {
    if (path_ != nullptr) return forget();
    const auto [vertex_a, vertex_b] = facing_vertices(a_, body_a_, b_, body_b_);
    tracked_.on_a = {ConvexFeature::Kind::vertex, vertex_a};
    tracked_.on_b = {ConvexFeature::Kind::vertex, vertex_b};
  }

  void forget() {
    tracked_.on_a = {ConvexFeature::Kind::vertex, body_a_.parts->any_vertex()};
    tracked_.on_b = {ConvexFeature::Kind::vertex, body_b_.parts->any_vertex()};
  }

  Distance told(const Distance& distance) {
    tracked_.state = distance.upper > 0 ? TrackedPair::State::apart : TrackedPair::State::meeting;
    return distance;
  }

  void keep_simplex(const FeaturesAsked& asked) {
    const VertexPairs pairs = pairs_of(features_of(asked));
    tracked_.workspace.vertex_a = pairs.a;
    tracked_.workspace.vertex_b = pairs.b;
    tracked_.workspace.simplex_size = static_cast<int>(pairs.size);
  }

  /// The distance by GJK, from what is kept of the last search or walk.
  Distance searched() {
    ++tracked_.counts.searched;
    const Distance distance = distance_by_gjk(a_, b_, {}, &tracked_.workspace);
    const VertexPairs simplex = cached_simplex(tracked_.workspace, a_, b_);
    const std::optional<NearestFeatures> features = canonical_features(simplex);
    tracked_.cores_meet = !features;
    if (features) {
      tracked_.on_a = feature_of(*body_a_.parts, std::span(features->a).first(features->count_a));
      tracked_.on_b = feature_of(*body_b_.parts, std::span(features->b).first(features->count_b));
      if (!is_walked(tracked_.on_a, tracked_.on_b)) forget();
    }
    return told(distance);
  }

  const PosedPolytope& a_;
  const PosedPolytope& b_;
  WalkBody body_a_, body_b_;
  TrackedPair& tracked_;
  VoronoiPath* path_;
};

Distance answered(const PosedPolytope& a, const VoronoiRegions& regions_a, const PosedPolytope& b,
                  const VoronoiRegions& regions_b, TrackedPair& tracked, VoronoiPath* path) {
  require_regions_of(a, regions_a, "A");
  require_regions_of(b, regions_b, "B");
  return TrackedQuestion(a, regions_a, b, regions_b, tracked, path).distance();
}

}  // namespace

Distance distance_by_voronoi_walk(const PosedPolytope& a, const VoronoiRegions& regions_a, const PosedPolytope& b,
                                  const VoronoiRegions& regions_b, TrackedPair& tracked) {
  return answered(a, regions_a, b, regions_b, tracked, nullptr);
}

Distance distance_by_voronoi_walk(const PosedPolytope& a, const VoronoiRegions& regions_a, const PosedPolytope& b,
                                  const VoronoiRegions& regions_b, TrackedPair& tracked, VoronoiPath& path) {
  path = {};
  return answered(a, regions_a, b, regions_b, tracked, &path);
}

}  // namespace toccata
