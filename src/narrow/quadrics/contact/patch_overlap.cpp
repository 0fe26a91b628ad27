#include "narrow/quadrics/contact/patch_overlap.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "toccata/math/trigonometry.hpp"

// Everything here is seen along the normal: of a vector, x and y are looked at.
namespace toccata {
namespace {

using PatchKind = ContactPatch::Kind;

constexpr int rim_parts = 16;

/// A rim that leans less than this part of its radius is level; and less than what is rounding, in a pair of size 1.
constexpr double level_part = 0x1p-30;
constexpr double level_rounding = 0x1p-44;

double flat_dot(const Vec3& u, const Vec3& v) { return u.x * v.x + u.y * v.y; }
double flat_cross(const Vec3& u, const Vec3& v) { return u.x * v.y - u.y * v.x; }
double flat_length(const Vec3& u) { return std::sqrt(flat_dot(u, u)); }
Vec3 flat_unit(const Vec3& u) { return (1 / flat_length(u)) * Vec3{u.x, u.y, 0}; }

/// The part of a way from 0 to 1 that lies within a patch, and what of the patch is there at its ends.
struct Clip {
  double from = 0;
  double to = 1;
  ConvexFeature at_from;
  ConvexFeature at_to;

  [[nodiscard]] bool is_empty() const { return !(from <= to); }

  /// Takes off what is higher than 0; the height is linear.
  void take_off(double at_begin, double at_end, const ConvexFeature& side) {
    if (at_begin > 0 && at_end > 0) {
      to = -1;
    } else if (at_begin > 0) {
      begin(at_begin / (at_begin - at_end), side);
    } else if (at_end > 0) {
      end(at_begin / (at_begin - at_end), side);
    }
  }
  void begin(double at, const ConvexFeature& side) {
    if (at <= from) return;
    from = at;
    at_from = side;
  }
  void end(double at, const ConvexFeature& side) {
    if (at >= to) return;
    to = at;
    at_to = side;
  }
};

/// How far a point lies beyond a side of a polygon, times its length.
double beyond(const ContactPatch& polygon, std::size_t side, const Vec3& p) {
  const Vec3& from = polygon.corners[side].at;
  const Vec3& to = polygon.corners[(side + 1) % polygon.corners.size()].at;
  return -polygon.turn * flat_cross(to - from, p - from);
}

void clip_by_polygon(Clip& clip, const ContactPatch& polygon, const Vec3& p, const Vec3& q) {
  for (std::size_t i = 0; i < polygon.corners.size(); ++i)
    clip.take_off(beyond(polygon, i, p), beyond(polygon, i, q), polygon.corners[i].to_next);
}

/// Clips by a disc, from the part of the way that is the nearest to the disc's middle, where the disc's units are the
/// finest: what is far from a slim disc would lose all digits of where the way enters it.
void clip_by_disc(Clip& clip, const ContactPatch& disc, const Vec3& p, const Vec3& q) {
  const Vec3 along = q - p, from_p = disc.on_unit_disc(p), way = disc.on_unit_disc(q) - from_p;
  const double a = flat_dot(way, way);
  double amid = a > 0 ? -flat_dot(from_p, way) / a : 0;
  const Vec3 u = disc.on_unit_disc(p + amid * along);
  const double b = flat_dot(u, way), c = flat_dot(u, u) - 1, squared = b * b - a * c;
  if (!(a > 0) || !(squared >= 0)) {
    if (!(a == 0 && c <= 0)) clip.to = -1;
    return;
  }
  amid -= b / a;
  const double half = std::sqrt(squared) / a;
  clip.begin(amid - half, disc.rim_at(disc.on_unit_disc(p + (amid - half) * along)));
  clip.end(amid + half, disc.rim_at(disc.on_unit_disc(p + (amid + half) * along)));
}

/// Between the planes across the ends of a line along it; of others nothing.
void clip_by_line(Clip& clip, const ContactPatch& line, const Vec3& p, const Vec3& q) {
  const Vec3 from = line.corners[0].at, to = line.corners[1].at, along = to - from;
  if (!(std::fabs(flat_cross(along, q - p)) <= cosine_across * flat_length(along) * flat_length(q - p))) {
    clip.to = -1;
    return;
  }
  clip.take_off(flat_dot(along, from - p), flat_dot(along, from - q), line.corners[0].here);
  clip.take_off(flat_dot(along, p - to), flat_dot(along, q - to), line.corners[1].here);
}

std::optional<Clip> clipped(const ContactPatch& patch, const Vec3& p, const Vec3& q) {
  Clip clip{.at_from = patch.whole, .at_to = patch.whole};
  if (patch.kind == PatchKind::polygon) clip_by_polygon(clip, patch, p, q);
  if (patch.kind == PatchKind::disc) clip_by_disc(clip, patch, p, q);
  if (patch.kind == PatchKind::line) clip_by_line(clip, patch, p, q);
  if (clip.is_empty()) return {};
  return clip;
}

bool contains(const ContactPatch& area, const Vec3& p) {
  if (area.kind == PatchKind::disc) {
    const Vec3 u = area.on_unit_disc(p);
    return flat_dot(u, u) <= 1;
  }
  for (std::size_t i = 0; i < area.corners.size(); ++i)
    if (beyond(area, i, p) > 0) return false;
  return true;
}

/// One rim as another disc's unit disc sees it: above 0 outside of it.
struct RimHeight {
  const ContactPatch& rim;
  const ContactPatch& disc;

