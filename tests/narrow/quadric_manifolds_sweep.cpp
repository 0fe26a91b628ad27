#include <fmt/format.h>

#include "narrow/convex_cells.hpp"
#include "narrow/quadric_cases.hpp"
#include "narrow/quadric_manifold_checks.hpp"

// Manifolds of quadrics against 60 digits.
namespace toccata::test {
namespace {

using oracle::Fine;

bool is_flipped(const Manifold& m, const Manifold& other) {
  if (m.count != other.count || (m.count > 0 && m.normal != -other.normal)) return false;
  for (std::size_t i = 0; i < static_cast<std::size_t>(m.count); ++i) {
    const ManifoldPoint &p = m.points[i], &q = other.points[i];
    if (p.position != q.position || p.depth != q.depth || p.on_a != q.on_b || p.on_b != q.on_a) return false;
  }
  return true;
}

bool is_same(const PlacedQuadric& a, const PlacedQuadric& b) {
  return a.shape.index() == b.shape.index() && posed(a).half() == posed(b).half() &&
         a.pose.numbers() == b.pose.numbers();
}
bool is_same(const PlacedQuadric&, const PlacedPolytope&) { return false; }

bool is_equal(const Manifold& m, const Manifold& other) {
  const auto same = [](const ManifoldPoint& p, const ManifoldPoint& q) {
    return p.position == q.position && p.depth == q.depth && p.on_a == q.on_a && p.on_b == q.on_b;
  };
  return m.count == other.count && m.normal == other.normal &&
         std::equal(m.points.begin(), m.points.begin() + m.count, other.points.begin(), same);
}

/// From the middle of A: that of the pair.
double reach_of(const oracle::FineSet& a, const oracle::FineSet& b) {
  double largest = b.radius.convert_to<double>();
  const auto look = [&](const oracle::FinePoint& v) {
    for (const Fine& x : {v.x, v.y, v.z}) largest = std::max(largest, std::abs(x.convert_to<double>()));
  };
  for (const oracle::FineSet* set : {&a, &b}) {
    for (const auto& axis : set->axis) look(axis);
    for (const auto& v : set->vertices) look({v.x - a.centre.x, v.y - a.centre.y, v.z - a.centre.z});
  }
  if (b.kind != oracle::FineKind::hull)
    look({b.centre.x - a.centre.x, b.centre.y - a.centre.y, b.centre.z - a.centre.z});
  return largest;
}

bool is_known_feature(const ConvexFeature& f, const PlacedQuadric& placed) {
  using Kind = ConvexFeature::Kind;
  const std::size_t kind = placed.shape.index();
  if (kind == 2) return f == ConvexFeature{Kind::face, 0};
  if (f.kind == Kind::vertex) return kind == 1 && f.index == 0;
  return f.index < (f.kind == Kind::edge ? (kind == 0 ? 8 : 4) : (kind == 0 ? 3 : 2));
}

bool is_known_feature(const ConvexFeature& f, const PlacedPolytope& placed) {
  const PosedPolytope shape = posed(placed);
  if (f.kind == ConvexFeature::Kind::vertex) return f.index < shape.vertex_count();
  const HullTopology topology = shape.topology();
  return f.index < (f.kind == ConvexFeature::Kind::edge ? topology.origin.size() : topology.face_count());
}

/// Not a promise for all: the least is not always found on round sides.
std::string normal_fault(const Manifold& m, QuadricContact contact, const oracle::FineSet& a, const oracle::FineSet& b,
                         double size, Random& random) {
  const Fine depth = oracle::depth_along(a, b, fine_of(m.normal));
  if (contact == QuadricContact::undecided && depth > Fine(1e-11 * size))
    return fmt::format("undecided, but {} along the normal", depth.str(10));
  for (int i = 0; i < 50; ++i)
    if (const Fine other = oracle::depth_along(a, b, fine_of(quadric_direction(random)));
        other < Fine(0.9) * depth - Fine(1e-11 * size))
      return fmt::format("{} deep, and {} elsewhere", depth.str(10), other.str(10));
  return "";
}

template <class B>
std::string check_manifold(const QuadricCase& pair, const B& placed_b, bool with_extent, Random& random) {
  const PosedQuadric a = posed(pair.a);
  const auto b = posed(placed_b);
  const Manifold m = manifold(a, b);
  const QuadricContact contact = quadric_contact(a, b);
  if ((m.count > 0) != (contact != QuadricContact::apart)) return "there, or not";
  const Manifold exchanged = manifold(b, a);
  if (!(is_same(pair.a, placed_b) ? is_equal(m, exchanged) : is_flipped(m, exchanged))) return "exchanged";
  if (m.count == 0) return "";
  for (std::size_t i = 0; i < static_cast<std::size_t>(m.count); ++i)
    if (!is_known_feature(m.points[i].on_a, pair.a) || !is_known_feature(m.points[i].on_b, placed_b)) return "features";
  const oracle::FineSet set_a = fine_set(pair.a), set_b = fine_set(placed_b);
  const double size = reach_of(set_a, set_b);
  std::string wrong = quadric_manifold_fault(m, set_a, set_b, size);
  if (wrong.empty()) wrong = normal_fault(m, contact, set_a, set_b, size, random);
  if (wrong.empty() && with_extent && set_b.vertices.size() <= 8 && set_b.radius == 0)
    wrong = contact_extent_fault(m, set_a, set_b, size);
  return wrong;
}

std::vector<std::string> manifold_cells() {
  std::vector<std::string> cells;
  for (const std::string& a : quadric_kinds()) {
    for (const std::string& b : quadric_other_kinds()) cells.push_back(fmt::format("{}/{}", a, b));
    cells.push_back(a + "/half-space");
  }
  return cells;
}

/// The half-space as the box that it is beside the shape: of its surface only what is near is looked at.
std::string check_on_plane(const QuadricCase& pair, Random& random) {
  const PosedQuadric a = posed(pair.a);
  const oracle::FineSet set_a = fine_set(pair.a);
  const double size = reach_of(set_a, set_a);
  Vec3 normal = quadric_direction(random);
  if (random.below(2) == 0) {
    const Vec3 axis = pair.a.pose.linear.column(static_cast<int>(random.below(3)));
    normal = (random.below(2) == 0 ? 1 : -1) / std::sqrt(dot(axis, axis)) * axis;
  }
  const oracle::FinePoint lowest = oracle::farthest(set_a, fine_of(-normal));
  const Vec3 at{lowest.x.convert_to<double>(), lowest.y.convert_to<double>(), lowest.z.convert_to<double>()};
  const double depth = random.below(4) == 0 ? 0 : size * std::pow(10.0, random.between(-12, -1));
  const PosedHalfSpace b(HalfSpace(at + depth * normal, normal));
  const Manifold m = manifold(a, b);
  if ((m.count > 0) != overlap(a, b)) return "there, or not";
  if (!is_flipped(m, manifold(b, a))) return "exchanged";
  if (m.count == 0) return "";
  oracle::FineSet surface;
  const auto [x, y] = [&] {
    const Vec3 aside = std::fabs(b.normal.x) < 0.6 ? Vec3{1, 0, 0} : Vec3{0, 1, 0};
    const Vec3 u = cross(b.normal, aside);
    return std::pair(u, cross(b.normal, u));
  }();
  const double reach = 8 * size / dot(b.normal, b.normal);
  for (const double s : {-reach, reach})
    for (const double t : {-reach, reach}) {
      const oracle::FinePoint p = fine_of(b.point), u = fine_of(x), v = fine_of(y);
      surface.vertices.push_back({p.x + Fine(s) * u.x + Fine(t) * v.x, p.y + Fine(s) * u.y + Fine(t) * v.y,
                                  p.z + Fine(s) * u.z + Fine(t) * v.z});
    }
  return quadric_manifold_fault(m, set_a, surface, 16 * size);
}

/// Beyond those of all sweeps: leaning (face to face, line along line and line on face, but for a small angle), and
/// crossing (flat shapes and slim ones that go through each other).
const std::vector<std::string>& manifold_regimes() {
  static const std::vector<std::string> regimes = [] {
    std::vector<std::string> all = quadric_regimes();
    all.insert(all.end(), {"leaning", "crossing"});
    return all;
  }();
  return regimes;
}

QuadricCase manifold_case(const std::string& kind_a, const std::string& kind_b, const std::string& regime,
                          Random& random) {
  if (regime == "crossing") {
    QuadricCase pair = quadric_case(kind_a, kind_b, random.below(2) == 0 ? "flat" : "needle", random);
    pair.pose_of_b().offset = random.between(0, 0.5) * quadric_direction(random);
    return pair;
  }
  if (regime != "leaning") return quadric_case(kind_a, kind_b, regime, random);
  QuadricCase pair = quadric_case(kind_a, kind_b, "aligned", random);
  Pose& pose = pair.pose_of_b();
  const Mat3 turn = rotation_about(quadric_direction(random), std::pow(10.0, random.between(-9, 0.5)));
  pose = Pose{turn, {}} * Pose{pose.linear, {}};
  const int up = static_cast<int>(random.below(3));
  for (int i = 0; i < 3; ++i) pose.offset[i] = i == up ? 10 : random.between(-1, 1);
  leave_quadric_gap(pair, (random.below(2) == 0 ? -1 : 1) * std::pow(10.0, random.between(-14, -1)));
  return pair;
}

std::string check_case(const std::string& kind_a, const std::string& kind_b, std::uint64_t number, Random& random) {
  const std::string& regime = manifold_regimes()[number % manifold_regimes().size()];
  const bool on_plane = kind_b == "half-space";
  const QuadricCase pair = manifold_case(kind_a, on_plane ? "point" : kind_b, regime, random);
  if (on_plane) return check_on_plane(pair, random);
  const bool with_extent = regime == "aligned" && number % 26 < 13;
  return std::visit([&](const auto& other) { return check_manifold(pair, other, with_extent, random); }, pair.b);
}

SweepResult run_manifolds(const std::string& cell, std::uint64_t seed, std::uint64_t cases) {
  SweepResult result;
  Random random = random_of_cell(cell, seed);
  const std::size_t slash = cell.find('/');
  for (; result.cases < cases; ++result.cases) {
    const std::string wrong = check_case(cell.substr(0, slash), cell.substr(slash + 1), result.cases, random);
    if (wrong.empty()) continue;
    if (result.wrong++ == 0)
      result.first_failure = fmt::format("{}, case {} ({})", wrong, result.cases,
                                         manifold_regimes()[result.cases % manifold_regimes().size()]);
  }
  return result;
}

const bool manifolds_known =
    register_sweep({"quadric-manifolds", manifold_cells(), 10'000, 26, run_manifolds, 700, 13});

}  // namespace
}  // namespace toccata::test
