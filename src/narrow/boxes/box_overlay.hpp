#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "toccata/core/index.hpp"
#include "toccata/math/vec3.hpp"

// A face of a box over a face of another, seen in the frame of the latter: which points bound their common part, and
// which four stand for it. With vector instructions, the same bits at every level.
namespace toccata {

/// A parallelogram, centre ± along_x ± along_y, over a rectangle around the origin of which the sides are along x and
/// y. Its corner number 0 is at −, −, 1 at +, −, 2 at +, +, 3 at −, +, and side k leaves corner k; those of the
/// rectangle are numbered likewise.
struct SeenFace {
  Vec3 centre;
  Vec3 along_x;
  Vec3 along_y;
  double width = 0;   ///< half of the rectangle's extent along x
  double height = 0;  ///< and along y
};

/// The common part's corners, at places that tell what they are.
struct BoxOverlay {
  static constexpr std::size_t capacity = 16;

  /// An overlay without a point; nothing is written that nobody reads.
  BoxOverlay() {}

  static constexpr Index first_entry = 4;    ///< before it the parallelogram's corners that are over the rectangle
  static constexpr Index first_exit = 8;     ///< before it where the parallelogram's sides come over the rectangle
  static constexpr Index first_corner = 12;  ///< before it where they leave it; from here on the rectangle's corners

  std::array<double, capacity> x, y, gap;  ///< gap: z, the height over the rectangle
  unsigned points = 0;                     ///< a bit for each place that is taken
  /// Two corners may be the same but for rounding; where not, all of them are farther from each other than that.
  bool may_have_doubles;
  double size;  ///< the sum of width and height
  // A bit for each of the parallelogram's sides.
  unsigned enters_along_x, leaves_along_x;  ///< across a side of the rectangle that is along y
  unsigned goes_up_x, goes_up_y;            ///< towards greater coordinates

  /// The side of the rectangle which the parallelogram's side crosses at a place from first_entry on.
  [[nodiscard]] Index crossed_side(Index place) const {
    const Index side = place & 3U;
    const bool is_exit = place >= first_exit;
    const bool is_along_x = ((is_exit ? leaves_along_x : enters_along_x) >> side & 1U) != 0;
    const bool is_up = ((is_along_x ? goes_up_x : goes_up_y) >> side & 1U) != 0;
    return (is_along_x ? 1U : 2U) ^ (is_up == is_exit ? 0U : 2U);
  }
};

/// Precondition: coordinates are between 2^-200 and 2^200, or zero.
[[nodiscard]] BoxOverlay overlay_of(const SeenFace& face);

/// Some places of an overlay.
struct ChosenPlaces {
  std::array<std::uint8_t, 4> place;
  std::size_t count;
};

/// Chooses among the corners that touch, or nearly do, each once: all up to four; else the deepest, the farthest from
/// it, and the farthest to both sides of the line through these, or the two farthest to one.
[[nodiscard]] ChosenPlaces chosen_places(const BoxOverlay& overlay);

}  // namespace toccata
