#include "narrow/quadrics/distance/ellipsoid_pair.hpp"

#include <algorithm>
#include <cmath>

#include "math/constants.hpp"
#include "math/vec3_measures.hpp"
#include "narrow/pose_checks.hpp"

// An ellipsoid with the matrix S = M Mᵀ, M its half axes in the world, reaches h = √(d · S d) from its middle along d,
// at the point S d / h, and the derivative of that point is H = (S − (S d / h)(S d / h)ᵀ) / h. So with z the difference
// of the points of A farthest against d and of B farthest along it, and γ = z · d / d · d, the condition of the nearest
// points is that z is along d, and Newton's method for it, as H d = 0, the iteration d ← (γ + H_A + H_B)⁻¹ z.
namespace toccata {
namespace {

constexpr int most_ellipsoid_steps = 10;
constexpr int most_blind_steps = 3;
/// A share of what an ellipsoid reaches.
constexpr double blind_part = 0.1;
/// What is left after a turn this small, squared, is about its square.
constexpr double small_turn_squared = 0x1p-46;
/// The greatest ratio of half axes: that the squares of S do not hide the shorter ones.
constexpr double most_slim = 64;

/// A symmetric matrix, by its upper half.
struct EllipsoidMatrix {
  double xx = 0, xy = 0, xz = 0, yy = 0, yz = 0, zz = 0;
};

Vec3 operator*(const EllipsoidMatrix& m, const Vec3& v) {
  return {(m.xx * v.x + m.xy * v.y) + m.xz * v.z, (m.xy * v.x + m.yy * v.y) + m.yz * v.z,
          (m.xz * v.x + m.yz * v.y) + m.zz * v.z};
}

EllipsoidMatrix squared_axes(const PosedQuadric& shape) {
  const Vec3& h = shape.half();
  const auto scaled = [&](const Vec3& row) { return Vec3{row.x * h.x, row.y * h.y, row.z * h.z}; };
  const Vec3 x = scaled(shape.pose().linear[0]), y = scaled(shape.pose().linear[1]), z = scaled(shape.pose().linear[2]);
  return {dot(x, x), dot(x, y), dot(x, z), dot(y, y), dot(y, z), dot(z, z)};
}

/// What an ellipsoid reaches along a direction.
struct EllipsoidReach {
  EllipsoidReach(const EllipsoidMatrix& squared, const Vec3& direction) {
    const Vec3 along = squared * direction;
    part = 1 / std::sqrt(dot(along, direction));
    point = part * along;
  }
  Vec3 point;
  double part = 0;  // 1 / h
};

/// Adds H, but for what belongs to S.
void bend(EllipsoidMatrix& k, const EllipsoidMatrix& s, const EllipsoidReach& reach) {
  const Vec3 &p = reach.point, q = reach.part * p;
  k.xx += reach.part * s.xx - q.x * p.x;
  k.xy += reach.part * s.xy - q.x * p.y;
  k.xz += reach.part * s.xz - q.x * p.z;
  k.yy += reach.part * s.yy - q.y * p.y;
  k.yz += reach.part * s.yz - q.y * p.z;
  k.zz += reach.part * s.zz - q.z * p.z;
}

/// k⁻¹ v.
Vec3 solved(const EllipsoidMatrix& k, const Vec3& v) {
  const EllipsoidMatrix adjugate{k.yy * k.zz - k.yz * k.yz, k.xz * k.yz - k.xy * k.zz, k.xy * k.yz - k.xz * k.yy,
                                 k.xx * k.zz - k.xz * k.xz, k.xy * k.xz - k.xx * k.yz, k.xx * k.yy - k.xy * k.xy};
  const double determinant = (k.xx * adjugate.xx + k.xy * adjugate.xy) + k.xz * adjugate.xz;
  return (1 / determinant) * (adjugate * v);
}

/// From B to A, where the conditions of the nearest points hold, or the length of the gap across is enough.
template <class IsEnough>
std::optional<Vec3> nearest_direction(const PosedQuadric& a, const PosedQuadric& b, const Vec3& first,
                                      const IsEnough& is_enough) {
  const Vec3 between = a.pose().offset - b.pose().offset;
  const EllipsoidMatrix of_a = squared_axes(a), of_b = squared_axes(b);
  const Vec3 start = first == Vec3{} ? between : first;
  Vec3 d = (1 / plain_length(start)) * start;
  for (int i = 0; i < most_ellipsoid_steps; ++i) {
    const EllipsoidReach reach_a(of_a, d), reach_b(of_b, d);
    const Vec3 z = (between - reach_a.point) - reach_b.point;
    const double squared = dot(d, d), gap = dot(z, d) / squared;
    if (is_enough(gap * std::sqrt(squared))) return d;
    // Where the direction does not separate them yet, it is led on as if it did.
    const double positive = gap > 0 ? gap : blind_part / (reach_a.part * squared);
    if (!(gap > 0) && i >= most_blind_steps) return {};
    EllipsoidMatrix k{positive, 0, 0, positive, 0, positive};
    bend(k, of_a, reach_a);
    bend(k, of_b, reach_b);
    const Vec3 next = solved(k, z + (positive - gap) * d), turn = next - d;
    d = next;
    if (dot(turn, turn) < small_turn_squared * squared) return d;
  }
  return {};
}

/// The farthest point of an ellipsoid along a direction.
struct FarthestPoint {
  FarthestPoint(const PosedQuadric& shape, const Vec3& direction) {
    const Mat3& m = shape.pose().linear;
    const Vec3& half = shape.half();
    const Vec3 along{half.x * dot(m.column(0), direction), half.y * dot(m.column(1), direction),
                     half.z * dot(m.column(2), direction)};
    height = plain_length(along);
    round = drawn_into_ball(along, height);
    const Vec3 p{half.x * round.x, half.y * round.y, half.z * round.z};
    from_middle = {dot(m[0], p), dot(m[1], p), dot(m[2], p)};
    size = plain_length(half);
  }
  Vec3 round;  // in the unit ball
  Vec3 from_middle;
  double height = 0;  // but for drawing it in
  double size = 0;
};

/// Tiny gaps, with twice the digits.
std::optional<FastDistance> proved_longer(const PosedQuadric& a, const PosedQuadric& b, const FarthestPoint& on_a,
                                          const FarthestPoint& on_b, const Vec3& direction) {
  FastSide side_a, side_b;
  side_a.round = on_a.round;
  side_b.round = on_b.round;
  return if_narrow(proved_interval(a, b, side_a, side_b, direction));
}

// An operation rounds by at most u = 2⁻⁵³ of its result, a product of three terms by 3 u times that of the magnitudes;
// and rotations, but for 2⁻⁴², change no length. With e the length of a shape's half axes, h what it reaches along d,
// |d| its length and L that of z:
//
// Its point is at most h / |d| … e from the middle; as a point of the shape it rounds by u e for the half axes and
// 3 √3 u e turned. z: these of both, and the sums, of parts of at most L + e_A + e_B: u (8.2 (e_A + e_B) + 3 L).
// What the shape reaches beyond its point: the product with the half axes is off by 3 u |d| e and u h; that counts
// twice, as the point may be at either side; 10 u h for drawing in, 2.5 u of the length, 3 u of the factor, 2 u of the
// product: u (6 e |d| + 19.5 h).
std::optional<FastDistance> proved(const PosedQuadric& a, const PosedQuadric& b, const Vec3& d) {
  const FarthestPoint on_a(a, -d), on_b(b, d);
  const Vec3 z = ((a.pose().offset - b.pose().offset) + on_a.from_middle) - on_b.from_middle;
  const double length = plain_length(z), part = 1 / plain_length(d);
  if (!is_moderate(length)) return {};
  const double sizes = on_a.size + on_b.size;
  const double off = unit_roundoff * (9.3 * sizes + 3.5 * length);
  const double beyond = unit_roundoff * (6.8 * sizes + 22 * (on_a.height + on_b.height) * part);
  FastDistance found;
  // 2.5 u of the length, 2 u of the operations.
  found.upper = (length + off) * (1 + 6 * unit_roundoff);
  // 3 u of the product, 3.5 u of the quotient, 2 u of the operations.
  found.lower = (dot(z, d) * part - (off + beyond)) - 10 * unit_roundoff * length;
  found.on_a = on_a.from_middle + a.pose().offset;
  found.on_b = on_b.from_middle + b.pose().offset;
  if (is_narrow(found)) return found;
  return is_nearly_narrow(found) ? proved_longer(a, b, on_a, on_b, d) : std::nullopt;
}

/// Which part of a vector from its middle lies within an ellipsoid; more than 1 where it ends within.
double part_within(const PosedQuadric& shape, const Vec3& v) {
  const Mat3& m = shape.pose().linear;
  const Vec3& half = shape.half();
  return 1 / plain_length({dot(m.column(0), v) / half.x, dot(m.column(1), v) / half.y, dot(m.column(2), v) / half.z});
}

// A rotation is not farther from the pose than 2⁻⁴², and the products round by less; that counts at most `most_slim`
// times for the quotients with the half axes, so no part is off by 2⁻³⁴ of itself.
bool are_met_between_middles(const PosedQuadric& a, const PosedQuadric& b) {
  const Vec3 between = b.pose().offset - a.pose().offset;
  return part_within(a, between) + part_within(b, between) > 1 + 0x1p-32;
}

bool is_plain(const PosedQuadric& shape) {
  const Vec3& half = shape.half();
  const double least = std::min({half.x, half.y, half.z}), most = std::max({half.x, half.y, half.z});
  return shape.kind() == PosedQuadric::kind_of<Ellipsoid> && is_moderate(least) && is_moderate(most) &&
         most <= most_slim * least && is_surely_rigid(shape.pose().linear);
}

}  // namespace

std::optional<FastDistance> ellipsoid_distance(const PosedQuadric& a, const PosedQuadric& b,
                                               const Vec3& first_direction) {
  if (!is_plain(a) || !is_plain(b)) return {};
  const auto never = [](double) { return false; };
  if (const auto direction = nearest_direction(a, b, first_direction, never)) return proved(a, b, *direction);
  return {};
}

// With e the length of a shape's half axes and |d| = 1, what S and the products round counts 12 u e² for d · S d: no
// more than 2⁻³⁵ of it, as the half axes differ by at most `most_slim`. What the shape reaches is off by half of that
// part, and the gap by some u of all lengths.
std::optional<QuadricContact> ellipsoid_contact(const PosedQuadric& a, const PosedQuadric& b) {
  if (!is_plain(a) || !is_plain(b)) return {};
  const double between = plain_length(a.pose().offset - b.pose().offset);
  const double least = 0x1p-34 * (between + plain_length(a.half()) + plain_length(b.half()));
  std::optional<QuadricContact> found;
  (void)nearest_direction(a, b, {}, [&](double gap) {
    if (is_moderate(between) && gap > least) found = QuadricContact::apart;
    if (!(gap > 0) && are_met_between_middles(a, b)) found = QuadricContact::contact;
    return found.has_value();
  });
  return found;
}

}  // namespace toccata
