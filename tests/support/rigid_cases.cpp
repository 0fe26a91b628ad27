#include "support/rigid_cases.hpp"

#include <algorithm>
#include <cmath>
#include <type_traits>

#include <fmt/format.h>

#include "oracle/rational.hpp"

namespace toccata::test {
namespace {

Vec3 drawn_vector(Random& random, double size) {
  return {random.between(-size, size), random.between(-size, size), random.between(-size, size)};
}

Pose drawn_pose(Random& random, const Vec3& at) {
  return {rotation_about(drawn_vector(random, 1) + Vec3{0, 0, 0.01}, random.between(-180, 180)), at};
}

ConvexHull drawn_hull(Random& random, int count) {
  std::vector<Vec3> points;
  for (int i = 0; i < count; ++i) points.push_back(drawn_vector(random, 1));
  return ConvexHull(points);
}

Shape drawn_polytope(Random& random) {
  switch (random.below(5)) {
    case 0:
      return Triangle{{drawn_vector(random, 1), drawn_vector(random, 1), drawn_vector(random, 1)}};
    case 1:
      return Segment(drawn_vector(random, 1), drawn_vector(random, 1));
    case 2:
      return drawn_hull(random, 5 + static_cast<int>(random.below(8)));
    default:
      return Box({random.between(0.1, 1), random.between(0.1, 1), random.between(0.1, 1)});
  }
}

Shape drawn_round(Random& random) {
  switch (random.below(3)) {
    case 0:
      return Sphere(random.between(0.1, 1), drawn_vector(random, 0.5));
    case 1:
      return Capsule(drawn_vector(random, 1), drawn_vector(random, 1), random.between(0.05, 0.5));
    default:
      return Rounded(Box({random.between(0.1, 1), random.between(0.1, 1), random.between(0.1, 1)}),
                     random.between(0.01, 0.3));
  }
}

Shape drawn_quadric(Random& random) {
  const double x = random.between(0.1, 1), y = random.between(0.1, 1), z = random.between(0.1, 1);
  switch (random.below(3)) {
    case 0:
      return Cylinder(x, z);
    case 1:
      return Cone(x, z);
    default:
      return Ellipsoid({x, y, z});
  }
}

/// B near the origin, A some way off and moving past or into it; both turn.
RigidCase approaching(Random& random, Shape a, Shape b) {
  const Vec3 from = drawn_vector(random, 3) + Vec3{random.below(2) == 0 ? 2.5 : -2.5, 0, 0};
  const Vec3 to = drawn_vector(random, 1.5);
  RigidCase pair{
      {std::move(a), drawn_pose(random, from), {from, drawn_vector(random, 1), random.between(-1, 1), to - from}},
      {std::move(b),
       drawn_pose(random, {}),
       {drawn_vector(random, 0.5), drawn_vector(random, 1), random.between(-0.5, 0.5), {}}}};
  if (random.below(3) == 0) pair.a.move.centre = drawn_vector(random, 1);
  if (random.below(4) == 0) pair.b.move = {};
  return pair;
}

RigidCase polytopes(Random& random) { return approaching(random, drawn_polytope(random), drawn_polytope(random)); }
RigidCase round_shapes(Random& random) { return approaching(random, drawn_round(random), drawn_polytope(random)); }
RigidCase quadrics(Random& random) {
  return approaching(random, drawn_quadric(random),
                     random.below(2) == 0 ? drawn_polytope(random) : drawn_quadric(random));
}

RigidCase half_spaces(Random& random) {
  RigidCase pair = approaching(random, random.below(2) == 0 ? drawn_polytope(random) : drawn_round(random),
                               HalfSpace({0, 0, -1}, {0, 0, 1}));
  pair.b.start = drawn_pose(random, drawn_vector(random, 1));
  pair.b.move.turns *= 0.5;
  return pair;
}

/// A wall that is thin, and what is fast.
RigidCase thin_walls(Random& random) {
  RigidCase pair = approaching(random, Box({random.between(0.01, 0.2), random.between(0.01, 0.2), 0.05}),
                               Box({1, 1, std::exp2(-random.between(5, 30))}));
  pair.a.move.translation = 50 * pair.a.move.translation;
  return pair;
}

/// A rod that turns beside one that stands: it meets with its end, or passes by.
RigidCase spinning_rods(Random& random) {
  const double height = random.between(-0.004, 0.012);
  return {{Box({1, 0.005, 0.002}),
           Pose::rotation({0, 0, 1}, random.between(20, 160)),
           {{}, {0, 0, 1}, random.between(-3, 3), {}}},
          {Box({0.004, 0.004, 0.004}), Pose::translation(random.between(0.9, 1.01), 0, height), {}}};
}

/// A tiny body that crosses the whole scene.
RigidCase bullets(Random& random) {
  const double size = std::exp2(-random.between(5, 20));
  const Vec3 from = drawn_vector(random, 1) + Vec3{20, 0, 0}, target = drawn_vector(random, 0.7);
  return {{Box({size, size, 2 * size}),
           drawn_pose(random, from),
           {from, drawn_vector(random, 1), random.between(-5, 5), 2 * (target - from)}},
          {drawn_polytope(random), drawn_pose(random, {}), {}}};
}

/// A corner, an edge or a face of a box comes to rest on a plate, as near as doubles put it, at the end or on the way.
RigidCase landings(Random& random) {
  const double times[] = {1, 0.5, 0.999, 1e-6};
  const double at = times[random.below(4)];
  const Mat3 landed[] = {Mat3{}, rotation_about({1, 0, 0}, 45), rotation_about({1, 1, 0}, 54.735610317245346)};
  const int how = static_cast<int>(random.below(3));
  const double height = how == 0 ? 1 : how == 1 ? std::sqrt(2.0) : std::sqrt(3.0);
  const double turns = random.between(-0.1, 0.1);
  const Mat3 start = rotation_about({0, 0, 1}, -360 * turns * at) * landed[how];
  const double fall = random.between(0.1, 5);
  return {{Box({1, 1, 1}), {start, {0, 0, height + fall * at}}, {{0, 0, 7}, {0, 0, 1}, turns, {0, 0, -fall}}},
          {Box({4, 4, 0.5}, {0, 0, -0.5}), {}, {}}};
}

/// A ball that spins in place close beside another or a little into it, or passes it like that.
RigidCase spinning_balls(Random& random) {
  const double radius_a = random.between(0.1, 1), radius_b = random.between(0.1, 1);
  // What passes and meets by less is met at a time that 60 digits hardly tell.
  const bool is_into = random.below(4) == 0;
  const double gap = is_into ? -std::exp2(-random.between(1, 20)) : std::exp2(-random.between(1, 40));
  const Vec3 at = drawn_vector(random, 3), aside = normalized(drawn_vector(random, 1) + Vec3{0, 0, 0.01});
  const Vec3 way = random.below(2) == 0 ? Vec3{} : 4 * cross(aside, drawn_vector(random, 1));
  const Vec3 beside = at + (radius_a + radius_b + gap) * aside, from = at - 0.5 * way;
  const auto turns = [&] { return random.between(-20, 20); };
  RigidCase pair{
      {Sphere(radius_a), Pose::translation(from.x, from.y, from.z), {from, drawn_vector(random, 1), turns(), way}},
      {Sphere(radius_b),
       Pose::translation(beside.x, beside.y, beside.z),
       {beside, drawn_vector(random, 1), turns(), {}}}};
  if (random.below(3) == 0) pair.b.move = {};
  return pair;
}

RigidCase scaled_case(const RigidCase& pair, double factor) {
  const auto scaled_body = [&](const MovingShape& body) {
    MovingShape result{scaled_in_itself(body.shape, factor), body.start, body.move};
    if (!keeps_its_form(body.shape)) result.start = scaled(body.start, factor);
    result.start.offset = factor * body.start.offset;
    result.move.centre = factor * body.move.centre;
    result.move.translation = factor * body.move.translation;
    return result;
  };
  return {scaled_body(pair.a), scaled_body(pair.b)};
}

RigidCase sizes(Random& random) { return scaled_case(polytopes(random), std::pow(10, random.between(-8, 8))); }

RigidCase far_away(Random& random) {
  RigidCase pair = polytopes(random);
  const Vec3 by = drawn_vector(random, std::pow(10, random.between(1, 6)));
  for (MovingShape* body : {&pair.a, &pair.b}) {
    body->start.offset += by;
    body->move.centre += by;
  }
  return pair;
}

std::vector<Vec3> posed(const Pose& pose, std::span<const Vec3> points) {
  std::vector<Vec3> world;
  for (const Vec3& p : points) world.push_back(oracle::world_vertex(pose, p));
  return world;
}

/// The points of doubles that a core is the hull of.
struct CorePoints {
  std::vector<Vec3> operator()(const Point& s) const { return {s.position()}; }
  std::vector<Vec3> operator()(const Segment& s) const { return {s.start(), s.end()}; }
  std::vector<Vec3> operator()(const Triangle& s) const { return {s[0], s[1], s[2]}; }
  std::vector<Vec3> operator()(const Box& s) const {
    std::vector<Vec3> points;
    for (int i = 0; i < 8; ++i) points.push_back(s.corner(i));
    return points;
  }
  std::vector<Vec3> operator()(const ConvexHull& s) const {
    std::vector<Vec3> points;
    for (Index i = 0; i < s.vertex_count(); ++i) points.push_back(s.vertex(i));
    return points;
  }
};

struct FineSetOf {
  using Set = std::variant<oracle::FineSet, oracle::FineHalfSpace>;

