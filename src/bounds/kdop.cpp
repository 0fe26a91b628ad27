#include "toccata/bounds/kdop.hpp"

#include "bounds/normals.hpp"
#include "bounds/point_clouds.hpp"
#include "bounds/polytope_measure.hpp"
#include "bounds/posed_bounds.hpp"
#include "bounds/separation.hpp"
#include "math/constants.hpp"

namespace toccata {

template <std::size_t k>
Directions face_normals(const Kdop<k>&) {
  Directions normals;
  for (const Vec3& n : kdop_normals<k>()) normals.direction[normals.count++] = n;
  return normals;
}

namespace {

/// No less than normal · point; exact along an axis.
double height_bound(const Vec3& normal, const Vec3& point) {
  const double components = std::fabs(normal.x) + std::fabs(normal.y) + std::fabs(normal.z);
  if (components == 1) return dot(normal, point);
  UpperSum sum;
  sum.add(normal, point);
  return sum.bound();
}

template <std::size_t k>
Kdop<k> fit_kdop(std::span<const Vec3> points) {
  static constexpr auto normals = kdop_normals<k>();
  Kdop<k> fitted;
  if (is_empty(checked_box(points))) return fitted;
  for (const Vec3& p : points)
    for (std::size_t i = 0; i < normals.size(); ++i) {
      fitted.upper[i] = std::max(fitted.upper[i], height_bound(normals[i], p));
      fitted.lower[i] = std::min(fitted.lower[i], -height_bound(-normals[i], p));
    }
  return fitted;
}

/// A non-negative multiple of a normal that points outwards, and the offset of its plane.
struct NormalPart {
  double factor = 0;
  Vec3 normal;
  double offset = 0;
};

/// The direction as a sum of three such.
using NormalParts = std::array<NormalPart, 3>;

/// The same for a direction with x ≥ y ≥ z ≥ 0, without offsets. The normals of every k cut the sphere of directions
/// into triangles; each case is one of them.
template <std::size_t k>
NormalParts sorted_parts(const Vec3& d) {
  if constexpr (k == 6) return {{{d.x, {1, 0, 0}}, {d.y, {0, 1, 0}}, {d.z, {0, 0, 1}}}};
  if constexpr (k == 14)
    return {{{d.x - d.y, {1, 0, 0}}, {0.5 * (d.y + d.z), {1, 1, 1}}, {0.5 * (d.y - d.z), {1, 1, -1}}}};
  if constexpr (k == 26) return {{{d.x - d.y, {1, 0, 0}}, {d.y - d.z, {1, 1, 0}}, {d.z, {1, 1, 1}}}};
  const double rest = (d.x - d.y) - d.z;
  if (rest >= 0) return {{{rest, {1, 0, 0}}, {d.y, {1, 1, 0}}, {d.z, {1, 0, 1}}}};
  return {{{0.5 * ((d.x + d.y) - d.z), {1, 1, 0}}, {0.5 * ((d.x - d.y) + d.z), {1, 0, 1}}, {-0.5 * rest, {0, 1, 1}}}};
}

/// The axes by descending magnitude of the direction's component.
std::array<int, 3> descending_axes(const Vec3& d) {
  std::array<int, 3> axes{0, 1, 2};
  const auto order = [&](std::size_t i, std::size_t j) {
    if (std::fabs(d[axes[i]]) < std::fabs(d[axes[j]])) std::swap(axes[i], axes[j]);
  };
  order(0, 1);
  order(1, 2);
  order(0, 1);
  return axes;
}

/// A normal as a number: its components are −1, 0 and 1.
constexpr std::size_t code_of(const Vec3& normal) {
  return static_cast<std::size_t>((normal.x + 1) * 9 + (normal.y + 1) * 3 + (normal.z + 1));
}

/// The number of the slab of every normal, by its code.
template <std::size_t k>
constexpr std::array<std::size_t, 27> slab_numbers() {
  std::array<std::size_t, 27> numbers{};
  const auto normals = kdop_normals<k>();
  for (std::size_t i = 0; i < normals.size(); ++i) numbers[code_of(normals[i])] = numbers[code_of(-normals[i])] = i;
  return numbers;
}

/// The offset of the plane with this normal, which is one of the normals or its opposite.
template <std::size_t k>
double offset_of(const Kdop<k>& v, const Vec3& normal) {
  static constexpr auto numbers = slab_numbers<k>();
  // The list has one of a normal and its opposite, that with the greater code: its first component other than 0 is 1.
  const std::size_t code = code_of(normal), slab = numbers[code];
  return code > 13 ? v.upper[slab] : -v.lower[slab];
}

template <std::size_t k>
NormalParts parts_of(const Kdop<k>& v, const Vec3& direction) {
  const std::array<int, 3> axes = descending_axes(direction);
  NormalParts parts =
      sorted_parts<k>({std::fabs(direction[axes[0]]), std::fabs(direction[axes[1]]), std::fabs(direction[axes[2]])});
  for (NormalPart& part : parts) {
    const Vec3 sorted = part.normal;
    for (int i = 0; i < 3; ++i) {
      const int axis = axes[static_cast<std::size_t>(i)];
      part.normal[axis] = direction[axis] < 0 ? -sorted[i] : sorted[i];
    }
    part.offset = offset_of(v, part.normal);
  }
  return parts;
}

/// How far from a point a point of the polytope can be, as a sum over the axes.
template <std::size_t k>
double reach_bound(const Kdop<k>& v, const Vec3& from) {
  double reach = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const double x = from[static_cast<int>(i)];
    reach += std::max(std::fabs(v.lower[i] - x), std::fabs(v.upper[i] - x));
  }
  return rounded_up(reach);
}

/// In units of `size`.
struct ScaledMeasure {
  PolytopeMeasure measure;
  double size = 0;
};

template <std::size_t k>
ScaledMeasure scaled_measure(const Kdop<k>& v) {
  static constexpr auto normals = kdop_normals<k>();
  if (is_empty(v)) return {};
  const Vec3 centre = middle(v);
  std::vector<PlaneBound> planes;
  double size = reach_bound(v, centre);
  for (std::size_t i = 0; i < normals.size(); ++i) {
    const double height = dot(normals[i], centre);
    planes.push_back({normals[i], v.upper[i] - height});
    planes.push_back({-normals[i], height - v.lower[i]});
    size = std::max({size, planes.rbegin()[0].offset, planes.rbegin()[1].offset});
  }
  if (!is_finite(centre) || !(size < infinity)) return {{infinity, infinity}, 1};
  for (PlaneBound& plane : planes) plane.offset /= size;
  return {measure_within(planes), size};
}

}  // namespace

