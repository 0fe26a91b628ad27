#include <algorithm>

#include <fmt/format.h>

#include "narrow/convex_cells.hpp"
#include "narrow/quadric_cases.hpp"
#include "toccata/narrow/quadrics.hpp"

// Penetration, relation, and casts of quadrics against 60 digits.
namespace toccata::test {
namespace {

using oracle::Fine;

oracle::FineSet moved_set(oracle::FineSet set, const Vec3& by, const Fine& times) {
  const auto move = [&](oracle::FinePoint& p) {
    p = {p.x + times * Fine(by.x), p.y + times * Fine(by.y), p.z + times * Fine(by.z)};
  };
  move(set.centre);
  for (auto& v : set.vertices) move(v);
  return set;
}

/// How far B has to move along the direction until a plane across it is between the sets.
Fine height_along(const oracle::FineSet& a, const oracle::FineSet& b, const Vec3& direction) {
  const oracle::FinePoint d{Fine(direction.x), Fine(direction.y), Fine(direction.z)}, back{-d.x, -d.y, -d.z};
  const oracle::FinePoint p = farthest(a, d), q = farthest(b, back);
  const Fine length = sqrt(d.x * d.x + d.y * d.y + d.z * d.z);
  return ((p.x - q.x) * d.x + (p.y - q.y) * d.y + (p.z - q.z) * d.z) / length;
}

/// How far A − B reaches along the axes.
double difference_size(const oracle::FineSet& a, const oracle::FineSet& b) {
  Fine most = 0;
  for (const Vec3& axis : {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}}) {
    const Fine along = height_along(a, b, axis) + height_along(a, b, -axis);
    if (along > most) most = along;
  }
  return static_cast<double>(most);
}

/// The lowest height that is found from a direction downhill, by turns that become smaller.
Fine lowest_from(const oracle::FineSet& a, const oracle::FineSet& b, Vec3 direction, Random& random) {
  Fine lowest = height_along(a, b, direction);
  double turn = 0.25;
  for (int i = 0; i < 25; ++i, turn *= 0.8) {
    const Vec3 next = direction + turn * quadric_direction(random);
    const Fine height = height_along(a, b, next);
    if (!(height < lowest)) continue;
    lowest = height;
    direction = (1 / std::sqrt(dot(next, next))) * next;
  }
  return lowest;
}

std::string depth_fault(const Penetration& p, const oracle::FineSet& a, const oracle::FineSet& b, Random& random) {
  if (!(p.lower <= p.upper)) return fmt::format("depth from {} to {}", p.lower, p.upper);
  if (!(p.upper > 0)) return "";
  const Fine along = height_along(a, b, p.direction);
  if (along > Fine(p.upper)) return fmt::format("upper {} does not part them", p.upper);
  for (int i = 0; i < 100; ++i) {
    const Fine height = i % 10 == 0 ? lowest_from(a, b, quadric_direction(random), random)
                                    : height_along(a, b, quadric_direction(random));
    if (height < Fine(p.lower)) return fmt::format("lower {} above {}", p.lower, height.str(20));
  }
  if (p.lower >= 0.9 * p.upper || p.upper <= 1e-12 * difference_size(a, b)) return "";
  return fmt::format("depth from {} to {}", p.lower, p.upper);
}

std::string cast_fault(const std::optional<Cast>& cast, const oracle::FineSet& a, const Vec3& motion,
                       const oracle::FineSet& b) {
  const auto nearness = [&](const Fine& time) { return fine_nearness(moved_set(a, motion, time), b, 1e-9, 200); };
  if (!cast) {
    for (int i = 0; i <= 8; ++i)
      if (nearness(Fine(i) / 8).meet) return fmt::format("a miss, but they meet at {}/8", i);
    return "";
  }
  if (!(cast->lower <= cast->upper && cast->upper <= 1)) return "times turned round";
  if (cast->lower > 0 && nearness(Fine(cast->lower)).meet) return fmt::format("they have met before {}", cast->lower);
  if (cast->lower > 0 && nearness(Fine(cast->lower) / 2).meet)
    return fmt::format("they meet at half of {}", cast->lower);
  if (cast->status == Status::exact && nearness(Fine(cast->upper)).lower > Fine(1e-20))
    return fmt::format("they have not met at {}", cast->upper);
  return "";
}

bool is_solid_kind(const PlacedQuadric&) { return true; }
bool is_solid_kind(const PlacedPolytope& placed) { return posed(placed).solid(); }

template <class B>
std::string check_moves(const QuadricCase& pair, const B& placed_b, Random& random) {
  const PosedQuadric a = posed(pair.a);
  const auto b = posed(placed_b);
  const oracle::FineSet set_a = fine_set(pair.a), set_b = fine_set(placed_b);
  const Relation lie = relation(a, b);
  const oracle::FineNearness truth = fine_nearness(set_a, set_b, 1e-9, 200);
  if (lie.kind == RelationKind::apart && truth.meet) return "apart, but they meet";
  if (lie.kind != RelationKind::apart && lie.status == Status::exact && truth.lower > 0)
    return "overlapping, but apart";
  if (relation(b, a).kind != lie.kind) return "relation exchanged";
  if (is_solid_kind(placed_b))
    if (std::string wrong = depth_fault(penetration(a, b), set_a, set_b, random); !wrong.empty()) return wrong;
  const Vec3 way = placed_b.pose.offset - pair.a.pose.offset;
  const Vec3 motion = 1.5 * way + 0.3 * std::sqrt(dot(way, way)) * quadric_direction(random);
  if (std::string wrong = cast_fault(cast_shape(a, motion, b), set_a, motion, set_b); !wrong.empty()) return wrong;
  // A ray from B's place to around A.
  const Vec3 from = placed_b.pose.offset, along = -motion;
  if (along == Vec3{}) return "";
  const std::string wrong = cast_fault(cast_ray(from, along, a), oracle::hull_set_of({from}, 0), along, set_a);
  return wrong.empty() ? "" : "ray: " + wrong;
}

std::vector<std::string> move_cells() {
  std::vector<std::string> cells;
  for (const std::string& a : quadric_kinds())
    for (const std::string& b : quadric_other_kinds()) cells.push_back(fmt::format("{}/{}", a, b));
  return cells;
}

SweepResult run_moves(const std::string& cell, std::uint64_t seed, std::uint64_t cases) {
  static const std::vector<std::string> regimes{"far", "near", "deep", "aligned", "affine", "distant", "flat"};
  SweepResult result;
  Random random = random_of_cell(cell, seed);
  const std::size_t slash = cell.find('/');
  for (; result.cases < cases; ++result.cases) {
    const std::string& regime = regimes[result.cases % regimes.size()];
    const QuadricCase pair = quadric_case(cell.substr(0, slash), cell.substr(slash + 1), regime, random);
    const std::string wrong = std::visit([&](const auto& other) { return check_moves(pair, other, random); }, pair.b);
    if (wrong.empty()) continue;
    if (result.wrong++ == 0) result.first_failure = fmt::format("{}, case {} ({})", wrong, result.cases, regime);
  }
  return result;
}

const bool moves_known = register_sweep({"quadric-moves", move_cells(), 10'000, 14, run_moves, 700, 7});

}  // namespace
}  // namespace toccata::test
