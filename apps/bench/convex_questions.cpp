#include "convex_questions.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "dop_bodies.hpp"
#include "toccata/core/error.hpp"
#include "toccata/core/random.hpp"
#include "toccata/math/rotation.hpp"
#include "toccata/narrow/convex_convex.hpp"
#include "toccata/narrow/smooth.hpp"

namespace toccata::bench {
namespace {

/// Of so many different pairs, so that shapes are not always in the nearest cache.
constexpr std::size_t different_pairs = 50;

double length(const Vec3& v) { return std::sqrt(dot(v, v)); }

// Every number is drawn in a statement of its own: the order in which arguments are evaluated is not specified.

Vec3 random_direction(Random& random) {
  while (true) {
    const double x = random.between(-1, 1);
    const double y = random.between(-1, 1);
    const double z = random.between(-1, 1);
    const Vec3 v{x, y, z};
    if (dot(v, v) > 0.01 && dot(v, v) <= 1) return (1 / length(v)) * v;
  }
}

Mat3 random_rotation(Random& random) {
  const Vec3 v = random_direction(random);
  const double w = random.between(-1, 1);
  return rotation_of({v.x, v.y, v.z, w});
}

double random_size(Random& random) { return random.between(0.3, 1); }

ConvexHull random_hull(std::size_t vertices, Random& random) {
  std::vector<Vec3> points;
  for (std::size_t i = 0; i < vertices; ++i) points.push_back(random_direction(random));
  return ConvexHull(points);
}

Box random_box(Random& random) {
  const double x = random_size(random);
  const double y = random_size(random);
  const double z = random_size(random);
  return Box({x, y, z});
}

Capsule random_capsule(Random& random) {
  const double half_length = random_size(random);
  const double radius = 0.5 * random_size(random);
  return Capsule({0, 0, -half_length}, {0, 0, half_length}, radius);
}

ConvexBody random_round(const std::string& kind, Random& random) {
  const double radius = random_size(random);
  const double half_height = random_size(random);
  if (kind == "cone") return Cone(radius, half_height);
  return Cylinder(radius, half_height);
}

Triangle random_triangle(Random& random) {
  const Vec3 p = random_direction(random);
  const Vec3 q = random_direction(random);
  return {{p, q, random_direction(random)}};
}

ConvexBody random_body(const std::string& kind, std::size_t vertices, Random& random) {
  if (kind == "sphere") return Sphere(random_size(random));
  if (kind == "box") return random_box(random);
  if (kind == "capsule") return random_capsule(random);
  if (kind == "triangle") return random_triangle(random);
  if (kind == "cylinder" || kind == "cone") return random_round(kind, random);
  if (kind == "ellipsoid") return Ellipsoid(random_box(random).half_extents());
  if (kind.ends_with("-dop")) return random_dop(kind, random);
  return random_hull(vertices, random);
}

/// The kinds of "sphere-box"; of "box", that twice.
std::pair<std::string, std::string> kinds_of(const std::string& pair) {
  const std::size_t dash = pair.find('-');
  if (dash == std::string::npos) return {pair, pair};
  return {pair.substr(0, dash), pair.substr(dash + 1)};
}

/// The radius of a ball around the origin that holds it.
double reach_of(const PosedSmooth& shape) { return length(shape.half()); }

double reach_of(const PosedConvex& shape) {
  double reach = 0;
  for (Index i = 0; i < shape.vertex_count(); ++i) reach = std::max(reach, length(shape.vertex(i)));
  return reach + shape.radius();
}

double reach_of(const ConvexBody& body) {
  return std::visit([]<class Shape>(const Shape& shape) { return reach_of(PosedAs<Shape>(shape, Pose{})); }, body);
}

Distance distance_of(const ConvexPair& pair, const ConvexQuestion& question) {
  return std::visit(
      [&]<class A, class B>(const A& a, const B& b) {
        return distance(PosedAs<A>(a, question.a), PosedAs<B>(b, question.b));
      },
      pair.a, pair.b);
}

/// Moves B along the shortest way until the gap is 1 % of the smaller shape.
void leave_gap(const ConvexPair& pair, ConvexQuestion& question) {
  const Distance now = distance_of(pair, question);
  const double gap = 0.01 * std::min(reach_of(pair.a), reach_of(pair.b));
  if (now.upper == 0) return;
  question.b.offset = question.b.offset + ((gap - now.upper) / now.upper) * (now.on_b - now.on_a);
}

ConvexQuestion random_question(const std::string& regime, const ConvexPair& pair, Random& random) {
  ConvexQuestion question;
  question.a = {random_rotation(random), {}};
  question.b = {random_rotation(random), {}};
  const double reach = reach_of(pair.a) + reach_of(pair.b);
  const double away = regime == "deep" ? 0.3 * random.unit() : regime == "far" ? random.between(1.5, 5) : 1.1;
  question.b.offset = away * reach * random_direction(random);
  if (regime == "near") leave_gap(pair, question);
  const Vec3 both = 5 * random_direction(random);
  question.a.offset = question.a.offset + both;
  question.b.offset = question.b.offset + both;
  return question;
}

/// How far away B goes round A, of the sum of both sizes: deep in A where a depth is asked for.
double distance_of_walk(ConvexTask task) {
  return task == ConvexTask::penetration || task == ConvexTask::manifold ? 0.3 : 1.02;
}

/// B goes round A near by, and both turn, by 1 % of their size a step.
void add_walk(std::size_t number, const ConvexPair& pair, std::size_t steps, Random& random, ConvexWork& work) {
  constexpr double degrees = 0.01 * 180 / 3.14159265358979323846;
  const double reach = distance_of_walk(work.task) * (reach_of(pair.a) + reach_of(pair.b));
  const Vec3 start = random_direction(random);
  const Vec3 across = cross(start, random_direction(random));
  const Vec3 axis_a = random_direction(random), axis_b = random_direction(random);
  const Mat3 first_a = random_rotation(random), first_b = random_rotation(random);
  for (std::size_t step = 0; step < steps; ++step) {
    const double angle = degrees * static_cast<double>(step);
    const auto turned = [&](const Vec3& axis, const Mat3& first) {
      return compose({rotation_about(axis, angle), {}}, {first, {}}).linear;
    };
    const Vec3 centre = reach * transform({rotation_about(across, angle / 2), {}}, start);
    work.questions.push_back({number, {turned(axis_a, first_a), {}}, {turned(axis_b, first_b), centre}, step > 0});
  }
}

}  // namespace

PosedConvex posed(const ConvexBody& body, const Pose& pose) {
  return std::visit(
      [&]<class Shape>(const Shape& shape) -> PosedConvex {
        if constexpr (Smooth<Shape>)
          throw Error("a shape with round sides has no vertices");
        else
          return PosedConvex(shape, pose);
      },
      body);
}

ConvexWork convex_work(const ConvexArguments& arguments) {
  static const std::map<std::string, ConvexTask> tasks{{"overlap", ConvexTask::overlap},
                                                       {"distance", ConvexTask::distance},
                                                       {"penetration", ConvexTask::penetration},
                                                       {"manifold", ConvexTask::manifold}};
  ConvexWork work{arguments.pair, tasks.at(arguments.task), arguments.regime == "coherent"};
  Random random(arguments.seed);
  const auto [kind_a, kind_b] = kinds_of(arguments.pair);
  const std::size_t pairs = std::min(arguments.count, different_pairs);
  for (std::size_t i = 0; i < pairs; ++i) {
    ConvexBody a = random_body(kind_a, arguments.vertices, random);
    ConvexBody b = random_body(kind_b, arguments.vertices, random);
    work.pairs.push_back({std::move(a), std::move(b)});
  }
  if (work.coherent) {
    for (std::size_t i = 0; i < pairs; ++i)
      add_walk(i, work.pairs[i], arguments.count * (i + 1) / pairs - arguments.count * i / pairs, random, work);
    return work;
  }
  for (std::size_t i = 0; i < arguments.count; ++i) {
    ConvexQuestion question = random_question(arguments.regime, work.pairs[i % pairs], random);
    question.pair = i % pairs;
    work.questions.push_back(question);
  }
  return work;
}

}  // namespace toccata::bench
