#include "narrow/quadrics/distance/newton_refinement.hpp"

#include <algorithm>
#include <cmath>

#include "math/vec3_measures.hpp"
#include "narrow/quadrics/distance/pivoted_system.hpp"

namespace toccata {
namespace {

constexpr int most_newton_steps = 12;
constexpr int most_changes = 16;
/// Residuals of this size are rounding, in a frame where the bodies are of size 1.
constexpr double settled = 0x1p-46;

double rounded(double x) { return x; }
double rounded(const DoubleWord& x) { return x.high; }

}  // namespace

/// What a side is made of, in numbers of one kind.
template <class Number>
struct NewtonRefinement::Values {
  Values(const Side& side, const VectorOf<Number>& direction) {
    const QuadricBody& body = *side.body;
    for (std::size_t j = 0; j < body.column_count(); ++j) {
      column[j] = vector_as<Number>(body.column(j));
      round[j] = number_as<Number>(side.round[j]);
      along[j] = inner(column[j], direction);
      mapped = j == 0 ? multiple(round[0], column[0]) : sum(mapped, multiple(round[j], column[j]));
    }
    for (std::size_t i = 0; i < side.size; ++i) {
      const Number weight = number_as<Number>(side.weight[i]);
      grown[i] = body.grown(side.generator[i]) && side.kind != Round::none;
      corner[i] = vector_as<Number>(body.centre(side.generator[i]));
      if (grown[i]) corner[i] = sum(corner[i], mapped);
      point = i == 0 ? multiple(weight, corner[0]) : sum(point, multiple(weight, corner[i]));
      if (grown[i]) grown_weight = grown_weight + weight;
    }
  }

