#include "convex_questions.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "random_bodies.hpp"
#include "toccata/core/error.hpp"
#include "toccata/core/random.hpp"
#include "toccata/math/pose.hpp"
#include "toccata/narrow/convex_convex.hpp"
#include "toccata/narrow/quadrics.hpp"

namespace toccata::bench {
namespace {

/// The kinds of "sphere-box"; of "box", that twice.
std::pair<std::string, std::string> kinds_of(const std::string& pair) {
  const std::size_t dash = pair.find('-');
  if (dash == std::string::npos) return {pair, pair};
  return {pair.substr(0, dash), pair.substr(dash + 1)};
}

Distance distance_of(const ConvexPair& pair, const ConvexQuestion& question) {
  return std::visit(
      [&]<class A, class B>(const A& a, const B& b) {
        return distance(PosedAs<A>(a, question.a), PosedAs<B>(b, question.b));
      },
      pair.a, pair.b);
}

/// Moves B along the shortest way until the gap is that part of the smaller shape; negative: beyond contact.
void leave_gap(double part, const ConvexPair& pair, ConvexQuestion& question) {
  const Distance now = distance_of(pair, question);
  const double gap = part * std::min(reach_of(pair.a), reach_of(pair.b));
  if (now.upper == 0) return;
  question.b.offset = question.b.offset + ((gap - now.upper) / now.upper) * (now.on_b - now.on_a);
}

ConvexQuestion random_question(const ConvexArguments& arguments, const ConvexPair& pair, Random& random) {
  const std::string& regime = arguments.regime;
  ConvexQuestion question;
  question.a = {random_rotation(random), {}};
  question.b = {random_rotation(random), {}};
  const double reach = reach_of(pair.a) + reach_of(pair.b);
  const double away = regime == "deep" ? 0.3 * random.unit() : regime == "far" ? random.between(1.5, 5) : 1.1;
  question.b.offset = away * reach * unit_vector(random);
  if (regime == "near") leave_gap(arguments.gap, pair, question);
  const Vec3 both = 5 * unit_vector(random);
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
  const Vec3 start = unit_vector(random);
  const Vec3 across = cross(start, unit_vector(random));
  const Vec3 axis_a = unit_vector(random), axis_b = unit_vector(random);
  const Mat3 first_a = random_rotation(random), first_b = random_rotation(random);
  for (std::size_t step = 0; step < steps; ++step) {
    const double angle = degrees * static_cast<double>(step);
    const auto turned = [&](const Vec3& axis, const Mat3& first) { return rotation_about(axis, angle) * first; };
    const Vec3 centre = reach * transform({rotation_about(across, angle / 2), {}}, start);
    work.questions.push_back({number, {turned(axis_a, first_a), {}}, {turned(axis_b, first_b), centre}, step > 0});
  }
}

}  // namespace

PosedPolytope posed(const ConvexBody& body, const Pose& pose) {
  return std::visit(
      [&]<class Shape>(const Shape& shape) -> PosedPolytope {
        if constexpr (Quadric<Shape>)
          throw Error("a shape with round sides has no vertices");
        else
          return PosedPolytope(shape, pose);
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
    ConvexQuestion question = random_question(arguments, work.pairs[i % pairs], random);
    question.pair = i % pairs;
    work.questions.push_back(question);
  }
  return work;
}

}  // namespace toccata::bench
