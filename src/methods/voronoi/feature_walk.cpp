#include "methods/voronoi/feature_walk.hpp"

#include "math/constants.hpp"
#include "math/vec3_measures.hpp"

namespace toccata {
namespace {

/// A face in the world.
class WorldFace {
 public:
  WorldFace(const WalkBody& body, Index face) : body_(body), side_(body.parts->sides[face]) {
    // Normals turn by the matrix of cofactors, and round where the pose mirrors.
    const Mat3& r = body.pose->linear;
    const Mat3 cofactors{{cross(r[1], r[2]), cross(r[2], r[0]), cross(r[0], r[1])}};
    turn_ = dot(r[0], cofactors[0]) < 0 ? -1 : 1;
    const Vec3& own = side_.normal;
    normal_ = turn_ * Vec3{dot(cofactors[0], own), dot(cofactors[1], own), dot(cofactors[2], own)};
    first_ = body_.vertex(corner(0));
  }

  /// Outwards, of any length.
  [[nodiscard]] const Vec3& normal() const { return normal_; }

  /// How far above the plane a point is, in units of the normal.
  [[nodiscard]] double height(const Vec3& p) const { return dot(normal_, p - first_); }

  /// Visits the edge–face planes: each half-edge with where it starts and a normal into the face, of any length.
  template <class Visit>
  void for_each_rim(Visit visit) const {
    Vec3 start = first_;
    for (Index i = 0; i < side_.corner_count; ++i) {
      const Vec3 next = i + 1 < side_.corner_count ? body_.vertex(corner(i + 1)) : first_;
      visit(side_.first + i, start, turn_ * cross(normal_, next - start));
      start = next;
    }
  }

 private:
  /// In the order of the face.
  [[nodiscard]] Index corner(Index i) const {
    if (side_.corner_count != 3) return body_.parts->topology.origin[side_.first + i];
    return side_.triangle[i == 0 || !side_.is_turned ? i : 3 - i];
  }

  const WalkBody& body_;
  const RegionParts::Side& side_;
  double turn_ = 1;
  Vec3 normal_;
  Vec3 first_;
};

/// A step of the walk: through which plane, and how steeply it leads down.
struct Descent {
  std::size_t of = 0;  // whose feature becomes larger: 0, A; 1, B
  ConvexFeature to;
  double slope = 0;  // of the distance; negative
};

class WalkOfFeatures {
 public:
  WalkOfFeatures(const WalkBody& a, const WalkBody& b) : body_{a, b} {}

  /// The nearest points of two features, until the next are asked for; null where a vertex lies behind a face.
  const FeaturesNear* nearest(const ConvexFeature& on_a, const ConvexFeature& on_b) {
    best_.squared = infinity;
    if (on_a.kind == ConvexFeature::Kind::face) {
      if (!at_face(0, on_a.index, on_b.index)) return nullptr;
    } else if (on_b.kind == ConvexFeature::Kind::face) {
      if (!at_face(1, on_b.index, on_a.index)) return nullptr;
    } else {
      at_low_features(on_a, on_b);
    }
    return &best_;
  }

  /// The steepest way from the nearest points of two features to something nearer. `slope` is 0 where there is none;
  /// `below` tells that one leads behind a face.
  Descent steepest(const FeaturesNear& near, bool& below) const {
    Descent best;
    for (std::size_t of = 0; of < 2; ++of) {
      const Vec3 outward = of == 0 ? near.between : -near.between;
      const Vec3 own = body_[of].own(outward);
      const ConvexFeature& feature = near.feature[of];
      if (feature.kind == ConvexFeature::Kind::vertex) from_vertex(of, feature.index, own, best);
      if (feature.kind == ConvexFeature::Kind::edge && parts(of).has_faces())
        below |= !from_edge(of, feature.index, own, best);
    }
    return best;
  }

  /// The nearest that the larger feature has, until the next are asked for; null where the way leads behind a face.
  const FeaturesNear* after(const FeaturesNear& near, const Descent& step) {
    best_.squared = infinity;
    const std::size_t of = step.of, other = 1 - of;
    const ConvexFeature beside = near.feature[other];
    if (step.to.kind == ConvexFeature::Kind::face) {
      const bool found = beside.kind == ConvexFeature::Kind::vertex
                             ? at_face(of, step.to.index, beside.index)
                             : along_face(of, step.to.index, beside.index, near.on[other]);
      if (!found) return nullptr;
    } else if (beside.kind == ConvexFeature::Kind::face) {
      if (!along_face(other, beside.index, step.to.index, near.on[of])) return nullptr;
    } else {
      at_low_features(of == 0 ? step.to : beside, of == 0 ? beside : step.to);
    }
    return &best_;
  }

