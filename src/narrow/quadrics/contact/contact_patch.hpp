#pragma once

#include <array>
#include <cstdint>
#include <memory_resource>
#include <optional>
#include <vector>

#include "narrow/quadrics/plain_body.hpp"
#include "toccata/narrow/convex_convex.hpp"

// What two shapes turn to each other where they meet, seen along the contact's normal.
namespace toccata {

/// A frame of which the third axis is the contact's normal, from A to B.
struct ContactFrame {
  ContactFrame(const Vec3& at, const Vec3& normal);

  [[nodiscard]] Vec3 turned(const Vec3& v) const { return {dot(v, x), dot(v, y), dot(v, z)}; }
  [[nodiscard]] Vec3 placed(const Vec3& p) const { return turned(p - origin); }
  [[nodiscard]] Vec3 back(const Vec3& p) const { return origin + ((p.x * x + p.y * y) + p.z * z); }

  Vec3 origin, x, y, z;
};

/// A shape turns a face to the normal within this cosine, and a line across it within this one: two degrees, or so.
inline constexpr double cosine_of_facing = 0.9995;
inline constexpr double cosine_across = 0.0316;

struct PatchCorner {
  Vec3 at;
  ConvexFeature here;
  ConvexFeature to_next;  ///< of a polygon
};

/// The points base + s · axis + width · (u₁ column[0] + u₂ column[1]) with |u| = 1 and s from 0 to 1; the width is 1,
/// or, where it tapers, 1 − s.
struct RoundSide {
  Vec3 base;
  Vec3 axis;
  std::array<Vec3, 2> column;
  bool tapers = false;

  /// The height of the surface at (x, y), of two the one nearer to the point; none beyond its ends.
  [[nodiscard]] std::optional<double> height_near(const Vec3& at) const;
};

/// A face, a line or a point of a shape, in the contact's frame; of a half-space its plane.
struct ContactPatch {
  enum class Kind : std::uint8_t { point, line, polygon, disc, plane };

  explicit ContactPatch(std::pmr::memory_resource& memory) : corners(&memory) {}

  /// The height of its point at (x, y), which may be beyond its sides.
  [[nodiscard]] double height(const Vec3& at) const;
  /// What a disc's point is the image of, on it or beyond; the third is 0.
  [[nodiscard]] Vec3 on_unit_disc(const Vec3& at) const;
  [[nodiscard]] Vec3 of_unit_disc(const Vec3& u) const { return centre + (u.x * column[0] + u.y * column[1]); }
  /// The quarter of a disc's rim.
  [[nodiscard]] ConvexFeature rim_at(const Vec3& u) const;
  [[nodiscard]] bool is_area() const { return kind != Kind::point && kind != Kind::line; }

  Kind kind = Kind::point;
  ConvexFeature whole;
  std::pmr::vector<PatchCorner> corners;  ///< of a line its ends
  double turn = 1;                        ///< of a polygon: −1 where the corners go clockwise
  std::optional<RoundSide> side;          ///< on which a line lies
  Vec3 centre;                            ///< of a disc; else a point of the patch
  std::array<Vec3, 2> column;             ///< of a disc, to its rim
  Index first_rim = 0;
  double slope_x = 0;  ///< of the height
  double slope_y = 0;
};

/// What the body of a quadric turns to `outwards` · normal, which is 1 or −1.
[[nodiscard]] ContactPatch patch_of(const PlainBody& body, const ContactFrame& frame, double outwards,
                                    std::pmr::memory_resource& memory);

/// The same of a convex shape in the scale of the pair; `origin` is that of the pair. `touching` is the point of it
/// that is farthest.
[[nodiscard]] ContactPatch patch_of(const PosedPolytope& shape, const Vec3& origin, const ContactFrame& frame,
                                    double outwards, const Vec3& touching, std::pmr::memory_resource& memory);

}  // namespace toccata