  double operator()(const Vec3& u) const {
    const Vec3 seen = disc.on_unit_disc(rim.of_unit_disc(u));
    return flat_dot(seen, seen) - 1;
  }
};

/// Half way around between two points of the unit circle.
Vec3 half_way_around(const Vec3& u, const Vec3& v) { return flat_unit(u + v); }

constexpr int halvings = 52;

/// Where the height changes its sign between two points.
Vec3 zero_between(const RimHeight& height, Vec3 u, Vec3 v) {
  const bool above = height(u) > 0;
  for (int i = 0; i < halvings; ++i) {
    const Vec3 middle = half_way_around(u, v);
    ((height(middle) > 0) == above ? u : v) = middle;
  }
  return u;
}

/// The point between two others of least `sign` · height, where there is but one such.
Vec3 extreme_between(const RimHeight& height, double sign, Vec3 u, Vec3 v) {
  for (int i = 0; i < halvings; ++i) {
    const Vec3 middle = half_way_around(u, v), left = half_way_around(u, middle), right = half_way_around(middle, v);
    if (sign * height(left) <= sign * height(right))
      v = right;
    else
      u = left;
  }
  return half_way_around(u, v);
}

/// The last part of the way from one that there is a height for to another one.
template <class Height>
double last_within(const Height& height, double within, double part) {
  if (height(part)) return part;
  double beyond = part;
  for (int i = 0; i < halvings; ++i) {
    const double middle = 0.5 * (within + beyond);
    (height(middle) ? within : beyond) = middle;
  }
  return within;
}

class CommonPointsOfPatches {
 public:
  CommonPointsOfPatches(const ContactPatch& a, const ContactPatch& b, std::pmr::memory_resource& memory)
      : patch_{&a, &b}, points_(&memory) {}

  std::pmr::vector<CommonPoint> all() {
    const auto is = [&](std::size_t i, PatchKind kind) { return patch_[i]->kind == kind; };
    if (is(0, PatchKind::point) || is(1, PatchKind::point)) return std::move(points_);
    if (is(0, PatchKind::line) && is(1, PatchKind::line)) {
      add_along(patch_[0]->side && !patch_[1]->side ? 1 : 0);
      return std::move(points_);
    }
    if (is(0, PatchKind::line) || is(1, PatchKind::line)) {
      add_straight(is(0, PatchKind::line) ? 0 : 1);
      return std::move(points_);
    }
    for (const std::size_t i : {0U, 1U})
      if (is(i, PatchKind::disc)) add_rim(i);
    if (is(0, PatchKind::disc) && is(1, PatchKind::disc)) add_crossings_of_rims();
    for (const std::size_t i : {0U, 1U})
      if (is(i, PatchKind::polygon)) add_straight(i);
    return std::move(points_);
  }

 private:
  /// Features of patch i and of the other one.
  void add(std::size_t i, const Vec3& p, const ConvexFeature& mine, const ConvexFeature& others) {
    add(i, p, {patch_[0]->height(p), patch_[1]->height(p)}, mine, others);
  }
  void add(std::size_t i, const Vec3& p, const std::array<double, 2>& height, const ConvexFeature& mine,
           const ConvexFeature& others) {
    points_.push_back({{p.x, p.y, 0.5 * (height[0] + height[1])},
                       height[0] - height[1],
                       i == 0 ? mine : others,
                       i == 0 ? others : mine});
  }

  /// The ends of what a line and another one along it have in common. They may cross under a small angle: points are on
  /// the first line, and beside the other one, on its round side.
  void add_along(std::size_t i) {
    const Vec3 &from = patch_[i]->corners[0].at, way = patch_[i]->corners[1].at - from;
    const ContactPatch& other = *patch_[1 - i];
    const std::optional<Clip> clip = clipped(other, from, from + way);
    if (!clip) return;
    const auto height = [&](double part) {
      const Vec3 p = from + part * way;
      return other.side->height_near({p.x, p.y, other.height(p)});
    };
    const double amid = std::clamp(-flat_dot(from, way) / flat_dot(way, way), clip->from, clip->to);
    const auto add_end = [&](double part, const ConvexFeature& mine, const ConvexFeature& others) {
      const double last = last_within(height, amid, part);
      const Vec3 p = from + last * way;
      const std::optional<double> there = height(last);
      if (!there) return;
      const bool is_end = last == part && (part == 0 || part == 1);
      add(i, p, i == 0 ? std::array{p.z, *there} : std::array{*there, p.z}, is_end ? mine : patch_[i]->whole, others);
    };
    add_end(clip->from, patch_[i]->corners[0].here, clip->at_from);
    add_end(clip->to, patch_[i]->corners[1].here, clip->at_to);
  }

