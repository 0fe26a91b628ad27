#include "query/volume/winding_volume.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <tuple>
#include <utility>

#include "query/meshes/pair_search.hpp"
#include "query/meshes/world_search.hpp"
#include "query/volume/perturbed_pair.hpp"
#include "shapes/union_find.hpp"

namespace toccata {
namespace {

/// Two triangles that cross, and where.
struct CrossingPair {
  Index of_first = 0;
  Index of_second = 0;
  EdgesThrough through;
};

BoundedVector seen_from_origin(const Vec3& p, const Vec3& origin) { return bounded_difference(p, origin); }

BoundedNumber counted_as(int count, const BoundedNumber& number) {
  return exactly(static_cast<double>(count)) * number;
}

/// The share of the way from `from` to `to`, on both sides of the plane or on it, at which the plane is.
BoundedNumber share_at_plane(const Triangle& plane, const Vec3& from, const Vec3& to) {
  const BoundedVector normal = cross(bounded_difference(plane[1], plane[0]), bounded_difference(plane[2], plane[0]));
  const BoundedNumber share =
      dot(normal, bounded_difference(from, plane[0])) / dot(normal, bounded_difference(from, to));
  if (share.error < 0.25) return share;
  return {{0.5, 0}, 0.25};  // between 0 and 1 in any case
}

BoundedVector normal_of(const Triangle& t) {
  return cross(bounded_difference(t[1], t[0]), bounded_difference(t[2], t[0]));
}

/// One of the two solids while the other's winding numbers are looked at on its surface.
class VolumeSurface {
 public:
  VolumeSurface(const PosedMesh& mesh, const PosedMesh& other, VolumeSide side, const Aabb& region)
      : graph_(mesh), other_(other), side_(side), triangles_(triangles_in_region(mesh, region)) {}

  [[nodiscard]] Triangle triangle(Index number) const { return graph_.mesh().triangle(number); }
  [[nodiscard]] VertexGraph& graph() { return graph_; }
  [[nodiscard]] const std::vector<Index>& triangles() const { return triangles_; }

  /// The winding number at a vertex, as the graph numbers it.
  [[nodiscard]] int winding_at(Index vertex) {
    const auto [found, is_new] = windings_.try_emplace(vertex, 0);
    if (is_new) found->second = perturbed_winding(graph_.position(vertex), side_, other_);
    return found->second;
  }

  /// What is the same for all vertices that triangles without contact join is asked once: of each triangle without
  /// contact the winding number on it. `in_contact` is ascending.
  [[nodiscard]] std::vector<std::pair<Index, int>> whole_triangles(std::span<const Index> in_contact) {
    std::vector<Index> whole;
    for (const Index t : triangles_)
      if (!std::binary_search(in_contact.begin(), in_contact.end(), t)) whole.push_back(t);
    std::vector<std::array<Index, 3>> corners;
    for (const Index t : whole) corners.push_back(graph_.corners(t));
    UnionFind joined(graph_.vertex_count());
    for (const auto& c : corners) {
      joined.unite(c[0], c[1]);
      joined.unite(c[0], c[2]);
    }
    std::vector<std::pair<Index, int>> found;
    for (std::size_t i = 0; i < whole.size(); ++i)
      if (const int winding = winding_at(joined.leader(corners[i][0])); winding != 0)
        found.emplace_back(whole[i], winding);
    for (const auto& c : corners)
      for (const Index vertex : c) windings_.try_emplace(vertex, winding_at(joined.leader(vertex)));
    return found;
  }

 private:
  VertexGraph graph_;
  const PosedMesh& other_;
  VolumeSide side_;
  std::vector<Index> triangles_;
  std::map<Index, int> windings_;
};

/// What a triangle in contact adds: its vertices, and twice the area of what of it is inside, along its normal.
class PartlyInside {
 public:
  explicit PartlyInside(const Triangle& triangle) : triangle_(triangle) {}

  /// A segment of the border, seen against the normal with the inside to its left.
  void add_segment(const BoundedVector& from, const BoundedVector& to) { twice_ = twice_ + cross(from, to); }

  /// Adds how much is inside of the edge from vertex 1 to 2, the only one that the vertex 0 does not lie on.
  void add_far_edge(const BoundedNumber& inside) { twice_ = twice_ + inside * normal_of(triangle_); }

  /// Six times the volume of the pyramids over it.
  [[nodiscard]] BoundedNumber six_volumes(const Vec3& origin) const {
    return dot(seen_from_origin(triangle_[0], origin), twice_);
  }

 private:
  Triangle triangle_;
  BoundedVector twice_{};
};

class VolumeIntegral {
 public:
  VolumeIntegral(const PosedMesh& first, const PosedMesh& second, const Aabb& region)
      : origin_(0.5 * region.lower + 0.5 * region.upper),
        first_(first, second, VolumeSide::first, region),
        second_(second, first, VolumeSide::second, region) {}

  [[nodiscard]] WindingVolume over(std::span<const Contact> contacts) {
    for (const Contact& contact : contacts) see(contact);
    WindingVolume result;
    BoundedNumber six = six_of_whole(first_, VolumeSide::first) + six_of_whole(second_, VolumeSide::second);
    add_crossings();
    for (auto& [number, part] : partly_) six = six + part.six_volumes(origin_);
    result.integral = six / exactly(6);
    result.curve_count = curves_.count();
    if (end_count_ > 0) result.middle = middle_of_ends();
    return result;
  }

