// Compiled once for every SIMD level; Highway includes this file into itself.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "narrow/convex/fast_expansion.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include <algorithm>
#include <bit>
#include <cmath>

#include "math/lanes.hpp"
#include "math/vec3_measures.hpp"
#include "narrow/convex/fast_expansion.hpp"
#include "narrow/convex/vertices_of.hpp"

HWY_BEFORE_NAMESPACE();
namespace toccata {
namespace HWY_NAMESPACE {
namespace {

constexpr Index vertices_at_once = static_cast<Index>(hn::MaxLanes(tag));

/// A start of twelve directions: those to the corners of an icosahedron, turned so that none lies in a plane of
/// symmetry of a shape along the axes. Six, and the six across.
constexpr std::array<Vec3, 6> start_axes{{{-0.3396, -0.4877, 0.8042},
                                          {0.6635, -0.5593, 0.497},
                                          {-0.6895, 0.4707, 0.5504},
                                          {-0.9334, -0.3549, -0.0533},
                                          {0.2974, 0.3444, 0.8905},
                                          {0.0972, 0.9915, 0.0863}}};
constexpr std::array<FacetSlots::Corners, 20> icosahedron_faces{
    {{0, 1, 4},  {0, 2, 3}, {0, 3, 11}, {0, 4, 2}, {0, 11, 1}, {1, 8, 9},   {1, 9, 4},
     {1, 11, 8}, {2, 4, 5}, {2, 5, 7},  {2, 7, 3}, {3, 7, 10}, {3, 10, 11}, {4, 9, 5},
     {5, 6, 7},  {5, 9, 6}, {6, 8, 10}, {6, 9, 8}, {6, 10, 7}, {8, 11, 10}}};

constexpr std::array<std::uint16_t, 80> twins_of_icosahedron() {
  std::array<std::uint16_t, 80> twins{};
  for (std::uint16_t e = 0; e < 80; ++e)
    for (std::uint16_t f = 0; f < 80; ++f)
      if (e % 4 < 3 && f % 4 < 3 && icosahedron_faces[e / 4][e % 4] == icosahedron_faces[f / 4][(f % 4 + 1) % 3] &&
          icosahedron_faces[f / 4][f % 4] == icosahedron_faces[e / 4][(e % 4 + 1) % 3])
        twins[e] = f;
  return twins;
}
constexpr std::array<std::uint16_t, 80> icosahedron_twins = twins_of_icosahedron();

/// A number whose last bits are exchanged for an index: the greatest of many then tells its own, and which of nearly
/// equal ones it is does not depend on the order in which they are looked at.
constexpr std::uint64_t chunk = 64;
constexpr std::uint64_t facet_bits = 511;
static_assert(FastSurface::most_facets <= facet_bits);

/// One of the shapes, to be searched in its own frame.
class SearchedShape {
 public:
  explicit SearchedShape(const PosedPolytope& posed) : shape_(posed) {
    const Mat3& m = posed.pose().linear;
    if (!posed.in_world()) world_in_local_ = {{m.column(0), m.column(1), m.column(2)}};
  }

  /// In the world; the formula of docs/truth.md.
  [[nodiscard]] HWY_INLINE Vec3 vertex(Index i) const {
    const Vec3 v{shape_.along(0)[i], shape_.along(1)[i], shape_.along(2)[i]};
    const Pose& pose = shape_.pose();
    if (shape_.in_world()) return v;
    return {dot(pose.linear[0], v) + pose.offset.x, dot(pose.linear[1], v) + pose.offset.y,
            dot(pose.linear[2], v) + pose.offset.z};
  }

  /// The vertex of the greatest height along a world direction, up to 2^-46 of the greatest magnitude of a height.
  [[nodiscard]] HWY_INLINE Index farthest(const Vec3& along) const {
    const Vec3 n = in_local(along);
    double best = -HUGE_VAL;
    Index start = 0;
    for (Index first = 0; first < shape_.padded_count(); first += chunk) {
      const double greatest = hn::GetLane(hn::MaxOfLanes(tag, range(n, first).greatest));
      if (greatest > best) best = greatest, start = first;
    }
    return clamped(start, best);
  }