  std::array<VectorOf<Number>, 3> column{};
  std::array<Number, 3> round{};
  std::array<Number, 3> along{};
  VectorOf<Number> mapped{};
  std::array<VectorOf<Number>, 4> corner{};
  std::array<bool, 4> grown{};
  VectorOf<Number> point{};
  Number grown_weight{};
};

BodyPoint NewtonRefinement::Side::point() const { return {*this, round}; }

std::size_t NewtonRefinement::Side::unknowns() const {
  const std::size_t of_round = kind == Round::none ? 0 : body->column_count() + (kind == Round::side ? 1 : 0);
  return size - 1 + of_round;
}

NewtonRefinement::NewtonRefinement(const QuadricBody& a, const QuadricBody& b) {
  side_[0].body = &a;
  side_[0].outward = -1;
  side_[1].body = &b;
  side_[1].outward = 1;
}

void NewtonRefinement::begin_side(Side& side, std::span<const QuadricSearch::Corner> corners, Attempt attempt) {
  const QuadricBody& body = *side.body;
  const auto of = &side == side_.data() ? QuadricSearch::SideOf::a : QuadricSearch::SideOf::b;
  const QuadricSearch::Carried carried = QuadricSearch::carried(corners, of, body);
  side.size = carried.size;
  side.generator = carried.generator;
  for (std::size_t i = 0; i < side.size; ++i) side.weight[i] = {carried.weight[i], 0};
  side.kind = Round::none;
  if (!(carried.grown > 0)) return;
  Vec3 round = carried.round;
  const Vec3 d{direction_[0].high, direction_[1].high, direction_[2].high};
  const Vec3 along = side.outward * body.along_columns(d);
  const double slope = plain_length(along), length = plain_length(round);
  const double widest = std::fmax(plain_length(body.plain_column(0)), plain_length(body.plain_column(1)));
  const bool may_be_cap = body.column_count() == 2 && length < 1 && slope < 0.1 * widest;
  bool is_cap = may_be_cap && (slope < 0x1p-30 * widest || (length < 0.999 && slope < 0.01 * widest));
  doubtful_ = doubtful_ || may_be_cap;
  if (may_be_cap && attempt == Attempt::second) is_cap = !is_cap;
  side.kind = is_cap ? Round::cap : Round::side;
  if (side.kind == Round::side)
    round = length > 0.5 ? (1 / length) * round : slope > 0 ? (1 / slope) * along : Vec3{1, 0, 0};
  side.slope = {side.kind == Round::side ? slope : 0, 0};
  for (std::size_t j = 0; j < 3; ++j) side.round[j] = {round[static_cast<int>(j)], 0};
}

void NewtonRefinement::begin(std::span<const QuadricSearch::Corner> corners, const Vec3& direction, Attempt attempt) {
  doubtful_ = false;
  direction_ = fine(unit_or_zero(direction));
  begin_side(side_[0], corners, attempt);
  begin_side(side_[1], corners, attempt);
  begin_distance();
}

void NewtonRefinement::begin_side(Side& side, const FastSide& guess) {
  const PlainBody& body = *side.body;
  side.size = guess.size;
  std::copy_n(guess.generator.begin(), guess.size, side.generator.begin());
  for (std::size_t i = 0; i < side.size; ++i) side.weight[i] = {guess.weight[i], 0};
  const bool any = side.any_grown(body);
  side.kind = !any ? Round::none : guess.in_cap ? Round::cap : Round::side;
  const Vec3 d{direction_[0].high, direction_[1].high, direction_[2].high};
  side.slope = {side.kind == Round::side ? plain_length(body.along_columns(d)) : 0, 0};
  for (std::size_t j = 0; j < 3; ++j) side.round[j] = {any ? guess.round[static_cast<int>(j)] : 0, 0};
}

void NewtonRefinement::begin(const FastRefinement& guess) {
  doubtful_ = false;
  direction_ = fine(guess.direction());
  begin_side(side_[0], guess.on_a());
  begin_side(side_[1], guess.on_b());
  begin_distance();
}

/// The distance of the points that the sides begin with.
void NewtonRefinement::begin_distance() {
  const Vec3 d{direction_[0].high, direction_[1].high, direction_[2].high};
  const VectorOf<double> exact = vector_as<double>(direction_);
  const auto x = Values<double>(side_[0], exact).point, y = Values<double>(side_[1], exact).point;
  distance_ = {inner(difference(x, y), VectorOf<double>{d.x, d.y, d.z}), 0};
}

void NewtonRefinement::number_unknowns() {
  side_[0].first_unknown = 4;
  side_[1].first_unknown = 4 + side_[0].unknowns();
  unknowns_ = side_[1].first_unknown + side_[1].unknowns();
}

template <class Number>
std::array<Number, 20> NewtonRefinement::residuals() const {
  std::array<Number, 20> rest{};
  const VectorOf<Number> d = vector_as<Number>(direction_);
  const Values<Number> of_a(side_[0], d), of_b(side_[1], d);
  const VectorOf<Number> apart =
      difference(difference(of_a.point, of_b.point), multiple(number_as<Number>(distance_), d));
  for (std::size_t i = 0; i < 3; ++i) rest[i] = apart[i];
  rest[3] = number_as<Number>(0.5) * (inner(d, d) - number_as<Number>(1.0));
  for (const Side& side : side_) {
    const Values<Number>& own = &side == side_.data() ? of_a : of_b;
    std::size_t row = side.first_unknown;
    for (std::size_t i = 1; i < side.size; ++i) rest[row++] = inner(d, difference(own.corner[i], own.corner[0]));
    if (side.kind == Round::none) continue;
    const Number outward = number_as<Number>(side.outward), slope = number_as<Number>(side.slope);
    Number squared = number_as<Number>(-1.0);
    for (std::size_t j = 0; j < side.body->column_count(); ++j) {
      rest[row++] = side.kind == Round::side ? outward * own.along[j] - slope * own.round[j] : own.along[j];
      squared = squared + own.round[j] * own.round[j];
    }
    if (side.kind == Round::side) rest[row] = number_as<Number>(0.5) * squared;
  }
  return rest;
}

template <class Number>
double NewtonRefinement::step() {
  number_unknowns();
  const auto rest = residuals<Number>();
  PivotedSystem system(unknowns_);
  double largest = 0;
  for (std::size_t row = 0; row < unknowns_; ++row) {
    system.right(row) = -rounded(rest[row]);
    largest = std::fmax(largest, std::fabs(rounded(rest[row])));
  }
  if (!std::isfinite(largest)) return HUGE_VAL;
  const VectorOf<double> d = vector_as<double>(direction_);
  for (std::size_t i = 0; i < 3; ++i) {
    system.at(i, i) = -distance_.high;
    system.at(i, 3) = -d[i];
    system.at(3, i) = d[i];
  }
  for (const Side& side : side_) {
    const Values<double> own(side, d);
    const double sign = -side.outward;  // of the side's point in x − y
    std::size_t next = side.first_unknown;
    const std::size_t first_round = next + side.size - 1;
    for (std::size_t i = 1; i < side.size; ++i, ++next) {
      const VectorOf<double> edge = difference(own.corner[i], own.corner[0]);
      for (std::size_t k = 0; k < 3; ++k) {
        system.at(k, next) = sign * edge[k];
        system.at(next, k) = edge[k];
      }
      const double grown = (own.grown[i] ? 1.0 : 0.0) - (own.grown[0] ? 1.0 : 0.0);
      if (grown != 0)
        for (std::size_t j = 0; j < side.body->column_count(); ++j)
          system.at(next, first_round + j) = grown * own.along[j];
    }
    if (side.kind == Round::none) continue;
    const std::size_t columns = side.body->column_count(), slope = first_round + columns;
    const bool is_side = side.kind == Round::side;
    for (std::size_t j = 0; j < columns; ++j) {
      const std::size_t unknown = first_round + j;
      for (std::size_t k = 0; k < 3; ++k) {
        system.at(k, unknown) = sign * own.grown_weight * own.column[j][k];
        system.at(unknown, k) = (is_side ? side.outward : 1) * own.column[j][k];
      }
      if (!is_side) continue;
      system.at(unknown, unknown) = -side.slope.high;
      system.at(unknown, slope) = -own.round[j];
      system.at(slope, unknown) = own.round[j];
    }
  }
  move_by(system.solve());
  return largest;
}

void NewtonRefinement::move_by(const std::array<double, 20>& change) {
  const auto add = [](DoubleWord& to, double x) { to = to + DoubleWord{x, 0}; };
  for (std::size_t i = 0; i < 3; ++i) add(direction_[i], change[i]);
  add(distance_, change[3]);
  for (Side& side : side_) {
    std::size_t next = side.first_unknown;
    for (std::size_t i = 1; i < side.size; ++i, ++next) {
      add(side.weight[i], change[next]);
      add(side.weight[0], -change[next]);
    }
    if (side.kind == Round::none) continue;
    for (std::size_t j = 0; j < side.body->column_count(); ++j) add(side.round[j], change[next++]);
    if (side.kind == Round::side) add(side.slope, change[next]);
  }
}

bool NewtonRefinement::converge() {
  double last = HUGE_VAL;
  for (int i = 0; i < most_newton_steps; ++i) {
    const double rest = step<double>();
    if (!std::isfinite(rest) || rest > 1e3) return false;
    if (rest < settled) return true;
    if (i > 4 && rest > 0.5 * last) return rest < 1e-8;
    last = rest;
  }
  return last < 1e-8;
}

bool NewtonRefinement::add_missing_generator(Side& side) {
  const Vec3 d = side.outward * Vec3{direction_[0].high, direction_[1].high, direction_[2].high};
  const QuadricSupport farthest = side.body->support(d);
  if (side.has(farthest.generator) || side.size == 4) return false;
  const VectorOf<double> exact = vector_as<double>(direction_);
  const Values<double> own(side, exact);
  const Vec3 corner{own.corner[0][0], own.corner[0][1], own.corner[0][2]};
  if (!(dot(d, farthest.point - corner) > 0x1p-47)) return false;
  add_generator(side, farthest.generator);
  return true;
}

void NewtonRefinement::add_generator(Side& side, Index which) {
  side.append(which, {});
  if (side.kind != Round::none || !side.body->grown(which)) return;
  const Vec3 along =
      side.body->along_columns(side.outward * Vec3{direction_[0].high, direction_[1].high, direction_[2].high});
  const Vec3 round = unit_or_zero(along);
  side.kind = Round::side;
  for (std::size_t j = 0; j < 3; ++j) side.round[j] = {round[static_cast<int>(j)], 0};
  side.slope = {plain_length(along), 0};
}

bool NewtonRefinement::add_finely_missing_generator(Side& side) {
  if (side.size == 4) return false;
  FineDirection outward = direction_;
  if (side.outward < 0)
    for (DoubleWord& x : outward) x = -x;
  std::array<Index, 16> found;
  const Index count = side.body->highest_generators({outward[0].high, outward[1].high, outward[2].high}, found);
  const BoundedNumber own = generator_height<BoundedNumber>(*side.body, side.generator[0], outward);
  double most = 0x1p-90;
  std::optional<Index> missing;
  for (Index i = 0; i < std::min<Index>(count, 16); ++i) {
    if (side.has(found[i])) continue;
    const double above = (generator_height<BoundedNumber>(*side.body, found[i], outward) - own).value.high;
    if (!(above > most)) continue;
    most = above;
    missing = found[i];
  }
  if (missing) add_generator(side, *missing);
  return missing.has_value();
}

bool NewtonRefinement::change(Side& side) {
  if (side.drop_negative(slack_)) {
    if (!side.any_grown(*side.body)) side.kind = Round::none;
    return true;
  }
  if (side.kind == Round::side && side.slope.high < 0) {
    if (side.body->column_count() == 3) {
      for (DoubleWord& u : side.round) u = -u;
      side.slope = -side.slope;
    } else {
      side.kind = Round::cap;
    }
    return true;
  }
  if (side.kind == Round::cap) {
    const double x = side.round[0].high, y = side.round[1].high, length = std::sqrt(x * x + y * y);
    const DoubleWord one{-1, 0};
    const double squared_excess = ((side.round[0] * side.round[0] + side.round[1] * side.round[1]) + one).high;
    if (squared_excess > 2 * slack_) {
      side.round = {DoubleWord{x / length, 0}, DoubleWord{y / length, 0}, DoubleWord{}};
      side.slope = {};
      side.kind = Round::side;
      return true;
    }
  }
  return slack_ < 0x1p-60 ? add_finely_missing_generator(side) : add_missing_generator(side);
}

bool NewtonRefinement::change_active_set() {
  const bool of_a = change(side_[0]), of_b = change(side_[1]);
  return of_a || of_b;
}

bool NewtonRefinement::settle() {
  slack_ = 0x1p-40;
  for (int i = 0; i < most_changes; ++i) {
    if (!converge()) return false;
    if (!change_active_set()) return true;
  }
  return false;
}

void NewtonRefinement::refine() {
  slack_ = 0x1p-85;
  for (int i = 0; i < most_changes; ++i) {
    for (int k = 0; k < 4; ++k)
      if (step<DoubleWord>() < 0x1p-92) break;
    if (!change_active_set()) return;
  }
}

}  // namespace toccata