 private:
  using SurfaceTriangle = std::pair<VolumeSide, Index>;

  void see(const Contact& contact) {
    touched_[0].push_back(contact.triangle_a);
    touched_[1].push_back(contact.triangle_b);
    const Triangle a = first_.triangle(contact.triangle_a), b = second_.triangle(contact.triangle_b);
    if (!has_area(a) || !has_area(b)) return;
    const EdgesThrough through = perturbed_edges_through(a, b);
    if (through.any()) pairs_.push_back({contact.triangle_a, contact.triangle_b, through});
  }

  /// Six times the volume of the pyramids over the triangles that no contact cuts; those that one does are prepared.
  [[nodiscard]] BoundedNumber six_of_whole(VolumeSurface& surface, VolumeSide side) {
    std::vector<Index>& in_contact = touched_[side == VolumeSide::first ? 0 : 1];
    std::sort(in_contact.begin(), in_contact.end());
    in_contact.erase(std::unique(in_contact.begin(), in_contact.end()), in_contact.end());
    BoundedNumber six;
    for (const auto& [number, winding] : surface.whole_triangles(in_contact)) {
      const Triangle t = surface.triangle(number);
      six = six + counted_as(winding, dot(seen_from_origin(t[0], origin_), normal_of(t)));
    }
    for (const Index number : in_contact) {
      const Triangle t = surface.triangle(number);
      if (!has_area(t)) continue;
      PartlyInside part(t);
      if (const int winding = surface.winding_at(surface.graph().corners(number)[1]); winding != 0)
        part.add_far_edge(exactly(winding));
      partly_.emplace(SurfaceTriangle{side, number}, part);
    }
    return six;
  }

  void add_crossings() {
    for (const CrossingPair& pair : pairs_) {
      add_crossing(pair);
      curves_.add(first_.graph(), pair.of_first, second_.graph(), pair.of_second, pair.through);
    }
  }

  /// The segment that both have in common, as a part of the border of what of each is inside the other.
  void add_crossing(const CrossingPair& pair) {
    const Triangle a = first_.triangle(pair.of_first), b = second_.triangle(pair.of_second);
    PartlyInside& part_a = partly_.at({VolumeSide::first, pair.of_first});
    PartlyInside& part_b = partly_.at({VolumeSide::second, pair.of_second});
    PassedEdge tail, head;
    for (int i = 0; i < 3; ++i) {
      if (const int through = pair.through.of_first[static_cast<std::size_t>(i)]; through != 0) {
        PassedEdge& end = through > 0 ? head : tail;
        end = {a[i], a[(i + 1) % 3], share_at_plane(b, a[i], a[(i + 1) % 3])};
        note_end(end);
        if (i == 1) part_a.add_far_edge(counted_as(through, exactly(1) - end.share));
      }
      if (const int through = pair.through.of_second[static_cast<std::size_t>(i)]; through != 0) {
        PassedEdge& end = through > 0 ? tail : head;
        end = {b[i], b[(i + 1) % 3], share_at_plane(a, b[i], b[(i + 1) % 3])};
        note_end(end);
        if (i == 1) part_b.add_far_edge(counted_as(through, exactly(1) - end.share));
      }
    }
    part_a.add_segment(tail.seen_from(a[0]), head.seen_from(a[0]));
    part_b.add_segment(head.seen_from(b[0]), tail.seen_from(b[0]));
  }

  struct PassedEdge {
    Vec3 from;
    Vec3 to;
    BoundedNumber share;

    [[nodiscard]] BoundedVector seen_from(const Vec3& p) const {
      return bounded_difference(from, p) + share * bounded_difference(to, from);
    }
  };

  void note_end(const PassedEdge& end) {
    at_ends_ = at_ends_ + (end.from + end.share.value.high * (end.to - end.from) - origin_);
    ++end_count_;
  }

  [[nodiscard]] Vec3 middle_of_ends() const { return origin_ + (1.0 / static_cast<double>(end_count_)) * at_ends_; }

  Vec3 origin_;
  VolumeSurface first_;
  VolumeSurface second_;
  std::array<std::vector<Index>, 2> touched_;
  std::vector<CrossingPair> pairs_;
  std::map<SurfaceTriangle, PartlyInside> partly_;
  CrossingCurves curves_;
  Vec3 at_ends_;
  std::size_t end_count_ = 0;
};

}  // namespace

std::vector<Index> triangles_in_region(const PosedMesh& mesh, const Aabb& region) {
  std::vector<Index> found;
  visit_triangles_near(mesh, region, [&](Index number) {
    if (has_area(mesh.triangle(number))) found.push_back(number);
    return true;
  });
  std::sort(found.begin(), found.end());
  return found;
}

Aabb common_box(const Aabb& a, const Aabb& b) {
  return {{std::max(a.lower.x, b.lower.x), std::max(a.lower.y, b.lower.y), std::max(a.lower.z, b.lower.z)},
          {std::min(a.upper.x, b.upper.x), std::min(a.upper.y, b.upper.y), std::min(a.upper.z, b.upper.z)}};
}

WindingVolume winding_volume(const PosedMesh& first, const PosedMesh& second, SearchScratch& scratch) {
  const Aabb region = common_box(first.box(), second.box());
  if (!overlap(first.box(), second.box())) return {};
  const auto contacts = surface_contacts(first, second, scratch);
  return VolumeIntegral(first, second, region).over(contacts);
}

}  // namespace toccata
