#include "query/meshes/wide_cull.hpp"

#include <algorithm>
#include <cmath>

#include "math/floats.hpp"
#include "math/vec3_measures.hpp"
#include "query/meshes/cull_bounds.hpp"

namespace toccata {
namespace {

// Floats are used for numbers up to this size; beyond, an axis is left out.
constexpr double largest_number = 1e30;

/// own · q is offset + other · p where a point q of the own tree and a point p of the other are one in the world, up to
/// the pad; all in the units of the trees.
struct Form {
  Vec3 own;
  Vec3 other;
  double offset = 0;
  double pad = 0;
};

Form scaled(const Form& f, double factor) {
  return {factor * f.own, factor * f.other, factor * f.offset, std::abs(factor) * f.pad};
}

Form form_of(const CullDirection& d, const WideBvh& a, const WideBvh& b) {
  return {a.unit * d.on_a, b.unit * d.on_b, (dot(d.on_b, b.origin) - dot(d.on_a, a.origin)) - d.offset, 2 * d.pad};
}

Form seen_from_other(const Form& f) { return {f.other, f.own, -f.offset, f.pad}; }

/// What the doubles of a form round during a walk, and what becomes of numbers that underflow as floats.
double rounding_of(const Form& f) {
  return 16 * unit_roundoff * ((sum_of_magnitudes(f.own) + sum_of_magnitudes(f.other)) + std::abs(f.offset)) + 1e-30;
}

/// As a float, and not less.
float not_less(double value) { return static_cast<float>(value * (1 + 0x1p-20)); }

bool is_usable(const Form& f) {
  return sum_of_magnitudes(f.own) < largest_number && sum_of_magnitudes(f.other) < largest_number &&
         std::abs(f.offset) < largest_number && f.pad < largest_number;
}

/// The own coordinate that the axis follows, up to what rounding made of it; 3 where there is none.
int coordinate_of(const Vec3& own) {
  for (int i = 0; i < 3; ++i)
    if (sum_of_magnitudes(own) - std::abs(own[i]) <= 0x1p-40 * std::abs(own[i]) && own[i] != 0) return i;
  return 3;
}

class AxesMaker {
 public:
  AxesMaker() { std::fill_n(axes_.pad.begin(), WideAxes::straight, std::numeric_limits<float>::infinity()); }

  void add(const Form& form) {
    const int i = coordinate_of(form.own);
    if (i < 3 && std::isinf(axes_.pad[static_cast<std::size_t>(i)]))
      add_straight(i, scaled(form, 1 / form.own[i]));
    else
      add_slanted(scaled(form, 1 / std::max(largest_magnitude(form.own), largest_magnitude(form.other))));
  }

  WideAxes axes(double other_is_larger_by) {
    axes_.other_is_larger_by = static_cast<float>(std::clamp(other_is_larger_by, 1e-15, 1e15));
    return axes_;
  }

 private:
  void add_straight(int i, Form form) {
    if (!is_usable(form)) return;
    // |q| ≤ 2 (trees/wide_bvh.hpp), so what the other two coordinates add is at most twice their factors.
    form.pad += 2 * (sum_of_magnitudes(form.own) - std::abs(form.own[i]));
    set(static_cast<std::size_t>(i), form, 2);
  }

  void add_slanted(const Form& form) {
    if (!is_usable(form) || axes_.count == WideAxes::most) return;
    axes_.slanted[axes_.count] = SlantedForm(as_floats(form.own));
    set(axes_.count++, form, 2 * sum_of_magnitudes(form.own));
  }

  void set(std::size_t axis, const Form& form, double own_size) {
    for (int i = 0; i < 3; ++i) {
      axes_.other[static_cast<std::size_t>(i)][axis] = form.other[i];
      axes_.other_size[static_cast<std::size_t>(i)][axis] = not_less(std::abs(form.other[i]));
    }
    axes_.offset[axis] = form.offset;
    axes_.own_size[axis] = not_less(own_size);
    axes_.pad[axis] = not_less(form.pad + rounding_of(form));
  }

  WideAxes axes_;
};

double world_size(const PosedMesh& mesh) {
  const Mat3& linear = mesh.pose().linear;
  return mesh.model().wide_bvh().unit *
         std::max({largest_magnitude(linear[0]), largest_magnitude(linear[1]), largest_magnitude(linear[2])});
}

}  // namespace

WideCull wide_cull(const PairCull& cull, const PosedMesh& a, const PosedMesh& b) {
  AxesMaker of_a, of_b;
  for (const CullDirection& direction : cull.directions()) {
    const Form form = form_of(direction, a.model().wide_bvh(), b.model().wide_bvh());
    of_a.add(form);
    of_b.add(seen_from_other(form));
  }
  const double size_a = world_size(a), size_b = world_size(b);
  return {of_a.axes(size_b / size_a), of_b.axes(size_a / size_b)};
}

WideCull wide_cull_in_one_frame(const WideBvh& a, const WideBvh& b, double reach) {
  AxesMaker of_a, of_b;
  for (int axis = 0; axis < 3; ++axis) {
    // The offset is rounded once, for which AxesMaker allows.
    Form form;
    form.own[axis] = a.unit;
    form.other[axis] = b.unit;
    form.offset = b.origin[axis] - a.origin[axis];
    form.pad = reach;
    of_a.add(form);
    of_b.add(seen_from_other(form));
  }
  return {of_a.axes(b.unit / a.unit), of_b.axes(a.unit / b.unit)};
}

void add_axis(const RegionDirection& direction, const WideBvh& tree, WideProbe& probe) {
  const double middle = 0.5 * direction.region.low + 0.5 * direction.region.high;
  const double half = 0.5 * direction.region.high - 0.5 * direction.region.low;
  const double origin = dot(direction.on_mesh, tree.origin) + direction.offset;
  // The region's side and the origin's number are rounded too: the pad counts twice, and both sides once more.
  const double pad = 2 * direction.pad + 4 * unit_roundoff * (std::abs(middle) + half);
  const Form whole{tree.unit * direction.on_mesh, {}, middle - origin, half + pad};
  const Form form = scaled(whole, 1 / largest_magnitude(whole.own));
  if (!is_usable(form) || probe.count == WideProbe::most) return;
  const double slack = 0x1p-20 * ((2 * sum_of_magnitudes(form.own) + std::abs(form.offset)) + form.pad);
  probe.axes[probe.count++] = {SlantedForm(as_floats(form.own)), static_cast<float>(form.offset),
                               not_less((form.pad + rounding_of(form)) + slack)};
}

}  // namespace toccata