  /// The straight sides of a patch as far as they lie within the other one.
  void add_straight(std::size_t i) {
    const ContactPatch &mine = *patch_[i], &other = *patch_[1 - i];
    const bool is_line = mine.kind == PatchKind::line;
    for (std::size_t k = 0; k < (is_line ? 1 : mine.corners.size()); ++k) {
      const PatchCorner &p = mine.corners[k], &q = mine.corners[(k + 1) % mine.corners.size()];
      const std::optional<Clip> clip = clipped(other, p.at, q.at);
      if (!clip) continue;
      const ConvexFeature& side = is_line ? mine.whole : p.to_next;
      add(i, p.at + clip->from * (q.at - p.at), clip->from > 0 ? side : p.here, clip->at_from);
      // Where a polygon's side ends the next begins.
      if (is_line || clip->to < 1) add(i, p.at + clip->to * (q.at - p.at), clip->to < 1 ? side : q.here, clip->at_to);
    }
  }

  /// Where a rim begins to be counted: where it is deepest, or, when it is level, at a point of its own.
  [[nodiscard]] Vec3 first_of_rim(std::size_t i) const {
    const ContactPatch& disc = *patch_[i];
    const auto depth = [&](const Vec3& u) {
      const Vec3 p = disc.of_unit_disc(u);
      return patch_[0]->height(p) - patch_[1]->height(p);
    };
    const double level = depth({});
    const Vec3 slope{depth({1, 0, 0}) - level, depth({0, 1, 0}) - level, 0};
    const double radius = std::fmax(flat_length(disc.column[0]), flat_length(disc.column[1]));
    if (flat_length(slope) > std::fmax(level_part * radius, level_rounding)) return flat_unit(slope);
    return flat_unit({1, 1, 0});
  }

  [[nodiscard]] static Vec3 turned(const Vec3& u, int parts) {
    const SineCosine turn = sine_cosine_of_turns(static_cast<double>(parts) / rim_parts);
    return {u.x * turn.cosine - u.y * turn.sine, u.x * turn.sine + u.y * turn.cosine, 0};
  }

  void add_rim(std::size_t i) {
    const ContactPatch &mine = *patch_[i], &other = *patch_[1 - i];
    const Vec3 first = first_of_rim(i);
    for (int k = 0; k < rim_parts; ++k) {
      const Vec3 u = turned(first, k), p = mine.of_unit_disc(u);
      if (contains(other, p)) add(i, p, mine.rim_at(u), other.whole);
    }
  }

  void add_crossings_of_rims() {
    const RimHeight height{*patch_[0], *patch_[1]};
    constexpr int parts = 2 * rim_parts;
    std::array<Vec3, parts> u;
    std::array<double, parts> h{};
    for (std::size_t k = 0; k < parts; ++k) {
      const SineCosine turn = sine_cosine_of_turns(static_cast<double>(k) / parts);
      u[k] = {turn.cosine, turn.sine, 0};
      h[k] = height(u[k]);
    }
    for (std::size_t k = 0; k < parts; ++k) {
      const std::size_t next = (k + 1) % parts, after = (k + 2) % parts;
      if ((h[k] > 0) != (h[next] > 0)) {
        add_crossing(zero_between(height, u[k], u[next]));
      } else if (const double sign = h[next] > 0 ? 1 : -1;
                 (h[after] > 0) == (h[next] > 0) && sign * h[next] <= sign * h[k] && sign * h[next] < sign * h[after]) {
        add_crossings_around(height, sign, u[k], u[after]);
      }
    }
  }

  /// Between two points of the rim that are both outside, or both inside, it may be the other way.
  void add_crossings_around(const RimHeight& height, double sign, const Vec3& u, const Vec3& v) {
    const Vec3 extreme = extreme_between(height, sign, u, v);
    if ((height(extreme) > 0) == (sign > 0)) return;
    add_crossing(zero_between(height, u, extreme));
    add_crossing(zero_between(height, v, extreme));
  }

  void add_crossing(const Vec3& u) {
    const Vec3 p = patch_[0]->of_unit_disc(u);
    add(0, p, patch_[0]->rim_at(u), patch_[1]->rim_at(patch_[1]->on_unit_disc(p)));
  }

  std::array<const ContactPatch*, 2> patch_;
  std::pmr::vector<CommonPoint> points_;
};

}  // namespace

std::pmr::vector<CommonPoint> common_points(const ContactPatch& a, const ContactPatch& b,
                                            std::pmr::memory_resource& memory) {
  return CommonPointsOfPatches(a, b, memory).all();
}

}  // namespace toccata