template <>
Kdop<6> fit<Kdop<6>>(std::span<const Vec3> points) {
  return fit_kdop<6>(points);
}
template <>
Kdop<14> fit<Kdop<14>>(std::span<const Vec3> points) {
  return fit_kdop<14>(points);
}
template <>
Kdop<18> fit<Kdop<18>>(std::span<const Vec3> points) {
  return fit_kdop<18>(points);
}
template <>
Kdop<26> fit<Kdop<26>>(std::span<const Vec3> points) {
  return fit_kdop<26>(points);
}
template <>
Kdop<6> fit<Kdop<6>>(std::span<const Triangle> triangles) {
  return fit_kdop<6>(corners_of(triangles));
}
template <>
Kdop<14> fit<Kdop<14>>(std::span<const Triangle> triangles) {
  return fit_kdop<14>(corners_of(triangles));
}
template <>
Kdop<18> fit<Kdop<18>>(std::span<const Triangle> triangles) {
  return fit_kdop<18>(corners_of(triangles));
}
template <>
Kdop<26> fit<Kdop<26>>(std::span<const Triangle> triangles) {
  return fit_kdop<26>(corners_of(triangles));
}

template <std::size_t k>
double support_bound(const Kdop<k>& v, const Vec3& direction, const Vec3& from) {
  if (is_empty(v)) return -infinity;
  UpperSum sum;
  for (const NormalPart& part : parts_of(v, direction)) {
    if (part.factor == 0) continue;
    sum.add(part.factor, part.offset);
    for (int axis = 0; axis < 3; ++axis) sum.add(-part.factor * part.normal[axis], from[axis]);
  }
  // What is left of the direction: each component of the sum has met a few roundings.
  sum.add_slack(0x1p-48 * largest_magnitude(direction) * reach_bound(v, from));
  return sum.bound();
}

template <std::size_t k>
Vec3 farthest_point(const Kdop<k>& v, const Vec3& direction) {
  const NormalParts p = parts_of(v, direction);
  const Vec3 from = middle(v);
  const auto height = [&](const NormalPart& part) { return part.offset - dot(part.normal, from); };
  const Vec3 across = cross(p[1].normal, p[2].normal);
  const Vec3 sum = (height(p[0]) * across + height(p[1]) * cross(p[2].normal, p[0].normal)) +
                   height(p[2]) * cross(p[0].normal, p[1].normal);
  return from + (1 / dot(p[0].normal, across)) * sum;
}

template <std::size_t k>
Vec3 middle(const Kdop<k>& v) {
  return middle(box_around(v));
}

template <std::size_t k>
Kdop<k> merge(const Kdop<k>& a, const Kdop<k>& b) {
  Kdop<k> merged;
  for (std::size_t i = 0; i < Kdop<k>::slabs; ++i) {
    merged.lower[i] = std::min(a.lower[i], b.lower[i]);
    merged.upper[i] = std::max(a.upper[i], b.upper[i]);
  }
  return merged;
}

