#pragma once

#include "oracle/convex.hpp"
#include "toccata/bounds/all_volumes.hpp"

// Which set a volume is, as its header says, in rational numbers.
namespace toccata::test {

oracle::ConvexSet exact_set(const Aabb& volume);
oracle::ConvexSet exact_set(const Ball& volume);
oracle::ConvexSet exact_set(const Cube& volume);
oracle::ConvexSet exact_set(const Obb& volume);
oracle::ConvexSet exact_set(const Pss& volume);
oracle::ConvexSet exact_set(const Lss& volume);
oracle::ConvexSet exact_set(const Rss& volume);
oracle::ConvexSet exact_set(const HullBound& volume);

template <class V>
concept HasExactSet = requires(const V& volume) {
  exact_set(volume);
};

/// The point is in the set, exactly.
template <HasExactSet V>
bool holds(const V& volume, const Vec3& point) {
  return oracle::side_of(oracle::exact(point), exact_set(volume)) <= 0;
}

bool holds(const EllipsoidBound& volume, const Vec3& point);

template <std::size_t k>
bool holds(const Kdop<k>& volume, const Vec3& point) {
  for (std::size_t i = 0; i < Kdop<k>::slabs; ++i) {
    const oracle::Rational height = dot(oracle::exact(kdop_normals<k>()[i]), oracle::exact(point));
    if (height < oracle::exact(volume.lower[i]) || height > oracle::exact(volume.upper[i])) return false;
  }
  return true;
}

}  // namespace toccata::test
