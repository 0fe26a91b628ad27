#include "support/motion_judge.hpp"

#include <fmt/format.h>

#include "oracle/motion.hpp"

namespace toccata::test {
namespace {

template <class Pair>
std::optional<std::string> wrong(const Pair& pair, const std::optional<TimeOfImpact>& answer) {
  const auto truth = oracle::contact_time(pair);
  if (truth && !answer) return "a contact is missed";
  if (!truth && answer) return "a contact that is none";
  if (!truth) return std::nullopt;
  const int above = oracle::compared(*truth, oracle::exact(answer->lower));
  const int below = -oracle::compared(*truth, oracle::exact(answer->upper));
  if (above < 0 || below < 0) return fmt::format("the time is not in [{:a}, {:a}]", answer->lower, answer->upper);
  const oracle::Rational cell = oracle::exact(answer->lower).scaled(40);
  if (!cell.is_dyadic() || cell.exponent() < 0) return "the lower end is no multiple of 2^-40";
  // A time that is a multiple itself is told as such; else the upper end is the next.
  const double width = above == 0 ? 0 : 0x1p-40;
  if (answer->upper != answer->lower + width)
    return fmt::format("[{:a}, {:a}] is no cell", answer->lower, answer->upper);
  return std::nullopt;
}

std::string told(const MovingPoint& p) {
  return fmt::format("{{{{{:a}, {:a}, {:a}}}, {{{:a}, {:a}, {:a}}}}}", p.start.x, p.start.y, p.start.z, p.end.x,
                     p.end.y, p.end.z);
}

}  // namespace

std::optional<std::string> wrong_answer(const VertexFace& pair, const std::optional<TimeOfImpact>& answer) {
  return wrong(pair, answer);
}
std::optional<std::string> wrong_answer(const EdgeEdge& pair, const std::optional<TimeOfImpact>& answer) {
  return wrong(pair, answer);
}

std::string told(const VertexFace& pair) {
  return fmt::format("VertexFace{{{}, {{{}, {}, {}}}}}", told(pair.vertex), told(pair.face[0]), told(pair.face[1]),
                     told(pair.face[2]));
}
std::string told(const EdgeEdge& pair) {
  return fmt::format("EdgeEdge{{{{{}, {}}}, {{{}, {}}}}}", told(pair.a[0]), told(pair.a[1]), told(pair.b[0]),
                     told(pair.b[1]));
}

}  // namespace toccata::test