template <std::size_t k>
bool contains(const Kdop<k>& v, const Vec3& point) {
  static constexpr auto normals = kdop_normals<k>();
  for (std::size_t i = 0; i < normals.size(); ++i)
    if (!(height_bound(normals[i], point) <= v.upper[i] && height_bound(-normals[i], point) <= -v.lower[i]))
      return false;
  return true;
}

template <std::size_t k>
bool overlap(const Kdop<k>& a, const Kdop<k>& b) {
  if (is_empty(a) || is_empty(b)) return false;
  for (std::size_t i = 0; i < Kdop<k>::slabs; ++i)
    if (a.upper[i] < b.lower[i] || b.upper[i] < a.lower[i]) return false;
  return true;
}

template <std::size_t k>
double gap(const Kdop<k>& a, const Kdop<k>& b) {
  if (is_empty(a) || is_empty(b)) return infinity;
  static constexpr auto normals = kdop_normals<k>();
  double best = 0;
  for (std::size_t i = 0; i < Kdop<k>::slabs; ++i) {
    const double parted = std::max(b.lower[i] - a.upper[i], a.lower[i] - b.upper[i]);
    if (parted > 0) best = std::max(best, rounded_down(parted / length_bound(normals[i])));
  }
  if (best == 0) return 0;
  const auto look = [&](const Vec3& direction) {
    best = std::max(best, gap_along(a, b, direction));
    return false;
  };
  const Vec3 from_box = scaled_direction(between(box_around(a), box_around(b)));
  if (!(from_box == Vec3{})) look(from_box);
  search_directions(a, b, {}, from_box == Vec3{} ? Vec3{1, 0, 0} : from_box, look);
  return best;
}

template <std::size_t k>
Kdop<k> posed(const Kdop<k>& v, const Pose& pose) {
  static constexpr auto normals = kdop_normals<k>();
  Kdop<k> turned;
  if (is_empty(v)) return turned;
  const PosedSupport support(v, pose);
  for (std::size_t i = 0; i < normals.size(); ++i) {
    turned.upper[i] = support(normals[i], {});
    turned.lower[i] = -support(-normals[i], {});
  }
  return turned;
}

template <std::size_t k>
Aabb box_around(const Kdop<k>& v) {
  return {{v.lower[0], v.lower[1], v.lower[2]}, {v.upper[0], v.upper[1], v.upper[2]}};
}

template <std::size_t k>
double measure(const Kdop<k>& v) {
  const ScaledMeasure scaled = scaled_measure(v);
  return scaled.measure.volume * scaled.size * scaled.size * scaled.size;
}

template <std::size_t k>
double surface_area(const Kdop<k>& v) {
  const ScaledMeasure scaled = scaled_measure(v);
  return scaled.measure.area * scaled.size * scaled.size;
}

template <std::size_t k>
std::vector<Vec3> corner_points(const Kdop<k>& v) {
  const Vec3 centre = middle(v);
  std::vector<PlaneBound> planes;
  double size = 0;
  for (std::size_t i = 0; i < k / 2; ++i) {
    const Vec3 normal = kdop_normals<k>()[i];
    const double height = dot(normal, centre);
    planes.push_back({normal, v.upper[i] - height});
    planes.push_back({-normal, height - v.lower[i]});
    size = std::max({size, planes.rbegin()[0].offset, planes.rbegin()[1].offset});
  }
  if (!std::isfinite(size)) return {};
  if (!(size > 0)) return {centre};
  for (PlaneBound& plane : planes) plane.offset /= size;
  std::vector<Vec3> corners = corners_within(planes);
  for (Vec3& corner : corners) corner = centre + size * corner;
  return corners;
}

template <std::size_t k>
double half_area(const Kdop<k>& v) {
  return half_area(box_around(v));
}

#define TOCCATA_INSTANTIATE_KDOP(V)                                  \
  template double support_bound(const V&, const Vec3&, const Vec3&); \
  template Vec3 farthest_point(const V&, const Vec3&);               \
  template Vec3 middle(const V&);                                    \
  template V merge(const V&, const V&);                              \
  template bool contains(const V&, const Vec3&);                     \
  template V posed(const V&, const Pose&);                           \
  template Aabb box_around(const V&);                                \
  template double measure(const V&);                                 \
  template double surface_area(const V&);                            \
  template std::vector<Vec3> corner_points(const V&);                \
  template double half_area(const V&);                               \
  TOCCATA_INSTANTIATE_VOLUME(V)

TOCCATA_INSTANTIATE_KDOP(Kdop<6>);
TOCCATA_INSTANTIATE_KDOP(Kdop<14>);
TOCCATA_INSTANTIATE_KDOP(Kdop<18>);
TOCCATA_INSTANTIATE_KDOP(Kdop<26>);

}  // namespace toccata