  struct Ends {
    Index highest, lowest;
  };

  /// The same both ways.
  [[nodiscard]] HWY_INLINE Ends ends(const Vec3& along) const {
    const Vec3 n = in_local(along);
    double high = -HUGE_VAL, low = HUGE_VAL;
    Index start_high = 0, start_low = 0;
    for (Index first = 0; first < shape_.padded_count(); first += chunk) {
      const Range here = range(n, first);
      const double greatest = hn::GetLane(hn::MaxOfLanes(tag, here.greatest)),
                   least = hn::GetLane(hn::MinOfLanes(tag, here.least));
      if (greatest > high) high = greatest, start_high = first;
      if (least < low) low = least, start_low = first;
    }
    return {clamped(start_high, high), clamped(start_low, low)};
  }

 private:
  struct Range {
    Number least, greatest;
  };

  [[nodiscard]] HWY_INLINE Vec3 in_local(const Vec3& along) const {
    return {dot(world_in_local_[0], along), dot(world_in_local_[1], along), dot(world_in_local_[2], along)};
  }

  /// The last vertex may be there several times.
  [[nodiscard]] HWY_INLINE Index clamped(Index start, double height) const {
    const auto in_chunk = static_cast<Index>(std::bit_cast<std::uint64_t>(height) & (chunk - 1));
    return std::min(start + in_chunk, shape_.vertex_count() - 1);
  }

  /// The range of up to a chunk of vertices; the heights hold which of them it is.
  [[nodiscard]] HWY_INLINE Range range(const Vec3& n, Index first) const {
    const hn::RebindToUnsigned<Tag> bits;
    const Index count = std::min(static_cast<Index>(chunk), shape_.padded_count() - first);
    const double *x = shape_.along(0) + first, *y = shape_.along(1) + first, *z = shape_.along(2) + first;
    const Number nx = hn::Set(tag, n.x), ny = hn::Set(tag, n.y), nz = hn::Set(tag, n.z);
    const auto kept = hn::Set(bits, ~(chunk - 1)), step = hn::Set(bits, std::uint64_t{vertices_at_once});
    auto which = hn::Iota(bits, 0);
    Range range{hn::Set(tag, HUGE_VAL), hn::Set(tag, -HUGE_VAL)};
    for (Index i = 0; i < count; i += vertices_at_once) {
      const Number height = hn::Add(hn::Add(hn::Mul(nx, hn::LoadU(tag, x + i)), hn::Mul(ny, hn::LoadU(tag, y + i))),
                                    hn::Mul(nz, hn::LoadU(tag, z + i)));
      const Number here = hn::BitCast(tag, hn::Or(hn::And(hn::BitCast(bits, height), kept), which));
      which = hn::Add(which, step);
      range = {hn::Min(range.least, here), hn::Max(range.greatest, here)};
    }
    return range;
  }

  const PosedPolytope& shape_;
  Mat3 world_in_local_;
};

struct ExpansionPoint {
  Vec3 value;
  Index on_a, on_b;
};

double largest(const Vec3& v) { return std::max({std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)}); }

class Expansion {
 public:
  Expansion(const PosedPolytope& a, const PosedPolytope& b, FastSurface& surface)
      : a_(a), b_(b), between_(place_of(b) - place_of(a)), s_(surface) {}

  enum class Start { tetrahedron, icosahedron };

  bool run(Start start) {
    s_.points = 0;
    s_.facets.clear();
    if (!(start == Start::icosahedron ? start_icosahedron() : start_tetrahedron())) return false;
    while (s_.points < FastSurface::most_points) {
      const Index f = nearest();
      const ExpansionPoint p = support(s_.normal(f));
      const double height = dot(s_.normal(f), p.value);
      if (!(height > 0)) return false;  // apart, or touching
      s_.nearest = f;
      // Less is rounding: of the depth, or, where that is shallow, of the points.
      const double beyond = height - s_.offset[f];
      if (beyond <= 0x1p-43 * height || beyond <= s_.rounding[f]) return true;
      if (!add(p, f)) return false;
    }
    return false;
  }

