#include "narrow/quadrics/distance/fast_refinement.hpp"

#include <algorithm>
#include <cmath>

#include "math/vec3_measures.hpp"

namespace toccata {
namespace {

constexpr int most_fast_newton_steps = 12;
/// What is left after a turn this small is about its square, which is what doubles tell.
constexpr double small_turn = 0x1p-26;
/// Weights and lengths below this are rounding.
constexpr double slack_of_weights = 0x1p-40;

/// Two unit vectors across d and each other (T. Duff et al., "Building an orthonormal basis, revisited", 2017).
std::array<Vec3, 2> basis_across(const Vec3& d) {
  const double sign = std::copysign(1.0, d.z), a = -1 / (sign + d.z), b = d.x * d.y * a;
  return {Vec3{1 + sign * d.x * d.x * a, sign * b, -sign * d.x}, Vec3{b, sign + d.y * d.y * a, -d.y}};
}

/// A vector and a symmetric matrix across the direction.
struct Flat {
  double x = 0, y = 0;
};
struct FlatMatrix {
  double xx = 0, xy = 0, yy = 0;
};

double dot(const Flat& u, const Flat& v) { return u.x * v.x + u.y * v.y; }
Flat operator*(const FlatMatrix& m, const Flat& v) { return {m.xx * v.x + m.xy * v.y, m.xy * v.x + m.yy * v.y}; }
Flat operator-(const Flat& u, const Flat& v) { return {u.x - v.x, u.y - v.y}; }

/// M (1 − u uᵀ) Mᵀ across the direction, from the products of M with the two directions there: as |u| = 1, of t it is
/// |Mᵀt × u|².
FlatMatrix bent(const Vec3& along_t, const Vec3& along_s, const Vec3& round, std::size_t columns) {
  if (columns == 2) {
    const double f = round.x * along_t.y - round.y * along_t.x, g = round.x * along_s.y - round.y * along_s.x;
    return {f * f, f * g, g * g};
  }
  const Vec3 f = cross(along_t, round), g = cross(along_s, round);
  return {dot(f, f), dot(f, g), dot(g, g)};
}

}  // namespace

double FastSide::grown_weight() const {
  double grown = 0;
  for (std::size_t i = 0; i < size; ++i)
    if (body->grown(generator[i])) grown += weight[i];
  return grown;
}

FastRefinement::FastRefinement(const PlainBody& a, const PlainBody& b) {
  side_[0].body = &a;
  side_[0].outward = -1;
  side_[1].body = &b;
  side_[1].outward = 1;
}

void FastRefinement::begin_side(FastSide& side, std::span<const QuadricSearch::Corner> corners) {
  const PlainBody& body = *side.body;
  const auto of = side.outward < 0 ? QuadricSearch::SideOf::a : QuadricSearch::SideOf::b;
  const QuadricSearch::Carried carried = QuadricSearch::carried(corners, of, body);
  side.size = std::min(carried.size, side.generator.size());  // of the four of a simplex around the origin three
  std::copy_n(carried.generator.begin(), side.size, side.generator.begin());
  std::copy_n(carried.weight.begin(), side.size, side.weight.begin());
  side.round = carried.round;
  side.in_cap = false;
  if (body.column_count() != 2 || !(carried.grown > 0)) return;
  const double slope = plain_length(body.along_columns(direction_));
  const double widest = std::max(plain_length(body.plain_column(0)), plain_length(body.plain_column(1)));
  const double squared = dot(side.round, side.round);
  side.in_cap = slope < 0x1p-30 * widest || (squared < 0.998 && slope < 0.01 * widest);
}

FastRefinement::Witness FastRefinement::witness_of(FastSide& side) const {
  const PlainBody& body = *side.body;
  Witness witness;
  if (side.size == 1 && body.column_count() == 0) return {body.plain_centre(side.generator[0]), 0};
  for (std::size_t i = 0; i < side.size; ++i)
    witness.point = witness.point + side.weight[i] * body.plain_centre(side.generator[i]);
  const double grown = side.grown_weight();
  if (!(grown > 0) && !side.in_cap && !side.any_grown(body)) return witness;
  if (!side.in_cap) {
    const Vec3 along = side.outward * body.along_columns(direction_);
    const double length = plain_length(along);
    side.round = (1 / length) * along;
    witness.bend = grown / length;
  }
  witness.point = witness.point + grown * body.map(side.round);
  return witness;
}

void FastRefinement::collect_edges(FastSide& side) {
  const PlainBody& body = *side.body;
  const auto add = [&](const Vec3& along, std::size_t which) {
    if (edges_ < 2) edge_[edges_] = {-side.outward * along, &side, which};
    ++edges_;
  };
  const Vec3 mapped = body.column_count() > 0 ? body.map(side.round) : Vec3{};
  const auto corner = [&](std::size_t i) {
    const Vec3 centre = body.plain_centre(side.generator[i]);
    return body.grown(side.generator[i]) ? centre + mapped : centre;
  };
  for (std::size_t i = 1; i < side.size; ++i) add(corner(i) - corner(0), i);
  if (!side.in_cap) return;
  for (std::size_t j = 0; j < 2; ++j) add(side.grown_weight() * body.plain_column(j), 3 + j);
}

bool FastRefinement::collect_edges() {
  edges_ = 0;
  collect_edges(side_[0]);
  collect_edges(side_[1]);
  return edges_ <= 2;
}

FastRefinement::Step FastRefinement::step() {
  const Witness of_a = witness_of(side_[0]), of_b = witness_of(side_[1]);
  if (!collect_edges()) return Step::failed;
  const Vec3 z = of_a.point - of_b.point;
  const double gap = dot(z, direction_);
  if (!(gap > 0)) return Step::failed;
  const std::array<Vec3, 2> across = basis_across(direction_);
  const Vec3 &t = across[0], &s = across[1];  // not by structured binding: clang 14 captures none
  const auto flat = [&](const Vec3& v) { return Flat{dot(t, v), dot(s, v)}; };
  FlatMatrix k{gap, 0, gap};
  for (std::size_t i = 0; i < 2; ++i) {
    const double bend = i == 0 ? of_a.bend : of_b.bend;
    if (!(bend > 0)) continue;
    const PlainBody& body = *side_[i].body;
    const FlatMatrix h = bent(body.along_columns(t), body.along_columns(s), side_[i].round, body.column_count());
    k = {k.xx + bend * h.xx, k.xy + bend * h.xy, k.yy + bend * h.yy};
  }
  const Flat rest = flat(z);
  Flat turn;
  std::array<double, 2> along{};
  if (edges_ == 0) {
    const double part = 1 / (k.xx * k.yy - k.xy * k.xy);
    turn = {part * (k.yy * rest.x - k.xy * rest.y), part * (k.xx * rest.y - k.xy * rest.x)};
  } else if (edges_ == 1) {
    const Flat e = flat(edge_[0].along), n{-e.y, e.x};
    const double part = 1 / dot(e, e), towards = -part * dot(edge_[0].along, direction_);
    const double sideways = (dot(n, rest) - towards * dot(n, k * e)) / dot(n, k * n);
    turn = {towards * e.x + sideways * n.x, towards * e.y + sideways * n.y};
    along[0] = part * dot(e, k * turn - rest);
  } else {
    const Flat e = flat(edge_[0].along), f = flat(edge_[1].along);
    const double determinant = e.x * f.y - e.y * f.x;
    const double p = -dot(edge_[0].along, direction_), q = -dot(edge_[1].along, direction_);
    turn = {(p * f.y - q * e.y) / determinant, (q * e.x - p * f.x) / determinant};
    const Flat left = k * turn - rest;
    along = {(left.x * f.y - left.y * f.x) / determinant, (e.x * left.y - e.y * left.x) / determinant};
  }
  const double size = std::max(std::fabs(turn.x), std::fabs(turn.y));
  // Asked so that NaN fails.
  if (!(size < 1)) {
    if (!std::isfinite(size)) return Step::failed;
    const double less = 1 / size;
    turn = {less * turn.x, less * turn.y};
    along = {less * along[0], less * along[1]};
  }
  turn_by(turn.x * t + turn.y * s, dot(turn, turn));
  move_by(along);
  return size < small_turn ? Step::small : Step::far;
}

/// Turns the direction by a vector across it.
void FastRefinement::turn_by(const Vec3& turn, double squared) {
  const Vec3 turned = direction_ + turn;
  // The series of 1 / √(1 + squared) is as good as doubles are there, and sooner known.
  const double shorter = squared < 0x1p-18 ? 1 - squared * (0.5 - 0.375 * squared) : 1 / plain_length(turned);
  direction_ = shorter * turned;
}

void FastRefinement::move_by(const std::array<double, 2>& along_edges) {
  for (std::size_t i = 0; i < edges_; ++i) {
    FastSide& side = *edge_[i].side;
    if (edge_[i].which < 3) {
      side.weight[edge_[i].which] += along_edges[i];
      side.weight[0] -= along_edges[i];
    } else {
      side.round[static_cast<int>(edge_[i].which - 3)] += along_edges[i];
    }
  }
}

bool FastRefinement::change(FastSide& side) {
  if (side.drop_negative(slack_of_weights)) {
    if (side.in_cap && !(side.grown_weight() > 0)) side.in_cap = false;
    return true;
  }
  if (side.in_cap && dot(side.round, side.round) > 1 + slack_of_weights) {
    // On the rim then; the direction to there tells where on it.
    side.round = unit_or_zero(side.round);
    direction_ = unit_or_zero(witness_of(side_[0]).point - witness_of(side_[1]).point);
    side.in_cap = false;
    return true;
  }
  const QuadricSupport farthest = side.body->support(side.outward * direction_);
  if (side.has(farthest.generator)) return false;
  const PlainBody& body = *side.body;
  const Vec3 own = body.grown(side.generator[0]) ? body.plain_centre(side.generator[0]) + body.map(side.round)
                                                 : body.plain_centre(side.generator[0]);
  if (side.size == 3 || !(side.outward * dot(direction_, farthest.point - own) > 0x1p-47)) return false;
  side.append(farthest.generator, 0);
  return true;
}

void FastRefinement::begin(std::span<const QuadricSearch::Corner> corners, const Vec3& direction) {
  direction_ = unit_or_zero(direction);
  begin_side(side_[0], corners);
  begin_side(side_[1], corners);
}

bool FastRefinement::run() {
  for (int i = 0; i < most_fast_newton_steps; ++i) {
    const Step step_taken = step();
    if (step_taken == Step::failed) return false;
    if (step_taken == Step::far) continue;
    const bool of_a = change(side_[0]), of_b = change(side_[1]);
    if (of_a || of_b) continue;
    settle_round_parts();
    return true;
  }
  return false;
}

bool FastRefinement::refine() {
  if (step() != Step::small) return false;
  settle_round_parts();
  return true;
}

/// What they are for the last direction.
void FastRefinement::settle_round_parts() {
  for (FastSide& side : side_)
    if (side.body->column_count() > 0) (void)witness_of(side);
}

}  // namespace toccata
