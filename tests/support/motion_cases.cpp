#include "support/motion_cases.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

namespace toccata::test {
namespace {

double whole_between(Random& random, int low, int high) {
  return low + static_cast<double>(random.below(static_cast<std::uint64_t>(high - low) + 1));
}

Vec3 whole_vector(Random& random, int size) {
  const auto draw = [&] { return whole_between(random, -size, size); };
  const double x = draw(), y = draw();
  return {x, y, draw()};
}

Vec3 uniform_vector(Random& random) {
  const double x = random.between(-1, 1), y = random.between(-1, 1);
  return {x, y, random.between(-1, 1)};
}

template <class Draw>
MovingPoints independent(Draw draw) {
  MovingPoints points;
  for (MovingPoint& p : points) p = {draw(), draw()};
  return points;
}

template <class Change>
MovingPoints changed(MovingPoints points, Change change) {
  for (MovingPoint& p : points) p = {change(p.start), change(p.end)};
  return points;
}

MovingPoints uniform(Random& random) {
  return independent([&] { return uniform_vector(random); });
}

MovingPoints on_small_grid(Random& random) {
  return independent([&] { return whole_vector(random, 2); });
}

/// Four points of which, as whole numbers, the first lies in the triangle of the others (corners and edges often), or
/// the first two are the ends of an edge that meets that of the last two.
std::array<Vec3, 4> in_contact(Random& random) {
  const int size = 1 << (1 + random.below(20));
  if (random.below(2) == 0) {
    const Vec3 a = whole_vector(random, size), u = 4 * whole_vector(random, size), v = 4 * whole_vector(random, size);
    const double i = whole_between(random, 0, 4), j = whole_between(random, 0, 4 - static_cast<int>(i));
    return {a + (i / 4) * u + (j / 4) * v, a, a + u, a + v};
  }
  const Vec3 p = whole_vector(random, size), u = whole_vector(random, size), v = whole_vector(random, size);
  const double i = whole_between(random, 0, 4), j = whole_between(random, 0, 4);
  return {p - i * u, p + (4 - i) * u, p - j * v, p + (4 - j) * v};
}

/// They meet at a quarter of the time, and perhaps before.
MovingPoints planted(Random& random) {
  const std::array<Vec3, 4> meeting = in_contact(random);
  const double quarter = std::array<double, 4>{0, 1, 2, 4}[random.below(4)];
  MovingPoints points;
  for (std::size_t i = 0; i < 4; ++i) {
    const Vec3 start = quarter == 0 ? meeting[i] : whole_vector(random, 1 << 20);
    const Vec3 end =
        quarter == 0 ? whole_vector(random, 1 << 20) : (4 / quarter) * meeting[i] - (4 / quarter - 1) * start;
    points[i] = {start, end};
  }
  return points;
}

double& coordinate(MovingPoints& points, Random& random) {
  MovingPoint& point = points[random.below(4)];
  Vec3& end = random.below(2) == 0 ? point.start : point.end;
  return end[static_cast<int>(random.below(3))];
}

/// A coordinate is moved to the next double.
MovingPoints beside_planted(Random& random) {
  MovingPoints points = random.below(4) == 0 ? on_small_grid(random) : planted(random);
  double& moved = coordinate(points, random);
  moved = std::nextafter(moved, random.below(2) == 0 ? HUGE_VAL : -HUGE_VAL);
  return points;
}

/// Everything stays in the plane z = x + 2y.
MovingPoints sliding(Random& random) {
  const MovingPoints points =
      random.below(2) == 0 ? on_small_grid(random) : independent([&] { return whole_vector(random, 1 << 20); });
  return changed(points, [](const Vec3& p) { return Vec3{p.x, p.y, p.x + 2 * p.y}; });
}

/// Everything stays in one line.
MovingPoints in_one_line(Random& random) {
  const Vec3 direction = whole_vector(random, 3);
  const int size = random.below(2) == 0 ? 4 : 1 << 20;
  return independent([&] { return whole_between(random, -size, size) * direction; });
}

/// The double root of tests/oracle/motion_test.cpp, and a hair beside it.
MovingPoints grazing(Random& random) {
  const double height =
      random.below(3) == 0 ? 0 : std::ldexp(random.between(-1, 1), -static_cast<int>(random.below(60)));
  const double y = random.below(4) == 0 ? 0 : 1;
  const MovingPoints points{MovingPoint{{2, -1, height}, {-2, -1, height}},
                            MovingPoint{{2, y, height}, {-2, y, height}}, MovingPoint{{-2, 0, -1}, {-2, 0, 1}},
                            MovingPoint{{2, 0, 1}, {2, 0, -1}}};
  if (random.below(2) == 0) return points;
  // As a vertex and a face: the edge that turns has become a face, which the vertex passes.
  return {MovingPoint{{2, 0, height}, {-2, 0, height}}, points[2], points[3], MovingPoint{{2, 3, 1}, {2, y, -1}}};
}

/// Nothing moves, or all moves alike.
MovingPoints rigid(Random& random) {
  const Vec3 way = random.below(2) == 0 ? Vec3{} : whole_vector(random, 4);
  const bool is_in_contact = random.below(2) == 0;
  const std::array<Vec3, 4> meeting = in_contact(random);
  MovingPoints points;
  for (std::size_t i = 0; i < 4; ++i) {
    const Vec3 start = is_in_contact ? meeting[i] : whole_vector(random, 3);
    points[i] = {start, start + way};
  }
  return points;
}

/// Two points move alike, are one at the start or the end, or cross a third.
MovingPoints degenerate(Random& random) {
  MovingPoints points = random.below(2) == 0 ? on_small_grid(random) : planted(random);
  for (int times = static_cast<int>(random.below(3)); times >= 0; --times) {
    MovingPoint& to = points[random.below(4)];
    const MovingPoint from = points[random.below(4)];
    const auto which = random.below(3);
    if (which != 0) to.start = from.start;
    if (which != 1) to.end = from.end;
  }
  return points;
}

MovingPoints of_any_kind(Random& random) {
  constexpr std::array kinds{uniform, on_small_grid, planted, sliding, in_one_line, grazing, rigid, degenerate};
  return kinds[random.below(kinds.size())](random);
}

MovingPoints scaled(Random& random) {
  const double scale = random.below(2) == 0 ? std::pow(10.0, whole_between(random, -8, 8))
                                            : std::ldexp(1.0, static_cast<int>(whole_between(random, -60, 60)));
  return changed(of_any_kind(random), [&](const Vec3& p) { return scale * p; });
}

MovingPoints far_from_origin(Random& random) {
  const double distance = std::ldexp(1.0, static_cast<int>(whole_between(random, 10, 50)));
  const Vec3 there = random.below(2) == 0 ? distance * whole_vector(random, 3) : distance * uniform_vector(random);
  return changed(of_any_kind(random), [&](const Vec3& p) { return p + there; });
}

double any_double(Random& random) {
  for (;;) {
    const double value = std::bit_cast<double>(random.bits());
    if (std::isfinite(value)) return value;
  }
}

/// At the limits of the doubles, where products over- and underflow, and some with every exponent.
MovingPoints extreme(Random& random) {
  if (random.below(16) == 0)
    return independent([&] {
      const double x = any_double(random), y = any_double(random);
      return Vec3{x, y, any_double(random)};
    });
  constexpr std::array exponents{-1074, -1060, -700, -400, -350, 300, 339, 340, 341, 342, 350, 500, 900, 1000};
  const int exponent = exponents[random.below(exponents.size())];
  return changed(of_any_kind(random), [&](const Vec3& p) {
    const auto bounded = [&](double a) { return std::clamp(std::ldexp(a, exponent), -0x1.fp1023, 0x1.fp1023); };
    return Vec3{bounded(p.x), bounded(p.y), bounded(p.z)};
  });
}

}  // namespace

const std::vector<MotionFamily>& feature_families() {
  static const std::vector<MotionFamily> families{{"uniform", uniform},       {"grid", on_small_grid},
                                                  {"planted", planted},       {"beside-planted", beside_planted},
                                                  {"sliding", sliding},       {"one-line", in_one_line},
                                                  {"grazing", grazing},       {"rigid", rigid},
                                                  {"degenerate", degenerate}, {"scales", scaled},
                                                  {"far", far_from_origin},   {"extreme", extreme}};
  return families;
}

VertexFace vertex_face(const MovingPoints& p) { return {p[0], {p[1], p[2], p[3]}}; }
EdgeEdge edge_edge(const MovingPoints& p) { return {{p[0], p[1]}, {p[2], p[3]}}; }

}  // namespace toccata::test