 private:
  [[nodiscard]] HWY_INLINE ExpansionPoint point(Index i, Index j) const { return {a_.vertex(i) - b_.vertex(j), i, j}; }
  [[nodiscard]] HWY_INLINE ExpansionPoint support(const Vec3& n) const {
    return point(a_.farthest(n), b_.farthest(-n));
  }

  Index append(const ExpansionPoint& p) {
    const Index i = s_.points++;
    s_.x[i] = p.value.x;
    s_.y[i] = p.value.y;
    s_.z[i] = p.value.z;
    s_.on_a[i] = p.on_a;
    s_.on_b[i] = p.on_b;
    return i;
  }

  /// Measures a facet, with the edges that lead from a corner to the others. False when it has hardly an area.
  HWY_INLINE bool measure(Index f, const Vec3& corner, const Vec3& to_first, const Vec3& to_second) {
    const Vec3 n = cross(to_first, to_second);
    const double squared = dot(n, n), offset = dot(n, corner);
    const double order = offset * std::fabs(offset) / squared;
    s_.normal_x[f] = n.x;
    s_.normal_y[f] = n.y;
    s_.normal_z[f] = n.z;
    s_.offset[f] = offset;
    s_.rounding[f] = height_rounding_ * sum_of_magnitudes(n);
    s_.order[f] = std::bit_cast<double>((std::bit_cast<std::uint64_t>(order) & ~facet_bits) | f);
    return squared > least_squared_;
  }

  bool measure_all() {
    bool has_area = true;
    for (Index f = 0; f < slots(); ++f) {
      const auto [p, q, r] = s_.facets.corners(f);
      const Vec3 corner = s_.point(r);
      has_area &= measure(f, corner, s_.point(p) - corner, s_.point(q) - corner);
    }
    clear_padding(slots());
    return has_area;
  }

  void clear(Index f) {
    s_.normal_x[f] = s_.normal_y[f] = s_.normal_z[f] = s_.offset[f] = s_.rounding[f] = 0;
    s_.order[f] = HUGE_VAL;
  }

  [[nodiscard]] Index slots() const { return static_cast<Index>(s_.facets.count()); }
  [[nodiscard]] Index padded_slots() const { return (slots() + 7) / 8 * 8; }
  void clear_padding(Index from) {
    for (Index f = from; f < padded_slots(); ++f) clear(f);
  }

  bool is_in_range(double extent) {
    least_squared_ = 0x1p-72 * extent * extent * extent * extent;
    height_rounding_ = 0x1p-50 * extent;
    return extent > 0x1p-100 && extent < 0x1p100;
  }

  bool start_icosahedron() {
    double extent = 0;
    std::array<ExpansionPoint, 12> p;
    for (std::size_t k = 0; k < 6; ++k) {
      const SearchedShape::Ends i = a_.ends(start_axes[k]), j = b_.ends(start_axes[k]);
      p[k] = point(i.highest, j.lowest);
      p[k + 6] = point(i.lowest, j.highest);
    }
    for (const ExpansionPoint& here : p) {
      append(here);
      extent = std::max(extent, largest(here.value));
    }
    if (!is_in_range(extent)) return false;
    s_.facets.start(icosahedron_faces, icosahedron_twins);
    return measure_all();
  }

  /// Starts with a tetrahedron of far points, the first towards the origin's nearest side.
  bool start_tetrahedron() {
    const Vec3 along = dot(between_, between_) > 0 ? between_ : Vec3{1, 0, 0};
    std::array<ExpansionPoint, 4> p{support(along), support(-along), {}, {}};
    const Vec3 axis = p[1].value - p[0].value;
    const double x = std::fabs(axis.x), y = std::fabs(axis.y), z = std::fabs(axis.z);
    const Vec3 aside = x <= y && x <= z ? Vec3{0, -axis.z, axis.y}
                       : y <= z         ? Vec3{axis.z, 0, -axis.x}
                                        : Vec3{-axis.y, axis.x, 0};
    p[2] = support(aside);
    Vec3 normal = cross(axis, p[2].value - p[0].value);
    if (dot(normal, p[0].value) > 0) normal = -normal;  // towards the origin
    p[3] = support(normal);
    return make_tetrahedron(p);
  }

