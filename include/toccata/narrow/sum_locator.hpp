#pragma once

#include <cstddef>
#include <memory>

#include "toccata/narrow/minkowski.hpp"

namespace toccata {

/// Where points lie in a Minkowski sum, for many points: of a difference A − B, whether B meets A after many
/// translations. The same answers as `MinkowskiSum::side_of`, exact, in time that grows with the logarithm of the
/// number of faces. Immutable; copies share all, and any number of threads may ask.
///
/// Seen from a point inside, every direction leaves through one face. Directions are divided as the sides of a cube
/// are into squares, the squares into four where they have many faces, down to 1/1024 of a side; a point is compared
/// with the planes of the faces in its square. Around a vertex in which k faces meet the last squares have k. A sum
/// that is flat, or a thousand times longer than thick, is searched through face by face.
class SumLocator {
 public:
  /// Takes a hundred times as long as a question about the sum itself.
  explicit SumLocator(const MinkowskiSum& sum);

  /// As `MinkowskiSum::side_of`.
  [[nodiscard]] Sign side_of(const Vec3& point) const;
  [[nodiscard]] bool contains(const Vec3& point) const { return side_of(point) != Sign::positive; }

  /// Bytes beside those of the sum.
  [[nodiscard]] std::size_t memory() const;

 private:
  struct Parts;
  std::shared_ptr<const Parts> parts_;
};

}  // namespace toccata
