#include "query/volume/winding_volume.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "query/volume/perturbed_pair.hpp"

namespace toccata {
namespace {

BoundedVector seen_from_origin(const Vec3& p, const Vec3& origin) { return bounded_difference(p, origin); }

BoundedNumber counted_as(int count, const BoundedNumber& number) {
  return exactly(static_cast<double>(count)) * number;
}

BoundedVector normal_of(const Triangle& t) {
  return cross(bounded_difference(t[1], t[0]), bounded_difference(t[2], t[0]));
}

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
  VolumeIntegral(CrossedSurfaces& surfaces, const Vec3& origin)
      : surfaces_(surfaces), first_(surfaces.first), second_(surfaces.second), origin_(origin) {}

  [[nodiscard]] WindingVolume found() {
    WindingVolume result;
    BoundedNumber six = six_of_whole(first_) + six_of_whole(second_);
    add_crossings();
    for (auto& [number, part] : partly_) six = six + part.six_volumes(origin_);
    result.integral = six / exactly(6);
    result.curve_count = curves_.count();
    if (end_count_ > 0) result.middle = middle_of_ends();
    return result;
  }

 private:
  using SurfaceTriangle = std::pair<VolumeSide, Index>;

  /// Six times the volume of the pyramids over the triangles that no contact cuts; those that one does are prepared.
  [[nodiscard]] BoundedNumber six_of_whole(VolumeSurface& surface) {
    BoundedNumber six;
    for (const auto& [number, winding] : surface.whole_triangles()) {
      const Triangle t = surface.triangle(number);
      six = six + counted_as(winding, dot(seen_from_origin(t[0], origin_), normal_of(t)));
    }
    for (const Index number : surface.in_contact()) {
      PartlyInside part(surface.triangle(number));
      if (const int winding = surface.winding_at(surface.graph().corners(number)[1]); winding != 0)
        part.add_far_edge(exactly(winding));
      partly_.emplace(SurfaceTriangle{surface.side(), number}, part);
    }
    return six;
  }

  void add_crossings() {
    for (const CrossingPair& pair : surfaces_.pairs) {
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

  CrossedSurfaces& surfaces_;
  VolumeSurface& first_;
  VolumeSurface& second_;
  Vec3 origin_;
  std::map<SurfaceTriangle, PartlyInside> partly_;
  CrossingCurves curves_;
  Vec3 at_ends_;
  std::size_t end_count_ = 0;
};

}  // namespace

WindingVolume winding_volume(CrossedSurfaces& surfaces) {
  const Aabb region = common_box(surfaces.first.mesh().box(), surfaces.second.mesh().box());
  return VolumeIntegral(surfaces, 0.5 * region.lower + 0.5 * region.upper).found();
}

}  // namespace toccata
