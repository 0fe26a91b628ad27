#include "narrow/quadrics/distance/common_point.hpp"

#include <cmath>

#include "math/vec3_measures.hpp"
#include "narrow/quadrics/distance/shape_places.hpp"
#include "toccata/narrow/convex_convex.hpp"
#include "toccata/narrow/quadrics.hpp"
#include "toccata/shapes/primitives.hpp"

namespace toccata {
namespace {

/// In a pair of size 1: a few thousand roundings, and what nearest points may be off by along a round side.
constexpr double few_thousand_roundings = 0x1p-40, along_sides = 0x1p-18;

/// More places than this of one shape are not tried as points of both.
constexpr int most_places = 64;

bool holds(const PosedQuadric& shape, const Vec3& point) { return side_of(point, shape) != Sign::positive; }
bool holds(const PosedPolytope& shape, const Vec3& point) { return overlap(PosedPolytope(Point(point)), shape); }

double rounded(double x, double grid) { return grid * std::nearbyint(x / grid); }

/// A point, and which of its coordinates are those of a place.
struct Placed {
  Vec3 at;
  std::array<bool, 3> fixed{};
};

/// Takes over the coordinate of a place that is the nearest, where one is near.
template <class Shape>
void take_places(Placed& point, const Vec3& seen, const Shape& shape, double near) {
  std::array<double, 3> least{near, near, near};
  visit_places(shape, [&](const Vec3& place) {
    for (int i = 0; i < 3; ++i) {
      const double off = std::fabs(place[i] - seen[i]);
      double& closest = least[static_cast<std::size_t>(i)];
      if (!(off < closest)) continue;
      closest = off;
      point.at[i] = place[i];
      point.fixed[static_cast<std::size_t>(i)] = true;
    }
  });
}

template <class B>
class CommonPointSearch {
 public:
  CommonPointSearch(const PosedQuadric& a, const B& b, double size) : a_(a), b_(b), size_(size) {}

  std::optional<Vec3> from(const Vec3& on_a, const Vec3& on_b) {
    for (const Vec3& near : {on_a, on_b})
      if (is_common(near) || is_common(on_grid({near}, few_thousand_roundings * size_).at)) return found_;
    for (const Vec3& near : {on_a, on_b})
      for (const double off : {few_thousand_roundings, along_sides})
        for (const Take take : {Take::a, Take::b, Take::both})
          if (is_beside(near, off * size_, take)) return found_;
    if (is_place(a_, b_) || is_place(b_, a_)) return found_;
    return {};
  }

 private:
  enum class Take : std::uint8_t { a, b, both };

  /// With coordinates of places, and the others as they are, with few digits, or moved a little inwards.
  bool is_beside(const Vec3& near, double off, Take take) {
    Placed point{near};
    // Where those of both are taken, those of A come first.
    if (take != Take::a) take_places(point, near, b_, off);
    if (take != Take::b) take_places(point, near, a_, off);
    if (is_common(point.at) || is_common(on_grid(point, off).at)) return true;
    if (take != Take::both) return false;
    const Vec3 to_a = middle_of(a_) - near, to_b = middle_of(b_) - near;
    for (const double part : {0x1p-30, 0x1p-12, 0x1p-3})
      for (const Vec3& inwards : {to_a, to_b, 0.5 * (to_a + to_b)})
        if (is_common(moved(point, part * inwards).at)) return true;
    return false;
  }

  static Placed on_grid(Placed point, double grid) {
    for (int i = 0; i < 3; ++i)
      if (!point.fixed[static_cast<std::size_t>(i)]) point.at[i] = rounded(point.at[i], grid);
    return point;
  }

  static Placed moved(Placed point, const Vec3& by) {
    for (int i = 0; i < 3; ++i)
      if (!point.fixed[static_cast<std::size_t>(i)]) point.at[i] += by[i];
    return point;
  }

  template <class Shape, class Other>
  bool is_place(const Shape& shape, const Other& other) {
    int tried = 0;
    bool is_found = false;
    visit_places(shape, [&](const Vec3& place) {
      if (is_found || ++tried > most_places) return;
      if (is_finite(place) && holds(other, place) && is_common(place)) is_found = true;
    });
    return is_found;
  }

  bool is_common(const Vec3& point) {
    found_ = point;
    return is_finite(point) && holds(a_, point) && holds(b_, point);
  }

  const PosedQuadric& a_;
  const B& b_;
  double size_;
  Vec3 found_;
};

}  // namespace

std::optional<Vec3> common_point(const PosedQuadric& a, const PosedQuadric& b, const QuadricNearest& found,
                                 const PairFrame& frame) {
  return CommonPointSearch(a, b, 1 / frame.factor).from(frame.back(found.on_a), frame.back(found.on_b));
}
std::optional<Vec3> common_point(const PosedQuadric& a, const PosedPolytope& b, const QuadricNearest& found,
                                 const PairFrame& frame) {
  return CommonPointSearch(a, b, 1 / frame.factor).from(frame.back(found.on_a), frame.back(found.on_b));
}

}  // namespace toccata
