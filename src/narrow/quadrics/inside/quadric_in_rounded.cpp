#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "math/vec3_measures.hpp"
#include "narrow/quadrics/inside/quadric_containment.hpp"
#include "toccata/narrow/convex_convex.hpp"

namespace toccata {
namespace {

/// More points than this are not looked at.
constexpr int most_points = 20'000;

/// What is left of a circle or a sphere |w| = 1: an arc between two of its points, or the triangle between three.
struct Piece {
  std::array<Vec3, 3> corner;
  std::size_t size = 0;
};

/// The points of the piece lie within the hull of its corners and of these multiples of them: how far the line or plane
/// through the corners is from the middle.
double growth_of(const Piece& piece) {
  const Vec3 &p = piece.corner[0], &q = piece.corner[1], &r = piece.corner[2];
  if (piece.size == 2) return 2 / plain_length(p + q);
  const Vec3 normal = cross(q - p, r - p);
  return plain_length(normal) / std::fabs(dot(normal, p));
}

Vec3 middle_direction(const Vec3& p, const Vec3& q) { return (1 / plain_length(p + q)) * (p + q); }

std::vector<Piece> halves_of(const Piece& piece) {
  const Vec3 &p = piece.corner[0], &q = piece.corner[1], &r = piece.corner[2];
  const Vec3 pq = middle_direction(p, q);
  if (piece.size == 2) return {{{p, pq}, 2}, {{pq, q}, 2}};
  const Vec3 qr = middle_direction(q, r), rp = middle_direction(r, p);
  return {{{p, pq, rp}, 3}, {{pq, q, qr}, 3}, {{rp, qr, r}, 3}, {{pq, qr, rp}, 3}};
}

/// Quarters of the circle across z, or eighths of the sphere.
std::vector<Piece> whole(std::size_t dimensions) {
  std::vector<Piece> pieces;
  for (const double x : {1.0, -1.0})
    for (const double y : {1.0, -1.0})
      if (dimensions == 2) {
        pieces.push_back({{Vec3{x, 0, 0}, Vec3{0, y, 0}}, 2});
      } else {
        for (const double z : {1.0, -1.0}) pieces.push_back({{Vec3{x, 0, 0}, Vec3{0, y, 0}, Vec3{0, 0, z}}, 3});
      }
  return pieces;
}

class OffsetSearch {
 public:
  OffsetSearch(const QuadricBody& held, const PosedPolytope& core, double radius)
      : held_(held), core_(core), radius_(radius) {
    double largest = 1;
    for (Index i = 0; i < core.vertex_count(); ++i) largest = std::fmax(largest, largest_magnitude(core.vertex(i)));
    slack_ = 0x1p-49 * (largest + radius);
  }

  [[nodiscard]] Within found() {
    Within all = Within::yes;
    for (Index i = 0; i < held_.generator_count() && all != Within::no; ++i)
      all = both(all, held_.grown(i) ? surface_of(i) : at(i, {}));
    return all;
  }

 private:
  /// A point of a generator, or beyond it, in doubles: what that rounds is less than the slack.
  Within at(Index generator, const Vec3& round) {
    ++seen_;
    const Distance found = distance(PosedPolytope(Point{held_.plain_centre(generator) + held_.map(round)}), core_);
    if (found.upper + slack_ <= radius_) return Within::yes;
    return found.lower - slack_ > radius_ ? Within::no : Within::undecided;
  }

  Within surface_of(Index generator) {
    std::vector<Piece> left = whole(held_.column_count());
    Within all = Within::yes;
    while (!left.empty() && all != Within::no) {
      if (seen_ > most_points) return both(all, Within::unfinished);
      const Piece piece = left.back();
      left.pop_back();
      if (is_offset_held(generator, piece)) continue;
      Within corners = Within::yes;
      for (std::size_t i = 0; i < piece.size; ++i) corners = both(corners, at(generator, piece.corner[i]));
      if (corners != Within::yes) {
        // Neither shown to be in nor out: then nor is what lies around it.
        all = both(all, corners);
        continue;
      }
      for (const Piece& half : halves_of(piece)) left.push_back(half);
    }
    return all;
  }

  bool is_offset_held(Index generator, const Piece& piece) {
    const double growth = growth_of(piece);
    if (!(growth < 4)) return false;
    for (std::size_t i = 0; i < piece.size; ++i)
      if (at(generator, growth * piece.corner[i]) != Within::yes) return false;
    return true;
  }

  const QuadricBody& held_;
  const PosedPolytope& core_;
  double radius_;
  double slack_ = 0;
  int seen_ = 0;
};

}  // namespace

Within is_held_by_offset(const QuadricBody& held, const PosedPolytope& core, double radius) {
  return OffsetSearch(held, core, radius).found();
}

}  // namespace toccata