  Set hull(const std::vector<Vec3>& points, double radius) const {
    return oracle::hull_set_of(posed(start, points), radius);
  }
  Set operator()(const Sphere& s) const { return hull({s.centre()}, s.radius()); }
  Set operator()(const Capsule& s) const { return hull({s.start(), s.end()}, s.radius()); }
  Set operator()(const Rounded& s) const { return hull(std::visit(CorePoints{}, s.core()), s.radius()); }
  Set operator()(const HalfSpace& s) const {
    const PosedHalfSpace placed(s, start);
    const auto fine = [](const Vec3& v) {
      return oracle::FinePoint{oracle::Fine(v.x), oracle::Fine(v.y), oracle::Fine(v.z)};
    };
    return oracle::FineHalfSpace{fine(placed.point), fine(placed.normal)};
  }
  template <class S>
  Set operator()(const S& s) const {
    if constexpr (QuadricShape<S>) {
      using enum oracle::FineKind;
      const auto kind = std::is_same_v<S, Cylinder> ? cylinder : std::is_same_v<S, Cone> ? cone : ellipsoid;
      return oracle::quadric_set(kind, s.half_axes(), start);
    } else if constexpr (requires { CorePoints{}(s); }) {
      return hull(CorePoints{}(s), 0);
    } else {
      throw std::logic_error("the oracle of bodies that move knows convex shapes alone");
    }
  }