  bool make_tetrahedron(const std::array<ExpansionPoint, 4>& p) {
    double extent = 0;
    for (const ExpansionPoint& here : p) {
      append(here);
      extent = std::max(extent, largest(here.value));
    }
    const Vec3 u = p[1].value - p[0].value, v = p[2].value - p[0].value, w = p[3].value - p[0].value;
    const double volume = dot(cross(u, v), w);
    if (!is_in_range(extent) || !(std::fabs(volume) > 0x1p-30 * extent * extent * extent)) return false;
    s_.facets.start_tetrahedron(volume > 0);
    return measure_all();
  }

  [[nodiscard]] HWY_INLINE Index nearest() const {
    const Index count = padded_slots();
    Number least = hn::Load(tag, s_.order.data());
    for (Index i = vertices_at_once; i < count; i += vertices_at_once)
      least = hn::Min(least, hn::Load(tag, s_.order.data() + i));
    const double order = hn::GetLane(hn::MinOfLanes(tag, least));
    return static_cast<Index>(std::bit_cast<std::uint64_t>(order) & facet_bits);
  }

  /// One bit a slot: the facets that see the point, by more than rounding.
  HWY_INLINE void find_seen(const Vec3& p, FacetSlots::Bits& seen) const {
    const Number x = hn::Set(tag, p.x), y = hn::Set(tag, p.y), z = hn::Set(tag, p.z);
    const Number rounding = hn::Set(tag, 1 + 0x1p-44);
    const Index count = padded_slots();
    for (Index i = 0; i < count; i += vertices_at_once) {
      const Number height = hn::Add(
          hn::Add(hn::Mul(x, hn::Load(tag, s_.normal_x.data() + i)), hn::Mul(y, hn::Load(tag, s_.normal_y.data() + i))),
          hn::Mul(z, hn::Load(tag, s_.normal_z.data() + i)));
      const Number offset = hn::Load(tag, s_.offset.data() + i);
      const Number above = hn::Add(hn::Mul(rounding, offset), hn::Load(tag, s_.rounding.data() + i));
      seen.word[i / 64] |= std::uint64_t{bits_of(tag, hn::Gt(height, above))} << (i % 64);
    }
  }

  /// False when what is seen is no disc, or a facet has hardly an area.
  bool add(const ExpansionPoint& point, Index above) {
    FacetSlots::Bits seen;
    find_seen(point.value, seen);
    if (!s_.facets.find_hole(above, seen)) return false;
    const Index padded = padded_slots();
    s_.facets.fill_hole(append(point));
    clear_padding(padded);
    for (const std::uint16_t f : s_.facets.left_over()) clear(f);
    bool has_area = true;
    Vec3 to_from = s_.point(s_.facets.hole()[0].from) - point.value;
    for (const FacetSlots::HoleEdge& edge : s_.facets.hole()) {
      const Vec3 to_next = s_.point(edge.to) - point.value;
      has_area &= measure(edge.slot, point.value, to_from, to_next);
      to_from = to_next;
    }
    return has_area;
  }

  SearchedShape a_, b_;
  Vec3 between_;
  FastSurface& s_;
  double least_squared_ = 0;
  double height_rounding_ = 0;  ///< of a normal whose coordinates' magnitudes sum up to 1
};

}  // namespace

bool expand_at_this_level(const PosedPolytope& a, const PosedPolytope& b, FastSurface& surface) {
  Expansion search(a, b, surface);
  // The twelve points are not different ones where vertices are few.
  const bool many = a.vertex_count() >= 16 && b.vertex_count() >= 16;
  if (many && search.run(Expansion::Start::icosahedron)) return true;
  return search.run(Expansion::Start::tetrahedron);
}

}  // namespace HWY_NAMESPACE
}  // namespace toccata
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace toccata {

HWY_EXPORT(expand_at_this_level);

bool expand_fast(const PosedPolytope& a, const PosedPolytope& b, FastSurface& surface) {
  return HWY_DYNAMIC_DISPATCH(expand_at_this_level)(a, b, surface);
}

}  // namespace toccata
#endif