 private:
  [[nodiscard]] const RegionParts& parts(std::size_t of) const { return *body_[of].parts; }
  [[nodiscard]] Vec3 world(std::size_t of, Index vertex) const { return body_[of].vertex(vertex); }

  void offer(std::size_t of, const ConvexFeature& feature, const ConvexFeature& other, const Vec3& on,
             const Vec3& on_other, const Vec3& from_other) {
    const double squared = dot(from_other, from_other);
    if (!(squared < best_.squared)) return;
    best_.feature[of] = feature;
    best_.feature[1 - of] = other;
    best_.on[of] = on;
    best_.on[1 - of] = on_other;
    best_.between = of == 0 ? from_other : -from_other;
    best_.squared = squared;
  }

  void at_vertices(Index a, Index b) {
    const Vec3 on_a = world(0, a), on_b = world(1, b);
    offer(0, {ConvexFeature::Kind::vertex, a}, {ConvexFeature::Kind::vertex, b}, on_a, on_b, on_a - on_b);
  }

  struct Edge {
    Index half_edge = 0;  // that names it
    std::array<Index, 2> vertex{};
    Vec3 from, to;
  };

  [[nodiscard]] Edge edge(std::size_t of, Index half_edge) const {
    const RegionParts::Edge& own = parts(of).edge(half_edge);
    return {own.half_edge, own.vertex, world(of, own.vertex[0]), world(of, own.vertex[1])};
  }

  /// The edge is of one shape, the vertex of the other.
  void at_edge_and_vertex(std::size_t of, const Edge& edge, Index vertex, const Vec3& on_other) {
    const Vec3 along = edge.to - edge.from, first = edge.from - on_other;
    const double forth = -dot(first, along), whole = dot(along, along);
    const ConvexFeature other{ConvexFeature::Kind::vertex, vertex};
    if (!(forth > 0))
      return offer(of, {ConvexFeature::Kind::vertex, edge.vertex[0]}, other, edge.from, on_other, first);
    if (!(forth < whole))
      return offer(of, {ConvexFeature::Kind::vertex, edge.vertex[1]}, other, edge.to, on_other, edge.to - on_other);
    const Vec3 moved = (forth / whole) * along;
    offer(of, {ConvexFeature::Kind::edge, edge.half_edge}, other, edge.from + moved, on_other, first + moved);
  }

  void at_edges(const Edge& a, const Edge& b) {
    const Vec3 first = a.from - b.from, along_a = a.to - a.from, along_b = b.to - b.from;
    const Vec3 normal = cross(along_a, along_b);
    const double squared = dot(normal, normal);
    const double share_a = dot(cross(along_b, first), normal), share_b = dot(cross(along_a, first), normal);
    if (share_a > 0 && share_a < squared && share_b > 0 && share_b < squared) {
      const Vec3 between = (dot(normal, first) / squared) * normal;
      offer(0, {ConvexFeature::Kind::edge, a.half_edge}, {ConvexFeature::Kind::edge, b.half_edge},
            a.from + (share_a / squared) * along_a, b.from + (share_b / squared) * along_b, between);
      return;
    }
    at_edge_and_vertex(0, a, b.vertex[0], b.from);
    at_edge_and_vertex(0, a, b.vertex[1], b.to);
    at_edge_and_vertex(1, b, a.vertex[0], a.from);
    at_edge_and_vertex(1, b, a.vertex[1], a.to);
  }

  void at_low_features(const ConvexFeature& a, const ConvexFeature& b) {
    if (a.kind == ConvexFeature::Kind::vertex && b.kind == ConvexFeature::Kind::vertex)
      return at_vertices(a.index, b.index);
    if (a.kind == ConvexFeature::Kind::vertex)
      return at_edge_and_vertex(1, edge(1, b.index), a.index, world(0, a.index));
    if (b.kind == ConvexFeature::Kind::vertex)
      return at_edge_and_vertex(0, edge(0, a.index), b.index, world(1, b.index));
    at_edges(edge(0, a.index), edge(1, b.index));
  }

  /// A vertex over a face, or beside it; no where it lies behind.
  [[nodiscard]] bool at_face(std::size_t of, Index face, Index vertex) {
    const WorldFace plane(body_[of], face);
    const Vec3 p = world(1 - of, vertex);
    const double above = plane.height(p);
    if (!(above > 0)) return false;
    bool inside = true;
    plane.for_each_rim([&](Index h, const Vec3& start, const Vec3& into) {
      if (dot(into, p - start) > 0) return;
      inside = false;
      at_edge_and_vertex(of, edge(of, h), vertex, p);
    });
    if (!inside) return true;
    const Vec3 up = (above / dot(plane.normal(), plane.normal())) * plane.normal();
    offer(of, {ConvexFeature::Kind::face, face}, {ConvexFeature::Kind::vertex, vertex}, p - up, p, -up);
    return true;
  }