  const Pose& start;
};

double size_of(const RigidCase& pair) {
  double size = 1e-300;
  for (const MovingShape* body : {&pair.a, &pair.b}) {
    const oracle::FineBody fine = fine_body(*body);
    if (const auto* set = std::get_if<oracle::FineSet>(&fine.set)) {
      for (const auto& v : set->vertices)
        size = std::max(size, std::abs(v.x.convert_to<double>()) + std::abs(v.y.convert_to<double>()) +
                                  std::abs(v.z.convert_to<double>()));
    }
    for (const Vec3& v : {body->start.offset, body->move.centre, body->move.translation})
      size = std::max(size, std::abs(v.x) + std::abs(v.y) + std::abs(v.z));
  }
  return size;
}

RigidCase exchanged(const RigidCase& pair) { return {pair.b, pair.a}; }

RigidCase backwards(const RigidCase& pair) {
  const auto turned_back = [](const MovingShape& body) {
    const RigidMove& m = body.move;
    return MovingShape{body.shape, body.motion().at(1), {m.centre + m.translation, m.axis, -m.turns, -m.translation}};
  };
  return {turned_back(pair.a), turned_back(pair.b)};
}

/// Behind a mirror: x becomes −x, and what turned left turns right.
RigidCase mirrored(const RigidCase& pair) {
  const auto behind = [](const Vec3& v) { return Vec3{-v.x, v.y, v.z}; };
  const auto mirrored_body = [&](const MovingShape& body) {
    const RigidMove& m = body.move;
    MovingShape result{body.shape, body.start, {behind(m.centre), behind(m.axis), -m.turns, behind(m.translation)}};
    result.start.linear[0] = -result.start.linear[0];
    result.start.offset = behind(result.start.offset);
    return result;
  };
  return {mirrored_body(pair.a), mirrored_body(pair.b)};
}

/// A shape whose vertices are the same, in another order.
struct Reordered {
  Shape operator()(const Segment& s) const { return Segment(s.end(), s.start()); }
  Shape operator()(const Triangle& s) const { return Triangle{{s[2], s[0], s[1]}}; }
  Shape operator()(const Capsule& s) const { return Capsule(s.end(), s.start(), s.radius()); }
  Shape operator()(const ConvexHull& s) const {
    std::vector<Vec3> points = CorePoints{}(s);
    std::reverse(points.begin(), points.end());
    return ConvexHull(points);
  }
  template <class S>
  Shape operator()(const S& s) const {
    return s;
  }
};

RigidCase reordered(const RigidCase& pair) {
  const auto body = [](const MovingShape& b) { return MovingShape{std::visit(Reordered{}, b.shape), b.start, b.move}; };
  return {body(pair.a), body(pair.b)};
}

/// That nothing is met is proved.
Status status_of(const std::optional<ShapeHit>& answer) { return answer ? answer->status : Status::exact; }

/// What is wrong with the answer to a question that is the same but for how it is put; nothing where both are right.
std::optional<std::string> contradiction(const std::optional<ShapeHit>& answer, const std::optional<ShapeHit>& other,
                                         const char* change) {
  if (status_of(answer) != Status::exact || status_of(other) != Status::exact) return std::nullopt;
  if (other.has_value() != answer.has_value()) return fmt::format("{} changes the answer", change);
  if (answer && (other->lower > answer->upper || other->upper < answer->lower))
    return fmt::format("{} changes the time", change);
  return std::nullopt;
}

}  // namespace

const std::vector<RigidFamily>& rigid_families() {
  static const std::vector<RigidFamily> families{{"polytopes", polytopes},
                                                 {"round", round_shapes},
                                                 {"quadrics", quadrics},
                                                 {"half-spaces", half_spaces},
                                                 {"thin walls", thin_walls},
                                                 {"rods", spinning_rods},
                                                 {"bullets", bullets},
                                                 {"landings", landings},
                                                 {"sizes", sizes},
                                                 {"far", far_away},
                                                 {"spinning balls", spinning_balls}};
  return families;
}

oracle::FineBody fine_body(const MovingShape& body) {
  return {std::visit(FineSetOf{body.start}, body.shape), body.move};
}

namespace {

std::string told_of(const std::optional<ShapeHit>& answer) {
  if (!answer) return "nothing";
  return fmt::format("[{}, {}] {}", answer->lower, answer->upper,
                     answer->status == Status::exact ? "exact" : "undecided");
}

}  // namespace

std::optional<ShapeHit> swept(const RigidCase& pair) {
  return sweep(Model(pair.a.shape), pair.a.motion(), Model(pair.b.shape), pair.b.motion());
}

std::optional<std::string> wrong_sweep(const RigidCase& pair, const std::optional<ShapeHit>& answer) {
  using enum oracle::FineContact::Kind;
  const oracle::FineBody a = fine_body(pair.a), b = fine_body(pair.b);
  const oracle::FineContact truth = oracle::first_contact(a, b, 1e-9);
  const double lower = truth.lower.convert_to<double>(), upper = truth.upper.convert_to<double>();
  const std::string told =
      fmt::format(" (told {}, true {} [{}, {}])", told_of(answer), static_cast<int>(truth.kind), lower, upper);
  if (!answer) return truth.kind == hit ? std::optional("a contact is missed" + told) : std::nullopt;
  if (truth.kind == hit && answer->lower > upper) return "a contact comes before what is told" + told;
  if (answer->status == Status::exact) {
    if (truth.kind == free) return "an exact contact, and there is none" + told;
    if (answer->upper < lower) return "they are apart when they are told to have met" + told;
    if (answer->upper > 0 && !oracle::meet_at(a, b, answer->upper)) return "apart at the upper end" + told;
    if (answer->lower > 0 && oracle::meet_at(a, b, answer->lower)) return "met before the lower end" + told;
    return std::nullopt;
  }
  const double gap = oracle::nearness_at(a, b, oracle::Fine(answer->lower)).lower.convert_to<double>();
  if (gap > 1e-11 * size_of(pair)) return fmt::format("undecided where they are {} apart", gap) + told;
  return std::nullopt;
}

std::optional<std::string> changed_sweep(const RigidCase& pair, const std::optional<ShapeHit>& answer) {
  if (auto wrong = contradiction(answer, swept(exchanged(pair)), "the order")) return wrong;
  if (auto wrong = contradiction(answer, swept(mirrored(pair)), "a mirror")) return wrong;
  if (auto wrong = contradiction(answer, swept(reordered(pair)), "the order of vertices")) return wrong;
  const std::optional<ShapeHit> back = swept(backwards(pair));
  if (status_of(back) == Status::exact && status_of(answer) == Status::exact && back.has_value() != answer.has_value())
    return "the direction of time changes the answer";
  const std::optional<ShapeHit> large = swept(scaled_case(pair, 0x1p10));
  // The numbers of distances of quadrics are found by steps that know no unit of two.
  const bool has_quadric = is_quadric(kind_of(pair.a.shape)) || is_quadric(kind_of(pair.b.shape));
  const auto numbers = [](const std::optional<ShapeHit>& hit) {
    return hit ? std::tuple(hit->lower, hit->upper, hit->status) : std::tuple(0.0, 0.0, Status::exact);
  };
  if (large.has_value() != answer.has_value() || !(numbers(large) == numbers(answer) || has_quadric))
    return fmt::format("the unit changes the answer: {} and {}", told_of(answer), told_of(large));
  return std::nullopt;
}

}  // namespace toccata::test
