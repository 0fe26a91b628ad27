#include "cast_questions.hpp"

#include <cmath>

#include "random_bodies.hpp"
#include "toccata/core/error.hpp"

namespace toccata::bench {
namespace {

CastBody random_cast_body(const std::string& kind, Random& random) {
  if (kind == "ray") return Point(Vec3{});
  return std::visit(
      [&]<class Shape>(const Shape& shape) -> CastBody {
        if constexpr (std::is_constructible_v<CastBody, const Shape&>)
          return shape;
        else
          throw Error("--pair " + kind + ": no shape of this kind is cast");
      },
      random_body(kind, 0, random));
}

double reach_of_cast_body(const CastBody& body) {
  return std::visit(
      []<class Shape>(const Shape& shape) {
        if constexpr (std::is_same_v<Shape, Point>)
          return 0.0;
        else
          return reach_of(ConvexBody(shape));
      },
      body);
}

/// A way past the middle of what stands, beside it by a part of `aside`.
struct Passing {
  Vec3 from;
  Vec3 middle;
  Vec3 aside;
};

CastQuestion passed(CastQuestion question, const Passing& passing, double part) {
  question.start.offset = passing.from;
  question.motion = 1.5 * (passing.middle + part * passing.aside - passing.from);
  return question;
}

/// The part at which it hardly meets any more, to a millionth.
double border(const CastPair& pair, const CastQuestion& question, const Passing& passing) {
  double meets = 0, misses = 2;
  while (misses - meets > 1e-6) {
    const double middle = 0.5 * (meets + misses);
    (cast_of(pair, passed(question, passing, middle)) ? meets : misses) = middle;
  }
  return meets;
}

CastQuestion random_cast(const std::string& regime, const CastPair& pair, Random& random) {
  CastQuestion question;
  question.start.linear = random_rotation(random);
  question.standing.linear = random_rotation(random);
  const double reach = reach_of_cast_body(pair.moving) + reach_of_cast_body(pair.standing);
  const Vec3 towards = unit_vector(random), across = cross(towards, unit_vector(random));
  const Vec3 middle = 5 * unit_vector(random);
  const double away = random.between(2, 5) * reach;
  question.standing.offset = middle;
  const Passing passing{middle - away * towards, middle, (reach / std::sqrt(dot(across, across))) * across};
  const double part = random.between(-1, 1);
  const double least = border(pair, question, passing);
  const double chosen = regime == "hit" ? 0.4 * (1 + part) : regime == "graze" ? 1 + 0.01 * part : 1.5 + 0.45 * part;
  return passed(question, passing, chosen * least);
}

}  // namespace

std::optional<Cast> cast_of(const CastPair& pair, const CastQuestion& question) {
  return std::visit([&](const auto& moving, const auto& standing) { return cast_given(moving, standing, question); },
                    pair.moving, pair.standing);
}

CastWork cast_work(const CastsArguments& arguments) {
  CastWork work{arguments.pair};
  Random random(arguments.seed);
  const std::size_t dash = arguments.pair.find('-');
  const std::string moving = arguments.pair.substr(0, dash);
  const std::string standing = dash == std::string::npos ? moving : arguments.pair.substr(dash + 1);
  for (std::size_t i = 0; i < std::min(arguments.count, different_pairs); ++i) {
    CastBody body = random_cast_body(moving, random);
    work.pairs.push_back({std::move(body), random_cast_body(standing, random)});
  }
  for (std::size_t i = 0; i < arguments.count; ++i) {
    const std::size_t pair = i % work.pairs.size();
    work.questions.push_back(random_cast(arguments.regime, work.pairs[pair], random));
    work.questions.back().pair = pair;
  }
  return work;
}

}  // namespace toccata::bench