  /// An edge over a face, from one of its points downhill to its end or to where it leaves the face; no where it goes
  /// behind before.
  [[nodiscard]] bool along_face(std::size_t of, Index face, Index half_edge, const Vec3& start) {
    const WorldFace plane(body_[of], face);
    const Edge over = edge(1 - of, half_edge);
    const bool forth = dot(plane.normal(), over.to - over.from) < 0;
    const Vec3 way = (forth ? over.to : over.from) - start;
    bool inside = true;
    double share = 1;
    std::optional<Index> out;
    plane.for_each_rim([&](Index h, const Vec3& corner, const Vec3& into) {
      const double height = dot(into, start - corner), falls = -dot(into, way);
      if (height < 0) {
        inside = false;
        beside_face(of, h, over);
      } else if (falls > 0 && height < share * falls) {
        share = height / falls;
        out = h;
      }
    });
    if (!inside) return true;
    if (!(plane.height(start + share * way) > 0)) return false;
    if (!out) return at_face(of, face, over.vertex[forth ? 1 : 0]);
    beside_face(of, *out, over);
    return true;
  }

  /// Two edges: one of the face that is left, and the one that leaves it.
  void beside_face(std::size_t of, Index rim, const Edge& over) {
    if (of == 0)
      at_edges(edge(0, rim), over);
    else
      at_edges(over, edge(1, rim));
  }

  void from_vertex(std::size_t of, Index vertex, const Vec3& outward, Descent& best) const {
    const RegionParts& p = parts(of);
    const Vec3 start = p.vertex(vertex);
    for (const RegionParts::Spoke& spoke : p.spokes_at(vertex)) {
      const Vec3 way = p.vertex(spoke.vertex) - start;
      const double falls = dot(outward, way);
      if (!(falls < 0)) continue;
      const double slope = falls / plain_length(way);
      if (slope < best.slope) best = {of, {ConvexFeature::Kind::edge, p.edge_of(spoke.half_edge)}, slope};
    }
  }

  /// No where every way into a face leads behind it.
  [[nodiscard]] bool from_edge(std::size_t of, Index edge, const Vec3& outward, Descent& best) const {
    const RegionParts& p = parts(of);
    const Index number = p.edge_number[edge];
    const auto [least, greatest] = p.edges[number].vertex;
    Vec3 way = p.vertex(greatest) - p.vertex(least);
    const double per_length = 1 / plain_length(way);
    bool falls = false, stays = false;
    for (const Index face : p.faces_at[number]) {
      const Vec3& normal = p.sides[face].normal;
      const double slope = per_length * dot(outward, cross(normal, way));
      way = -way;  // as the other face sees it
      if (!(slope < 0)) continue;
      falls = true;
      if (!(dot(outward, normal) < 0)) continue;
      stays = true;
      if (slope < best.slope) best = {of, {ConvexFeature::Kind::face, face}, slope};
    }
    return stays || !falls;
  }

  std::array<WalkBody, 2> body_;
  FeaturesNear best_;
};

/// The walk from the features to the nearest ones.
FeatureWalk walked(WalkOfFeatures& walk, const ConvexFeature& on_a, const ConvexFeature& on_b, VoronoiPath* path) {
  const FeaturesNear* const start = walk.nearest(on_a, on_b);
  if (start == nullptr) return {{{on_a, on_b}, {}, {}, 0}, WalkEnd::below, 0};
  FeatureWalk result{*start, WalkEnd::nearest, 0};
  const auto visit = [&](const FeaturesNear& near) {
    if (path != nullptr)
      path->visits.push_back({near.feature[0], near.feature[1], near.on[0], near.on[1], near.squared});
  };
  visit(*start);
  while (true) {
    bool below = false;
    const Descent step = walk.steepest(result.near, below);
    result.end = below ? WalkEnd::below : WalkEnd::nearest;
    if (!(step.slope < 0)) return result;
    ++result.steps;
    const FeaturesNear* const next = walk.after(result.near, step);
    result.end = next != nullptr ? WalkEnd::tie : WalkEnd::below;
    // Strictly: the squares of distances that were reached never come again, and there are finitely many.
    if (next == nullptr || !(next->squared < result.near.squared)) return result;
    result.near = *next;
    visit(*next);
  }
}

}  // namespace

FeatureWalk walk_features(const WalkBody& a, const WalkBody& b, const ConvexFeature& on_a, const ConvexFeature& on_b,
                          VoronoiPath* path) {
  if (path != nullptr) path->visits.clear();
  WalkOfFeatures walk(a, b);
  const FeatureWalk result = walked(walk, on_a, on_b, path);
  if (path != nullptr) path->end = result.end;
  return result;
}

}  // namespace toccata
