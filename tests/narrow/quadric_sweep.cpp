#include <fmt/format.h>

#include "narrow/convex_cells.hpp"
#include "narrow/quadric_cases.hpp"
#include "toccata/core/error.hpp"

// Quadrics against 60 digits: what is said to be apart, to meet or to be undecided, and the interval.
namespace toccata::test {
namespace {

using oracle::Fine;

std::vector<std::string> quadric_cells() {
  std::vector<std::string> cells;
  for (const std::string& a : quadric_kinds())
    for (const std::string& b : quadric_other_kinds()) cells.push_back(fmt::format("{}/{}", a, b));
  return cells;
}

double largest_of(const oracle::FinePoint& v) {
  double largest = 0;
  for (const Fine& x : {v.x, v.y, v.z}) largest = std::max(largest, std::abs(x.convert_to<double>()));
  return largest;
}

/// How large the pair is, seen from A: what undecided is measured with.
double size_of_both(const oracle::FineSet& a, const oracle::FineSet& b) {
  double largest = b.radius.convert_to<double>();
  for (const oracle::FineSet* set : {&a, &b})
    for (const auto& axis : set->axis) largest = std::max(largest, largest_of(axis));
  for (const auto& v : b.vertices)
    largest = std::max(largest, largest_of({v.x - a.centre.x, v.y - a.centre.y, v.z - a.centre.z}));
  return largest;
}

std::string fault_of(const Distance& d, const QuadricContact contact, const oracle::FineNearness& truth, double size) {
  if (d.status == Status::exact && d.upper - d.lower > 1e-12 * d.upper) return "interval too wide";
  if (d.lower > d.upper) return "interval turned round";
  if (Fine(d.lower) > truth.upper) return fmt::format("lower {} above {}", d.lower, truth.upper.str(30));
  if (Fine(d.upper) < truth.lower) return fmt::format("upper {} below {}", d.upper, truth.lower.str(30));
  const bool apart = truth.lower > Fine(1e-12) * Fine(size);
  if (apart && (contact != QuadricContact::apart || !(d.lower > 0))) return "not seen to be apart";
  if (contact == QuadricContact::apart && truth.meet) return "apart, but they meet";
  if (contact == QuadricContact::contact && truth.lower > 0) return "contact, but they are apart";
  const bool deep = truth.meet && truth.depth > Fine(1e-12) * Fine(size);
  if (deep && (contact != QuadricContact::contact || d.status != Status::exact)) return "not seen to meet";
  // Nearer than this the interval may be wider, and says so.
  const bool hair = d.upper <= 1e-9 * size;
  if (d.status == Status::not_converged && !hair) return fmt::format("not converged: [{}, {}]", d.lower, d.upper);
  return "";
}

template <class B>
std::string check_pair(const PlacedQuadric& placed_a, const B& placed_b) {
  const PosedQuadric a = posed(placed_a);
  const auto b = posed(placed_b);
  const Distance d = distance(a, b), back = distance(b, a);
  const QuadricContact contact = quadric_contact(a, b);
  if (back.lower != d.lower || back.upper != d.upper || !(back.on_a == d.on_b) || !(back.on_b == d.on_a))
    return "exchanged";
  if (overlap(a, b) != (contact != QuadricContact::apart) || quadric_contact(b, a) != contact) return "overlap";
  const oracle::FineSet set_a = fine_set(placed_a), set_b = fine_set(placed_b);
  const oracle::FineNearness truth = oracle::fine_nearness(set_a, set_b, 1e-14, 400);
  return fault_of(d, contact, truth, size_of_both(set_a, set_b));
}

std::string text_of(const PlacedQuadric& placed) {
  const PosedQuadric seen = posed(placed);
  std::string text = fmt::format("{} half {:.17g} {:.17g} {:.17g} pose", static_cast<int>(seen.kind()), seen.half().x,
                                 seen.half().y, seen.half().z);
  for (const double x : placed.pose.numbers()) text += fmt::format(" {:.17g}", x);
  return text;
}

std::string text_of(const PlacedPolytope& placed) {
  const PosedPolytope seen = posed(placed);
  std::string text = fmt::format("radius {:.17g} vertices", seen.radius());
  for (Index i = 0; i < seen.vertex_count(); ++i)
    text += fmt::format(" ({:.17g}, {:.17g}, {:.17g})", seen.vertex(i).x, seen.vertex(i).y, seen.vertex(i).z);
  return text;
}

SweepResult run_quadric(const std::string& cell, std::uint64_t seed, std::uint64_t cases) {
  SweepResult result;
  Random random = random_of_cell(cell, seed);
  const std::size_t slash = cell.find('/');
  for (; result.cases < cases; ++result.cases) {
    const std::string& regime = quadric_regimes()[result.cases % quadric_regimes().size()];
    const QuadricCase pair = quadric_case(cell.substr(0, slash), cell.substr(slash + 1), regime, random);
    const std::string wrong = std::visit([&](const auto& other) { return check_pair(pair.a, other); }, pair.b);
    if (wrong.empty()) continue;
    if (result.wrong++ == 0)
      result.first_failure = fmt::format("{}, case {} ({}): {}; {}", wrong, result.cases, regime, text_of(pair.a),
                                         std::visit([](const auto& other) { return text_of(other); }, pair.b));
  }
  return result;
}

const bool quadric_known = register_sweep({"quadrics", quadric_cells(), 10'000, 44, run_quadric, 1100, 11});

}  // namespace
}  // namespace toccata::test
